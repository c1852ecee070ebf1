//! The shipped WGSL against the f64 reference, on random blades, poses, winds and spheres.

mod common;
#[path = "common/physics_pass.rs"]
mod physics_pass;

use common::{Draws, balls_near, calm, device, gusty_wind, rolling, thing_near};
use glam::{DVec3, Vec3};
use physics_pass::{Model, PhysicsPass, rounded};
use sward::frame::collide::primitive::Primitive;
use sward::frame::physics::paper_twin;
use sward::frame::physics::twin::{self, Blade, State, Surroundings};
use sward::shared::curve_twin::project_tip;
use sward::{Gravity, Sphere, Wind};

const COUNT: u32 = 512;

fn blades(tilt: f64) -> Vec<Blade> {
    (0..COUNT).map(|seed| rounded(Draws::new(seed).blade(tilt))).collect()
}

/// Any pose, any crush; one in eight upright, where the curve's formula is most delicate.
fn states(blades: &[Blade]) -> Vec<State> {
    let state = |(seed, blade): (usize, &Blade)| {
        let mut draws = Draws::new(seed as u32 + 10_000);
        let pose = if seed % 8 == 0 { blade.up } else { draws.unit() };
        let tip = project_tip(pose, blade.up, blade.facing, blade.arch).as_vec3().as_dvec3();
        State { tip, crush: f64::from(draws.between(0.0, 2.0)) }
    };
    blades.iter().enumerate().map(state).collect()
}

fn advance(blade: &Blade, state: State, gap: f32, around: &Surroundings, model: Model) -> State {
    match model {
        Model::Sward => twin::advance(blade, state, f64::from(gap), around),
        Model::Paper => paper_twin::advance(blade, state, f64::from(gap), around),
        Model::Rest => State { tip: twin::rest_tip(blade, &around.gravity), crush: 0.0 },
    }
}

/// Tip differences, largest last, and the largest of crush.
fn differences(gpu: &[State], cpu: &[State]) -> (Vec<f64>, f64) {
    let mut tips: Vec<f64> = gpu.iter().zip(cpu).map(|(a, b)| a.tip.distance(b.tip)).collect();
    assert!(tips.iter().all(|d| d.is_finite()), "a state is not a number");
    tips.sort_by(f64::total_cmp);
    let crush = gpu.iter().zip(cpu).map(|(a, b)| (a.crush - b.crush).abs()).fold(0.0, f64::max);
    (tips, crush)
}

#[test]
fn one_step_equals_the_reference() {
    let (blades, mut wind) = (blades(3.0), gusty_wind());
    let start = states(&blades);
    wind.advance(1234.5);
    let spheres: Vec<Primitive> = blades
        .iter()
        .enumerate()
        .flat_map(|(i, blade)| balls_near(&mut Draws::new(i as u32 + 777), blade, 2))
        .collect();
    let mut draws = Draws::new(1);
    let gaps: Vec<f32> = blades.iter().map(|_| 10_f32.powf(draws.between(-4.0, 1.0))).collect();
    let gravity = Gravity { blend: 0.3, center: Vec3::new(0.0, -20.0, 0.0), ..Gravity::default() };
    let center = Gravity { blend: 1.0, center: blades[3].root.as_vec3(), ..Gravity::default() };
    for model in [Model::Sward, Model::Paper, Model::Rest] {
        for (gravity, balls) in [(gravity, true), (Gravity::default(), false), (center, false)] {
            let spheres = if balls { &spheres[..] } else { &[] };
            let around =
                Surroundings { primitives: spheres, gravity, ..calm(&wind, 0.016_f32.into()) };
            let pass = PhysicsPass::new(&blades, &start);
            pass.step(&around, &gaps, model);
            let cpu: Vec<State> = (0..blades.len())
                .map(|i| {
                    let spheres = if balls { &spheres[i * 2..i * 2 + 2] } else { &[] };
                    let around = Surroundings { primitives: spheres, ..around };
                    advance(&blades[i], start[i], gaps[i], &around, model)
                })
                .collect();
            let (tips, crush) = differences(&pass.states(), &cpu);
            let worst = tips[tips.len() - 1];
            println!("{model:?}, balls {balls}: tip {worst:.2e} h, crush {crush:.2e}");
            assert!(worst < 2e-4, "{model:?}: {:?}", &tips[tips.len() - 8..]);
            assert!(crush < 2e-4, "{model:?}: {crush}");
        }
    }
}

