//! Small pictures of the tests' own scene against stored ones; `common/golden.rs` says how.
//! `SWARD_BLESS=1 cargo test -p sward_app --test golden` writes them anew.

mod common;

use common::golden::{draw, golden};
use common::{Folder, scene};

const SIZE: &str = "256x192";

#[test]
fn tiny() {
    golden("tiny", SIZE, &[&scene("tiny.ron")]);
}

#[test]
fn tiny_in_the_wind() {
    golden("tiny_wind", SIZE, &[&scene("tiny.ron"), "--time", "1.5", "--camera", "side"]);
}

#[test]
fn tiny_reference() {
    golden("tiny_reference", SIZE, &[&scene("tiny.ron"), "--reference"]);
}

#[test]
fn tiny_as_in_the_paper() {
    golden("tiny_paper", SIZE, &[&scene("tiny.ron"), "--physics", "paper", "--culling", "paper"]);
}

#[test]
fn debug_views() {
    for view in [
        "patches",
        "culling",
        "level",
        "awake",
        "crush",
        "wireframe",
        "half-wireframe",
        "position",
        "distance",
        "frustum",
    ] {
        golden(
            &format!("debug/{view}"),
            SIZE,
            &[&scene("tiny.ron"), "--time", "0.5", "--debug", view],
        );
    }
}

#[test]
fn culling_seen_from_another_camera() {
    let cameras = ["--camera", "side", "--culling-camera", "main", "--debug", "culling"];
    golden("debug/culling_camera", SIZE, &[&[scene("tiny.ron").as_str()], &cameras[..]].concat());
}

#[test]
fn the_same_frame_twice_is_bit_equal() {
    let folder = Folder::new();
    let arguments: &[&str] = &[&scene("tiny.ron"), "--time", "0.5"];
    let (one, two) = (draw(&folder, "one", SIZE, arguments), draw(&folder, "two", SIZE, arguments));
    assert!(one == two, "the same frame differs");
}
