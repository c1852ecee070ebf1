//! Cosines, rotors, vortices and fans: what a person who stands there would feel.

use glam::{Vec2, Vec3, vec3};
use sward::{Cosine, Error, Fan, Rotor, Vortex, Wind, WindMap, WindSource, WindTexture};

fn wind(source: WindSource) -> Wind {
    Wind::new(vec![source]).expect("valid")
}

/// Without what moves and shakes it.
fn steady_rotor() -> Rotor {
    Rotor { pulse: 0.0, turbulence: 0.0, swirl: 0.0, ..Rotor::default() }
}

fn steady_vortex() -> Vortex {
    Vortex { turbulence: 0.0, inflow: 0.0, updraft: 0.0, ..Vortex::default() }
}

fn steady_fan() -> Fan {
    Fan { turbulence: 0.0, ..Fan::default() }
}

/// A map with one gust across its middle row, which turns to the right: 4 texels of 5 m.
fn gust_map() -> WindTexture {
    let mut winds = vec![[0.0, 0.0]; 16];
    (0..4).for_each(|column| winds[4 + column] = [1.0, 0.5]);
    winds[4] = [0.2, -0.5];
    let map = WindMap::new(4, 4, winds).expect("a map").into();
    WindTexture { map, size_m: 20.0, strength: 2.0, speed_mps: 2.5, direction: Vec2::Y }
}

fn moving() -> [WindSource; 3] {
    [
        WindSource::Rotor(Rotor::default()),
        WindSource::Vortex(Vortex::default()),
        WindSource::Fan(Fan::default()),
    ]
}

fn refused(source: WindSource) -> String {
    match Wind::new(vec![source]) {
        Err(Error::Setting { setting, .. }) => setting,
        other => panic!("should be refused: {other:?}"),
    }
}

#[test]
fn bad_settings_are_refused_by_name() {
    let cosine = |c| refused(WindSource::Cosine(c));
    let c = Cosine::default();
    assert_eq!(cosine(Cosine { direction: Vec2::ZERO, ..c }), "wind[0].direction");
    assert_eq!(cosine(Cosine { period_s: 0.0, ..c }), "wind[0].period_s");
    assert_eq!(cosine(Cosine { wavelength_m: f32::NAN, ..c }), "wind[0].wavelength_m");
    let rotor = |r| refused(WindSource::Rotor(r));
    let r = Rotor::default();
    assert_eq!(rotor(Rotor { radius_m: 0.0, ..r }), "wind[0].radius_m");
    assert_eq!(rotor(Rotor { range_m: -1.0, ..r }), "wind[0].range_m");
    assert_eq!(rotor(Rotor { blades: 0, ..r }), "wind[0].blades");
    assert_eq!(rotor(Rotor { rpm: f32::NAN, ..r }), "wind[0].rpm");
    assert_eq!(rotor(Rotor { speed_mps: 0.0, ..r }), "wind[0].speed_mps");
    assert_eq!(rotor(Rotor { position: Vec3::NAN, ..r }), "wind[0].position");
    assert_eq!(rotor(Rotor { velocity: Vec3::splat(1e9), ..r }), "wind[0].velocity");
    let vortex = |v| refused(WindSource::Vortex(v));
    let v = Vortex::default();
    assert_eq!(vortex(Vortex { strength: -1.0, ..v }), "wind[0].strength");
    assert_eq!(vortex(Vortex { inflow: f32::INFINITY, ..v }), "wind[0].inflow");
    let texture = |t| refused(WindSource::Texture(t));
    assert_eq!(texture(WindTexture { size_m: 0.0, ..gust_map() }), "wind[0].size_m");
    assert_eq!(texture(WindTexture { direction: Vec2::NAN, ..gust_map() }), "wind[0].direction");
    assert_eq!(texture(WindTexture { strength: -0.1, ..gust_map() }), "wind[0].strength");
    let fan = |f| refused(WindSource::Fan(f));
    let f = Fan::default();
    assert_eq!(fan(Fan { direction: Vec3::ZERO, ..f }), "wind[0].direction");
    assert_eq!(fan(Fan { half_angle_deg: 90.0, ..f }), "wind[0].half_angle_deg");
    assert_eq!(fan(Fan { turbulence: 2.0, ..f }), "wind[0].turbulence");
}

