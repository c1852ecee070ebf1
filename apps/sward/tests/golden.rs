//! Small pictures against stored ones. `SWARD_BLESS=1 cargo test -p sward_app --test golden` writes
//! them anew: look at them before they are committed.
//!
//! Drivers round differently, so pictures are compared by FLIP, whose 99th percentile catches a
//! fault too small for the mean.

mod common;

use common::{Folder, scene, stderr};
use image::RgbImage;
use std::path::{Path, PathBuf};
use sward_app::compare::flip;

/// Equal but for rounding: measured 0 on the driver that drew them.
const MEAN: f32 = 0.01;
const P99: f32 = 0.15;

fn draw(folder: &Folder, name: &str, arguments: &[&str]) -> RgbImage {
    let file = format!("{name}.png");
    let size = ["--size", "256x192", "-o", &file];
    let output = folder.sward(&[&["render"], arguments, &size[..]].concat());
    // Without an adapter this fails, loudly, as it should.
    assert!(output.status.success(), "{name}: {}", stderr(&output));
    image::open(folder.path(&file)).unwrap().into_rgb8()
}

fn golden(name: &str, arguments: &[&str]) {
    let folder = Folder::new();
    let picture = draw(&folder, name, arguments);
    let stored = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/golden/{name}.png"));
    if std::env::var_os("SWARD_BLESS").is_some() {
        picture.save(&stored).unwrap();
        return;
    }
    let expected = image::open(&stored).unwrap().into_rgb8();
    let result = flip(&expected, &picture).unwrap();
    if result.mean > MEAN || result.p99 > P99 {
        let kept = keep(name, &picture);
        panic!("{name}: {result:?}, above {MEAN} and {P99}; the new picture is {}", kept.display());
    }
}

/// Keeps a picture that failed, to be looked at.
fn keep(name: &str, picture: &RgbImage) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
    picture.save(&path).unwrap();
    path
}

#[test]
fn tiny() {
    golden("tiny", &[&scene("tiny.ron")]);
}

#[test]
fn tiny_in_the_wind() {
    golden("tiny_wind", &[&scene("tiny.ron"), "--time", "1.5", "--camera", "side"]);
}

#[test]
fn tiny_reference() {
    golden("tiny_reference", &[&scene("tiny.ron"), "--reference"]);
}

#[test]
fn tiny_as_in_the_paper() {
    golden("tiny_paper", &[&scene("tiny.ron"), "--physics", "paper", "--culling", "paper"]);
}

#[test]
fn the_same_frame_twice_is_bit_equal() {
    let folder = Folder::new();
    let arguments: &[&str] = &[&scene("tiny.ron"), "--time", "0.5"];
    let (one, two) = (draw(&folder, "one", arguments), draw(&folder, "two", arguments));
    assert!(one == two, "the same frame differs");
}
