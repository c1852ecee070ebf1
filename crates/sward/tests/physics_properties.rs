//! What must hold for every blade, checked on the f64 reference of both models.

mod common;

use common::{Draws, balls_near, calm, gusty_wind, rolling, upright};
use glam::{DVec3, Vec3, dvec3};
use sward::frame::collide::primitive::Primitive;
use sward::frame::collide::twin::contact_push;
use sward::frame::physics::twin::{Blade, State, Surroundings, advance, rest_tip};
use sward::frame::physics::{paper_twin, twin};
use sward::shared::curve_twin::project_tip;
use sward::{Gravity, Sphere, Wind};

const RATES_HZ: [u32; 3] = [30, 60, 144];

fn plain_blade(height: f64) -> Blade {
    Blade {
        root: DVec3::ZERO,
        up: DVec3::Y,
        facing: DVec3::Z,
        height,
        response: 5.0,
        droop: 0.4,
        gust: 1.0,
        arch: 0.2,
    }
}

/// Runs a blade for `seconds` at `hz` in the gusty wind, with a ball that may pass.
fn run(
    blade: &Blade,
    hz: u32,
    seconds: u32,
    ball: impl Fn(f64, f64) -> Option<Primitive>,
) -> State {
    let dt_s = 1.0 / f64::from(hz);
    let mut wind = gusty_wind();
    let mut state = State { tip: rest_tip(blade, &Gravity::default()), crush: 0.0 };
    for step in 0..hz * seconds {
        wind.advance(dt_s);
        let passing: Vec<_> = ball(f64::from(step + 1) * dt_s, dt_s).into_iter().collect();
        let around = Surroundings { primitives: &passing, ..calm(&wind, dt_s) };
        state = advance(blade, state, dt_s, &around);
    }
    state
}

#[test]
fn a_tip_is_never_under_its_root_plane() {
    for seed in 0..300 {
        let mut draws = Draws::new(seed);
        let blade = draws.blade(3.0);
        let mut wind = gusty_wind();
        let mut state = upright(&blade);
        let mut paper = state;
        for _ in 0..120 {
            let dt_s = f64::from(draws.between(0.001, 0.2));
            wind.advance(dt_s);
            let spheres = balls_near(&mut draws, &blade, 3);
            let around = Surroundings { primitives: &spheres, ..calm(&wind, dt_s) };
            state = advance(&blade, state, dt_s, &around);
            paper = paper_twin::advance(&blade, paper, dt_s, &around);
            assert!(state.tip.dot(blade.up) > -1e-6, "seed {seed}: {state:?}");
            assert!(paper.tip.dot(blade.up) > -1e-6, "seed {seed}, paper: {paper:?}");
            assert!((0.0..=2.0).contains(&state.crush) && (0.0..=2.0).contains(&paper.crush));
        }
    }
}

#[test]
fn crush_only_fades_without_contact() {
    let mut wind = gusty_wind();
    for seed in 0..100 {
        let mut draws = Draws::new(seed);
        let blade = draws.blade(0.5);
        let tip = project_tip(draws.unit(), blade.up, blade.facing, blade.arch);
        let mut state = State { tip, crush: f64::from(draws.between(0.0, 2.0)) };
        let mut paper = state;
        for _ in 0..200 {
            wind.advance(0.05);
            let around = calm(&wind, 0.05);
            let next = advance(&blade, state, 0.05, &around);
            let next_paper = paper_twin::advance(&blade, paper, 0.05, &around);
            assert!(next.crush < state.crush || next.crush == 0.0);
            assert!(next_paper.crush < paper.crush || next_paper.crush == 0.0);
            (state, paper) = (next, next_paper);
        }
        assert!(state.crush == 0.0 && paper.crush == 0.0, "10 s are enough for any crush");
    }
}

#[test]
fn displacement_never_grows_without_force() {
    let wind = Wind::default();
    let gravity = Gravity { strength: 0.0, center_strength: 0.0, ..Gravity::default() };
    for seed in 0..500 {
        let mut draws = Draws::new(seed);
        let blade = draws.blade(3.0);
        let tip = project_tip(draws.unit(), blade.up, blade.facing, blade.arch);
        let mut state = State { tip, crush: f64::from(draws.between(0.0, 2.0)) };
        for _ in 0..60 {
            let dt_s = 10_f64.powf(f64::from(draws.between(-5.0, 1.0)));
            let around = Surroundings { gravity, ..calm(&wind, dt_s) };
            let next = advance(&blade, state, dt_s, &around);
            let (before, after) = (state.tip.distance(blade.up), next.tip.distance(blade.up));
            assert!(after <= before + 1e-9, "seed {seed}, dt {dt_s}: {before} grew to {after}");
            state = next;
        }
    }
}