#[test]
fn a_map_blows_along_and_across_and_repeats() {
    let wind = wind(WindSource::Texture(gust_map()));
    // Direction z: columns run along z, rows across it, which seen from above is towards -x.
    let at = |along: f32, across: f32| wind.strength_at(vec3(-across, 0.3, along), 0.0);
    let middle = at(7.5, 7.5);
    assert!(middle.distance(vec3(-1.0, 0.0, 2.0)) < 1e-6, "{middle}");
    assert!(at(2.5, 7.5).distance(vec3(1.0, 0.0, 0.4)) < 1e-6);
    assert!(at(5.0, 7.5).distance(vec3(0.0, 0.0, 1.2)) < 1e-6, "straight between two texels");
    assert_eq!(at(7.5, 12.5), Vec3::ZERO);
    for (tile_along, tile_across) in [(1.0, 0.0), (-2.0, 1.0), (40.0, -7.0)] {
        let again = at(7.5 + 20.0 * tile_along, 7.5 + 20.0 * tile_across);
        assert!(again.distance(middle) < 1e-3, "{again}");
    }
}

#[test]
fn a_map_drifts_along_its_direction() {
    let mut wind = wind(WindSource::Texture(gust_map()));
    let at = |wind: &Wind, along: f32, ago: f32| wind.strength_at(vec3(-7.5, 0.0, along), ago);
    let before = at(&wind, 2.5, 0.0);
    wind.advance(2.0);
    assert!(at(&wind, 7.5, 0.0).distance(before) < 1e-5, "5 m on");
    assert!(at(&wind, 2.5, 2.0).distance(before) < 1e-5, "the past");
    wind.advance(6.0 + 8.0 * 1e6);
    assert!(at(&wind, 2.5, 0.0).distance(before) < 1e-3, "a tile has passed");
}

#[test]
fn noise_maps_have_no_seam_and_depend_on_their_seed() {
    let map = WindMap::noise(4, 1);
    assert_eq!(map, WindMap::noise(4, 1));
    assert_ne!(map, WindMap::noise(4, 2));
    let (width, height) = (map.width() as usize, map.height() as usize);
    let wind = |x: usize, y: usize| Vec2::from(map.winds()[(y % height) * width + x % width]);
    let step =
        |(x, y, dx, dy): (usize, usize, usize, usize)| wind(x, y).distance(wind(x + dx, y + dy));
    let inside = (0..width - 1).flat_map(|x| (0..height - 1).map(move |y| (x, y)));
    let most = inside.map(|(x, y)| step((x, y, 1, 0)).max(step((x, y, 0, 1)))).fold(0.0, f32::max);
    for i in 0..width {
        assert!(step((width - 1, i, 1, 0)) <= most && step((i, height - 1, 0, 1)) <= most);
    }
    assert!(most < 0.2, "{most}");
    let strong = map.winds().iter().filter(|w| w[0] > 0.8).count();
    let weak = map.winds().iter().filter(|w| w[0] < 0.2).count();
    assert!(strong > 2_000 && weak > 2_000, "{strong} {weak}");
}

#[test]
fn bad_maps_are_refused() {
    let refused = |width, height, winds| match WindMap::new(width, height, winds) {
        Err(Error::Setting { setting, cause }) => format!("{setting}: {cause}"),
        other => panic!("should be refused: {other:?}"),
    };
    assert!(refused(0, 4, vec![]).contains("sides must be 1 to 2048"));
    assert!(refused(2049, 1, vec![[0.0; 2]; 2049]).contains("2049 x 1"));
    assert!(refused(2, 2, vec![[0.0; 2]; 3]).contains("but 3 winds"));
    assert!(refused(1, 1, vec![[f32::NAN, 0.0]]).contains("wind 0 is"));
    assert!(refused(1, 1, vec![[0.0, -1.5]]).contains("use -1 to 1"));
}

