//! Blades, species and patches to their GPU form, and a blade back again.

use super::layout::{GpuPatch, GpuSpecies, MAX_SPECIES};
use crate::frame::sweep::patches::NO_CELL;
use crate::grow::{Blade, Patch};
use crate::plants::layers::{LayerRange, PlantLayers};
use crate::species::{Form, Range, Shape, Species};
use crate::{Field, Look};
use bytemuck::Zeroable;
use glam::{Vec2, Vec3};
use std::f32::consts::TAU;

/// Two unit vectors perpendicular to a unit `up` and to each other; facing turns from the first to
/// the second.
pub fn tangent_frame(up: Vec3) -> (Vec3, Vec3) {
    if up.y < -0.55 {
        let second = Vec3::new(0.0, up.z, -up.y).normalize_or(Vec3::Z);
        return (second.cross(up), second);
    }
    let a = 1.0 / (1.0 + up.y);
    let b = -up.x * up.z * a;
    (Vec3::new(1.0 - up.x * up.x * a, -up.x, b), Vec3::new(b, -up.z, 1.0 - up.z * up.z * a))
}

fn oct_encode(v: Vec3) -> Vec2 {
    let sum = (v.x.abs() + v.y.abs() + v.z.abs()).max(1e-12);
    let e = Vec2::new(v.x, v.z) / sum;
    if v.y >= 0.0 {
        return e;
    }
    let sign = |x: f32| if x >= 0.0 { 1.0 } else { -1.0 };
    Vec2::new((1.0 - e.y.abs()) * sign(e.x), (1.0 - e.x.abs()) * sign(e.y))
}

fn oct_decode(e: Vec2) -> Vec3 {
    let y = 1.0 - e.x.abs() - e.y.abs();
    let fold = (-y).max(0.0);
    let unfold = |x: f32| x - if x >= 0.0 { fold } else { -fold };
    Vec3::new(unfold(e.x), y, unfold(e.y)).normalize_or(Vec3::Y)
}

fn snorm16(x: f32) -> u32 {
    u32::from((x.clamp(-1.0, 1.0) * 32767.0).round() as i16 as u16)
}

fn from_snorm16(bits: u32) -> f32 {
    (f32::from(bits as u16 as i16) / 32767.0).max(-1.0)
}

/// Where `value` lies in a range, in `0..=steps`.
fn step_in(range: Range, value: f32, steps: f32) -> u32 {
    let span = range.max - range.min;
    if span <= 0.0 {
        return 0;
    }
    (((value - range.min) / span).clamp(0.0, 1.0) * steps).round() as u32
}

/// The cube that a patch's roots are quantised in: its corner and edge.
pub fn patch_cube(patch: &Patch) -> (Vec3, f32) {
    let edge = (patch.root_max - patch.root_min).max_element().max(1e-6);
    (patch.root_min, edge)
}

fn unpack_up(halves: [u32; 2]) -> Vec3 {
    oct_decode(Vec2::from_array(halves.map(from_snorm16)))
}

/// The blade's facing as an angle about the quantised `up`: the tangent frame has a seam, and the
/// two may lie on different sides of it.
fn facing_about(up: Vec3, blade: &Blade) -> f32 {
    let (first, second) = tangent_frame(blade.up);
    let facing = first * blade.facing.cos() + second * blade.facing.sin();
    let (first, second) = tangent_frame(up);
    facing.dot(second).atan2(facing.dot(first))
}

/// The 16 static bytes of a blade.
pub fn pack_blade(blade: &Blade, patch: &Patch, species: &Species) -> [u32; 4] {
    let (origin, edge) = patch_cube(patch);
    let q = ((blade.root - origin) / edge).clamp(Vec3::ZERO, Vec3::ONE) * 65535.0;
    let (x, y, z) = (q.x.round() as u32, q.y.round() as u32, q.z.round() as u32);
    let response = step_in(species.response, blade.response, 255.0);
    let up = oct_encode(blade.up);
    let up = [snorm16(up.x), snorm16(up.y)];
    let facing = (facing_about(unpack_up(up), blade) / TAU * 4096.0).round() as i64 as u32 & 0xfff;
    let height = step_in(species.height_m, blade.height, 4095.0);
    let width = step_in(species.width_m, blade.width, 255.0);
    [
        x | y << 16,
        z | u32::from(blade.species) << 16 | response << 24,
        up[0] | up[1] << 16,
        facing | height << 12 | width << 24,
    ]
}

