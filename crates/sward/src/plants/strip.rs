//! The texture of a strip: a blade of grass with a midrib and veins, round at its tip.

use crate::bake::raster::{Texel, Tile};
use glam::Vec3;

/// Samples a side of a texel.
const SAMPLES: u32 = 4;
/// Where the blade begins to narrow, of its length.
const SHOULDER: f32 = 0.62;
/// Veins on each side of the midrib.
const VEINS: f32 = 5.0;

/// Half of the width at a share of the length, of half the picture: a long, rounded tip.
fn half_width(v: f32) -> f32 {
    let t = ((v - SHOULDER) / (1.0 - SHOULDER)).clamp(0.0, 1.0);
    let rise = (v / 0.35).min(1.0);
    let root = 0.7 + 0.28 * rise * rise * (3.0 - 2.0 * rise);
    root * (1.0 - t.powf(2.6)).max(0.0).sqrt()
}

/// A grey that a tint multiplies: bright between the veins, a light midrib in a dark groove, darker
/// towards the root; `u` is -1..1 across.
fn shade(u: f32, v: f32) -> f32 {
    let across = u / half_width(v).max(0.05);
    let vein = (across.abs() * VEINS).fract();
    let groove = 1.0 - 0.22 * (1.0 - (2.0 * vein - 1.0).abs()).powi(3);
    let rib = 0.22 * (-(across / 0.06).powi(2)).exp() - 0.16 * (-(across / 0.2).powi(2)).exp();
    // Fine bands along it, as blades have from their growth
    let growth = 1.0 + 0.04 * (v * 41.0 + 2.0 * across).sin();
    (0.8 * groove * growth + rib) * (0.72 + 0.28 * v.powf(0.6))
}

/// Tilted to both sides of the midrib, and a little at each vein.
fn normal(u: f32, v: f32) -> Vec3 {
    let across = u / half_width(v).max(0.05);
    let fold = 0.35 * (across / 0.15).clamp(-1.0, 1.0);
    let vein = 0.18 * (across.abs() * VEINS * std::f32::consts::TAU).sin() * across.signum();
    Vec3::new(fold + vein, 0.0, 1.0).normalize()
}

/// The picture: colour as a shade of green that is neutral enough for a tint, cut at its outline.
pub(crate) fn strip(size: u32) -> Tile {
    let texels = (0..size * size).map(|index| texel(index % size, index / size, size));
    let mut tile = Tile { size: [size; 2], texels: texels.collect() };
    tile.dilate();
    tile
}

fn texel(x: u32, y: u32, size: u32) -> Texel {
    let mut sum = Texel::EMPTY;
    for sample in 0..SAMPLES * SAMPLES {
        let place = |cell: u32, part: u32| {
            (cell as f32 + (part as f32 + 0.5) / SAMPLES as f32) / size as f32
        };
        let u = 2.0 * place(x, sample % SAMPLES) - 1.0;
        let v = 1.0 - place(y, sample / SAMPLES);
        if u.abs() > half_width(v) {
            continue;
        }
        sum.albedo += Vec3::splat(shade(u, v));
        sum.normal += normal(u, v);
        sum.height_share += v;
        sum.alpha += 1.0;
    }
    if sum.alpha == 0.0 {
        return Texel::EMPTY;
    }
    Texel {
        albedo: sum.albedo / sum.alpha,
        alpha: sum.alpha / (SAMPLES * SAMPLES) as f32,
        normal: sum.normal.normalize_or(Vec3::Z),
        height_share: sum.height_share / sum.alpha,
        thickness: 1.0,
    }
}