#[test]
fn a_cosine_swings_with_its_period_and_along_its_direction() {
    let source = Cosine { direction: Vec2::new(0.0, 3.0), period_s: 2.0, ..Cosine::default() };
    let mut wind = wind(WindSource::Cosine(source));
    let at = |wind: &Wind, z| wind.strength_at(vec3(7.0, 1.0, z), 0.0);
    assert!(at(&wind, 0.0).distance(Vec3::Z * 0.5) < 1e-6);
    assert!(at(&wind, 10.0).distance(Vec3::Z * -0.5) < 1e-6, "half a wavelength on");
    let now = at(&wind, 3.3);
    wind.advance(0.5);
    assert!(at(&wind, 0.0).length() < 1e-6, "a quarter of the period later");
    assert!(wind.strength_at(vec3(7.0, 1.0, 3.3), 0.5).distance(now) < 1e-6);
    wind.advance(1.5);
    assert!(at(&wind, 3.3).distance(now) < 1e-6);
    let unison = Cosine { wavelength_m: f32::INFINITY, ..source };
    let unison = self::wind(WindSource::Cosine(unison));
    assert_eq!(at(&unison, -80.0), at(&unison, 33.0));
}

#[test]
fn a_rotor_blows_outward_and_down_and_not_in_its_middle() {
    let rotor = steady_rotor();
    let wind = wind(WindSource::Rotor(rotor));
    let middle = wind.strength_at(Vec3::ZERO, 0.0);
    assert!(middle.x == 0.0 && middle.z == 0.0 && middle.y < -1.0, "{middle}");
    let mut last = f32::INFINITY;
    for i in 0..60 {
        let (sin, cos) = (i as f32 * 0.7).sin_cos();
        let out = vec3(cos, 0.0, sin);
        let distance = 0.3 + i as f32 * 0.7;
        let here = wind.strength_at(out * distance, 0.0);
        assert!(here.y <= 0.0, "never up: {here}");
        let level = here.with_y(0.0);
        assert!(level.cross(out).length() < 1e-5 && level.dot(out) >= 0.0, "outward: {here}");
        if distance > 1.2 * rotor.radius_m {
            assert!(level.length() <= last, "weaker with distance");
            last = level.length();
        }
    }
    let peak = wind.strength_at(vec3(rotor.radius_m, 2.0, 0.0), 0.0).x;
    assert!((0.9..=1.0).contains(&(peak / rotor.strength)), "{peak}");
    assert_eq!(wind.strength_at(Vec3::X * rotor.range_m, 0.0), Vec3::ZERO);
    assert_eq!(wind.strength_at(vec3(5.0, 4.5, 0.0), 0.0), Vec3::ZERO, "none above it");
    let low = Rotor { position: Vec3::Y * 2.0, ..rotor };
    let high = Rotor { position: Vec3::Y * 20.0, ..rotor };
    let at = |rotor| self::wind(WindSource::Rotor(rotor)).strength_at(Vec3::X * 6.0, 0.0).x;
    assert!(at(low) > 1.5 * at(high), "stronger the lower it flies");
}

/// The pattern turns with the rotor: later, the wind is that of before, turned.
#[test]
fn the_arms_of_a_rotor_turn_with_it() {
    for rpm in [30.0, -45.0] {
        let rotor = Rotor { rpm, blades: 3, turbulence: 0.0, ..Rotor::default() };
        let mut wind = wind(WindSource::Rotor(rotor));
        let places: Vec<Vec3> =
            (0..40).map(|i| vec3((i % 7) as f32, 0.0, i as f32 - 20.0)).collect();
        let before: Vec<Vec3> = places.iter().map(|at| wind.strength_at(*at, 0.0)).collect();
        wind.advance(0.3);
        // Counter-clockwise seen from above is a positive turn about y.
        let turn = glam::Quat::from_rotation_y(rpm / 60.0 * std::f32::consts::TAU * 0.3);
        for (at, before) in places.iter().zip(before) {
            let after = wind.strength_at(turn * *at, 0.0);
            assert!(after.distance(turn * before) < 1e-4, "{after} {}", turn * before);
            let past = wind.strength_at(*at, 0.3);
            assert!(past.distance(before) < 1e-4);
        }
        let ring = |i: i32| wind.strength_at(turn * vec3(6.0, 0.0, 0.0), i as f32 * 0.05).length();
        let strengths: Vec<f32> = (0..40).map(ring).collect();
        let (low, high) =
            strengths.iter().fold((9.0_f32, 0.0_f32), |(a, b), s| (a.min(*s), b.max(*s)));
        assert!(high > 1.5 * low, "gusts pass: {low} to {high}");
    }
}

