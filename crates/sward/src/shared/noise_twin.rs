//! Integer hashes and 2-D gradient noise, the reference of `noise.wgsl`.

use glam::{DVec2, dvec2};

/// Lattice period of [`noise2`] in cells: what drifts may wrap at without a jump.
pub const NOISE_PERIOD: u32 = 256;

/// A PCG output permutation of one linear congruential step: a bijection of `u32`.
pub fn hash_u32(value: u32) -> u32 {
    let state = value.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

/// Uniform in `0..1` (1 excluded) for an id; each salt is an independent draw. Exact in `f32`.
pub fn hash01(id: u32, salt: u32) -> f32 {
    (hash_u32(id ^ hash_u32(salt)) >> 8) as f32 / 16_777_216.0
}

/// Gradient noise in `-1..=1`, twice differentiable, of period [`NOISE_PERIOD`] on both axes.
/// Typical values lie within ±0.5.
pub fn noise2(at: DVec2, seed: u32) -> f64 {
    let base = at.floor();
    let f = at - base;
    let cell = [base.x as i64, base.y as i64];
    let corner = |x: i64, y: i64| {
        gradient([cell[0] + x, cell[1] + y], seed).dot(f - dvec2(x as f64, y as f64))
    };
    let fade = |t: f64| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
    let near = mix(corner(0, 0), corner(1, 0), fade(f.x));
    let far = mix(corner(0, 1), corner(1, 1), fade(f.x));
    mix(near, far, fade(f.y))
}

/// The gradient at a lattice point; both components in `-1..=1`.
fn gradient(cell: [i64; 2], seed: u32) -> DVec2 {
    let wrapped = cell.map(|c| c.rem_euclid(i64::from(NOISE_PERIOD)) as u32);
    let row = hash_u32(wrapped[1].wrapping_add(hash_u32(seed)));
    let bits = hash_u32(wrapped[0].wrapping_add(row));
    dvec2(f64::from(bits & 0xffff), f64::from(bits >> 16)) / 32767.5 - DVec2::ONE
}

/// WGSL's smoothstep: 0 to 1 as `value` goes `from` to `to`.
pub(crate) fn smoothstep(from: f64, to: f64, value: f64) -> f64 {
    let t = ((value - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
