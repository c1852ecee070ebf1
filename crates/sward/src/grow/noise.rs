//! Smooth noise: gradient noise for terrain, value noise for the meadow's patches of tall grass.

use super::random::mix;
use glam::{Vec2, Vec3};

fn corner(seed: u64, x: i64, y: i64, z: i64) -> u64 {
    mix(seed ^ mix((x as u64) ^ mix((y as u64) ^ mix(z as u64))))
}

/// Quintic fade: first and second derivative are 0 at both ends, so that shading shows no grid.
fn fade(t: f32) -> f32 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

fn lerp(a: f32, b: f32, t: f32) -> f32 {
    a + (b - a) * t
}

/// Gradient noise in the plane, about -1..=1, mean 0, features about 1 apart.
pub(crate) fn gradient(seed: u64, at: Vec2) -> f32 {
    let base = at.floor();
    let inside = at - base;
    let (x, y) = (base.x as i64, base.y as i64);
    let dot = |i: i64, j: i64| {
        let bits = corner(seed, x.wrapping_add(i), y.wrapping_add(j), 0);
        let angle = (bits >> 40) as f32 * (std::f32::consts::TAU / 16_777_216.0);
        Vec2::from_angle(angle).dot(inside - Vec2::new(i as f32, j as f32))
    };
    let (u, v) = (fade(inside.x), fade(inside.y));
    let low = lerp(dot(0, 0), dot(1, 0), u);
    let high = lerp(dot(0, 1), dot(1, 1), u);
    lerp(low, high, v) * std::f32::consts::SQRT_2
}

/// Value noise in space, 0..=1, features about 1 apart.
pub(crate) fn value(seed: u64, at: Vec3) -> f32 {
    let base = at.floor();
    let inside = at - base;
    let (x, y, z) = (base.x as i64, base.y as i64, base.z as i64);
    let (u, v, w) = (fade(inside.x), fade(inside.y), fade(inside.z));
    let level = |k: i64| {
        let cell = |i: i64, j: i64| {
            let bits = corner(seed, x.wrapping_add(i), y.wrapping_add(j), z.wrapping_add(k));
            (bits >> 40) as f32 * (1.0 / 16_777_216.0)
        };
        lerp(lerp(cell(0, 0), cell(1, 0), u), lerp(cell(0, 1), cell(1, 1), u), v)
    };
    lerp(level(0), level(1), w)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_smooth_and_in_range() {
        let mut last = gradient(1, Vec2::ZERO);
        let (mut low, mut high) = (f32::MAX, f32::MIN);
        for i in 1..20_000 {
            let at = Vec2::new(i as f32 * 0.01, i as f32 * 0.003);
            let now = gradient(1, at);
            assert!((now - last).abs() < 0.06, "jump at {at}");
            last = now;
            (low, high) = (low.min(now), high.max(now));
            let v = value(1, at.extend(0.3));
            assert!((0.0..=1.0).contains(&v));
        }
        assert!(low < -0.5 && low > -1.01 && high > 0.5 && high < 1.01, "{low} {high}");
    }
}
