//! Blocks of neighbouring patches that a view may see, found on the host: what is wholly out of view
//! takes no thread, so that a frame costs what it shows, however large the field.

use crate::Technique;
use crate::gpu::buffers::{uniform, write};
use crate::gpu::layout::{BAND, BLOCK, GpuPatch, GpuView, PAGE_BLADES};
use crate::gpu::view::{DISTANCE, FRUSTUM};
use glam::{Vec3, Vec4};

/// Relative slack for what this and the shader round in other ways.
const SLACK: f32 = 1e-4;

/// Patches of one block: a block is what one group of the scan sums up.
pub(crate) fn patches_a_block(patch_size: u32) -> u32 {
    BLOCK / (patch_size / BAND)
}

/// Box of every pose of a block's blades.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BlockBox {
    low: Vec3,
    high: Vec3,
}

/// The boxes of a page's blocks, in order.
pub(crate) fn block_boxes(patches: &[GpuPatch], patches_a_block: u32) -> Vec<BlockBox> {
    let around = |run: &[GpuPatch]| {
        let low = run.iter().map(|p| Vec3::from(p.reach_min)).reduce(Vec3::min);
        let high = run.iter().map(|p| Vec3::from(p.reach_max)).reduce(Vec3::max);
        BlockBox { low: low.unwrap_or_default(), high: high.unwrap_or_default() }
    };
    patches.chunks(patches_a_block as usize).map(around).collect()
}

/// Metres that clusters may reach beyond the box: at its far end, where they are widened most.
fn margin(block: &BlockBox, view: &GpuView, [_, half_width, height, _]: [f32; 4]) -> f32 {
    if view.technique != Technique::Continuum as u32 {
        return 0.0;
    }
    let eye = Vec4::from(view.eye);
    let across = (block.low - eye.truncate()).abs().max((block.high - eye.truncate()).abs());
    let far = if eye.w > 0.5 { across.length().max(1e-3) } else { 1.0 };
    let kept = (2.0 * half_width * view.focal / far / view.least_cluster).clamp(1e-3, 1.0);
    // As `widening` of level.wgsl at most, for any share
    half_width / (0.85 * kept) + height
}

fn is_outside(block: &BlockBox, margin: f32, plane: Vec4) -> bool {
    let normal = plane.truncate();
    let corner = Vec3::select(normal.cmpgt(Vec3::ZERO), block.high, block.low);
    let slack = SLACK * (1.0 + plane.w.abs());
    normal.dot(corner) + margin * normal.abs().element_sum() + plane.w < -slack
}

fn is_too_far(block: &BlockBox, view: &GpuView) -> bool {
    let eye = Vec4::from(view.eye);
    let nearest = eye.truncate().clamp(block.low, block.high);
    eye.w > 0.5 && eye.truncate().distance(nearest) > view.max_distance * (1.0 + SLACK)
}

/// The numbers of the blocks that a view may see, ascending. `cluster`: as in `GpuField`.
pub(crate) fn seen_blocks(boxes: &[BlockBox], view: &GpuView, cluster: [f32; 4]) -> Vec<u32> {
    let may_see = |block: &BlockBox| {
        let reach = margin(block, view, cluster);
        let planes = view.planes.iter().map(|plane| Vec4::from(*plane));
        let outside =
            planes.filter(|_| view.flags & FRUSTUM != 0).any(|p| is_outside(block, reach, p));
        let too_far = view.flags & DISTANCE != 0 && is_too_far(block, view);
        !outside && !too_far
    };
    (0..).zip(boxes).filter(|(_, block)| may_see(block)).map(|(number, _)| number).collect()
}

/// Words of the uniform with the numbers of blocks.
const SEEN_WORDS: usize = 4 * 68;
// Blocks of the worst patch size have 247 bands
const _: () = assert!(PAGE_BLADES.div_ceil(247 * BAND as u64) < SEEN_WORDS as u64);

/// The blocks that one view may see.
#[derive(Debug)]
pub(crate) struct Seen {
    /// How many there are, then their numbers.
    pub(crate) numbers: wgpu::Buffer,
    /// How many there are.
    pub(crate) count: u32,
}

impl Seen {
    /// None.
    pub(crate) fn new(device: &wgpu::Device) -> Self {
        let numbers = uniform(device, "sward.seen_blocks", 4 * SEEN_WORDS as u64);
        Self { numbers, count: 0 }
    }

    pub(crate) fn set(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        numbers: Vec<u32>,
    ) {
        self.count = numbers.len() as u32;
        let content: Vec<u32> = std::iter::once(self.count).chain(numbers).collect();
        write(device, encoder, &self.numbers, bytemuck::cast_slice(&content));
    }
}
