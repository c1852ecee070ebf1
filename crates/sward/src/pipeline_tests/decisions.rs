//! Patch culling, blade tests and levels against their references, on random fields and cameras.

use super::decoded::{Decoded, decode, pose, states};
use super::rig::Rig;
use super::scenes::{random_field, random_states, random_view};
use crate::frame::cull::twin::{decide, kept_blades, pixels_per_metre};
use crate::frame::level::twin::choose_level;
use crate::gpu::layout::{BAND, GpuView};
use crate::gpu::quantize::gpu_patch;
use crate::gpu::view::gpu_view;
use crate::{Culling, PhysicsModel, Statistics, View};
use glam::{Vec3, Vec4};

const MODEL: PhysicsModel = PhysicsModel::Sward;

/// Of one blade.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Decision {
    failed: u32,
    bucket: u32,
    morph: u32,
    fade: u32,
}

fn decision(view: &GpuView, decoded: &Decoded, bits: [u32; 2]) -> Decision {
    let state = crate::gpu::state_twin::unpack_state(&decoded.physics, bits, MODEL);
    let pose = pose(&decoded.physics, &state);
    let no_depth = |_| 1.0;
    let view_here = GpuView { flags: view.flags & !crate::frame::cull::twin::OCCLUSION, ..*view };
    let (failed, fade) =
        decide(&view_here, &decoded.blade, decoded.ridge, &pose, decoded.local, &no_depth);
    let middle = decoded.blade.root + decoded.blade.up * (0.5 * decoded.blade.height);
    let distance = middle.distance(Vec4::from(view.eye).truncate());
    let height_px = decoded.blade.height * pixels_per_metre(view, distance) * view.detail;
    let (level, morph) = choose_level(height_px);
    let first = if decoded.flat_tip { 4 } else { 0 };
    Decision {
        failed,
        bucket: if failed == 0 { first + level } else { 15 },
        morph: (morph * 31.0).round() as u32,
        fade: (fade * 31.0).ceil().clamp(1.0, 31.0) as u32,
    }
}

/// How many blades of each patch are dispatched: 0 where the view does not see it.
fn kept_by_patch(rig: &Rig, view: &GpuView) -> Vec<u32> {
    let kept = |patch| {
        let gpu = gpu_patch(patch, rig.field.blades());
        kept_blades(view, patch.reach_min, patch.reach_max, gpu.max_width, patch.count)
    };
    rig.field.patches().iter().map(kept).collect()
}

fn wholly_inside(view: &GpuView, low: Vec3, high: Vec3) -> bool {
    view.planes.iter().all(|plane| {
        let plane = Vec4::from(*plane);
        let corner = Vec3::select(plane.truncate().cmpgt(Vec3::ZERO), low, high);
        plane.truncate().dot(corner) + plane.w >= 0.0
    })
}

#[derive(Default, Debug)]
struct Tally {
    blades: usize,
    /// Another bucket than the reference's.
    buckets: usize,
    /// Morph or fade more than a step off.
    grades: usize,
    /// Sum over bands and tests of the differences of the counts of failed tests.
    counts: usize,
}

fn compare_blades(rig: &Rig, view: &GpuView, bits: &[[u32; 2]], tally: &mut Tally) {
    let decoded = decode(&rig.field);
    let kept = kept_by_patch(rig, view);
    let bands = rig.bands();
    let bands_a_patch = (rig.field.patch_size() / BAND) as usize;
    let mut counts = vec![[0_u32; 4]; bands.len()];
    for ((blade, bits), gpu) in decoded.iter().zip(bits).zip(rig.decisions()) {
        let local = blade.local.0;
        let band = blade.patch * bands_a_patch + (local / BAND) as usize;
        let dispatched = local < kept[blade.patch].div_ceil(BAND) * BAND;
        assert_eq!(gpu.is_some(), dispatched, "blade {local} of patch {}", blade.patch);
        let Some(gpu) = gpu else {
            // What is thinned by whole bands counts as culled by distance
            counts[band][2] += u32::from(kept[blade.patch] > 0);
            continue;
        };
        let own = decision(view, blade, *bits);
        for (test, count) in counts[band].iter_mut().enumerate() {
            *count += own.failed >> test & 1;
        }
        let (bucket, morph, fade) =
            (u32::from(gpu & 15), u32::from(gpu >> 4 & 31), u32::from(gpu >> 9));
        tally.blades += 1;
        tally.buckets += usize::from(bucket != own.bucket);
        let off = morph.abs_diff(own.morph) > 1 || fade.abs_diff(own.fade) > 1;
        tally.grades += usize::from(bucket == own.bucket && bucket != 15 && off);
    }
    for (band, own) in bands.iter().zip(&counts) {
        for (gpu, own) in band.culled.to_le_bytes().map(u32::from).iter().zip(own) {
            tally.counts += gpu.abs_diff(*own) as usize;
        }
    }
}