/// The blade that the shaders see: the twin of `unpack_blade` in field.wgsl.
#[cfg(test)]
pub fn unpack_blade(words: [u32; 4], patch: &Patch, species: &[Species]) -> Blade {
    let (origin, edge) = patch_cube(patch);
    let q =
        Vec3::new((words[0] & 0xffff) as f32, (words[0] >> 16) as f32, (words[1] & 0xffff) as f32);
    let kind = (words[1] >> 16 & 0xff) as u8;
    let own = &species[usize::from(kind)];
    Blade {
        root: origin + q * (edge / 65535.0),
        up: unpack_up([words[2] & 0xffff, words[2] >> 16]),
        facing: (words[3] & 0xfff) as f32 * (TAU / 4096.0),
        height: own.height_m.at((words[3] >> 12 & 0xfff) as f32 / 4095.0),
        width: own.width_m.at((words[3] >> 24) as f32 / 255.0),
        response: own.response.at((words[1] >> 24) as f32 / 255.0),
        species: kind,
    }
}

/// A patch's box and cube.
pub fn gpu_patch(patch: &Patch, blades: &[Blade]) -> GpuPatch {
    let (origin, edge) = patch_cube(patch);
    let own = &blades[patch.first as usize..(patch.first + patch.count) as usize];
    GpuPatch {
        origin: origin.to_array(),
        edge,
        reach_min: patch.reach_min.to_array(),
        cell: NO_CELL,
        reach_max: patch.reach_max.to_array(),
        max_width: own.iter().fold(0.0, |m, b| m.max(b.width)),
    }
}

/// Share of the width left at `v` (J equation 22): the twin of `outline` in outline.wgsl.
pub fn outline(shape: Shape, v: f32) -> f32 {
    match shape {
        // A dandelion's pixels are cut from the full width
        Shape::Quad | Shape::Dandelion => 1.0,
        Shape::Triangle => 1.0 - v,
        Shape::Quadratic => 1.0 - v * v,
        Shape::TriangleTip { tip } => 1.0 - (v - tip).max(0.0) / (1.0 - tip),
    }
}

/// Area of the outline drawn with so many segments, for a blade at rest, whose curve parameter
/// runs as 2v - v^2 along its length.
fn outline_area(shape: Shape, segments: u32) -> f32 {
    let along = |v: f32| 2.0 * v - v * v;
    (0..segments)
        .map(|k| {
            let (v0, v1) = (k as f32 / segments as f32, (k + 1) as f32 / segments as f32);
            0.5 * (outline(shape, v0) + outline(shape, v1)) * (along(v1) - along(v0))
        })
        .sum()
}

/// Segments of each level.
pub const SEGMENTS: [u32; 4] = [8, 4, 2, 1];

/// Mean width that a folded blade shows from all around, over that of a flat one: a convex outline
/// shows its perimeter over pi (Cauchy). Levels without the ridge are wider by it.
fn folded_width(ridge: f32) -> f32 {
    (1.0 + (1.0 + ridge * ridge).sqrt()) / 2.0
}

/// Area of blades over an area of ground, of a whole field: its leaf area index.
fn leaf_area_index(blades: &[Blade], patches: &[Patch]) -> f32 {
    // In f64: in f32 the sum of a large field stops growing
    let leaves: f64 = blades.iter().map(|b| 0.75 * f64::from(b.height * b.width)).sum();
    let ground: f64 = patches
        .iter()
        .map(|patch| {
            let size = patch.root_max - patch.root_min;
            // Its two longest sides: the third is the ground's relief
            f64::from((size.x * size.y).max(size.y * size.z).max(size.x * size.z))
        })
        .sum();
    (leaves / ground.max(1e-6)) as f32
}

/// Share of the sky that reaches the roots (Beer-Lambert), where blades stand every way.
fn root_openness(leaf_area_index: f32) -> f32 {
    (-0.8 * leaf_area_index).exp().clamp(0.12, 0.85)
}

/// Share of the sky that reaches the roots of a field.
pub fn field_openness(field: &Field) -> f32 {
    root_openness(leaf_area_index(field.blades(), field.patches()))
}

/// What the width is multiplied by at a level, so that the outline keeps its area.
pub fn area_scale(species: &Species, level: usize) -> f32 {
    let lost = if level <= 1 { 1.0 } else { folded_width(species.ridge) };
    lost * outline_area(species.shape, 256) / outline_area(species.shape, SEGMENTS[level])
}

