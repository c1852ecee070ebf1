//! Models as triangles for the painter, and as points for the GPU.

use super::model::{Model, Ribbon};
use crate::bake::{Corner, Triangle};
use glam::{Mat3, Vec3};

/// Pieces along a painted ribbon: fine enough that no corner shows in a picture.
const FINE: u32 = 12;
/// Pieces along a drawn ribbon, and its points.
pub(crate) const PIECES: u32 = 4;
pub(crate) const RIBBON_POINTS: u32 = 2 * (PIECES + 1);
/// How far the normals at the edges turn to the sides: of flat ribbons, and of round ones.
const FLAT_TURN: f32 = 0.3;
const ROUND_TURN: f32 = 0.9;
/// Points lie within -1.25..1.25 of the plant's height and width.
pub(crate) const POINT_RANGE: f32 = 1.25;
/// Thicknesses lie within 0..5.
const THICKNESS_RANGE: f32 = 5.0;

/// One end of a ring across a ribbon.
struct Edge {
    position: Vec3,
    round: Vec3,
}

fn edges(ribbon: &Ribbon, v: f32, towards: Vec3) -> [Edge; 2] {
    let (center, across) = (ribbon.point(v), ribbon.across(v, towards));
    let turn = if ribbon.round { ROUND_TURN } else { FLAT_TURN };
    [-1.0, 1.0].map(|side| Edge {
        position: center + across * (0.5 * side * ribbon.width_at(v)),
        round: across * (side * turn),
    })
}

/// The model's triangles as `to_view` turns them: the viewer is at z above all.
pub(crate) fn triangles(model: &Model, to_view: Mat3) -> Vec<Triangle> {
    let towards = to_view.transpose() * Vec3::Z;
    let mut list = Vec::with_capacity(model.ribbons.len() * 2 * FINE as usize);
    for ribbon in &model.ribbons {
        let ring = |k: u32| {
            let v = k as f32 / FINE as f32;
            let normal = ribbon.across(v, towards).cross(ribbon.along(v));
            edges(ribbon, v, towards).map(|edge| Corner {
                position: to_view * edge.position,
                normal: to_view * normal,
                round: to_view * edge.round,
                albedo: ribbon.color(v),
                height_share: edge.position.y.clamp(0.0, 1.0),
                thickness: ribbon.thickness,
            })
        };
        let mut low = ring(0);
        for k in 1..=FINE {
            let high = ring(k);
            let ([a, b], [c, d]) = (low, high);
            list.extend([[a, b, c], [b, d, c]]);
            low = high;
        }
    }
    list
}

/// 10 bits a channel, square root encoded, as the shader unpacks it.
fn pack_color(color: Vec3) -> u32 {
    let channel = |x: f32| (x.clamp(0.0, 1.0).sqrt() * 1023.0).round() as u32;
    channel(color.x) | channel(color.y) << 10 | channel(color.z) << 20
}

fn snorm16(x: f32) -> u32 {
    u32::from((x.clamp(-1.0, 1.0) * 32767.0).round() as i16 as u16)
}

/// Octahedral, folded about y, as `oct_decode` of the shaders reads it.
fn octahedral(v: Vec3) -> u32 {
    let n = v / (v.x.abs() + v.y.abs() + v.z.abs()).max(1e-12);
    let fold = |a: f32, b: f32| if n.y >= 0.0 { a } else { (1.0 - b.abs()).copysign(a) };
    snorm16(fold(n.x, n.z)) | snorm16(fold(n.z, n.x)) << 16
}

/// The points of a ribbon of a plant so wide, ring by ring, two a ring, each one texel:
///
/// | word | bits | content |
/// |---|---|---|
/// | 0 | 16 + 16 | x in widths of the plant, y in heights, over [`POINT_RANGE`] |
/// | 1 | 16 + 16 | z in widths; half of a round ribbon's width in widths, signed by side; a flat one's thickness over 5 |
/// | 2 | 30 + 1 | colour; whether the ribbon is round |
/// | 3 | 16 + 16 | normal, or the ribbon's direction where it is round, octahedral |
///
/// The place is the ribbon's middle where it is round: the shader turns its width to the eye.
pub(crate) fn points(ribbon: &Ribbon, plant_width: f32) -> [[u32; 4]; RIBBON_POINTS as usize] {
    std::array::from_fn(|point| {
        let (ring, side) = (point / 2, point % 2);
        let v = ring as f32 / PIECES as f32;
        let sign = if side == 0 { -1.0 } else { 1.0 };
        let half = 0.5 * ribbon.width_at(v);
        let (along, across) = (ribbon.along(v), ribbon.across(v, Vec3::Z));
        let (place, direction) = if ribbon.round {
            (ribbon.point(v), along)
        } else {
            let normal = across.cross(along);
            (ribbon.point(v) + across * (sign * half), normal)
        };
        let scale = Vec3::new(plant_width, 1.0, plant_width) * POINT_RANGE;
        let [x, y, z] = (place / scale).to_array().map(snorm16);
        let thick = ribbon.thickness / THICKNESS_RANGE;
        let wide_or_thick = if ribbon.round { sign * half / scale.x } else { thick };
        [
            x | y << 16,
            z | snorm16(wide_or_thick) << 16,
            pack_color(ribbon.color(v)) | u32::from(ribbon.round) << 30,
            octahedral(direction),
        ]
    })
}
