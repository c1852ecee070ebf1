//! The draw list against its reference, bit for bit and in order.

use super::decoded::decode;
use super::rig::Rig;
use super::scenes::{random_field, random_states, random_view, see_all};
use crate::frame::compact::twin::compact;
use crate::gpu::layout::GpuDraw;
use crate::{Culling, PhysicsModel, View};

fn rig(seed: u32, count: u32, patch_size: u32) -> Rig {
    let rig = Rig::new(random_field(seed, count, 6.0, patch_size));
    let bits = random_states(seed, &decode(&rig.field), PhysicsModel::Sward);
    rig.write_states(&bits);
    rig
}

fn check(rig: &Rig, view: usize) -> Vec<GpuDraw> {
    let decisions: Vec<u16> = rig.decisions().iter().map(|d| d.unwrap_or(15)).collect();
    let (list, draws) = compact(&decisions, rig.lists(view).capacity);
    assert_eq!(rig.list(view), (list, draws.to_vec()));
    let arguments: Vec<[u32; 5]> = rig.read(&rig.lists(view).indirect);
    for (own, draw) in arguments.iter().zip(&draws) {
        assert_eq!(own[1], draw.count.div_ceil(64));
        // A draw with another first instance needs a feature that not every adapter has
        assert_eq!(own[2..], [0, 0, 0]);
    }
    draws.to_vec()
}

/// A view in which blades of many sizes survive.
fn mixed_view(seed: u32) -> View<'static> {
    View { detail: 2.0, ..random_view(2 * seed, 6.0) }
}

#[test]
fn the_list_equals_the_reference() {
    for (seed, count, patch_size) in [(1, 5000, 64), (2, 5000, 256), (3, 5001, 1024), (4, 1, 64)] {
        let mut rig = rig(seed, count, patch_size);
        let mut used = [false; 8];
        for camera in 0..6 {
            rig.cull(&[mixed_view(seed * 10 + camera)]);
            for (used, draw) in used.iter_mut().zip(check(&rig, 0)) {
                *used |= draw.count > 0;
            }
        }
        assert!(count == 1 || used.iter().filter(|x| **x).count() >= 6, "buckets: {used:?}");
    }
}

#[test]
fn a_full_list_keeps_the_first_buckets_and_counts_the_rest() {
    let mut rig = rig(5, 3000, 256);
    let view =
        View { culling: Culling { orientation: false, ..Culling::default() }, ..mixed_view(2) };
    rig.cull(&[view]);
    let whole = check(&rig, 0);
    let (all, _) = rig.list(0);
    assert!(all.len() > 500, "{}", all.len());
    for most in [0, 1, 63, 64, 100, 333, all.len() as u32 - 1, all.len() as u32, 5000] {
        rig.cull(&[View { max_blades: Some(most), ..view }]);
        let draws = check(&rig, 0);
        let (list, _) = rig.list(0);
        assert_eq!(rig.lists(0).capacity, most.min(3000));
        assert_eq!(list[..], all[..all.len().min(most as usize)], "the nearest levels first");
        let dropped = all.len() - list.len();
        assert_eq!(rig.statistics().dropped, dropped as u64);
        assert_eq!(rig.statistics().blades_drawn, list.len() as u64);
        for (own, whole) in draws.iter().zip(&whole) {
            assert_eq!(own.count + own.dropped, whole.count);
        }
    }
}

#[test]
fn the_same_frame_gives_the_same_list() {
    let mut rig = rig(6, 4000, 64);
    rig.cull(&[mixed_view(1)]);
    let first = rig.list(0);
    for _ in 0..5 {
        rig.cull(&[mixed_view(2)]);
        assert_ne!(rig.list(0), first);
        rig.cull(&[mixed_view(1)]);
        assert_eq!(rig.list(0), first);
    }
}

/// More than 32 blocks of 256 bands, so that each lane of the last scan sums several blocks.
#[test]
fn the_scan_runs_over_many_blocks() {
    let count = 33 * 256 * 64 + 100;
    let mut rig = Rig::new(random_field(7, count, 60.0, 64));
    assert_eq!(rig.page(0).block_count(), 34);
    for view in [see_all(), View { detail: 0.5, ..random_view(8, 60.0) }] {
        rig.cull(&[view]);
        check(&rig, 0);
    }
}
