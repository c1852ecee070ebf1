//! Blades become patches: compact groups of equal count, ordered inside.
//!
//! Recursive bisection: blades are split at a multiple of the patch size across the axis along
//! which they lie farthest apart, until a group fits a patch. Groups are so compact, of equal
//! count, and only the last patch may be short.

use super::order;
use super::{Blade, Patch};
use crate::{BladeOrder, Metric};
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use std::cmp::Ordering;

/// Groups larger than this are split on two threads.
const PARALLEL: usize = 8192;
/// Longest that a drawn curve is, over the blade's height, with some room for quantisation. The
/// length step keeps it within 1.2 %.
const LONGEST: f32 = 1.025;

/// A blade's root and its index: all that grouping needs, in a quarter of a blade's memory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Key {
    pub(crate) position: Vec3,
    pub(crate) index: u32,
}

impl Key {
    /// A total order along an axis: equal coordinates fall back to the index.
    pub(crate) fn compare(&self, other: &Self, axis: usize) -> Ordering {
        let (a, b) = (self.position[axis], other.position[axis]);
        a.total_cmp(&b).then(self.index.cmp(&other.index))
    }
}

/// Groups blades into patches and sorts them by patch, then by the order inside; with each its tint,
/// where there are tints.
pub(crate) fn arrange(
    blades: &[Blade],
    tints: &[u32],
    patch_size: u32,
    metric: Metric,
    order: BladeOrder,
) -> (Vec<Blade>, Vec<u32>, Vec<Patch>) {
    let size = patch_size as usize;
    let mut keys: Vec<Key> = (blades.par_iter().with_min_len(4096).enumerate())
        .map(|(i, blade)| Key { position: blade.root, index: i as u32 })
        .collect();
    bisect(&mut keys, size, metric);
    keys.par_chunks_mut(size)
        .enumerate()
        .for_each_init(Vec::new, |scratch, (i, chunk)| order::sort(chunk, order, i, scratch));
    let sorted: Vec<Blade> =
        keys.par_iter().with_min_len(4096).map(|key| blades[key.index as usize]).collect();
    let own_tint = |key: &Key| tints.get(key.index as usize).copied();
    let tints = keys.iter().filter_map(own_tint).collect();
    let patches = (sorted.par_chunks(size).enumerate())
        .map(|(i, chunk)| bound(chunk, i as u32 * patch_size))
        .collect();
    (sorted, tints, patches)
}

fn bisect(keys: &mut [Key], size: usize, metric: Metric) {
    if keys.len() <= size {
        return;
    }
    let axis = split_axis(keys, metric);
    let middle = keys.len().div_ceil(size) / 2 * size;
    keys.select_nth_unstable_by(middle, |a, b| a.compare(b, axis));
    let (low, high) = keys.split_at_mut(middle);
    if low.len() + high.len() > PARALLEL {
        rayon::join(|| bisect(low, size, metric), || bisect(high, size, metric));
    } else {
        bisect(low, size, metric);
        bisect(high, size, metric);
    }
}

/// The axis whose split takes most off the groups' total distance to their centres: for straight
/// distances, squared, the one of greatest variance; for the sum of the axes' distances the one
/// of greatest mean absolute deviation, which outliers sway less.
fn split_axis(keys: &[Key], metric: Metric) -> usize {
    let count = keys.len() as f64;
    let mean = keys.iter().map(|k| k.position.as_dvec3()).sum::<DVec3>() / count;
    let cost: DVec3 = (keys.iter())
        .map(|key| {
            let off = key.position.as_dvec3() - mean;
            match metric {
                Metric::Euclidean => off * off,
                Metric::Manhattan => off.abs(),
            }
        })
        .sum();
    cost.max_position()
}

fn bound(blades: &[Blade], first: u32) -> Patch {
    let mut patch = Patch {
        first,
        count: blades.len() as u32,
        root_min: Vec3::INFINITY,
        root_max: Vec3::NEG_INFINITY,
        reach_min: Vec3::INFINITY,
        reach_max: Vec3::NEG_INFINITY,
    };
    for blade in blades {
        let (low, high) = reach(blade);
        patch.root_min = patch.root_min.min(blade.root);
        patch.root_max = patch.root_max.max(blade.root);
        patch.reach_min = patch.reach_min.min(low);
        patch.reach_max = patch.reach_max.max(high);
    }
    patch
}

/// The box of every pose of a blade: half a ball above the root plane, and half the width about.
fn reach(blade: &Blade) -> (Vec3, Vec3) {
    let length = LONGEST * blade.height;
    let half_width = 0.5 * blade.width;
    // Along an axis the half ball reaches its full radius where the axis points above the plane,
    // and the rim of its base disk where it points below.
    let extent = |up: f32| {
        let rim = (1.0 - up * up).max(0.0).sqrt();
        length * if up >= 0.0 { 1.0 } else { rim } + half_width
    };
    let high = Vec3::new(extent(blade.up.x), extent(blade.up.y), extent(blade.up.z));
    let low = Vec3::new(extent(-blade.up.x), extent(-blade.up.y), extent(-blade.up.z));
    (blade.root - low, blade.root + high)
}