fn compare_patches(rig: &Rig, view: &GpuView, frustum: bool) {
    let kept = kept_by_patch(rig, view);
    let expected: Vec<_> = (0..)
        .zip(rig.field.patches())
        .filter(|(index, _)| kept[*index] > 0)
        .map(|(index, patch)| {
            let inside = !frustum || wholly_inside(view, patch.reach_min, patch.reach_max);
            (index as u32, inside, kept[index])
        })
        .collect();
    assert_eq!(rig.work(), expected);
    let (list, draws) = rig.list(0);
    let statistics = rig.statistics();
    let visible =
        rig.field.patches().iter().zip(&kept).filter(|(_, kept)| **kept > 0).map(|(p, _)| p.count);
    assert_eq!(statistics.patches_visible, expected.len() as u64);
    assert_eq!(statistics.blades_visible, u64::from(visible.sum::<u32>()));
    assert_eq!(statistics.blades_drawn, list.len() as u64);
    assert_eq!(statistics.blades_drawn, draws.iter().map(|d| u64::from(d.count)).sum::<u64>());
    let drawn = rig.decisions().iter().flatten().filter(|d| **d & 15 != 15).count();
    assert_eq!(statistics.blades_drawn, drawn as u64);
    assert_eq!(culled(&statistics), culled_in_bands(rig));
}

fn culled(statistics: &Statistics) -> [u64; 4] {
    [
        statistics.culled_orientation,
        statistics.culled_frustum,
        statistics.culled_distance,
        statistics.culled_occlusion,
    ]
}

fn culled_in_bands(rig: &Rig) -> [u64; 4] {
    rig.bands().iter().fold([0; 4], |sum, band| {
        let own = band.culled.to_le_bytes();
        std::array::from_fn(|i| sum[i] + u64::from(own[i]))
    })
}

fn cullings() -> Vec<Culling> {
    let on = |bits: u32, bit: u32| bits & bit != 0;
    (0..16)
        .map(|bits| Culling {
            frustum: on(bits, 1),
            distance: on(bits, 2),
            orientation: on(bits, 4),
            occlusion: false,
            paper: on(bits, 8),
            max_distance_m: if on(bits, 8) || bits % 3 == 0 { 11.0 } else { f32::INFINITY },
        })
        .collect()
}

#[test]
fn decisions_equal_the_reference() {
    for (seed, patch_size) in [(1, 64), (2, 256), (3, 1024)] {
        let mut rig = Rig::new(random_field(seed, 2500, 6.0, patch_size));
        let bits = random_states(seed, &decode(&rig.field), MODEL);
        rig.write_states(&bits);
        let mut tally = Tally::default();
        for (turn, culling) in (0..).zip(cullings()) {
            for camera in [2 * turn, 2 * turn + 1] {
                let detail = [1.0, 0.3, 4.0, f32::INFINITY][turn as usize % 4];
                let view = View { culling, detail, ..random_view(seed * 1000 + camera, 6.0) };
                rig.cull(&[view]);
                let uniform = gpu_view(&view, u32::MAX);
                compare_patches(&rig, &uniform, culling.frustum);
                compare_blades(&rig, &uniform, &bits, &mut tally);
            }
        }
        println!("patches of {patch_size}: {tally:?}");
        let allowed = tally.blades * 3 / 1000;
        assert!(tally.blades > 20_000, "{tally:?}");
        assert!(tally.buckets <= allowed && tally.grades <= allowed, "{tally:?}");
        assert!(tally.counts <= allowed, "{tally:?}");
        assert_eq!(rig.states(), bits, "culling alone moves nothing");
    }
}

/// The same through physics: what is tested is what is drawn, the state after its quantisation.
#[test]
fn blades_are_tested_as_they_are_drawn() {
    let wind = super::scenes::breeze();
    let mut rig = Rig::new(random_field(9, 2500, 4.0, 256));
    let view = random_view(4, 4.0);
    for _ in 0..3 {
        rig.step(&crate::Frame::new(0.03, &wind), &[view]);
    }
    let bits = rig.states();
    let moved = states(&decode(&rig.field), &bits, MODEL);
    assert!(moved.iter().all(super::scenes::is_sound));
    let mut tally = Tally::default();
    let uniform = gpu_view(&view, u32::MAX);
    compare_blades(&rig, &uniform, &bits, &mut tally);
    println!("{tally:?}");
    assert!(tally.blades > 500, "{tally:?}");
    assert!(tally.buckets * 1000 <= tally.blades * 3, "{tally:?}");
}

#[test]
fn a_view_of_the_sky_draws_nothing() {
    let mut rig = Rig::new(random_field(5, 1000, 4.0, 256));
    rig.cull(&[super::scenes::see_all()]);
    assert_eq!(rig.statistics().blades_drawn, 1000);
    rig.cull(&[super::scenes::see_none()]);
    // Those that the view before it moved, in the same step, are none of its own
    let nothing = Statistics { blades: 1000, patches: 4, ..Statistics::default() };
    assert_eq!(rig.statistics(), nothing);
    let arguments: Vec<u32> = rig.read(&rig.lists(0).indirect);
    assert!(arguments.chunks(5).all(|draw| draw[1] == 0), "{arguments:?}");
}
