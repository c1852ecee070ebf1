//! What the shaders and the host share, member by member. A test compares each struct with its
//! WGSL counterpart through naga.
//!
//! # A blade in 16 static bytes
//! | word | bits | content | precision |
//! |---|---|---|---|
//! | 0 | 16 + 16 | root x, y in the patch's cube | edge / 65535: 0.05 mm in a 3 m patch |
//! | 1 | 16 + 8 + 8 | root z, species, response | response range / 255 |
//! | 2 | 16 + 16 | up, octahedral | 0.004 degrees |
//! | 3 | 12 + 12 + 8 | facing, height, width | 0.09 degrees, height range / 4095, width range / 255 |
//!
//! # Its 8 dynamic bytes
//! Direction of the tip in the blade's own frame (24 + 24 bits, half octahedral) and crush (16 bits
//! over 0..2, rounded up or down by turns so that the error of many small steps does not add up).
//! `PhysicsModel::Paper` keeps a length as well: 17 + 17 + 14 + 16.
//!
//! # Its colour, in a field that takes its surface's
//! 4 bytes more: 10 bits a channel, square root encoded, of the surface at the root. Fields without
//! a colour map have no such bytes: their static and dynamic data and lists stay below 32.
//!
//! # What else grows with the blades
//! Per blade 4 bytes of draw list and 2 of decisions; per 64 blades 64 bytes of clocks, counts,
//! offsets and sway, and a work entry (8); per patch its box (48), its list of near colliders (128) and
//! another work entry (8).

use crate::frame::wind::GpuWindSource;
use bytemuck::{Pod, Zeroable};

/// Blades of one workgroup.
pub const BAND: u32 = 64;
/// Bands of one block of the scan.
pub const BLOCK: u32 = 256;
/// Draw lists: 0 to 7 blades (four levels, pointed and flat-tipped), 8 clusters, 9 and 10 strips of
/// many and few rings, 11 and 12 billboards near and far, 13 modelled plants. Number 15 is none.
pub const BUCKETS: usize = 16;
/// Of them, those of single blades.
pub const BLADE_BUCKETS: usize = 8;
/// Clusters.
pub const CLUSTER_BUCKET: usize = 8;
/// Strips of many rings, and of few.
pub const STRIP_BUCKETS: [usize; 2] = [9, 10];
/// Billboards in the middle band, and in the far one.
pub const BILLBOARD_BUCKETS: [usize; 2] = [11, 12];
/// Modelled plants.
pub const MODEL_BUCKET: usize = 13;
/// Words of a patch's list of near colliders: 2, and 3 for each of up to [`NEAR_SLOTS`] chunks.
pub const NEAR_STRIDE: u32 = 32;
/// Most chunks of primitives in a patch's list.
#[cfg(test)]
pub const NEAR_SLOTS: u32 = 10;
/// Primitives of one chunk.
pub const CHUNK: usize = 64;
/// Entries of a chunk: its box, then its primitives.
pub const CHUNK_STRIDE: usize = CHUNK + 1;
/// Most blades of a page: the draw list has 22 bits for a blade's index.
pub const PAGE_BLADES: u64 = 1 << 22;
/// Most pages of a field.
pub const MAX_PAGES: u64 = 16;
/// Most species of a field.
pub const MAX_SPECIES: usize = 256;
/// Most wind sources at once.
pub const MAX_WIND_SOURCES: usize = 64;
/// Resolution of the clock that sleeping blades are timed with.
pub const TICKS_PER_SECOND: f64 = 16384.0;

/// `GpuFrame` of frame.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub struct GpuFrame {
    pub gravity_direction: [f32; 4],
    pub gravity_center: [f32; 4],
    pub to_sun: [f32; 4],
    pub sun: [f32; 4],
    pub sky: [f32; 4],
    pub ground: [f32; 4],
    pub haze: [f32; 4],
    pub sway: [f32; 4],
    pub shade: [f32; 4],
    pub dt_s: f32,
    pub gravity_blend: f32,
    pub crush_decay: f32,
    pub physics_model: u32,
    pub wind_count: u32,
    pub chunk_count: u32,
    pub step: u32,
    pub ticks: u32,
    pub resting_chunks: u32,
    pub keep_resting: u32,
    pub shade_x: f32,
    pub shade_y: f32,
    pub wind_sources: [GpuWindSource; MAX_WIND_SOURCES],
}