/// Of second order: half the step, a quarter of the error.
#[test]
fn halving_the_step_converges() {
    let blades: Vec<Blade> = (0..40).map(|seed| Draws::new(seed).blade(0.5)).collect();
    let tips = |hz: u32| -> Vec<DVec3> {
        blades.iter().map(|blade| run(blade, hz, 5, |_, _| None).tip).collect()
    };
    let exact = tips(2048);
    let error = |hz: u32| {
        let squares = tips(hz).iter().zip(&exact).map(|(a, b)| a.distance_squared(*b)).sum::<f64>();
        (squares / blades.len() as f64).sqrt()
    };
    let errors = [32, 64, 128, 256].map(error);
    println!("rms error of the tip at 32 to 256 Hz: {errors:?}");
    for pair in errors.windows(2) {
        assert!(pair[1] < pair[0] * 0.4, "halving must cut the error: {errors:?}");
    }
    assert!(errors[3] < 1e-3, "{errors:?}");
}

#[test]
fn frame_rates_agree_after_five_seconds() {
    let mut worst = 0.0_f64;
    for seed in 0..100 {
        let blade = Draws::new(seed).blade(0.5);
        let tips = RATES_HZ.map(|hz| run(&blade, hz, 5, |_, _| None).tip);
        worst = worst.max(tips[0].distance(tips[2])).max(tips[1].distance(tips[2]));
    }
    println!("worst tip difference between 30, 60 and 144 Hz: {worst:.5} h");
    assert!(worst < 0.02, "{worst}");
}

#[test]
fn crush_by_a_passing_ball_agrees_between_frame_rates() {
    let (mut sums, mut spreads) = ([0.0; 3], Vec::new());
    for seed in 0..200 {
        let mut draws = Draws::new(seed);
        let mut blade = draws.blade(0.3);
        blade.height = f64::from(draws.between(0.3, 0.8));
        let radius = draws.between(0.2, 0.5);
        let side = draws.between(-0.6, 0.6);
        let height = blade.root.y as f32 + radius * 0.8;
        let start = Vec3::new(blade.root.x as f32 - 2.0, height, blade.root.z as f32 + side);
        let ball = |time, dt_s| Some(rolling(start, Vec3::X * 1.5, radius, time, dt_s));
        let crushes = RATES_HZ.map(|hz| run(&blade, hz, 3, ball).crush);
        let spread = (crushes[0] - crushes[2]).abs().max((crushes[1] - crushes[2]).abs());
        if crushes.iter().any(|crush| *crush > 0.0) {
            spreads.push(spread);
        }
        for (sum, crush) in sums.iter_mut().zip(crushes) {
            *sum += crush;
        }
    }
    spreads.sort_by(f64::total_cmp);
    let [most, worst] = [9, 10].map(|tenths| spreads[(spreads.len() - 1) * tenths / 10]);
    println!(
        "crush at 30, 60, 144 Hz: {sums:?}; spread of a blade, 90 %: {most:.3}, worst {worst:.3}"
    );
    assert!(spreads.len() > 50, "the ball must touch most blades: {}", spreads.len());
    assert!(most < 0.05 && worst < 0.12, "{spreads:?}");
    // The trail as a whole; a single blade may slip off the ball's side a little earlier or later.
    for sum in &sums[..2] {
        assert!((sum / sums[2] - 1.0).abs() < 0.01, "{sums:?}");
    }
}

#[test]
fn a_sleeper_wakes_where_it_would_have_been() {
    const HZ: u32 = 60;
    let dt_s = 1.0 / f64::from(HZ);
    for sleep_s in [1, 3, 7, 10, 100] {
        let mut worst = 0.0_f64;
        for seed in 0..60 {
            let mut draws = Draws::new(seed);
            let blade = draws.blade(0.5);
            let mut wind = gusty_wind();
            let crush = if seed % 2 == 0 { 0.0 } else { f64::from(draws.between(0.0, 2.0)) };
            let tip = project_tip(draws.unit(), blade.up, blade.facing, blade.arch);
            let mut asleep = State { tip, crush };
            // Half of them were flattened, all then lived 1 to 9 s in the wind before they slept.
            if seed % 2 == 1 {
                let flat = asleep.tip.reject_from(blade.up);
                asleep.tip = project_tip(flat, blade.up, blade.facing, blade.arch);
                asleep.crush = asleep.tip.distance_squared(blade.up).min(2.0);
            }
            for _ in 0..HZ * (1 + seed % 9) {
                wind.advance(dt_s);
                asleep = advance(&blade, asleep, dt_s, &calm(&wind, dt_s));
            }
            let mut awake = asleep;
            for _ in 0..HZ * sleep_s {
                wind.advance(dt_s);
                awake = advance(&blade, awake, dt_s, &calm(&wind, dt_s));
            }
            let woken = advance(&blade, asleep, f64::from(sleep_s), &calm(&wind, dt_s));
            let error = woken.tip.distance(awake.tip);
            worst = worst.max(error);
            assert!((woken.crush - awake.crush).abs() < 1e-6);
        }
        println!("slept {sleep_s} s: worst tip error on waking {worst:.4} h");
        assert!(worst < 0.03, "slept {sleep_s} s: {worst}");
    }
}

