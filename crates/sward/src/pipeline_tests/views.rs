//! Several views of one simulation, steps of any length, and what a host may get wrong.

use super::decoded::{decode, states};
use super::depth::depth_texture;
use super::rig::{Rig, shared};
use super::scenes::{breeze, is_sound, look, random_field, random_view, see_all, see_none};
use crate::{Collider, Culling, Error, Frame, Gravity, PhysicsModel, Sphere, Stage, View};
use glam::{Mat4, Vec3};

const MODELS: [PhysicsModel; 2] = [PhysicsModel::Sward, PhysicsModel::Paper];

fn rig() -> Rig {
    Rig::new(random_field(1, 1500, 5.0, 64))
}

#[test]
fn views_share_a_simulation_and_do_not_disturb_each_other() {
    let (mut both, mut alone) = (rig(), rig());
    let mut wind = breeze();
    for step in 0..4 {
        wind.advance(0.03);
        let [a, b] = [random_view(2 * step, 5.0), random_view(2 * step + 1, 5.0)];
        let frame = Frame::new(0.03, &wind);
        both.step(&frame, &[a, b]);
        let counted = both.statistics();
        alone.step(&frame, &[a]);
        assert_eq!(both.list(0), alone.list(0), "step {step}");
        assert_eq!(counted, alone.statistics(), "view 0 is counted");
        // The blades that both see have moved once
        alone.cull(&[b]);
        assert_eq!(both.list(1), alone.list(0), "step {step}");
        assert_eq!(both.states(), alone.states());
    }
}

#[test]
fn single_stages_do_what_the_fused_ones_do() {
    let (mut fused, mut single) = (rig(), rig());
    let mut wind = breeze();
    for step in 0..3 {
        wind.advance(0.03);
        let (frame, view) = (Frame::new(0.03, &wind), random_view(step, 5.0));
        fused.step(&frame, &[see_none(), view]);
        single.simulate(&frame);
        single.submit(|renderer, (device, _), encoder| {
            renderer.prepare_view(device, encoder, 1, &view).expect("a camera");
            for stage in
                [Stage::PatchCull, Stage::Physics, Stage::Visibility, Stage::Light, Stage::Compact]
            {
                renderer.encode_stage(device, encoder, stage, 1, &view);
            }
        });
        assert_eq!(fused.states(), single.states());
        assert_eq!(fused.list(1), single.list(1));
        assert_eq!(single.lists(0).capacity, 0, "views are numbered without gaps");
    }
}

#[test]
fn two_steps_before_a_view_count_as_one() {
    let (mut twice, mut once) = (rig(), rig());
    let blades = decode(&twice.field);
    let mut wind = breeze();
    let mut before = Vec::new();
    for _ in 0..20 {
        before = states(&blades, &once.states(), PhysicsModel::Sward);
        wind.advance(0.01);
        once.step(&Frame::new(0.01, &wind), &[see_all()]);
        twice.simulate(&Frame::new(0.01, &wind));
        wind.advance(0.01);
        once.step(&Frame::new(0.01, &wind), &[see_all()]);
        twice.step(&Frame::new(0.01, &wind), &[see_all()]);
    }
    let [a, b] = [&twice, &once].map(|r| states(&blades, &r.states(), PhysicsModel::Sward));
    let largest = |a: &[crate::frame::physics::twin::State], b: &[_]| {
        let pairs = a.iter().zip(b);
        pairs
            .map(|(a, b): (_, &crate::frame::physics::twin::State)| a.tip.distance(b.tip))
            .fold(0.0, f64::max)
    };
    let (off, moved) = (largest(&a, &b), largest(&before, &b));
    println!("off by {off:.1e} h; a step moves {moved:.1e} h");
    assert!(off < 2e-3 && moved > 2.0 * off, "{off} {moved}");
}

#[test]
fn steps_of_any_length_leave_numbers() {
    for model in MODELS {
        let mut rig = rig();
        let blades = decode(&rig.field);
        let mut wind = breeze();
        for dt_s in [0.016, 1e-5, 10.0, f32::NAN, f32::INFINITY, -1.0, 1e30, 0.016] {
            wind.advance(f64::from(dt_s));
            rig.step(&Frame { physics: model, ..Frame::new(dt_s, &wind) }, &[see_all()]);
            let all = states(&blades, &rig.states(), model);
            assert!(all.iter().all(is_sound), "{model:?}, {dt_s} s");
        }
        let before = rig.states();
        rig.step(&Frame { physics: model, ..Frame::new(0.0, &wind) }, &[see_all()]);
        let (a, b) = (states(&blades, &before, model), states(&blades, &rig.states(), model));
        let worst = a.iter().zip(&b).map(|(a, b)| a.tip.distance(b.tip)).fold(0.0, f64::max);
        assert!(worst < 1e-6, "no time passes, but {model:?} moves by {worst}");
    }
}