/// The species table of a field.
pub fn species_table(field: &Field, plants: &PlantLayers) -> Vec<GpuSpecies> {
    let leaf_area = leaf_area_index(field.blades(), field.patches());
    let tint = field.tint_mix();
    let entry = |species| gpu_species(species, plants, leaf_area, tint);
    let mut table: Vec<_> = field.species().iter().map(entry).collect();
    table.resize(MAX_SPECIES, GpuSpecies::zeroed());
    table
}

/// A species' table entry, in a field of those pictures and that leaf area index, which takes so much of its surface's
/// colour.
fn gpu_species(
    species: &Species,
    plants: &PlantLayers,
    leaf_area_index: f32,
    tint: f32,
) -> GpuSpecies {
    let range = |r: Range| [r.min, r.max - r.min];
    let (shape, tip) = match species.shape {
        Shape::Quad => (0.0, 0.5),
        Shape::Triangle => (1.0, 0.5),
        Shape::Quadratic => (2.0, 0.5),
        Shape::TriangleTip { tip } => (3.0, tip),
        Shape::Dandelion => (4.0, 0.5),
    };
    let (root, top) = (species.root_color, species.tip_color);
    let (look, look_values) = species_look(species, plants);
    GpuSpecies {
        height: range(species.height_m),
        width: range(species.width_m),
        response: range(species.response),
        droop: range(species.droop),
        gust: species.gust,
        arch: species.arch,
        first_bucket: if has_flat_tip(species) { 4 } else { 0 },
        tint,
        form: [species.ridge, tip, root_openness(leaf_area_index), shape],
        area_scale: std::array::from_fn(|level| area_scale(species, level)),
        colors: [root.from, root.to, top.from, top.to].map(pack_color),
        look,
        look_values,
    }
}

/// Set in `look.w` where near plants are drawn as models.
pub const MODELLED: u32 = 0x100;

/// `look` and `look_values` of a species.
fn species_look(species: &Species, plants: &PlantLayers) -> ([u32; 4], [f32; 4]) {
    let form = species.form.number();
    let LayerRange { first, count } = match species.form.look() {
        Some(look) => plants.range(&look),
        None => plants.strip(),
    };
    match &species.form {
        Form::Billboard(b) => {
            let modelled = if matches!(b.look, Look::Plant(_)) { MODELLED } else { 0 };
            let values = [b.angle_deg.to_radians(), b.wind_turn, b.wind_tint, b.absorption];
            ([form, first, count, b.quads | modelled], values)
        }
        Form::Strip(strip) => ([form, first, count, 0], strip.values()),
        _ => ([form, first, count, 0], [0.0; 4]),
    }
}

/// 10 bits a channel, square root encoded: finer in the dark.
pub fn pack_color(color: [f32; 3]) -> u32 {
    let channel = |x: f32| (x.clamp(0.0, 1.0).sqrt() * 1023.0).round() as u32;
    channel(color[0]) | channel(color[1]) << 10 | channel(color[2]) << 20
}

/// What [`pack_color`] keeps: the twin of `unpack_color` in blade_point.wgsl.
pub fn unpack_color(bits: u32) -> [f32; 3] {
    [0, 10, 20].map(|shift| {
        let channel = (bits >> shift & 0x3ff) as f32 / 1023.0;
        channel * channel
    })
}

/// Whether the outline is drawn on a strip that ends in an edge rather than a point.
pub fn has_flat_tip(species: &Species) -> bool {
    matches!(species.shape, Shape::Quad | Shape::Dandelion)
}

#[cfg(test)]
mod tests {
    use super::{leaf_area_index, root_openness};
    use crate::grow::{Blade, Patch};
    use glam::Vec3;

    /// The index of 100 blades on a square metre whose ground is so uneven.
    fn on_ground(relief_m: f32) -> f32 {
        let blade = Blade {
            root: Vec3::ZERO,
            up: Vec3::Y,
            facing: 0.0,
            height: 0.5,
            width: 0.02,
            response: 5.0,
            species: 0,
        };
        let size = Vec3::new(1.0, relief_m, 1.0);
        let (root_min, root_max) = (Vec3::ZERO, size);
        let (reach_min, reach_max) = (root_min, root_max);
        let patch = Patch { first: 0, count: 100, root_min, root_max, reach_min, reach_max };
        leaf_area_index(&[blade; 100], &[patch])
    }

    #[test]
    fn level_ground_bears_as_much_as_uneven_ground() {
        for relief_m in [0.0, 1e-7, 1e-3, 0.2] {
            let index = on_ground(relief_m);
            assert!((index - 0.75).abs() < 1e-4, "{relief_m} m: {index}");
        }
        assert!(root_openness(0.1) > root_openness(1.0));
    }
}
