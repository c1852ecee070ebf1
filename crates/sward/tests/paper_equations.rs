//! The paper's equations on hand-worked examples, and each erratum told from the printed form.

mod common;

use common::{calm, upright};
use glam::{DVec3, Vec2, Vec3, dvec3};
use sward::frame::physics::paper_twin::{advance, collision, push_out, step_s, valid_tip};
use sward::frame::physics::twin::{Blade, State, Surroundings, gravity_pull, wind_velocity};
use sward::{Gravity, Sphere, Waves, Wind, WindSource};

/// 1 m high, at the origin, facing z.
fn blade() -> Blade {
    Blade {
        root: DVec3::ZERO,
        up: DVec3::Y,
        facing: DVec3::Z,
        height: 1.0,
        response: 5.0,
        droop: 0.4,
        gust: 1.0,
        arch: 0.7,
    }
}

fn near(a: DVec3, b: DVec3) {
    assert!(a.distance(b) < 1e-6, "{a} is not {b}");
}

#[test]
fn recovery_is_the_way_back_times_response_and_what_crush_leaves() {
    // Equations 1 and 3 alone: no gravity, no wind. x = (0.6, -0.2, 0), s = 5, dt = 0.02.
    let wind = Wind::default();
    let gravity = Gravity { strength: 0.0, ..Gravity::default() };
    let around = Surroundings { gravity, ..calm(&wind, 0.02) };
    let tip = dvec3(0.6, 0.8, 0.0);
    for (crush, left) in [(0.0, 1.0), (0.5, 0.5), (1.7, 0.1)] {
        let moved = dvec3(0.6 - 0.6 * 5.0 * left * 0.02, 0.8 + 0.2 * 5.0 * left * 0.02, 0.0);
        let next = advance(&blade(), State { tip, crush }, 0.02, &around);
        near(next.tip, valid_tip(&blade(), moved));
    }
}

#[test]
fn crush_fades_from_its_old_value() {
    // Equation 2; printed, the right-hand side has c instead of the old eta.
    let wind = Wind::default();
    let state = State { tip: DVec3::Y, crush: 0.5 };
    let next = advance(&blade(), state, 0.1, &calm(&wind, 0.1));
    assert!((next.crush - 0.475).abs() < 1e-9, "{}", next.crush);
    let next = advance(&blade(), State { crush: 0.01, ..state }, 0.1, &calm(&wind, 0.1));
    assert_eq!(next.crush, 0.0, "max keeps it from passing 0");
}

#[test]
fn both_terms_of_gravity_are_unit_directions_times_strength() {
    // Equation 4; printed, the second term is not divided by its length: it would be 3 x 10.
    let gravity = Gravity {
        direction: Vec3::new(0.0, -2.0, 0.0),
        strength: 1.5,
        center: Vec3::new(10.0, 0.0, 0.0),
        center_strength: 3.0,
        blend: 0.25,
    };
    near(gravity_pull(&gravity, DVec3::ZERO), dvec3(0.75, -1.125, 0.0));
    near(gravity_pull(&gravity, dvec3(10.0, 4.0, 0.0)), dvec3(0.0, -1.125 - 0.75, 0.0));
    // At the centre itself that term has no direction.
    near(gravity_pull(&gravity, dvec3(10.0, 0.0, 0.0)), dvec3(0.0, -1.125, 0.0));
}

#[test]
fn front_gravity_is_a_quarter_along_the_facing() {
    // Equations 5 and 6 on an upright blade: gamma s = 2, so g = (0, -2, 0.5); dt = 0.1.
    let wind = Wind::default();
    let next = advance(&blade(), upright(&blade()), 0.1, &calm(&wind, 0.1));
    near(next.tip, valid_tip(&blade(), dvec3(0.0, 0.8, 0.05)));
}

#[test]
fn wind_acts_across_the_blade_and_on_its_height() {
    // Equations 7 and 8. s = 5, so beta 1 across the front of an upright blade is 5 heights/s.
    near(wind_velocity(&blade(), DVec3::Y, DVec3::Z), DVec3::Z * 5.0);
    // Along the blade: nothing. The printed fd without its absolute value would double at -y.
    near(wind_velocity(&blade(), DVec3::Y, DVec3::Y), DVec3::ZERO);
    near(wind_velocity(&blade(), DVec3::Y, -DVec3::Y), DVec3::ZERO);
    // Along the width: less, as the text says; the printed fd would give 5.
    near(wind_velocity(&blade(), DVec3::Y, DVec3::X), DVec3::X * 2.5);
    // A blade half way down, across its lean: fr = 0.6.
    near(wind_velocity(&blade(), dvec3(0.8, 0.6, 0.0), DVec3::Z), DVec3::Z * 3.0);
    near(wind_velocity(&blade(), DVec3::Y, DVec3::ZERO), DVec3::ZERO);
}

