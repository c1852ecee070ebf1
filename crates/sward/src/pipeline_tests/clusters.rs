//! Clusters as a host meets them: what is chosen, drawn, counted and kept.

use super::decoded::decode;
use super::drawing::{covered, draw};
use super::rig::Rig;
use super::scenes::{breeze, look, no_culling, random_field};
use crate::frame::cull::twin::pixels_per_metre;
use crate::frame::level::continuum_twin::{Plant, anchor_count, choose};
use crate::frame::physics::twin::rest_tip;
use crate::gpu::layout::{BLADE_BUCKETS, CLUSTER_BUCKET, GpuBand};
use crate::gpu::view::gpu_view;
use crate::{Culling, DebugView, Frame, Gravity, PhysicsModel, Technique, View, Wind};
use glam::{Vec3, Vec4};

/// From so far away, with no test but that by size. Detail brings the change to clusters farther out, where one distance
/// goes for all of the field.
fn from(distance_m: f32) -> View<'static> {
    let view = look(Vec3::new(0.0, 0.25 * distance_m, distance_m), Vec3::ZERO);
    let culling = Culling { distance: true, ..no_culling() };
    View { technique: Technique::Continuum, culling, detail: 4.0, ..view }
}

/// From here all blades of `rig` are run.
const NEAR_M: f32 = 2.0;

fn rig(blades: u32) -> Rig {
    Rig::new(random_field(7, blades, 4.0, 256))
}

fn count(rig: &Rig, bucket: usize) -> u32 {
    rig.list(0).1[bucket].count
}

/// Near there are blades only; then both; then clusters only, of which few are run; then nothing.
#[test]
fn blades_turn_into_clusters_and_clusters_into_ground() {
    let mut rig = rig(4096);
    let (mut last_clusters, mut fewest) = (0, u64::MAX);
    let mut seen = [false; 3];
    for step in 0..50 {
        // In so much detail that in the first views no blade of the field is far
        let view = from(0.7 * 1.2_f32.powi(step));
        rig.step(&Frame::new(0.02, &breeze()), &[view]);
        let blades: u32 = (0..BLADE_BUCKETS).map(|b| count(&rig, b)).sum();
        let clusters = count(&rig, CLUSTER_BUCKET);
        let statistics = rig.statistics();
        assert_eq!(statistics.clusters_drawn, u64::from(clusters));
        assert_eq!(statistics.drawn_by_level.iter().sum::<u64>(), u64::from(blades));
        assert_eq!(statistics.blades_drawn, u64::from(blades + clusters));
        assert!(clusters <= anchor_count(4096), "one a plant");
        seen[0] |= clusters == 0 && blades > 0;
        seen[1] |= clusters > 0 && blades > 0;
        if clusters > 0 && blades == 0 {
            seen[2] = true;
            fewest = fewest.min(statistics.blades_moved);
            assert!(statistics.vertices <= 4 * u64::from(clusters));
        }
        last_clusters = clusters;
    }
    // The anchors are enough
    assert!(fewest <= 4096 / 32, "{fewest} blades are run");
    assert!(seen.iter().all(|s| *s) && last_clusters == 0, "{seen:?}, {last_clusters}");
}

/// Each blade's form and width against the reference.
#[test]
fn decisions_equal_the_reference() {
    let mut rig = rig(2048);
    let mut changing = 0;
    for distance in [7.0, 8.0, 9.0, 10.0, 11.0, 14.0, 60.0, 250.0] {
        let view = from(distance);
        rig.step(&Frame::new(0.02, &breeze()), &[view]);
        let uniform = gpu_view(&view, u32::MAX);
        let cluster = rig.page(0).field.cluster;
        let (mut off, mut anchors) = (0, [0; 2]);
        for (id, (own, gpu)) in (0..).zip(decode(&rig.field).iter().zip(rig.decisions())) {
            let middle = own.blade.root + own.blade.up * (0.5 * own.blade.height);
            let eye = Vec4::from(uniform.eye).truncate();
            let scale = pixels_per_metre(&uniform, middle.distance(eye));
            let keep = own.blade.width * scale / uniform.least_width;
            let (local, count) = own.local;
            let plant = Plant { id, local, count, scale, keep };
            let (clustered, fade) = choose(&uniform, cluster, plant);
            anchors[usize::from(clustered)] += usize::from(local < anchor_count(count));
            let steps = (fade * 31.0).ceil() as u32;
            let Some(bits) = gpu else {
                assert!(fade <= 0.0, "blade {id} of {distance} m is not run");
                continue;
            };
            let (bucket, shown) = (usize::from(bits & 15), u32::from(bits >> 9));
            let drawn = bucket != 15;
            let same = drawn == (fade > 0.0)
                && (!drawn
                    || (bucket == CLUSTER_BUCKET) == clustered && shown.abs_diff(steps) <= 1);
            off += usize::from(!same);
        }
        changing += anchors[0].min(anchors[1]);
        assert!(off <= 6, "{off} blades of {distance} m");
    }
    assert!(changing > 50, "{changing} anchors are asked in the midst of the change");
}

