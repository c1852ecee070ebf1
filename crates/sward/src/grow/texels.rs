//! Images sampled where a blade stands.

use glam::Vec2;
use std::ops::{Add, Mul};

/// Samples an image of values, wrapping; texel (0, 0) is centred at half a texel.
pub(crate) fn bilinear<T>(width: u32, height: u32, at: Vec2, value: impl Fn(usize) -> T) -> T
where
    T: Mul<f32, Output = T> + Add<Output = T>,
{
    let size = Vec2::new(width as f32, height as f32);
    // Rounding can make the fraction 1; the wrap below takes that as 0.
    let at = (at - at.floor()) * size - 0.5;
    let base = at.floor();
    let t = at - base;
    let texel = |dx: i64, dy: i64| {
        let x = (base.x as i64 + dx).rem_euclid(i64::from(width));
        let y = (base.y as i64 + dy).rem_euclid(i64::from(height));
        value((y * i64::from(width) + x) as usize)
    };
    let row = |dy| texel(0, dy) * (1.0 - t.x) + texel(1, dy) * t.x;
    row(0) * (1.0 - t.y) + row(1) * t.y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_wrap_and_blend() {
        let values = [0.0, 1.0, 0.5, 0.25];
        let at = |u, v| bilinear(2, 2, Vec2::new(u, v), |i| values[i]);
        assert_eq!(at(0.25, 0.25), 0.0);
        assert_eq!(at(0.75, 0.25), 1.0);
        assert_eq!(at(0.25, 0.75), 0.5);
        assert_eq!(at(-0.25, 1.25), 1.0);
        assert_eq!(at(0.5, 0.25), 0.5);
        assert_eq!(at(0.0, 0.25), 0.5, "wraps between the last and the first texel");
    }
}
