//! What must hold of any sky.

use super::{ABOVE_AIR, Atmosphere, Dome};
use glam::Vec3;

fn clear() -> Atmosphere {
    Atmosphere::new(2.5, Vec3::new(0.12, 0.13, 0.07))
}

/// A unit direction at a height, degrees, and so far from the sun, which is over +x.
fn direction(around_deg: f32, up_deg: f32) -> Vec3 {
    let ((sin_a, cos_a), (sin_u, cos_u)) =
        (around_deg.to_radians().sin_cos(), up_deg.to_radians().sin_cos());
    Vec3::new(cos_u * cos_a, sin_u, cos_u * sin_a)
}

fn dome(atmosphere: &Atmosphere, sun_deg: f32) -> Dome {
    Dome::new(atmosphere, direction(0.0, sun_deg), Vec3::splat(ABOVE_AIR), Vec3::ZERO)
}

/// How blue a colour is beside its red.
fn blue(color: Vec3) -> f32 {
    color.z / color.x
}

#[test]
fn light_is_a_number_everywhere() {
    for (turbidity, albedo) in
        [(f32::NAN, 0.0), (-1.0, 1.0), (1.0, f32::NAN), (2.5, 0.2), (1e9, 1.0)]
    {
        {
            let sky = Atmosphere::new(turbidity, Vec3::splat(albedo));
            for sun in [-90.0, -18.0, -6.0, -0.3, 0.0, 0.3, 5.0, 45.0, 90.0] {
                let light = sky.sunlight(sun);
                assert!(light.is_finite() && light.min_element() >= 0.0, "{turbidity} {sun}");
                assert!(light.max_element() <= 1.0, "{turbidity} {sun}: {light}");
                for (around, up) in
                    [(0.0, 0.0), (0.0, sun), (90.0, 90.0), (180.0, 3.0), (40.0, -30.0)]
                {
                    let light = sky.radiance(direction(around, up), direction(0.0, sun));
                    let good = light.is_finite() && light.min_element() >= 0.0;
                    assert!(good, "{turbidity}, sun {sun}, {around} {up}: {light}");
                }
            }
        }
    }
    let sky = clear();
    assert!(sky.radiance(Vec3::ZERO, Vec3::ZERO).is_finite());
}

#[test]
fn the_sky_is_bluest_overhead_and_reddest_by_a_low_sun() {
    let noon = dome(&clear(), 62.0);
    let overhead = noon.radiance(direction(180.0, 80.0));
    let low = noon.radiance(direction(90.0, 2.0));
    assert!(blue(overhead) > 1.5 * blue(low), "{overhead} {low}");
    assert!(blue(overhead) > 1.5 && low.y > overhead.y, "{overhead} {low}");
    let evening = dome(&clear(), 1.5);
    let sunward = evening.radiance(direction(0.0, 1.5));
    assert!(blue(sunward) < 0.6 && sunward.x > sunward.y, "{sunward}");
    assert!(blue(sunward) < 0.5 * blue(evening.radiance(direction(180.0, 20.0))));
    // Twilight: no sun, and light where it went down
    let dusk = dome(&clear(), -4.0);
    let (glow, behind) = (dusk.radiance(direction(0.0, 2.0)), dusk.radiance(direction(180.0, 2.0)));
    assert!(glow.x > 2.0 * behind.x && behind.y > 0.0, "{glow} {behind}");
    assert!(blue(glow) < 0.7 * blue(behind), "{glow} {behind}");
    assert_eq!(clear().sunlight(-1.0), Vec3::ZERO);
}

#[test]
fn sunlight_warms_as_the_sun_sinks_and_grows_as_it_rises() {
    let sky = clear();
    let mut last = sky.sunlight(90.0);
    for step in 1..=178 {
        let now = sky.sunlight(90.0 - 0.5 * step as f32);
        assert!(now.cmple(last + 1e-6).all(), "{step}: {last} {now}");
        assert!(blue(now) <= blue(last) + 1e-6, "{step}: {last} {now}");
        last = now;
    }
    let (low, high) = (sky.sunlight(4.0), sky.sunlight(60.0));
    assert!(blue(low) < 0.3 && blue(high) > 0.7, "{low} {high}");
}