/// `GpuField` of field.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub struct GpuField {
    pub blade_count: u32,
    pub patch_count: u32,
    pub patch_size: u32,
    pub first_id: u32,
    pub cluster: [f32; 4],
    pub layers: [f32; 2],
    pub reserved_a: f32,
    pub reserved_b: f32,
}

/// `GpuPage` of field.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub struct GpuPage {
    pub field: GpuField,
    pub species: [GpuSpecies; MAX_SPECIES],
}

/// `GpuPatch` of field.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub struct GpuPatch {
    pub origin: [f32; 3],
    pub edge: f32,
    pub reach_min: [f32; 3],
    pub cell: u32,
    pub reach_max: [f32; 3],
    pub max_width: f32,
}

/// `GpuSpecies` of field.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub struct GpuSpecies {
    pub height: [f32; 2],
    pub width: [f32; 2],
    pub response: [f32; 2],
    pub droop: [f32; 2],
    pub gust: f32,
    pub arch: f32,
    pub first_bucket: u32,
    pub tint: f32,
    pub form: [f32; 4],
    pub area_scale: [f32; 4],
    pub colors: [u32; 4],
    pub look: [u32; 4],
    pub look_values: [f32; 4],
}

/// `GpuView` of view.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub struct GpuView {
    pub clip_from_world: [[f32; 4]; 4],
    pub eye: [f32; 4],
    pub depth_row: [f32; 4],
    pub planes: [[f32; 4]; 6],
    pub depth_from_value: [f32; 4],
    pub size: [f32; 2],
    pub focal: f32,
    pub detail: f32,
    pub least_width: f32,
    pub max_distance: f32,
    pub flags: u32,
    pub capacity: u32,
    pub level_height: [f32; 2],
    pub cluster_height: [f32; 2],
    pub technique: u32,
    pub least_cluster: f32,
    pub far_share: f32,
    pub far_size: f32,
    pub bands: [f32; 4],
    pub level_scale: f32,
    pub reserved_a: f32,
    pub reserved_b: f32,
    pub reserved_c: f32,
}

/// `GpuBand` of band.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub struct GpuBand {
    pub step: u32,
    pub ticks: u32,
    pub culled: u32,
    pub tested: u32,
    pub counts: [u32; 8],
    pub anchor_step: u32,
    pub anchor_ticks: u32,
    pub sway: [u32; 2],
}

/// `GpuBlock` of band.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub struct GpuBlock {
    pub buckets: [u32; 16],
    pub counted: [u32; 8],
}

/// `GpuDraw` of draws.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Pod, Zeroable)]
pub struct GpuDraw {
    pub start: u32,
    pub count: u32,
    pub dropped: u32,
    pub reserved: u32,
}

/// `GpuLook` of canopy.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct GpuLook {
    pub waves: [[f32; 4]; 15],
    pub around: [f32; 4],
    pub tilt: [f32; 4],
}

/// `GpuBent` of canopy.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct GpuBent {
    pub mean: GpuLook,
    pub first: GpuLook,
    pub second: GpuLook,
    pub third: GpuLook,
    pub across: [[f32; 4]; 10],
    pub across_double: [[f32; 4]; 10],
}

/// `GpuCanopyRow` of canopy.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct GpuCanopyRow {
    pub shown: [f32; 4],
    pub rest: GpuLook,
    pub winds: [GpuBent; 3],
}

/// `GpuCanopy` of canopy.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct GpuCanopy {
    pub size: [f32; 4],
    pub pose: [f32; 4],
    pub tint: [f32; 4],
    pub tint_mean: [f32; 4],
    pub cards: [[f32; 4]; 8],
    pub rows: [GpuCanopyRow; 6],
}

impl GpuCanopy {
    /// Of no grass.
    pub fn empty() -> Self {
        let mut canopy = Self::zeroed();
        for row in &mut canopy.rows {
            row.rest.around[3] = 1.0;
            row.winds.iter_mut().for_each(|wind| wind.mean.around[3] = 1.0);
        }
        canopy.tint_mean = [1.0; 4];
        canopy
    }
}