/// Capsules, balls that moved and boxes. Where two ways out are as near the sides may choose apart.
#[test]
fn contact_equals_the_reference() {
    let blades = blades(0.8);
    let (start, wind) = (states(&blades), Wind::default());
    let gaps = vec![0.016; blades.len()];
    for model in [Model::Sward, Model::Paper] {
        for kind in 0..3 {
            let things: Vec<Primitive> = blades
                .iter()
                .enumerate()
                .map(|(i, b)| thing_near(&mut Draws::new(i as u32 + 1 + 1000 * kind), b, kind))
                .collect();
            let plain = calm(&wind, 0.016_f32.into());
            let pass = PhysicsPass::new(&blades, &start);
            pass.step(&Surroundings { primitives: &things, ..plain }, &gaps, model);
            let step = |i: usize, primitives| {
                let around = Surroundings { primitives, ..plain };
                advance(&blades[i], start[i], gaps[i], &around, model)
            };
            let cpu: Vec<State> = (0..blades.len()).map(|i| step(i, &things[i..=i])).collect();
            let hit = (0..blades.len()).filter(|i| step(*i, &[]).tip != cpu[*i].tip).count();
            let (tips, _) = differences(&pass.states(), &cpu);
            let far = tips.iter().filter(|d| **d > 5e-4).count();
            println!(
                "{model:?}, kind {kind}: {hit} hit, {far} apart; {:.1e}",
                tips[tips.len() / 2]
            );
            assert!(hit > 100 && far * 100 <= hit, "{model:?} {kind}: {:?}", &tips[500..]);
        }
    }
}

/// Steps blades on both sides and returns the differences at the end.
fn run(hz: f32, frames: u32, model: Model, ball: Option<Sphere>) -> (Vec<f64>, f64) {
    let (blades, mut wind, dt_s) = (blades(0.5), gusty_wind(), 1.0 / hz);
    let mut cpu = states(&blades);
    let pass = PhysicsPass::new(&blades, &cpu);
    let gaps = vec![dt_s; blades.len()];
    for frame in 0..frames {
        wind.advance(dt_s.into());
        let around = calm(&wind, dt_s.into());
        let time = f64::from(frame) * f64::from(dt_s);
        // The same ball for each blade, in the blade's own place and size.
        let spheres: Vec<Primitive> = ball
            .iter()
            .flat_map(|b| blades.iter().map(move |blade| seen_by(blade, b, time, dt_s.into())))
            .collect();
        pass.step(&Surroundings { primitives: &spheres, ..around }, &gaps, model);
        for (i, (blade, state)) in blades.iter().zip(&mut cpu).enumerate() {
            let spheres = spheres.get(i..=i).unwrap_or_default();
            *state = advance(
                blade,
                *state,
                dt_s,
                &Surroundings { primitives: spheres, ..around },
                model,
            );
        }
    }
    differences(&pass.states(), &cpu)
}

fn seen_by(blade: &Blade, ball: &Sphere, time_s: f64, dt_s: f64) -> Primitive {
    let h = blade.height as f32;
    rolling(blade.root.as_vec3() + ball.center * h, Vec3::X * h, ball.radius * h, time_s, dt_s)
}

#[test]
fn six_hundred_frames_equal_the_reference() {
    for (model, hz) in [(Model::Sward, 144.0), (Model::Sward, 240.0), (Model::Paper, 144.0)] {
        let (tips, crush) = run(hz, 600, model, None);
        let worst = tips[tips.len() - 1];
        println!("{model:?} at {hz} Hz: tip {worst:.2e} h, crush {crush:.2e}");
        assert!(worst < 1e-3, "{model:?}: {:?}", &tips[tips.len() - 8..]);
        assert!(crush < 1e-3, "{model:?}: {crush}");
    }
}

/// A ball divides those that it passes; one that it meets head on may fall to either side.
#[test]
fn blades_under_a_ball_equal_the_reference() {
    let ball = Sphere { center: Vec3::new(-1.5, 0.3, 0.2), radius: 0.4 };
    let (tips, crush) = run(60.0, 240, Model::Sward, Some(ball));
    let at = |share: f64| tips[(share * (tips.len() - 1) as f64) as usize];
    println!(
        "tip median {:.2e}, 99 % {:.2e}, worst {:.2e} h; crush {crush:.2e}",
        at(0.5),
        at(0.99),
        at(1.0)
    );
    assert!(at(0.99) < 1e-3, "{:?}", &tips[tips.len() - 16..]);
}

#[test]
fn absurd_surroundings_leave_numbers() {
    let blades = blades(3.0);
    let mut start = states(&blades);
    start[5] = State { tip: DVec3::NAN, crush: f64::NAN };
    let absurd = [
        (Vec3::ZERO, f32::NAN),
        (Vec3::splat(f32::NAN), 1.0),
        (Vec3::ZERO, f32::INFINITY),
        (Vec3::splat(1e30), 1e35),
        (Vec3::splat(f32::MAX), f32::MAX),
    ];
    let spheres: Vec<Primitive> = (0..blades.len())
        .map(|i| absurd[i % absurd.len()])
        .map(|(center, radius)| Sphere { center, radius }.into())
        .collect();
    let wind = gusty_wind();
    for model in [Model::Sward, Model::Paper] {
        let pass = PhysicsPass::new(&blades, &start);
        for dt in [1e-5, 10.0, 0.016, f32::MAX, f32::INFINITY, f32::NAN] {
            pass.step(
                &Surroundings { primitives: &spheres, ..calm(&wind, 0.016) },
                &vec![dt; blades.len()],
                model,
            );
        }
        for (i, state) in pass.states().iter().enumerate() {
            assert!(state.tip.is_finite() && state.crush.is_finite(), "{model:?} {i}: {state:?}");
            assert!(state.tip.length() < 1.3, "{model:?} {i}: {state:?}");
        }
    }
}
