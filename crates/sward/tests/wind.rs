//! The wind as a host sees it: valid, smooth, moving, and exact after days.

mod common;

use common::gusty_wind;
use glam::{Vec2, Vec3};
use sward::{Error, Gusts, Waves, Wind, WindSource};

fn waves() -> Waves {
    Waves {
        direction: Vec2::new(3.0, 0.0),
        mean: 0.4,
        amplitude: 0.3,
        wavelength_m: 8.0,
        speed_mps: 4.0,
    }
}

fn gusts() -> Gusts {
    Gusts {
        direction: Vec2::X,
        strength: 1.0,
        size_m: 6.0,
        speed_mps: 5.0,
        turbulence: 0.5,
        seed: 3,
    }
}

fn refused(source: WindSource) -> String {
    match Wind::new(vec![WindSource::Waves(waves()), source]) {
        Err(Error::Setting { setting, .. }) => setting,
        other => panic!("should be refused: {other:?}"),
    }
}

#[test]
fn bad_settings_are_refused_by_name() {
    let w = waves();
    let wave = |w| refused(WindSource::Waves(w));
    assert_eq!(wave(Waves { direction: Vec2::ZERO, ..w }), "wind[1].direction");
    assert_eq!(wave(Waves { direction: Vec2::NAN, ..w }), "wind[1].direction");
    assert_eq!(wave(Waves { wavelength_m: 0.0, ..w }), "wind[1].wavelength_m");
    assert_eq!(wave(Waves { mean: f32::NAN, ..w }), "wind[1].mean");
    assert_eq!(wave(Waves { speed_mps: f32::INFINITY, ..w }), "wind[1].speed_mps");
    let g = gusts();
    let gust = |g| refused(WindSource::Gusts(g));
    assert_eq!(gust(Gusts { size_m: -1.0, ..g }), "wind[1].size_m");
    assert_eq!(gust(Gusts { turbulence: 1.5, ..g }), "wind[1].turbulence");
}

#[test]
fn settings_broken_later_are_no_wind() {
    let mut wind = Wind::new(vec![WindSource::Waves(waves())]).expect("valid");
    wind.sources[0] = WindSource::Waves(Waves { wavelength_m: f32::NAN, ..waves() });
    wind.advance(1.0);
    assert_eq!(wind.strength_at(Vec3::ONE, 0.0), Vec3::ZERO);
    assert!(wind.gpu_sources().is_empty());
    wind.sources.push(WindSource::Gusts(gusts()));
    assert_eq!(wind.gpu_sources().len(), 1);
    wind.advance(f64::NAN);
    assert!(wind.strength_at(Vec3::ONE, 0.0).is_finite());
}

#[test]
fn wind_is_smooth_in_time_and_place() {
    let mut wind = gusty_wind();
    let mut largest = 0.0_f32;
    for step in 0..2000 {
        let place = Vec3::new(step as f32 * 0.37 % 60.0, 0.0, step as f32 * 0.11 % 40.0);
        let now = wind.strength_at(place, 0.0);
        let beside = wind.strength_at(place + Vec3::new(0.01, 0.0, 0.01), 0.0);
        largest = largest.max(now.distance(beside) / 0.0142);
        wind.advance(0.002);
        largest = largest.max(now.distance(wind.strength_at(place, 0.0)) / 0.002 / 5.0);
        // What was 2 ms ago is what is then seen to have been.
        assert!(now.distance(wind.strength_at(place, 0.002)) < 1e-5);
    }
    println!("steepest change: {largest:.3} beta a metre");
    assert!(largest < 3.0, "{largest}");
}

#[test]
fn strengths_are_as_documented() {
    let mut wind = gusty_wind();
    let (mut sum, mut peak, mut n) = (0.0_f64, 0.0_f32, 0);
    for step in 0..4000 {
        wind.advance(0.1);
        let place = Vec3::new((step % 61) as f32, 0.0, (step % 47) as f32 * 1.7);
        let strength = wind.strength_at(place, 0.0).length();
        sum += f64::from(strength);
        peak = peak.max(strength);
        n += 1;
    }
    let mean = sum / f64::from(n);
    println!("mean {mean:.3}, peak {peak:.3}");
    assert!((0.25..0.75).contains(&mean), "{mean}");
    assert!((0.8..1.6).contains(&peak), "{peak}");
}

/// Crests travel along the direction at the given speed: the past is the same wind upstream.
#[test]
fn waves_and_gusts_travel() {
    for source in [WindSource::Waves(waves()), WindSource::Gusts(gusts())] {
        let speed = match &source {
            WindSource::Waves(w) => w.speed_mps,
            WindSource::Gusts(g) => g.speed_mps,
            _ => unreachable!(),
        };
        let wind = Wind::new(vec![source]).expect("valid");
        for i in 0..50 {
            let place = Vec3::new(i as f32, 0.0, i as f32 * 0.7);
            let past = wind.strength_at(place, 1.5);
            let downstream = wind.strength_at(place + Vec3::X * speed * 1.5, 0.0);
            assert!(past.distance(downstream) < 1e-4);
        }
    }
}

/// Crests are broken: along a straight line across the wind, on which plain waves would all be in
/// step, every wavelength or two finds another phase.
#[test]
fn crests_are_no_stripes() {
    let wind = Wind::new(vec![WindSource::Waves(waves())]).expect("valid");
    for x in [3.0, 20.0, 50.0, 90.0] {
        let at = |i: i32| wind.strength_at(Vec3::new(x, 0.0, i as f32), 0.0).x;
        let strengths: Vec<f32> = (0..400).map(at).collect();
        let high = strengths.iter().filter(|s| **s > 0.5).count();
        let low = strengths.iter().filter(|s| **s < 0.3).count();
        assert!(high > 40 && low > 40, "x {x}: {high} high, {low} low of 400");
    }
}

#[test]
fn days_of_wind_are_as_exact_as_seconds() {
    let mut wind = gusty_wind();
    wind.advance(30.0 * 86_400.0);
    let place = Vec3::new(12.0, 0.0, -7.0);
    let mut largest = 0.0_f32;
    for _ in 0..500 {
        let before = wind.strength_at(place, 0.0);
        wind.advance(0.004);
        largest = largest.max(before.distance(wind.strength_at(place, 0.0)));
        for source in wind.gpu_sources() {
            assert!(source.phase.iter().all(|p| (0.0..=256.0).contains(p)), "{source:?}");
        }
    }
    assert!(largest < 0.03 && largest > 1e-4, "{largest}");
}

#[test]
fn a_change_of_speed_makes_no_jump() {
    let mut wind = Wind::new(vec![WindSource::Waves(waves())]).expect("valid");
    wind.advance(1000.3);
    let place = Vec3::new(5.0, 0.0, 3.0);
    let before = wind.strength_at(place, 0.0);
    wind.sources[0] = WindSource::Waves(Waves { speed_mps: 9.0, ..waves() });
    assert_eq!(wind.strength_at(place, 0.0), before);
}
