//! Paths over ground: heights above it, and balls that roll.

use super::{Path, PathKey};
use crate::check::{Key, Problem};
use crate::objects::ground::Ground;
use glam::{Quat, Vec3, Vec3Swizzles};

/// Ground is looked up at least this often on the way, metres.
const STEP_M: f32 = 0.05;
/// Stretches of a smooth curve between two of its keys: straight ones in place of it are then at most
/// about 0.1 % of its length off.
const CURVE_STEPS: f32 = 32.0;
/// Most keys of the path that follows: 10 km, half of that where it is smooth.
const MOST_STEPS: usize = 200_000;
/// A ball this share of its radius above the ground still rolls.
const TOUCHING: f32 = 0.1;

/// The path with its heights, so far above ground, raised to it and by `lift_m` more. It has all the
/// path's keys, and more between them wherever it moves over the ground, so its speed does not
/// matter. Where a path leaves the ground, the last height holds.
pub(crate) fn along_ground(
    path: &Path,
    ground: &Ground,
    lift_m: f32,
    key: &Key,
) -> Result<Path, Problem> {
    let mut floor = ground.min.y;
    let mut keys = sampled(path, key)?;
    for key in &mut keys {
        floor = ground.height(key.position.xz()).unwrap_or(floor);
        key.position.y += floor + lift_m;
    }
    Ok(Path::checked(keys, false, path.repeat))
}

/// The path of a ball that rolls wherever it touches the ground. Heights of `above` are those over
/// the ground, at the same times.
pub(crate) fn rolling(path: &Path, above: &Path, ground: &Ground, radius_m: f32) -> Path {
    let mut turned = Quat::IDENTITY;
    let mut last: Option<PathKey> = None;
    let keys = path.keys.iter().map(|key| {
        if let Some(last) = last {
            let height = above.pose_at(key.time_s.into()).translation.y;
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

/// The path's keys and those between them.
fn sampled(path: &Path, key: &Key) -> Result<Vec<PathKey>, Problem> {
    let mut keys: Vec<PathKey> = path.keys.first().copied().into_iter().collect();
    for pair in path.keys.windows(2) {
        let [from, to] = pair else { continue };
        // No coordinate turns back between two keys, so no way is longer
        let most_m = (to.position - from.position).abs().element_sum();
        let steps = steps(most_m, path.smooth);
        if keys.len() + steps as usize > MOST_STEPS {
            return Err(key.problem(format!(
                "is too long to follow the ground: it takes a place every {STEP_M} m, and at most \
                 {MOST_STEPS}; shorten it, or give heights without `above`"
            )));
        }
        keys.extend((1..steps).map(|step| {
            let share = step as f32 / steps as f32;
            let time_s = from.time_s + (to.time_s - from.time_s) * share;
            let pose = path.pose_within(time_s.into());
            PathKey { time_s, position: pose.translation, rotation: pose.rotation }
        }));
        keys.push(*to);
    }
    Ok(keys)
}

/// Stretches between two keys.
fn steps(most_m: f32, smooth: bool) -> u32 {
    // On a smooth way the speed is up to twice the mean
    let (factor, least) = if smooth && most_m > 0.0 { (2.0, CURVE_STEPS) } else { (1.0, 1.0) };
    (factor * most_m / STEP_M).ceil().max(least) as u32
}