#[test]
fn a_vortex_goes_round_strongest_at_its_core() {
    let vortex = steady_vortex();
    let wind = wind(WindSource::Vortex(vortex));
    assert_eq!(wind.strength_at(vec3(0.0, 3.0, 0.0), 0.0), Vec3::ZERO);
    let mut speeds = vec![];
    for i in 1..50 {
        let (sin, cos) = (i as f32).sin_cos();
        let out = vec3(cos, 0.0, sin);
        let here = wind.strength_at(out * i as f32 * 0.5, 1.0);
        // Counter-clockwise seen from above: y cross out.
        assert!(here.dot(Vec3::Y.cross(out)) > 0.0 && here.dot(out).abs() < 1e-4 && here.y == 0.0);
        speeds.push(here.length());
    }
    let peak = (0..49).max_by(|a, b| speeds[*a].total_cmp(&speeds[*b])).unwrap();
    assert!((6..=8).contains(&(peak + 1)), "at {} m", (peak + 1) as f32 * 0.5);
    assert!((0.9..=1.0).contains(&(speeds[peak] / vortex.strength)));
    assert!(speeds[..peak].is_sorted() && speeds[peak..].is_sorted_by(|a, b| a >= b));
    let clockwise = Vortex { clockwise: true, ..vortex };
    let other = self::wind(WindSource::Vortex(clockwise));
    let place = vec3(2.0, 0.0, 5.0);
    assert!(other.strength_at(place, 0.0).distance(-wind.strength_at(place, 0.0)) < 1e-6);
    let lifting = Vortex { inflow: 0.5, updraft: 0.7, ..vortex };
    let lifting = self::wind(WindSource::Vortex(lifting));
    assert!(lifting.strength_at(Vec3::X * 5.0, 0.0).x < -0.5, "inward");
    assert!((lifting.strength_at(Vec3::ZERO, 0.0) - Vec3::Y * 2.8).length() < 1e-5, "up");
}

#[test]
fn a_fan_blows_in_its_cone_and_nowhere_else() {
    let fan = Fan { position: vec3(1.0, 2.0, 3.0), direction: vec3(0.0, 0.0, 2.0), ..steady_fan() };
    let wind = wind(WindSource::Fan(fan));
    let at = |x, along| wind.strength_at(fan.position + vec3(x, 0.0, along), 0.0);
    let axis: Vec<f32> = (0..130).map(|i| at(0.0, 0.3 + i as f32 * 0.1).z).collect();
    assert!(axis.is_sorted_by(|a, b| a >= b), "weaker along the axis: {axis:?}");
    assert!(axis[0] > 0.6 * fan.strength && axis[115] > 0.0 && axis[117] == 0.0, "{axis:?}");
    for along in [0.5, 4.0, 11.0] {
        let edge = fan.radius_m + along * fan.half_angle_deg.to_radians().tan();
        let across: Vec<f32> =
            (0..10).map(|i| at(edge * i as f32 / 10.0, along).length()).collect();
        assert!(across.is_sorted_by(|a, b| a > b), "weaker towards the edge: {across:?}");
        assert_eq!(at(edge + 1e-3, along), Vec3::ZERO);
        let out = at(0.8 * edge, along);
        assert!(out.x > 0.0 && out.x < out.z, "spreads: {out}");
    }
    assert_eq!(at(0.0, 0.0), Vec3::ZERO);
    assert_eq!(at(0.1, -0.5), Vec3::ZERO, "behind it");
}

#[test]
fn sources_add_up() {
    let sources = vec![
        WindSource::Cosine(Cosine::default()),
        WindSource::Rotor(Rotor::default()),
        WindSource::Vortex(Vortex { position: vec3(6.0, 0.0, 2.0), ..Vortex::default() }),
        WindSource::Fan(Fan { direction: vec3(1.0, -0.1, 0.4), ..Fan::default() }),
    ];
    let mut all = Wind::new(sources.clone()).expect("valid");
    all.advance(3.7);
    let mut singles: Vec<Wind> = sources.into_iter().map(wind).collect();
    singles.iter_mut().for_each(|wind| wind.advance(3.7));
    for i in 0..100 {
        let at = vec3(i as f32 * 0.17 - 8.0, 0.3, i as f32 * 0.31 % 9.0);
        let sum: Vec3 = singles.iter().map(|wind| wind.strength_at(at, 0.4)).sum();
        assert!(all.strength_at(at, 0.4).distance(sum) < 1e-4);
    }
}