/// The picture's cover goes on through the change.
#[test]
fn cover_goes_on() {
    // Large: a cluster at the border reaches its own radius beyond it, which blades do not
    let mut rig = Rig::new(random_field(3, 16_384, 4.0, 256));
    let (mut all, mut all_blades) = (0, 0);
    for step in 0..16 {
        let distance = 4.0 + step as f32;
        let view = from(distance);
        rig.step(&Frame::new(0.02, &breeze()), &[view]);
        let mixed = covered(&draw(&mut rig, 0));
        // Every blade as wide as it is: thin ones are otherwise drawn wider than they are
        let (culling, technique) = (no_culling(), Technique::Blades);
        let plain = View { culling, technique, width_correction: false, ..view };
        rig.cull(&[plain]);
        let blades = covered(&draw(&mut rig, 0));
        println!("{distance} m: {mixed}, {blades} pixels");
        (all, all_blades) = (all + mixed, all_blades + blades);
    }
    let ratio = all as f32 / all_blades as f32;
    assert!((ratio - 1.0).abs() < 0.08, "{all}, {all_blades} pixels");
}

/// Nothing moves and nothing flickers where time stands still, and a saved state draws the same.
#[test]
fn still_frames_are_equal_and_saved_ones_too() {
    let mut rig = rig(4096);
    let wind = breeze();
    let view = from(8.0);
    for _ in 0..3 {
        rig.step(&Frame::new(0.02, &wind), &[view]);
    }
    let frame = Frame::new(0.0, &wind);
    rig.step(&frame, &[view]);
    let first = draw(&mut rig, 0);
    assert!(count(&rig, CLUSTER_BUCKET) > 0);
    for _ in 0..3 {
        rig.step(&frame, &[view]);
        assert!(draw(&mut rig, 0) == first);
    }
    let state = rig.renderer.save_state(&rig.device, &rig.queue).expect("saved");
    rig.step(&Frame::new(0.3, &wind), &[view]);
    assert!(draw(&mut rig, 0) != first, "wind moves clusters");
    rig.renderer.restore_state(&rig.queue, &state).expect("restored");
    rig.step(&frame, &[view]);
    assert!(draw(&mut rig, 0) == first);
}

fn sway(band: &GpuBand) -> Vec3 {
    let axis = |bits: u32| f32::from(bits as u16 as i16) * (2.0 / 32767.0);
    let [xy, z] = band.sway;
    Vec3::new(axis(xy), axis(xy >> 16), axis(z))
}

/// What the wind moves the anchors of each patch by, near and far, which moves its clusters; nothing
/// where there is none.
#[test]
fn a_patch_knows_how_far_the_wind_has_moved_it() {
    let wind = breeze();
    for (distance, far, seconds) in [(NEAR_M, false, 0.05), (60.0, true, 0.05), (60.0, true, 30.0)]
    {
        let mut rig = rig(512);
        let still = Wind::default();
        rig.step(
            &Frame::new(seconds, if seconds < 1.0 { &wind } else { &still }),
            &[from(distance)],
        );
        assert!(rig.all_work().iter().all(|entry| entry.3 == far));
        let blades = decode(&rig.field);
        let states = super::decoded::states(&blades, &rig.states(), PhysicsModel::Sward);
        for (band, first) in rig.bands().iter().step_by(4).zip((0..512).step_by(256)) {
            let displaced = (first..first + 8).map(|i| {
                (states[i].tip - rest_tip(&blades[i].physics, &Gravity::default())).as_vec3()
            });
            let mean = displaced.sum::<Vec3>() / 8.0;
            let own = sway(band);
            // The shader's rest is reckoned in one step, the twin's is where a blade settles
            assert!(own.distance(mean) < 2e-3, "{distance} m, {seconds} s: {own} is not {mean}");
            assert_eq!(mean.length() < 1e-3, seconds > 1.0, "{mean}");
        }
    }
}

/// Of a patch whose anchors alone were run the others keep their own time, and all catch up.
#[test]
fn blades_that_were_far_catch_up() {
    let (mut near, mut other) = (rig(1024), rig(1024));
    let mut wind = breeze();
    for step in 0..120 {
        wind.advance(0.02);
        let frame = Frame::new(0.02, &wind);
        near.step(&frame, &[from(NEAR_M)]);
        other.step(&frame, &[from(if step % 60 < 50 { 60.0 } else { NEAR_M })]);
        let moved = other.statistics().blades_moved;
        assert_eq!(moved, if step % 60 < 50 { 1024 / 32 } else { 1024 });
        if step == 30 {
            // A near view in the same step: the anchors have moved, and move no more
            let [a, b] = [&near, &other].map(Rig::states);
            assert!((0..1024).all(|i| (a[i] == b[i]) == (i % 256 < 8)));
            other.cull(&[from(NEAR_M)]);
            assert_eq!(other.statistics().blades_moved, 1024);
            assert!((0..1024).step_by(256).all(|i| other.states()[i..i + 8] == b[i..i + 8]));
        }
    }
    let blades = decode(&near.field);
    let tips = |rig: &Rig| super::decoded::states(&blades, &rig.states(), PhysicsModel::Sward);
    for (a, b) in tips(&near).iter().zip(tips(&other)) {
        assert!(a.tip.distance(b.tip) < 0.03, "{} is not {}", a.tip, b.tip);
    }
}

#[test]
fn debug_views_show_clusters() {
    let mut rig = rig(4096);
    let view = from(24.0);
    rig.step(&Frame::new(0.02, &breeze()), &[view]);
    let plain = draw(&mut rig, 0);
    rig.cull(&[View { debug: Some(DebugView::Level), ..view }]);
    let shown = draw(&mut rig, 0);
    assert_eq!(covered(&plain), covered(&shown));
    let pink = shown.iter().filter(|p| p[3] > 0 && p[0] > p[1] && p[2] > p[1]).count();
    assert!(pink * 10 > covered(&shown) * 9, "{pink}");
}