#[test]
fn absurd_spheres_are_ignored() {
    let absurd = [
        (Vec3::NAN, 1.0),
        (Vec3::ZERO, f32::NAN),
        (Vec3::ZERO, f32::INFINITY),
        (Vec3::INFINITY, 1.0),
        (Vec3::ZERO, 0.0),
        (Vec3::ZERO, -1.0),
    ]
    .map(|(center, radius)| Collider::ball(Sphere { center, radius }));
    for model in MODELS {
        let (mut with, mut without) = (rig(), rig());
        let wind = breeze();
        let plain = Frame { physics: model, ..Frame::new(0.02, &wind) };
        for _ in 0..3 {
            with.step(&Frame { colliders: &absurd, ..plain.clone() }, &[see_all()]);
            without.step(&plain, &[see_all()]);
        }
        assert_eq!(with.states(), without.states(), "{model:?}");
        // Finite, but beyond what a square can hold
        let huge = [
            Sphere { center: Vec3::splat(1e30), radius: 1e35 },
            Sphere { center: Vec3::splat(f32::MAX), radius: f32::MAX },
        ]
        .map(Collider::ball);
        with.step(&Frame { colliders: &huge, ..plain.clone() }, &[see_all()]);
        let all = states(&decode(&with.field), &with.states(), model);
        assert!(all.iter().all(is_sound), "{model:?}");
    }
}

#[test]
fn absurd_gravity_is_an_error_and_changes_nothing() {
    let (mut rig, mut other) = (rig(), rig());
    let wind = breeze();
    rig.step(&Frame::new(0.02, &wind), &[see_all()]);
    other.step(&Frame::new(0.02, &wind), &[see_all()]);
    let gravities = [
        Gravity { direction: Vec3::NAN, ..Gravity::default() },
        Gravity { strength: f32::INFINITY, ..Gravity::default() },
        Gravity { center: Vec3::INFINITY, ..Gravity::default() },
        Gravity { blend: f32::NAN, ..Gravity::default() },
        Gravity { blend: 1.5, ..Gravity::default() },
    ];
    for gravity in gravities {
        // Refused as a whole: the other model does not take over
        let frame = Frame { gravity, physics: PhysicsModel::Paper, ..Frame::new(0.02, &wind) };
        let error = rig.submit(|renderer, (device, _), encoder| {
            renderer.simulate(device, encoder, &frame).expect_err("no gravity")
        });
        assert!(matches!(&error, Error::Setting { setting, .. } if setting == "gravity"));
    }
    rig.step(&Frame::new(0.02, &wind), &[see_all()]);
    other.step(&Frame::new(0.02, &wind), &[see_all()]);
    assert_eq!(rig.states(), other.states());
    let strong = Gravity { strength: 1e38, center_strength: 1e38, ..Gravity::default() };
    rig.step(&Frame { gravity: strong, ..Frame::new(0.02, &wind) }, &[see_all()]);
    let all = states(&decode(&rig.field), &rig.states(), PhysicsModel::Sward);
    assert!(all.iter().all(is_sound));
}

#[test]
fn a_view_that_is_no_camera_is_an_error() {
    let mut rig = rig();
    let good = see_all();
    let small = depth_texture(&shared(), 1, "1.0");
    let culling = |max_distance_m| Culling { max_distance_m, ..Culling::default() };
    let bad = [
        View { view_from_world: Mat4::NAN, ..good },
        View { clip_from_view: Mat4::NAN, ..good },
        View { view_from_world: Mat4::ZERO, ..good },
        View { view_from_world: Mat4::from_scale(Vec3::splat(f32::INFINITY)), ..good },
        View { size: [0, 96], ..good },
        View { size: [128, 0], ..good },
        View { detail: 0.0, ..good },
        View { detail: f32::NAN, ..good },
        View { level: Some(4), ..good },
        View { culling: culling(0.0), ..good },
        View { culling: culling(f32::NAN), ..good },
        View { size: [129, 96], opaque_depth: Some(&small), ..good },
    ];
    for (i, view) in bad.into_iter().enumerate() {
        let error = rig.submit(|renderer, (device, _), encoder| {
            renderer.cull(device, encoder, &[view]).expect_err("no camera")
        });
        assert!(matches!(error, Error::Setting { .. }), "{i}: {error}");
    }
    rig.cull(&[look(Vec3::new(0.0, 2.0, 9.0), Vec3::ZERO)]);
    assert!(rig.statistics().blades_drawn > 0);
}
