//! The smooth way between keys: a cubic through them all that never overshoots.
//!
//! Velocities are Steffen's (A simple method for monotonic interpolation in one dimension, 1990),
//! for each axis by itself. Between two keys no coordinate leaves the range of the two, so a thing
//! that two keys hold still does rest, and one that is to end on the ground does not dip below it.

use super::PathKey;
use glam::Vec3;

/// Velocity at each key, metres a second.
pub(super) fn velocities(keys: &[PathKey], repeat: bool) -> Vec<Vec3> {
    let slopes: Vec<_> = keys
        .windows(2)
        .filter_map(|pair| match pair {
            [a, b] => Some(Slope::new(a, b)),
            _ => None,
        })
        .collect();
    let around = if repeat { slopes.last().zip(slopes.first()) } else { None };
    let joint = around.map(|(before, after)| at_key(before, after));
    (0..keys.len())
        .map(|i| match (i.checked_sub(1).and_then(|i| slopes.get(i)), slopes.get(i)) {
            (Some(before), Some(after)) => at_key(before, after),
            // A path sets off and arrives at the speed of its first and last stretch
            (Some(end), None) | (None, Some(end)) => joint.unwrap_or(end.slope),
            (None, None) => Vec3::ZERO,
        })
        .collect()
}

/// Between two keys.
struct Slope {
    span_s: f32,
    slope: Vec3,
}

impl Slope {
    fn new(a: &PathKey, b: &PathKey) -> Self {
        let span_s = b.time_s - a.time_s;
        Self { span_s, slope: (b.position - a.position) / span_s }
    }
}

fn at_key(before: &Slope, after: &Slope) -> Vec3 {
    let weighted = before.slope * after.span_s + after.slope * before.span_s;
    let parabola = weighted / (before.span_s + after.span_s);
    let axis = |a: f32, b: f32, p: f32| {
        let sign = a.signum() + b.signum();
        // 0 where the two slopes differ in sign: the key is a turning point
        0.5 * sign * (2.0 * a.abs().min(b.abs())).min(p.abs())
    };
    let (a, b) = (before.slope, after.slope);
    Vec3::new(axis(a.x, b.x, parabola.x), axis(a.y, b.y, parabola.y), axis(a.z, b.z, parabola.z))
}

/// Hermite's cubic from `a` to `b`, whose ends have these tangents.
pub(super) fn between(a: Vec3, start: Vec3, b: Vec3, end: Vec3, t: f32) -> Vec3 {
    let way = b - a;
    // Written from `a` on, so that the ends are met to the bit
    let back = t - 1.0;
    if t >= 1.0 {
        return b;
    }
    a + way * (t * t * (3.0 - 2.0 * t)) + start * (t * back * back) + end * (t * t * back)
}