#[test]
fn any_step_is_stable_and_finite() {
    let absurd = [
        Sphere { center: Vec3::ZERO, radius: f32::NAN },
        Sphere { center: Vec3::splat(f32::NAN), radius: 1.0 },
        Sphere { center: Vec3::ZERO, radius: f32::INFINITY },
        Sphere { center: Vec3::splat(1e30), radius: 1e35 },
        Sphere { center: Vec3::ZERO, radius: -1.0 },
    ]
    .map(Primitive::from);
    let mut wind = gusty_wind();
    for seed in 0..200 {
        let mut draws = Draws::new(seed);
        let blade = draws.blade(3.0);
        let mut state = upright(&blade);
        let mut paper = state;
        for step in 0..100 {
            let dt_s = 10_f64.powf(f64::from(draws.between(-5.0, 1.0)));
            wind.advance(dt_s);
            let mut spheres = balls_near(&mut draws, &blade, 2);
            spheres.push(absurd[(step % absurd.len() as u32) as usize]);
            spheres.push(Sphere { center: blade.root.as_vec3(), radius: 0.0 }.into());
            let around = Surroundings { primitives: &spheres, ..calm(&wind, dt_s) };
            state = advance(&blade, state, dt_s, &around);
            paper = paper_twin::advance(&blade, paper, dt_s, &around);
            for s in [state, paper] {
                assert!(s.tip.is_finite() && s.crush.is_finite(), "seed {seed}: {s:?}");
                assert!(s.tip.length() < 1.3, "seed {seed}: {s:?}");
            }
        }
    }
}

#[test]
fn a_step_of_nothing_changes_nothing() {
    let wind = gusty_wind();
    let blade = plain_blade(0.4);
    let state = State { tip: dvec3(0.3, 0.2, 0.1), crush: 0.7 };
    for gap in [0.0, -1.0, f64::NAN] {
        assert_eq!(advance(&blade, state, gap, &calm(&wind, 0.01)), state);
        assert_eq!(paper_twin::advance(&blade, state, gap, &calm(&wind, 0.01)), state);
    }
}

#[test]
fn a_broken_state_heals() {
    let wind = gusty_wind();
    let blade = plain_blade(0.4);
    let broken = State { tip: DVec3::NAN, crush: f64::INFINITY };
    for next in [advance, paper_twin::advance] {
        let state = next(&blade, broken, 0.01, &calm(&wind, 0.01));
        assert!(state.tip.is_finite() && state.crush.is_finite(), "{state:?}");
    }
}

/// Seconds until a flattened blade's tip is back at four fifths of its height at rest.
fn time_to_stand(height: f64, hz: u32) -> f64 {
    let wind = Wind::default();
    let dt_s = 1.0 / f64::from(hz);
    let blade = plain_blade(height);
    let rest = rest_tip(&blade, &Gravity::default());
    let tip = project_tip(DVec3::X, blade.up, blade.facing, blade.arch);
    let mut state = State { tip, crush: 2.0 };
    for step in 1..hz * 30 {
        state = advance(&blade, state, dt_s, &calm(&wind, dt_s));
        if state.tip.y > 0.8 * rest.y {
            return f64::from(step) * dt_s;
        }
    }
    f64::INFINITY
}

#[test]
fn a_crushed_blade_stands_again_seven_seconds_later() {
    for height in [0.05, 0.4, 2.0] {
        for hz in RATES_HZ {
            let seconds = time_to_stand(height, hz);
            println!("h {height} m at {hz} Hz: {seconds:.2} s");
            assert!((5.5..8.5).contains(&seconds), "{height} m at {hz} Hz: {seconds} s");
        }
    }
}