#[test]
fn haze_whitens_the_sky_and_dims_the_sun() {
    let mut last: Option<(f32, f32)> = None;
    for turbidity in [1.0, 1.5, 2.5, 4.0, 7.0, 10.0] {
        let sky = Atmosphere::new(turbidity, Vec3::splat(0.1));
        let overhead = dome(&sky, 50.0).radiance(direction(150.0, 75.0));
        let now = (blue(overhead), sky.sunlight(50.0).y);
        if let Some(last) = last {
            assert!(now.0 < last.0 && now.1 < last.1, "{turbidity}: {now:?} {last:?}");
        }
        last = Some(now);
    }
}

/// What the ground gets is never more than what falls on the air above it. The Earth is round: with
/// the sun on the horizon the air overhead is still lit, which is the small addition.
#[test]
fn the_ground_gets_no_more_than_comes_in() {
    for turbidity in [1.0, 2.5, 6.0, 10.0] {
        for albedo in [0.0, 0.13, 0.3] {
            let sky = Atmosphere::new(turbidity, Vec3::splat(albedo));
            for sun in [-6.0, 0.0, 2.0, 6.0, 15.0, 40.0, 90.0_f32] {
                let up = sun.to_radians().sin().max(0.0);
                let fallen =
                    dome(&sky, sun).irradiance(Vec3::Y) + sky.sunlight(sun) * (ABOVE_AIR * up);
                let most = ABOVE_AIR * (up + 0.04 * (1.0 - up).powi(8));
                assert!(fallen.max_element() < most, "{turbidity} {albedo} {sun}: {fallen} {most}");
                let least = if sun > 5.0 { 0.15 * most } else { 0.0 };
                assert!(fallen.y > least, "{turbidity} {albedo} {sun}: {fallen} {most}");
            }
        }
    }
}

#[test]
fn harmonics_shed_the_light_of_the_table() {
    for sun in [-3.0, 3.0, 30.0, 75.0] {
        let (dome, ground) = (dome(&clear(), sun), Vec3::splat(0.002));
        let harmonics = dome.harmonics(ground);
        // Of a surface that faces the brightest sky
        let all = dome.irradiance(direction(0.0, sun.max(30.0)));
        for (around, up) in [(0.0, 90.0), (0.0, 20.0), (90.0, 45.0), (180.0, 10.0), (135.0, 60.0)] {
            let normal = direction(around, up);
            let below = ground * std::f32::consts::PI * 0.5 * (1.0 - normal.y);
            let (got, exact) = (harmonics.irradiance(normal), dome.irradiance(normal) + below);
            let off = ((got - exact) / all.max(exact)).abs().max_element();
            assert!(off < 0.05, "sun {sun}, {around} {up}: {got}, not {exact}");
        }
    }
}

#[test]
fn the_table_is_the_sky_between_its_texels() {
    let (sky, sun) = (clear(), direction(0.0, 35.0));
    let table = Dome::new(&sky, sun, Vec3::ONE, Vec3::ZERO);
    for (around, up) in [(3.3, 34.0), (-71.0, 0.7), (121.0, 8.8), (200.0, 55.0), (10.0, 88.0)] {
        let way = direction(around, up);
        let (read, exact) = (table.radiance(way), sky.radiance(way, sun));
        let off = ((read - exact) / exact).abs().max_element();
        assert!(off < 0.02, "{around} {up}: {read}, not {exact}");
    }
}

#[test]
fn clouds_shed_what_they_are_told_and_hide_the_sun() {
    let mut dome = dome(&clear(), 40.0);
    dome.cover(1.0, Vec3::new(0.9, 1.0, 1.1));
    let shed = dome.irradiance(Vec3::Y);
    assert!((shed - Vec3::new(0.9, 1.0, 1.1)).abs().max_element() < 0.01, "{shed}");
    let (zenith, horizon) = (dome.radiance(Vec3::Y), dome.radiance(Vec3::X));
    assert!((zenith.y / horizon.y - 3.0).abs() < 1e-3, "{zenith} {horizon}");
    assert_eq!(dome.disc, 0.0);
}