#[test]
fn wind_moves_the_tip() {
    let waves = Waves {
        direction: Vec2::new(0.0, 2.0),
        mean: 0.5,
        amplitude: 0.0,
        wavelength_m: 5.0,
        speed_mps: 1.0,
    };
    let wind = Wind::new(vec![WindSource::Waves(waves)]).expect("valid wind");
    let gravity = Gravity { strength: 0.0, ..Gravity::default() };
    let around = Surroundings { gravity, ..calm(&wind, 0.1) };
    // beta 0.5 times s = 5: 2.5 heights/s, for 0.1 s
    let next = advance(&blade(), upright(&blade()), 0.1, &around);
    near(next.tip, valid_tip(&blade(), dvec3(0.0, 1.0, 0.25)));
}

#[test]
fn ground_lifts_only_what_is_under_it() {
    // Equation 9, min and not max: a tip above the ground stays.
    let lifted = valid_tip(&blade(), dvec3(0.5, -0.4, 0.0));
    assert!(lifted.y.abs() < 1e-12 && lifted.x > 0.5, "{lifted}");
    let above = valid_tip(&blade(), dvec3(0.5, 0.4, 0.0));
    assert!(above.y > 0.3, "{above}");
}

#[test]
fn length_pass_divides_by_the_printed_estimate() {
    // Equations 10 to 13 by hand: v2 = (0.6, 0.8): l = 0.6, v1 = (0, 0.4), L0 = 1,
    // L1 = 0.4 + sqrt(0.36 + 0.16) = 1.1211103, L = (2 + 1.1211103) / 3 = 1.0403701.
    near(valid_tip(&blade(), dvec3(0.6, 0.8, 0.0)), dvec3(0.6, 0.8, 0.0) / 1.040_370_1);
    // Flat beyond h: l = 2, so v1 is at 0.05 l/h = 0.1; L = (4 + 0.1 + 2.0024984) / 3.
    near(valid_tip(&blade(), dvec3(2.0, 0.0, 0.0)), dvec3(2.0, 0.0, 0.0) / 2.034_166_1);
    // An upright blade of full length stays; the arch of the species is not the paper's.
    near(valid_tip(&blade(), DVec3::Y), DVec3::Y);
}

#[test]
fn collision_pushes_out_what_is_inside_only() {
    // Equation 14: min keeps what is inside. 0.2 inside, along +x away from the centre.
    let ball = Sphere { center: Vec3::new(-0.3, 1.0, 0.0), radius: 0.5 };
    near(push_out(DVec3::Y, &ball.into(), &blade(), DVec3::Z), dvec3(0.2, 0.0, 0.0));
    near(push_out(dvec3(0.3, 1.0, 0.0), &ball.into(), &blade(), DVec3::Z), DVec3::ZERO);
    // At the centre: along the lean, by the radius.
    near(push_out(ball.center.as_dvec3(), &ball.into(), &blade(), DVec3::Z), dvec3(0.0, 0.0, 0.5));
}

#[test]
fn midpoint_counts_four_times_but_crushes_once() {
    // Upright: m = 0.25 v0 + 0.5 v1 + 0.25 v2 = 0.75 up; a small ball at that height hits it only.
    let ball = Sphere { center: Vec3::new(-0.1, 0.75, 0.0), radius: 0.15 };
    let (moved, crush) = collision(&blade(), DVec3::Y, &[ball.into()]);
    near(moved, dvec3(0.2, 0.0, 0.0));
    assert!((crush - 0.05 * 0.05).abs() < 1e-8, "{crush}: equation 16 takes d before the four");
    let at_tip = Sphere { center: Vec3::new(-0.1, 1.0, 0.0), radius: 0.15 };
    let (moved, crush) = collision(&blade(), DVec3::Y, &[at_tip.into()]);
    near(moved, dvec3(0.05, 0.0, 0.0));
    assert!((crush - 0.05 * 0.05).abs() < 1e-8);
}

#[test]
fn step_is_short_enough_to_be_stable() {
    assert_eq!(step_s(&blade(), 0.016), 0.016);
    assert_eq!(step_s(&blade(), 10.0), 0.1);
    assert_eq!(step_s(&Blade { response: 50.0, ..blade() }, 10.0), 0.02);
}
