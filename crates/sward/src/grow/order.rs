//! The order of the blades inside a patch.

use super::patches::Key;
use super::random::mix;
use crate::BladeOrder;
use glam::Vec3;

/// Sorts the blades of patch number `patch`; `scratch` is memory to reuse.
pub(crate) fn sort(keys: &mut [Key], order: BladeOrder, patch: usize, scratch: &mut Vec<Key>) {
    match order {
        BladeOrder::Progressive => {
            scratch.clear();
            scratch.extend_from_slice(keys);
            // Turned differently in each patch, so that neighbouring patches share no pattern.
            progressive(keys, scratch, mix(patch as u64));
        }
        BladeOrder::Morton => morton(keys),
        BladeOrder::Lexicographic => keys.sort_unstable_by(|a, b| {
            let axis = |i: usize| a.position[i].total_cmp(&b.position[i]);
            axis(0).then(axis(1)).then(axis(2)).then(a.index.cmp(&b.index))
        }),
    }
}

/// Halves the blades across their longest axis, orders each half, and takes from the two in turn:
/// every prefix so holds the same number from each half, and from each half of a half, down to
/// the last blade. A prefix thus keeps the proportions of the density, which picking the
/// farthest point each time would not, and favours no rim.
///
/// The halves of the second half are taken in the opposite order, as in an ordered dither, so
/// that the second blade stands diagonally across from the first.
fn progressive(keys: &mut [Key], scratch: &mut [Key], turns: u64) {
    let count = keys.len();
    if count <= 1 {
        return;
    }
    let middle = count / 2;
    let axis = bounds(keys).max_position();
    keys.select_nth_unstable_by(middle, |a, b| a.compare(b, axis));
    let (low, high) = keys.split_at_mut(middle);
    let (low_scratch, high_scratch) = scratch.split_at_mut(middle);
    progressive(low, low_scratch, turns >> 1);
    progressive(high, high_scratch, !(turns >> 1));
    // The larger half begins; of equal ones the turn says which.
    let low_first = count.is_multiple_of(2) && turns & 1 == 0;
    let (first, second) = if low_first { (low, high) } else { (high, low) };
    for (pair, &key) in scratch.chunks_mut(2).zip(&*first) {
        pair[0] = key;
    }
    for (pair, &key) in scratch.chunks_exact_mut(2).zip(&*second) {
        pair[1] = key;
    }
    keys.copy_from_slice(scratch);
}

/// Extent of the roots' bounding box.
fn bounds(keys: &[Key]) -> Vec3 {
    let (low, high) = corners(keys);
    high - low
}

fn corners(keys: &[Key]) -> (Vec3, Vec3) {
    keys.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), key| {
        (low.min(key.position), high.max(key.position))
    })
}

fn morton(keys: &mut [Key]) {
    let (low, high) = corners(keys);
    let scale = 1023.0 / (high - low).max_element().max(f32::MIN_POSITIVE);
    keys.sort_by_cached_key(|key| {
        let cell = ((key.position - low) * scale).as_uvec3();
        (spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2, key.index)
    });
}

/// Puts two zeros between the ten low bits.
pub(crate) fn spread(x: u32) -> u32 {
    let x = x & 0x3ff;
    let x = (x | x << 16) & 0x0300_00ff;
    let x = (x | x << 8) & 0x0300_f00f;
    let x = (x | x << 4) & 0x030c_30c3;
    (x | x << 2) & 0x0924_9249
}
