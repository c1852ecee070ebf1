//! Pictures of models: seen from the side or from above, in parallel, without light.

use super::kinds::model;
use super::mesh::triangles;
use super::model::Model;
use super::{Angle, Plant};
use crate::bake::raster::{Tile, Window};
use glam::{Mat3, Vec2, Vec3};

/// Samples a side of a texel.
const SAMPLES: u32 = 6;

/// Turns a model so that whoever looks is at z above all, with the picture's right along x.
fn to_view(angle: Angle) -> Mat3 {
    match angle {
        Angle::Side { turned } => Mat3::from_rotation_y(-turned),
        Angle::Above => Mat3::from_rotation_x(std::f32::consts::FRAC_PI_2),
    }
}

/// A picture that holds the plant's box: from the side its width and its height, from above its
/// width both ways.
pub(super) fn paint_model(model: &Model, width_share: f32, angle: Angle, size: u32) -> Tile {
    let half = 0.5 * width_share;
    let (center, half) = match angle {
        Angle::Side { .. } => (Vec3::Y * 0.5, Vec2::new(half, 0.5)),
        Angle::Above => (Vec3::ZERO, Vec2::splat(half)),
    };
    let (right, up) = (Vec3::X, Vec3::Y);
    let window = Window { center, right, up, half, size: [size; 2], samples: SAMPLES };
    // What the foremost ribbon lets pass, as the near form is lit, and not all behind it: a tile
    // keeps the sum of thicknesses, but of heights those of what shows
    let mut list = triangles(model, to_view(angle));
    list.iter_mut().flatten().for_each(|corner| corner.height_share = corner.thickness);
    let mut tile = window.see(&list).tile();
    tile.texels.iter_mut().for_each(|texel| texel.thickness = texel.height_share);
    tile
}

/// A picture of a variant.
pub(super) fn paint(plant: Plant, seed: u64, angle: Angle, size: u32) -> Tile {
    paint_model(&model(plant, seed), plant.width_share(), angle, size)
}