#[test]
fn a_low_ball_pushes_the_blade() {
    let blade = plain_blade(1.0);
    for top in [0.1, 0.3, 0.5, 0.7] {
        let radius = top / 2.0;
        let ball = Sphere { center: Vec3::new(0.4 * radius, radius, 0.0), radius }.into();
        let push = contact_push(&blade, DVec3::Y, &ball);
        assert!(push.x < -0.05 * f64::from(radius), "a ball {top} h high: {push}");
        let away = Sphere { center: Vec3::new(1.1 * radius, radius, 0.0), radius }.into();
        assert_eq!(contact_push(&blade, DVec3::Y, &away), DVec3::ZERO);
        // J's two points, the tip and the curve's midpoint at 0.75 h, do not feel it.
        assert_eq!(paper_twin::collision(&blade, DVec3::Y, &[ball]), (DVec3::ZERO, 0.0));
    }
}

#[test]
fn a_ball_that_stays_clears_its_blades() {
    let wind = Wind::default();
    let mut worst = 0.0_f64;
    for seed in 0..200 {
        let mut draws = Draws::new(seed);
        let blade = plain_blade(0.5);
        let radius = draws.between(0.1, 0.3);
        let aside = draws.unit().as_vec3() * Vec3::new(1.0, 0.0, 1.0) * 0.3;
        let ball = [Sphere { center: aside + Vec3::Y * radius, radius }.into()];
        let mut state = upright(&blade);
        for _ in 0..60 {
            let around = Surroundings { primitives: &ball, ..calm(&wind, 1.0 / 60.0) };
            state = advance(&blade, state, 1.0 / 60.0, &around);
        }
        if aside.length() < radius {
            continue;
        }
        let left = contact_push(&blade, state.tip, &ball[0]).length();
        worst = worst.max(left);
    }
    println!("deepest contact left after 1 s: {worst:.4} h of tip");
    assert!(worst < 0.1, "{worst}");
}

#[test]
fn scale_free_species_behave_alike() {
    // The same numbers but for the height: in calm air, the same pose in heights at all times.
    let (turf, reed) = (plain_blade(0.05), plain_blade(2.0));
    let wind = Wind::default();
    let start = State { tip: project_tip(DVec3::X, DVec3::Y, DVec3::Z, 0.2), crush: 0.5 };
    let (mut a, mut b) = (start, start);
    for _ in 0..200 {
        a = twin::advance(&turf, a, 0.02, &calm(&wind, 0.02));
        b = twin::advance(&reed, b, 0.02, &calm(&wind, 0.02));
        assert!(a.tip.distance(b.tip) < 1e-12);
    }
}

#[test]
fn droop_leans_a_blade_as_documented() {
    let lean = |droop| {
        let tip = rest_tip(&Blade { droop, arch: 0.0, ..plain_blade(0.4) }, &Gravity::default());
        tip.angle_between(DVec3::Y).to_degrees()
    };
    println!("lean at droop 0.3, 0.4, 0.65: {:.1} {:.1} {:.1}", lean(0.3), lean(0.4), lean(0.65));
    assert!((4.0..10.0).contains(&lean(0.3)));
    assert!((15.0..40.0).contains(&lean(0.65)));
}

/// Whatever pose a blade is left in, it comes back to the one it would have had: no azimuth is
/// neutral, no second equilibrium holds it.
#[test]
fn blades_forget_how_they_started() {
    let dt_s = 1.0 / 60.0;
    for (mut wind, tilt) in [(Wind::default(), 0.0), (Wind::default(), 0.6), (gusty_wind(), 0.6)] {
        let blades: Vec<Blade> = (0..60).map(|seed| Draws::new(seed).blade(tilt)).collect();
        let flat = |(seed, blade): (usize, &Blade)| {
            let aside = Draws::new(seed as u32 + 1000).unit().reject_from(blade.up);
            let tip = project_tip(aside, blade.up, blade.facing, blade.arch);
            (upright(blade), State { tip, crush: 0.0 })
        };
        let mut pairs: Vec<_> = blades.iter().enumerate().map(flat).collect();
        for _ in 0..60 * 20 {
            wind.advance(dt_s);
            for (blade, (a, b)) in blades.iter().zip(&mut pairs) {
                *a = advance(blade, *a, dt_s, &calm(&wind, dt_s));
                *b = advance(blade, *b, dt_s, &calm(&wind, dt_s));
            }
        }
        let worst = pairs.iter().map(|(a, b)| a.tip.distance(b.tip)).fold(0.0, f64::max);
        assert!(worst < 0.01, "tilt {tilt}: {worst}");
    }
}
