//! Lights by name and by the time of day: what they must refuse, and what every picture must hold.

mod common;

use common::golden::draw;
use common::{Folder, scene, stderr};
use image::Rgb32FImage;

/// The tests' scene in still air, with more keys on its second line.
fn with(folder: &Folder, file: &str, keys: &str) -> String {
    let text = std::fs::read_to_string(scene("tiny.ron")).unwrap();
    let start = text.find("(\n").unwrap() + 1;
    std::fs::write(folder.path(file), format!("({keys},{}", &text[start..])).unwrap();
    file.into()
}

fn light(folder: &Folder, name: &str, arguments: &[&str]) -> Rgb32FImage {
    let file = format!("{name}.exr");
    let size = ["--size", "48x36", "--samples", "1", "-o", &file];
    let output = folder.sward(&[&["render"], arguments, &size[..]].concat());
    assert!(output.status.success(), "{name}: {}", stderr(&output));
    image::open(folder.path(&file)).unwrap().into_rgb32f()
}

fn mean(light: &Rgb32FImage) -> f32 {
    light.as_raw().iter().sum::<f32>() / light.as_raw().len() as f32
}

#[test]
fn values_out_of_range_are_named_with_their_line() {
    let folder = Folder::new();
    for (keys, cause) in [
        ("light: (turbidity: 0.5)", "light.turbidity: 0.5 is out of range: it must be 1 to 10"),
        ("light: (turbidity: NaN)", "light.turbidity: NaN"),
        ("light: (ground_albedo: (0.1, 1.5, 0))", "light.ground_albedo: 1.5"),
        ("light: (strength: -1)", "light.strength: -1"),
        ("light: (strength: 1e9)", "light.strength: 1000000000"),
        ("light: (time_h: inf)", "light.time_h: inf"),
        ("light: (haze_m: -3)", "light.haze_m: -3"),
        ("exposure_ev: NaN", "exposure_ev: NaN"),
        ("exposure_ev: 90", "exposure_ev: 90 is out of range: it must be -20 to 20"),
        ("tone: Aces", "unknown kind 'Aces'; known here: Neutral, Agx"),
        ("sun: (strength: NaN)", "sun.strength: NaN"),
        ("sky: (zenith: (-1, 0, 0))", "sky.zenith: -1"),
        ("light: (cloud: 1)", "unknown key 'cloud'"),
    ] {
        let file = with(&folder, "bad.ron", keys);
        let output = folder.sward(&["check", &file]);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{keys}: {said}");
        assert_eq!(said.lines().count(), 1, "{keys}: {said}");
        assert!(said.contains(cause) && said.contains("bad.ron:1:"), "{keys}: {said}");
    }
}

/// Presets, night, haze, a sun under the ground: all light is a number, none is negative, and the darker
/// scene is the darker picture.
#[test]
fn every_light_is_a_number() {
    let folder = Folder::new();
    let tiny = scene("tiny.ron");
    let preset = |name: &str| mean_of(&folder, name, &[&tiny, "--light", name]);
    let (noon, moonlit) = (preset("noon"), preset("moonlit"));
    assert!(moonlit < 0.05 * noon && moonlit > 0.0, "{moonlit} {noon}");
    assert!(preset("overcast") < noon && preset("golden-hour") < noon);
    for (name, keys) in [
        ("night", "light: (time_h: 0)"),
        ("thick", "light: (time_h: 20, turbidity: 10, ground_albedo: (1, 1, 1))"),
        ("under", "sun: (elevation_deg: -90)"),
    ] {
        let file = with(&folder, &format!("{name}.ron"), keys);
        assert!(mean_of(&folder, name, &[&file]) > 0.0, "{name}");
    }
}

fn mean_of(folder: &Folder, name: &str, arguments: &[&str]) -> f32 {
    let light = light(folder, name, arguments);
    let good = light.as_raw().iter().all(|x| x.is_finite() && *x >= 0.0);
    assert!(good, "{name}: light that is no number, or below 0");
    mean(&light)
}

/// Exposure brightens pictures and leaves the light; without it moonlight is dim, not black.
#[test]
fn exposure_is_of_the_picture_alone() {
    let folder = Folder::new();
    let grey = |name: &str, arguments: &[&str]| {
        let picture = draw(&folder, name, "48x36", arguments);
        picture.as_raw().iter().map(|&v| f32::from(v)).sum::<f32>() / picture.as_raw().len() as f32
    };
    let day = with(&folder, "day.ron", "light: (time_h: 12)");
    let dark = with(&folder, "dark.ron", "light: (time_h: 12), exposure_ev: -3");
    let (own, darker) = (grey("own", &[&day]), grey("darker", &[&dark]));
    assert!((60.0..200.0).contains(&own) && darker < 0.6 * own, "{own} {darker}");
    assert!(light(&folder, "a", &[&day]) == light(&folder, "b", &[&dark]));
    let moonlit = grey("moonlit", &[&scene("tiny.ron"), "--light", "moonlit"]);
    assert!((12.0..90.0).contains(&moonlit), "{moonlit}");
    let neutral = with(&folder, "neutral.ron", "light: (time_h: 12), tone: Neutral");
    assert!((grey("neutral", &[&neutral]) - own).abs() > 1.0, "the tone changes nothing");
}
