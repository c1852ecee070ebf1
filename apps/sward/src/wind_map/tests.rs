use super::*;
use std::path::Path;

fn map(wind: &str, time_s: f64) -> RgbImage {
    let text = format!(
        "(fields: [(on: Plane(size_m: (40, 40)), count: 10)], wind: [{wind}], warm_up_s: 0)"
    );
    let scene = sward_scene::parse(&text, Path::new("s.ron")).expect("a scene");
    draw(&scene, MapOptions { size: [320, 180], time_s, height_m: 0.2 }).expect("a map")
}

/// Lightness of the map about a place, arrows and all.
fn light(image: &RgbImage, world: Vec2) -> f32 {
    // 40 m and a little on 180 pixels.
    let center = Vec2::new(160.0, 90.0) + world * (180.0 / 42.4);
    let mut sum = 0.0;
    for y in -12..12 {
        for x in -12..12 {
            let pixel = center + Vec2::new(x as f32, y as f32);
            let Rgb([r, g, b]) = *image.get_pixel(pixel.x as u32, pixel.y as u32);
            sum += f32::from(r) + f32::from(g) + f32::from(b);
        }
    }
    sum / (24.0 * 24.0 * 3.0)
}

#[test]
fn strong_wind_is_lighter() {
    let fan = "Fan(at: (-15, 0.5, 0), radius_m: 3, range_m: 30, turbulence: 0)";
    let image = map(fan, 0.0);
    let (inside, outside) =
        (light(&image, Vec2::new(-9.0, 0.0)), light(&image, Vec2::new(0.0, -15.0)));
    assert!(inside > outside + 60.0, "{inside} {outside}");
    // Seen from above, x to the right and z down.
    let image = map("Fan(at: (0, 0.5, -15), direction: (0, 0, 1), radius_m: 3, range_m: 30)", 0.0);
    assert!(light(&image, Vec2::new(0.0, -9.0)) > light(&image, Vec2::new(-9.0, 0.0)) + 60.0);
}

#[test]
fn time_moves_the_map() {
    let path = "Vortex(path: [(0, -12, 0, 0), (4, 12, 0, 0)], range_m: 12, turbulence: 0)";
    let west = Vec2::new(-16.0, 0.0);
    assert!(light(&map(path, 0.0), west) > light(&map(path, 4.0), west) + 40.0);
    assert_eq!(map(path, 1.0), map(path, 1.0));
    assert_ne!(map("Waves()", 0.0), map("Waves()", 1.0));
}

#[test]
fn still_air_is_a_map_too() {
    let image = map("", 0.0);
    assert!(light(&image, Vec2::ZERO) < 70.0);
}
