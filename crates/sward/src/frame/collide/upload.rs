//! Chunks on their way to the GPU: those that rest are ordered and sent when they change, those
//! that move in every step.

use super::chunks::{Chunks, chunk_count};
use super::expand::Expanded;
use super::primitive::{GpuPrimitive, Primitive};
use crate::Error;
use crate::gpu::buffers;
use crate::gpu::layout::{CHUNK, CHUNK_STRIDE};
use wgpu::BufferUsages;

/// Bytes of a chunk.
const CHUNK_BYTES: u64 = (CHUNK_STRIDE * size_of::<GpuPrimitive>()) as u64;
const FIRST_CHUNKS: u64 = 2;

/// What the shaders are told of the chunks of a step.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct ChunkCounts {
    /// All chunks, those that rest first.
    pub(crate) all: u32,
    /// Those that rest.
    pub(crate) resting: u32,
    /// Whether patches keep what they know of those that rest.
    pub(crate) keep_resting: bool,
    /// Whether the lists of the patches hold for this step already.
    pub(crate) listed: bool,
}

/// The buffer of chunks, and what it holds.
#[derive(Debug)]
pub(crate) struct ChunkBuffer {
    buffer: wgpu::Buffer,
    resting: Vec<Primitive>,
    resting_chunks: Chunks,
    had_moving: bool,
    /// Whether some patches have no list yet.
    stale: bool,
}

fn chunk_buffer(device: &wgpu::Device, chunks: u64) -> wgpu::Buffer {
    buffers::storage(device, "sward.primitives", chunks * CHUNK_BYTES, BufferUsages::empty())
}

/// Most chunks that one binding holds.
fn most_chunks(limits: &wgpu::Limits) -> u64 {
    limits.max_storage_buffer_binding_size.min(limits.max_buffer_size) / CHUNK_BYTES
}

/// Checks that the primitives of a step fit.
///
/// # Errors
/// [`Error::Limit`] with how many fit.
pub(crate) fn check(limits: &wgpu::Limits, expanded: &Expanded) -> Result<(), Error> {
    let (resting, moving) = (expanded.resting.len(), expanded.moving.len());
    let chunks = (chunk_count(resting) + chunk_count(moving)) as u64;
    let most = most_chunks(limits);
    if chunks <= most {
        return Ok(());
    }
    // One chunk may be cut in two where what rests ends
    let fit = most.saturating_sub(1) * CHUNK as u64;
    Err(Error::Limit {
        what: format!("colliders of {} spheres, capsules and boxes", resting + moving),
        limit: "max_storage_buffer_binding_size",
        needed: chunks * CHUNK_BYTES,
        available: limits.max_storage_buffer_binding_size.min(limits.max_buffer_size),
        remedy: format!("{fit} fit: pass fewer"),
    })
}

impl ChunkBuffer {
    pub(crate) fn new(device: &wgpu::Device) -> Self {
        Self {
            buffer: chunk_buffer(device, FIRST_CHUNKS),
            resting: Vec::new(),
            resting_chunks: Chunks::default(),
            had_moving: false,
            stale: false,
        }
    }

    pub(crate) fn buffer(&self) -> &wgpu::Buffer {
        &self.buffer
    }

    /// Some patches are new: all are listed anew in the next step.
    pub(crate) fn forget_lists(&mut self) {
        self.stale = true;
    }

    /// The lists of the patches are of another time: they are made anew in the next step.
    pub(crate) fn make_lists_anew(&mut self) {
        self.stale = true;
        self.had_moving = true;
    }

    /// Writes what [`check`] let pass. Says what there is, and whether the buffer is another one.
    pub(crate) fn write(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        expanded: &Expanded,
    ) -> (ChunkCounts, bool) {
        let changed = expanded.resting != self.resting;
        if changed {
            self.resting.clone_from(&expanded.resting);
            self.resting_chunks = Chunks::new(&self.resting);
        }
        let moving = Chunks::new(&expanded.moving);
        let resting = self.resting_chunks.count() as u64;
        let all = resting + moving.count() as u64;
        let grown = all * CHUNK_BYTES > self.buffer.size();
        if grown {
            let room = all.next_power_of_two().min(most_chunks(&device.limits()));
            self.buffer = chunk_buffer(device, room);
        }
        if changed || grown {
            self.write_at(device, encoder, &self.resting_chunks, 0);
        }
        self.write_at(device, encoder, &moving, resting * CHUNK_BYTES);
        let has_moving = moving.count() > 0;
        // New patches have nothing near them, as they should where nothing rests
        let relist = changed || (self.stale && resting > 0);
        let counts = ChunkCounts {
            all: all as u32,
            resting: resting as u32,
            keep_resting: !relist,
            listed: !(relist || has_moving || self.had_moving),
        };
        (self.had_moving, self.stale) = (has_moving, false);
        (counts, grown)
    }

    fn write_at(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        chunks: &Chunks,
        offset: u64,
    ) {
        let content = bytemuck::cast_slice(&chunks.entries);
        buffers::write_at(device, encoder, &self.buffer, offset, content);
    }
}
