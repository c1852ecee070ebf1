//! Paths: where a thing is, and how it is turned, at a time.

mod follow;
mod spline;

pub(crate) use follow::{along_ground, rolling};

use crate::check::{Key, Problem};
use crate::schema::PathFile;
use glam::{EulerRot, Quat, Vec3};
use sward::Pose;

/// Where a thing is at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathKey {
    /// Time, seconds.
    pub time_s: f32,
    /// Place, metres.
    pub position: Vec3,
    /// Turn.
    pub rotation: Quat,
}

/// Keyframes and the way between them. Before the first and after the last a thing rests, unless
/// the path repeats.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    keys: Vec<PathKey>,
    /// Velocity of the place at each key, metres a second.
    velocities: Vec<Vec3>,
    smooth: bool,
    repeat: bool,
}

/// Most keys of a path.
const MOST_KEYS: usize = 100_000;
/// Latest time of a key, seconds.
const LATEST_S: f32 = 100_000.0;
/// How far the last key of a repeated path may be from the first, metres.
const SAME_PLACE_M: f32 = 1e-3;
/// And how far it may be turned from it, degrees.
const SAME_TURN_DEG: f32 = 0.2;

impl Path {
    /// A thing that rests.
    pub fn still(position: Vec3) -> Self {
        Self::checked(
            vec![PathKey { time_s: 0.0, position, rotation: Quat::IDENTITY }],
            false,
            false,
        )
    }

    /// From keys that are in order.
    fn checked(keys: Vec<PathKey>, smooth: bool, repeat: bool) -> Self {
        let velocities = if smooth { spline::velocities(&keys, repeat) } else { Vec::new() };
        Self { keys, velocities, smooth, repeat }
    }

    /// From a scene's keys.
    pub(crate) fn from_file(file: &PathFile, key: &Key) -> Result<Self, Problem> {
        let (count, keys_at) =
            (file.keys.len(), if file.listed { key.clone() } else { key.at("keys") });
        if count == 0 {
            return Err(keys_at.problem("is empty: give at least one key, (time_s, x, y, z)"));
        }
        if count > MOST_KEYS {
            return Err(keys_at.problem(format!("{count} keys: at most {MOST_KEYS} are taken")));
        }
        let mut keys: Vec<PathKey> = Vec::with_capacity(count);
        for (i, file) in file.keys.iter().enumerate() {
            let key = keys_at.index(i);
            let before = keys.last().map_or(f32::NEG_INFINITY, |key| key.time_s);
            key.within(file.time_s, 0.0, LATEST_S)?;
            if file.time_s <= before {
                let cause = format!("time {} must be after the one before, {before}", file.time_s);
                return Err(key.problem(cause));
            }
            let position = key.vector(file.at)?;
            let rotation = euler_deg(key.vector(file.rotate_deg)?);
            keys.push(PathKey { time_s: file.time_s, position, rotation });
        }
        if file.repeat {
            check_repeat(&keys, key)?;
        }
        Ok(Self::checked(keys, file.smooth, file.repeat))
    }

    /// The keys, by rising time.
    pub fn keys(&self) -> &[PathKey] {
        &self.keys
    }

    /// Whether it moves or turns at all.
    pub fn moves(&self) -> bool {
        self.keys.windows(2).any(|pair| match pair {
            [a, b] => a.position != b.position || a.rotation != b.rotation,
            _ => false,
        })
    }

    /// Place and turn at a time, seconds, any finite one. In double precision: after a day a single
    /// one steps by 8 ms.
    pub fn pose_at(&self, time_s: f64) -> Pose {
        self.pose_within(self.own_time(time_s))
    }

    /// The same without repetition.
    fn pose_within(&self, time_s: f64) -> Pose {
        let after = self.keys.partition_point(|key| f64::from(key.time_s) <= time_s);
        let Some(next) = self.keys.get(after).or(self.keys.last()) else {
            return Pose::default();
        };
        let from = after.saturating_sub(1);
        let last = self.keys.get(from).unwrap_or(next);
        let span_s = next.time_s - last.time_s;
        let share = (time_s - f64::from(last.time_s)) / f64::from(span_s);
        let t = if span_s > 0.0 { share.clamp(0.0, 1.0) as f32 } else { 0.0 };
        let translation = match (self.velocities.get(from), self.velocities.get(after)) {
            (Some(&start), Some(&end)) if self.smooth && span_s > 0.0 => {
                spline::between(last.position, start * span_s, next.position, end * span_s, t)
            }
            _ => last.position.lerp(next.position, t),
        };
        Pose { translation, rotation: last.rotation.slerp(next.rotation, t).normalize() }
    }

    /// Time on the path itself.
    fn own_time(&self, time_s: f64) -> f64 {
        match (self.keys.first(), self.keys.last()) {
            (Some(first), Some(last)) if self.repeat && last.time_s > first.time_s => {
                let [from_s, to_s] = [first, last].map(|key| f64::from(key.time_s));
                from_s + (time_s - from_s).rem_euclid(to_s - from_s)
            }
            _ => time_s,
        }
    }
}

/// A path that jumps back to its start would sweep through everything on the way.
fn check_repeat(keys: &[PathKey], key: &Key) -> Result<(), Problem> {
    let (Some(first), Some(last)) = (keys.first(), keys.last()) else { return Ok(()) };
    if keys.len() < 2 {
        return Err(key.at("repeat").problem("needs two keys or more"));
    }
    if first.position.distance(last.position) > SAME_PLACE_M {
        let cause = format!(
            "the last key must be where the first is, {}, but it is at {}",
            first.position, last.position
        );
        return Err(key.at("repeat").problem(cause));
    }
    // A rotation and its negative are the same turn
    let cosine = first.rotation.dot(last.rotation).abs().min(1.0);
    let angle_deg = 2.0 * cosine.acos().to_degrees();
    if angle_deg > SAME_TURN_DEG {
        let cause = format!(
            "the last key must be turned as the first is, but is {angle_deg:.1} degrees off"
        );
        return Err(key.at("repeat").problem(cause));
    }
    Ok(())
}

/// Turns about x, then y, then z, each about the world's axis: as a matrix product, z y x.
pub(crate) fn euler_deg(degrees: Vec3) -> Quat {
    let [x, y, z] = degrees.to_array().map(f32::to_radians);
    Quat::from_euler(EulerRot::ZYX, z, y, x)
}

#[cfg(test)]
mod tests;
