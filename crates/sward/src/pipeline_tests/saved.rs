//! A run that is cut in two, saved and restored, is the run as a whole.

use super::rig::{Rig, shared};
use super::scenes;
use crate::gpu::layout::GpuDraw;
use crate::gpu::test_device;
use crate::{
    Collider, ColliderShape, Error, Field, FieldDesc, Frame, Gusts, Mesh, Pose, Surface, View,
    Waves, Wind, WindSource,
};
use glam::{UVec2, Vec2, Vec3};

fn field(seed: u64) -> Field {
    let mesh = Mesh::plane(Vec2::splat(12.0), UVec2::ONE).expect("a plane");
    let surface = Surface::new(mesh).expect("a surface");
    let desc = FieldDesc { density: 60.0, seed, patch_size: 64, ..FieldDesc::default() };
    Field::grow(&surface, &desc).expect("grass")
}

fn wind() -> Wind {
    let sources = vec![WindSource::Waves(Waves::default()), WindSource::Gusts(Gusts::default())];
    Wind::new(sources).expect("wind")
}

/// Sees a part of the field, another one at each step, so that patches sleep and wake.
fn view(step: u32) -> View<'static> {
    let eye = Vec3::new(-6.0 + 0.5 * step as f32, 1.0, 3.0);
    scenes::look(eye, eye + Vec3::new(0.0, -0.3, -1.0))
}

/// Runs steps; a ball comes through, and is gone in the last of them.
fn run(rig: &mut Rig, wind: &mut Wind, steps: std::ops::Range<u32>) {
    for step in steps {
        let dt_s = 1.0 / 60.0;
        wind.advance(f64::from(dt_s));
        let at = |step: f32| Pose::at(Vec3::new(-5.0 + 0.6 * step, 0.3, 0.0));
        let ball = Collider {
            shape: ColliderShape::Sphere { radius: 0.5 },
            pose: at(step as f32),
            last_pose: Some(at(step as f32 - 1.0)),
        };
        let balls = [ball];
        let colliders = if step < 14 { &balls[..] } else { &[] };
        let frame = Frame { colliders, ..Frame::new(dt_s, wind) };
        rig.step(&frame, &[view(step)]);
    }
}

fn state(rig: &Rig) -> Vec<u8> {
    rig.renderer.save_state(&rig.device, &rig.queue).expect("a state")
}

/// The entries of every draw; what lies between them is left from earlier steps.
fn drawn(rig: &Rig) -> Vec<Vec<u32>> {
    let lists = &rig.renderer.pages()[0].views[0];
    let list = test_device::read::<u32>(&rig.device, &rig.queue, &lists.list);
    let draws = test_device::read::<GpuDraw>(&rig.device, &rig.queue, &lists.draws);
    let range = |draw: &GpuDraw| draw.start as usize..(draw.start + draw.count) as usize;
    draws.iter().map(|draw| list[range(draw)].to_vec()).collect()
}

#[test]
fn two_halves_are_the_whole() {
    let (mut whole, mut whole_wind) = (Rig::new(field(1)), wind());
    run(&mut whole, &mut whole_wind, 0..18);
    for cut in [1, 7, 14] {
        let (mut first, mut first_wind) = (Rig::new(field(1)), wind());
        run(&mut first, &mut first_wind, 0..cut);
        let saved = state(&first);
        let mut second = Rig::new(field(1));
        second.renderer.restore_state(&second.queue, &saved).expect("its own state");
        assert_eq!(state(&second), saved, "what is restored is what was saved");
        run(&mut second, &mut first_wind, cut..18);
        assert!(state(&second) == state(&whole), "cut at {cut}");
        assert!(drawn(&second) == drawn(&whole), "cut at {cut}");
    }
}

fn refused(rig: &mut Rig, saved: &[u8], cause: &str) {
    let before = state(rig);
    let error = rig.renderer.restore_state(&rig.queue, saved).expect_err("bad state");
    assert!(matches!(error, Error::State(_)) && error.to_string().contains(cause), "{error}");
    assert!(state(rig) == before, "a refusal changes nothing");
}

#[test]
fn other_states_are_refused() {
    let mut rig = Rig::new(field(1));
    let wind = Wind::default();
    rig.step(&Frame::new(0.1, &wind), &[view(3)]);
    let saved = state(&rig);
    refused(&mut rig, &[], "is cut short");
    refused(&mut rig, &saved[..20], "is cut short");
    refused(&mut rig, &saved[..saved.len() - 1], "is cut short");
    refused(&mut rig, &[&saved[..], &[0]].concat(), "is damaged");
    refused(&mut rig, &vec![7; saved.len()], "is none");
    for at in [saved.len() - 1, saved.len() / 2] {
        let mut flipped = saved.clone();
        flipped[at] ^= 4;
        refused(&mut rig, &flipped, "is damaged");
    }
    let mut later = saved.clone();
    later[8] += 1;
    refused(&mut rig, &later, "is of version 2");
    let mut lost = saved.clone();
    lost[24..32].copy_from_slice(&f64::NAN.to_le_bytes());
    refused(&mut rig, &lost, "its time is none");
    refused(&mut Rig::new(field(2)), &saved, "is of other fields");
    rig.renderer.restore_state(&rig.queue, &saved).expect("its own state");
}

/// The paper's model keeps other bits; a state brings its model along.
#[test]
fn a_state_has_its_model() {
    let mut rig = Rig::on(shared(), scenes::random_field(7, 500, 3.0, 64));
    let wind = wind();
    let paper = Frame { physics: crate::PhysicsModel::Paper, ..Frame::new(0.02, &wind) };
    rig.step(&paper, &[view(3)]);
    let saved = state(&rig);
    let mut other = Rig::on(shared(), scenes::random_field(7, 500, 3.0, 64));
    other.renderer.restore_state(&other.queue, &saved).expect("its own state");
    rig.step(&paper, &[view(3)]);
    other.step(&paper, &[view(3)]);
    assert!(state(&rig) == state(&other));
}
