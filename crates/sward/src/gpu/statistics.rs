//! Counted work comes back a frame or more late, without a wait.

use super::layout::{
    BILLBOARD_BUCKETS, BLADE_BUCKETS, BUCKETS, CLUSTER_BUCKET, GpuDraw, MODEL_BUCKET, STRIP_BUCKETS,
};
use crate::Statistics;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

/// Bytes that one page reports: what was counted, the draws, the work sizes.
pub const PAGE_BYTES: u64 = COUNTED_BYTES + DRAWS_BYTES + WORK_BYTES;
/// Bytes of the `counted` buffer.
pub const COUNTED_BYTES: u64 = 32;
/// Bytes of the `draws` buffer.
pub const DRAWS_BYTES: u64 = (BUCKETS * size_of::<GpuDraw>()) as u64;
/// Bytes of the `work_size` buffer.
pub const WORK_BYTES: u64 = 48;

const FREE: u8 = 0;
const PENDING: u8 = 1;
const READY: u8 = 2;

#[derive(Debug)]
struct Slot {
    buffer: wgpu::Buffer,
    state: Arc<AtomicU8>,
    /// Number of the record that it holds.
    record: u64,
}

impl Slot {
    fn if_free(&mut self) -> Option<&mut Self> {
        // No one else holds the state of an encoder that was dropped unsubmitted: its buffer will
        // never map
        if let Some(state) = Arc::get_mut(&mut self.state)
            && *state.get_mut() == PENDING
        {
            *state.get_mut() = FREE;
        }
        (self.state.load(Ordering::Acquire) == FREE).then_some(self)
    }
}

/// A few buffers on their way back.
#[derive(Debug, Default)]
pub struct ReadBack {
    slots: Vec<Slot>,
    bytes: u64,
    records: u64,
    newest: Option<Statistics>,
}

/// Where a page's counts are on the GPU.
pub struct PageCounts<'a> {
    /// Failed tests.
    pub counted: &'a wgpu::Buffer,
    /// Draws.
    pub draws: &'a wgpu::Buffer,
    /// Visible patches and their blades, patches with a full list.
    pub work_size: &'a wgpu::Buffer,
}

const SLOTS: usize = 3;

impl ReadBack {
    fn resize(&mut self, device: &wgpu::Device, bytes: u64) {
        self.bytes = bytes;
        self.slots = (0..SLOTS)
            .map(|_| Slot {
                buffer: device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some("sward.statistics"),
                    size: bytes,
                    usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                }),
                state: Arc::new(AtomicU8::new(FREE)),
                record: 0,
            })
            .collect();
    }

    /// Copies the counts at this point of the encoder, if a buffer is free; they map by themselves
    /// once it is submitted.
    pub fn record(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        pages: &[PageCounts],
    ) {
        let bytes = PAGE_BYTES * pages.len() as u64;
        if bytes == 0 {
            return;
        }
        if self.bytes != bytes {
            self.resize(device, bytes);
        }
        self.reclaim();
        let Some(slot) = self.slots.iter_mut().find_map(Slot::if_free) else { return };
        self.records += 1;
        slot.record = self.records;
        for (page, offset) in pages.iter().zip((0..).step_by(PAGE_BYTES as usize)) {
            let mut at = offset;
            for (source, size) in [
                (page.counted, COUNTED_BYTES),
                (page.draws, DRAWS_BYTES),
                (page.work_size, WORK_BYTES),
            ] {
                encoder.copy_buffer_to_buffer(source, 0, &slot.buffer, at, size);
                at += size;
            }
        }
        slot.state.store(PENDING, Ordering::Release);
        let state = slot.state.clone();
        encoder.map_buffer_on_submit(&slot.buffer, wgpu::MapMode::Read, .., move |result| {
            state.store(if result.is_ok() { READY } else { FREE }, Ordering::Release);
        });
    }

    /// Without a free buffer, gives up the oldest that has arrived and was not asked for.
    fn reclaim(&mut self) {
        let state = |slot: &Slot| slot.state.load(Ordering::Acquire);
        if self.slots.iter().any(|slot| state(slot) == FREE) {
            return;
        }
        let arrived = self.slots.iter().filter(|slot| state(slot) == READY);
        if let Some(oldest) = arrived.min_by_key(|slot| slot.record) {
            oldest.buffer.unmap();
            oldest.state.store(FREE, Ordering::Release);
        }
    }

    /// Whether counts are on their way.
    #[cfg(test)]
    pub fn in_flight(&self) -> bool {
        self.slots.iter().any(|slot| slot.state.load(Ordering::Acquire) == PENDING)
    }

    /// The newest counts that have arrived.
    pub fn collect(&mut self, vertices: &[u32; BUCKETS]) -> Option<Statistics> {
        self.slots.sort_by_key(|slot| slot.record);
        for slot in &self.slots {
            if slot.state.load(Ordering::Acquire) != READY {
                continue;
            }
            if let Ok(view) = slot.buffer.get_mapped_range(..) {
                let words: Vec<u32> = bytemuck::pod_collect_to_vec(&view[..]);
                self.newest = Some(sum_pages(&words, vertices));
            }
            slot.buffer.unmap();
            slot.state.store(FREE, Ordering::Release);
        }
        self.newest
    }
}

/// What counts the plants of a bucket by form.
fn form_count(sum: &mut Statistics, bucket: usize) -> &mut u64 {
    const OTHERS: usize = BLADE_BUCKETS;
    match bucket {
        0..OTHERS => &mut sum.drawn_by_level[bucket % 4],
        CLUSTER_BUCKET => &mut sum.clusters_drawn,
        bucket if bucket == MODEL_BUCKET => &mut sum.models_drawn,
        bucket if STRIP_BUCKETS.contains(&bucket) => &mut sum.strips_drawn,
        bucket if BILLBOARD_BUCKETS.contains(&bucket) => &mut sum.billboards_drawn,
        // No one is in the last lists
        _ => &mut sum.dropped,
    }
}

fn sum_pages(words: &[u32], vertices: &[u32; BUCKETS]) -> Statistics {
    let mut sum = Statistics::default();
    for page in words.chunks_exact((PAGE_BYTES / 4) as usize) {
        let (counted, rest) = page.split_at(8);
        let (draws, work) = rest.split_at(BUCKETS * 4);
        let count = |x: u32| u64::from(x);
        sum.culled_orientation += count(counted[0]);
        sum.culled_frustum += count(counted[1]);
        sum.culled_distance += count(counted[2]);
        sum.culled_occlusion += count(counted[3]);
        sum.spheres_tested += count(counted[4]);
        sum.blades_moved += count(counted[5]);
        for (bucket, (draw, per_blade)) in draws.chunks_exact(4).zip(vertices).enumerate() {
            sum.blades_drawn += count(draw[1]);
            *form_count(&mut sum, bucket) += count(draw[1]);
            sum.vertices += count(draw[1]) * count(*per_blade);
            sum.dropped += count(draw[2]);
        }
        // As work.wgsl numbers them
        sum.patches_visible += count(work[3]);
        sum.blades_visible += count(work[4]);
        sum.patches_crowded += count(work[9]);
    }
    sum
}