/// A place moves the whole pattern; of the past, the velocity tells, for a few seconds.
#[test]
fn places_move_the_pattern() {
    let (shift, velocity) = (vec3(20.0, 1.0, -7.0), vec3(3.0, 0.0, -1.0));
    for source in moving() {
        let (mut here, mut there) = (wind(source.clone()), wind(source.clone()));
        let start = source.position().expect("it has a place");
        there.sources[0].place(start + shift, velocity);
        assert_eq!(there.sources[0].position(), Some(start + shift));
        here.advance(5.0);
        there.advance(5.0);
        let last = shift - velocity * Wind::PAST_S;
        for i in 0..50 {
            let at = vec3(i as f32 * 0.2, 0.4, i as f32 * 0.37 % 5.0);
            for (ago, moved) in [(0.0, shift), (1.0, shift - velocity), (9.0, last)] {
                let (a, b) = (here.strength_at(at, ago), there.strength_at(at + moved, ago));
                assert!(a.distance(b) < 2e-4, "{source:?} {ago}: {a} {b}");
            }
        }
    }
    let mut waves = WindSource::Cosine(Cosine::default());
    waves.place(shift, velocity);
    assert_eq!(waves, WindSource::Cosine(Cosine::default()));
}

/// No number that is none, no jump: also in the middles and on the axes, where an angle is none.
#[test]
fn wind_is_finite_and_smooth_everywhere() {
    for source in moving() {
        let mut wind = wind(source.clone());
        let center = source.position().expect("it has a place");
        let mut steepest = 0.0_f32;
        for step in 0..400 {
            wind.advance(0.013);
            let reach = [0.0, 1e-4, 1e-2, 1.0, 8.0][step % 5];
            let (sin, cos) = (step as f32 * 1.3).sin_cos();
            let at = (center + vec3(cos, -0.3, sin) * reach).with_y(0.5);
            let here = wind.strength_at(at, 0.0);
            let beside = wind.strength_at(at + Vec3::splat(0.001), 0.0);
            assert!(here.is_finite());
            steepest = steepest.max(here.distance(beside) / 0.00173);
            let past = wind.strength_at(at, 0.002);
            steepest = steepest.max(here.distance(past) / 0.002 / 10.0);
        }
        println!("{:.20}: {steepest:.1} beta a metre", format!("{source:?}"));
        assert!(steepest < 25.0, "{source:?}: {steepest}");
    }
    let strong = WindSource::Vortex(Vortex { strength: 100.0, inflow: 4.0, ..Vortex::default() });
    let strong = Wind::new(vec![strong; 64]).expect("valid");
    let most = strong.strength_at(vec3(4.0, 0.0, 0.0), 0.0);
    assert!(most.abs().max_element() <= 100.0);
}

/// Turns, drifts and phases wrap without a jump.
#[test]
fn days_of_wind_are_as_exact_as_seconds() {
    for source in moving() {
        let mut wind = wind(source.clone());
        let at = source.position().expect("it has a place").with_y(0.5) + vec3(2.0, 0.0, 0.3);
        let largest = |wind: &mut Wind| {
            let step = |_| {
                let before = wind.strength_at(at, 0.0);
                wind.advance(0.004);
                before.distance(wind.strength_at(at, 0.0))
            };
            (0..2000).map(step).fold(0.0, f32::max)
        };
        let young = largest(&mut wind);
        wind.advance(9.0 * 86_400.0);
        let old = largest(&mut wind);
        assert!(young > 1e-4 && old < 1.5 * young && young < 1.5 * old, "{young} {old}");
        for gpu in wind.gpu_sources() {
            assert!(gpu.phase.iter().all(|p| (0.0..=256.0).contains(p)), "{gpu:?}");
        }
    }
}
