//! Paths over ground: heights above it, and balls that roll.

use super::{Path, PathKey};
use crate::objects::ground::Ground;
use glam::{Quat, Vec3, Vec3Swizzles};

/// How finely ground is followed, seconds and metres.
const STEP_S: f32 = 1.0 / 15.0;
const MOST_STEPS: f32 = 50_000.0;
/// A ball this share of its radius above the ground still rolls.
const TOUCHING: f32 = 0.1;

/// The path with its heights, so far above ground, raised to it and by `lift_m` more: keyframes
/// close enough to follow the ground. Where a path leaves it, the last height holds.
pub(crate) fn along_ground(path: &Path, ground: &Ground, lift_m: f32) -> Path {
    let mut floor = ground.min.y;
    let keys = sampled(path)
        .map(|mut key| {
            floor = ground.height(key.position.xz()).unwrap_or(floor);
            key.position.y += floor + lift_m;
            key
        })
        .collect();
    Path::checked(keys, false, path.repeat)
}

/// The path of a ball that rolls wherever it touches the ground. Heights of `above` are those over
/// the ground, at the same times.
pub(crate) fn rolling(path: &Path, above: &Path, ground: &Ground, radius_m: f32) -> Path {
    let mut turned = Quat::IDENTITY;
    let mut last: Option<PathKey> = None;
    let keys = path.keys.iter().map(|key| {
        if let Some(last) = last {
            let height = above.pose_at(key.time_s).translation.y;
            if height < TOUCHING * radius_m {
                turned = (step(last.position, key.position, ground, radius_m) * turned).normalize();
            }
        }
        last = Some(*key);
        PathKey { rotation: turned, ..*key }
    });
    Path::checked(keys.collect(), false, path.repeat)
}

/// Turn of a ball that rolls from one place to the next without sliding.
fn step(from: Vec3, to: Vec3, ground: &Ground, radius_m: f32) -> Quat {
    let way = to - from;
    let normal = ground.normal(((from + to) * 0.5).xz()).unwrap_or(Vec3::Y);
    Quat::from_scaled_axis(normal.cross(way) / radius_m)
}

/// Keys close together, from the first key's time to the last's.
fn sampled(path: &Path) -> impl Iterator<Item = PathKey> {
    let first = path.keys.first().map_or(0.0, |key| key.time_s);
    let last = path.keys.last().map_or(0.0, |key| key.time_s);
    let steps = ((last - first) / STEP_S).ceil().min(MOST_STEPS) as u32;
    (0..=steps).map(move |step| {
        let share = step as f32 / steps.max(1) as f32;
        let time_s = first + (last - first) * share;
        let pose = path.pose_within(time_s);
        PathKey { time_s, position: pose.translation, rotation: pose.rotation }
    })
}
