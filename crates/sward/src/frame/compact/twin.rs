//! The CPU reference of scan.wgsl and compact.wgsl.

use crate::gpu::layout::{BUCKETS, GpuDraw};

/// The draw list and each bucket's range, from the decisions of all blades in order: bucket by
/// bucket, each in blade order; what lies beyond the capacity is dropped.
pub(crate) fn compact(decisions: &[u16], capacity: u32) -> (Vec<u32>, [GpuDraw; BUCKETS]) {
    let mut list = Vec::new();
    let draws = std::array::from_fn(|bucket| {
        let first = list.len() as u32;
        // The last is no list: its plants are in none
        let is_own = |d: &u16| bucket != 15 && usize::from(*d & 15) == bucket;
        let own = decisions.iter().enumerate().filter(|(_, d)| is_own(d));
        list.extend(own.map(|(index, d)| index as u32 | u32::from(d >> 4) << 22));
        let (start, end) = (first.min(capacity), (list.len() as u32).min(capacity));
        let dropped = list.len() as u32 - first - (end - start);
        GpuDraw { start, count: end - start, dropped, reserved: 0 }
    });
    list.truncate(capacity as usize);
    (list, draws)
}
