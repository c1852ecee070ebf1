//! Fog, depth of field and the time of day: what they must leave alone, and what they must change.

mod common;

use common::golden::{draw, golden};
use common::{Folder, scene};
use image::RgbImage;

const SIZE: &str = "80x60";

/// The tests' scene in still air, with more keys.
fn with(folder: &Folder, name: &str, keys: &str, arguments: &[&str]) -> RgbImage {
    let text = std::fs::read_to_string(scene("tiny.ron")).unwrap();
    let (wind, end) = (text.find("    wind:").unwrap(), text.rfind(')').unwrap());
    let (before, rest) = (&text[..wind], &text[wind..end]);
    let after = &rest[rest.find('\n').unwrap()..];
    let file = format!("{name}.ron");
    std::fs::write(folder.path(&file), format!("{before}wind: [], {keys}, {after})")).unwrap();
    draw(folder, name, SIZE, &[&[file.as_str()], arguments].concat())
}

/// Pixels that differ, and how many of them lie in the upper third, which is sky.
fn changed(one: &RgbImage, two: &RgbImage) -> (usize, usize) {
    let places = one.enumerate_pixels().filter(|(x, y, pixel)| two.get_pixel(*x, *y) != *pixel);
    let rows: Vec<_> = places.map(|(_, y, _)| y).collect();
    (rows.len(), rows.iter().filter(|y| **y < one.height() / 3).count())
}

#[test]
fn effects() {
    golden("effects", "256x192", &[&scene("effects.ron"), "--time", "0.5"]);
}

#[test]
fn effects_of_no_strength_change_nothing() {
    let folder = Folder::new();
    let plain = with(&folder, "plain", "fps: 30", &[]);
    for keys in ["fog: (density_per_m: 0)", "depth_of_field: (aperture_mm: 0)"] {
        assert!(with(&folder, "none", keys, &[]) == plain, "{keys}");
    }
}

/// At one sample a pixel, so that no pixel is half sky.
#[test]
fn fog_leaves_the_sky_and_references_agree() {
    let folder = Folder::new();
    let one = ["--samples", "1"];
    let plain = with(&folder, "plain", "fps: 30", &one);
    let fog = "fog: (color: (0.6, 0.1, 0.1), density_per_m: 0.5)";
    let foggy = with(&folder, "foggy", fog, &one);
    let (all, of_sky) = changed(&plain, &foggy);
    assert!(all > 2000 && of_sky == 0, "{all} {of_sky}");
    // A reference is fogged once, at the end, and not 64 times
    let reference = with(&folder, "reference", fog, &["--reference"]);
    let off = sward_app::compare::flip(&reference, &foggy).unwrap().mean;
    let plainly = sward_app::compare::flip(&reference, &plain).unwrap().mean;
    assert!(off < 0.5 * plainly && off < 0.12, "{off} {plainly}");
}

/// Hours that pass move the sun while a run goes on, and any frame shows its own time.
#[test]
fn the_sun_moves_with_the_time() {
    let folder = Folder::new();
    let at = |name: &str, keys: &str, time: &str| with(&folder, name, keys, &["--time", time]);
    let moving = "light: (time_h: 9, hours_per_s: 6)";
    // Half a second later it is noon; grass in still air has not moved
    let (now, then) = (at("now", moving, "0"), at("then", moving, "0.5"));
    let noon = at("noon", "light: (time_h: 12)", "0.5");
    assert!(now != then, "the sun stands still");
    assert!(then == noon, "the light is not that of the time");
}
