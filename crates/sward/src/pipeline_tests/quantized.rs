//! The quantised state in the whole pipeline against an unquantised `f64` reference.

use super::decoded::{Decoded, decode, states};
use super::rig::Rig;
use super::scenes::{breeze, random_field, random_states, see_all, surroundings};
use crate::frame::collide::primitive::Primitive;
use crate::frame::physics::paper_twin;
use crate::frame::physics::twin::{self, State, Surroundings};
use crate::gpu::state_twin::{CRUSH_STEP, pack_state};
use crate::{Collider, Frame, PhysicsModel, Sphere};
use glam::Vec3;

/// Frames recorded at once.
const BATCH: u32 = 50;

struct Run {
    hz: f32,
    model: PhysicsModel,
    /// Of every blade at first.
    crush: f64,
    spheres_at: fn(f32) -> Vec<Sphere>,
}

impl Run {
    fn spheres(&self, frame: u32) -> Vec<Sphere> {
        (self.spheres_at)(frame as f32 / self.hz)
    }

    /// Awake blades in random poses.
    fn start(&self) -> (Rig, Vec<Decoded>, Vec<State>) {
        let mut rig = Rig::new(random_field(self.hz as u32, 192, 3.0, 64));
        let wind = breeze();
        let frame = Frame { physics: self.model, ..Frame::new(1.0 / self.hz, &wind) };
        // The first step wakes the blades; their state is set after it
        rig.step(&frame, &[see_all()]);
        let blades = decode(&rig.field);
        let pose = states(&blades, &random_states(3, &blades, self.model), self.model);
        let bits: Vec<_> = (pose.iter().zip(&blades))
            .map(|(state, b)| {
                pack_state(&b.physics, State { crush: self.crush, ..*state }, self.model)
            })
            .collect();
        rig.write_states(&bits);
        let cpu = states(&blades, &bits, self.model);
        (rig, blades, cpu)
    }

    /// Moves a field on both sides for 600 frames; returns the tip differences, sorted, and the
    /// largest of crush.
    fn compare(&self) -> (Vec<f64>, f64) {
        let (mut rig, blades, mut cpu) = self.start();
        let (mut wind, dt_s) = (breeze(), 1.0 / self.hz);
        for batch in 0..600 / BATCH {
            let frames = batch * BATCH..(batch + 1) * BATCH;
            let winds: Vec<_> = frames
                .clone()
                .map(|_| {
                    wind.advance(dt_s.into());
                    wind.clone()
                })
                .collect();
            rig.submit(|renderer, (device, _), encoder| {
                for (frame, wind) in frames.clone().zip(&winds) {
                    let spheres = self.spheres(frame);
                    let plain = Frame::new(dt_s, wind);
                    let colliders: Vec<_> = spheres.into_iter().map(Collider::ball).collect();
                    let frame = Frame { physics: self.model, colliders: &colliders, ..plain };
                    renderer.simulate(device, encoder, &frame).expect("valid frame");
                    renderer.cull(device, encoder, &[see_all()]).expect("valid view");
                }
            });
            for (frame, wind) in frames.zip(&winds) {
                let spheres = self.spheres(frame);
                let primitives: Vec<_> = spheres.into_iter().map(Primitive::from).collect();
                let around = surroundings(wind, &primitives, dt_s);
                for (blade, state) in blades.iter().zip(&mut cpu) {
                    *state = advance(self.model, &blade.physics, *state, dt_s, &around);
                }
            }
        }
        differences(&states(&blades, &rig.states(), self.model), &cpu)
    }
}

fn advance(
    model: PhysicsModel,
    blade: &twin::Blade,
    state: State,
    dt_s: f32,
    around: &Surroundings,
) -> State {
    match model {
        PhysicsModel::Sward => twin::advance(blade, state, dt_s.into(), around),
        PhysicsModel::Paper => paper_twin::advance(blade, state, dt_s.into(), around),
    }
}

fn differences(gpu: &[State], cpu: &[State]) -> (Vec<f64>, f64) {
    let mut tips: Vec<f64> = gpu.iter().zip(cpu).map(|(a, b)| a.tip.distance(b.tip)).collect();
    assert!(tips.iter().all(|x| x.is_finite()));
    tips.sort_by(f64::total_cmp);
    let crush = gpu.iter().zip(cpu).map(|(a, b)| (a.crush - b.crush).abs()).fold(0.0, f64::max);
    (tips, crush)
}

fn no_spheres(_: f32) -> Vec<Sphere> {
    Vec::new()
}

/// A crushed blade moves slowly, and the finer the steps the smaller they are: where the state has
/// too few bits, it stalls.
#[test]
fn a_crushed_blade_does_not_stall() {
    for (hz, model, crush) in [(240.0, PhysicsModel::Sward, 0.5), (144.0, PhysicsModel::Paper, 1.0)]
    {
        let (tips, crush_off) = Run { hz, model, crush, spheres_at: no_spheres }.compare();
        let worst = tips[tips.len() - 1];
        println!("{model:?} at {hz} Hz, crush {crush}: tip {worst:.2e} h, crush {crush_off:.2e}");
        assert!(worst < 0.002, "{model:?} at {hz} Hz: {worst}");
        // Rounded each frame, but up as often as down
        assert!(crush_off < 4.0 * CRUSH_STEP, "{model:?}: {crush_off}");
    }
}

/// A ball divides those that it passes: one that it meets head on may fall to either side.
#[test]
fn balls_push_as_in_the_reference() {
    fn balls(time_s: f32) -> Vec<Sphere> {
        let at = |x: f32, z: f32| Sphere { center: Vec3::new(x, 0.2, z), radius: 0.25 };
        vec![at(-3.0 + 1.5 * time_s, 0.3), at(1.0, 3.0 - time_s)]
    }
    let (tips, crush) =
        Run { hz: 144.0, model: PhysicsModel::Sward, crush: 0.0, spheres_at: balls }.compare();
    let at = |share: f64| tips[(share * (tips.len() - 1) as f64) as usize];
    println!(
        "tip median {:.1e}, 98 % {:.1e}, worst {:.1e} h; crush {crush:.1e}",
        at(0.5),
        at(0.98),
        at(1.0)
    );
    assert!(at(0.98) < 0.002, "{:?}", &tips[tips.len() - 16..]);
}
