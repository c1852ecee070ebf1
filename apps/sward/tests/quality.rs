//! A small `sward quality`: pictures of 160 x 90 pixels, short runs of each path, few ranges
//! of distance. What is seen must not change where plants change their form.

mod common;

use common::{Folder, scene, stderr, stdout};
use serde_json::Value;
use std::sync::OnceLock;

const SIZE: [&str; 2] = ["--size", "160x90"];

fn measured(folder: &Folder, technique: &str, extra: &[&str]) -> (Option<i32>, String) {
    let scene = scene("quality.ron");
    let base = ["quality", &scene, "--technique", technique, "--json", "q.json"];
    let output = folder.sward(&[&base[..], &SIZE, extra].concat());
    (output.status.code(), stdout(&output) + &stderr(&output))
}

/// Everything, once for all tests.
fn all() -> &'static (Value, String) {
    static ALL: OnceLock<(Value, String)> = OnceLock::new();
    ALL.get_or_init(|| {
        let folder = Folder::new();
        let files = ["--markdown", "q.md", "--plots", "plots", "--frames", "4", "--check"];
        let (code, said) = measured(&folder, "continuum", &files);
        // Without an adapter this fails, loudly, as it should.
        let errors = said.lines().filter(|line| line.starts_with("error: ")).count();
        assert_eq!(code, Some(i32::from(errors > 0)), "{said}");
        let read = |name| std::fs::read_to_string(folder.path(name)).unwrap();
        assert!(said.starts_with(&read("q.md")), "{said}");
        for plot in ["pictures", "flip", "jumps", "tile_jumps", "ratio_camera", "ratio_above"] {
            let plot = image::open(folder.path("plots").join(format!("{plot}.png"))).unwrap();
            assert!(plot.width() > 100);
        }
        println!("{said}");
        (serde_json::from_str(&read("q.json")).unwrap(), said)
    })
}

fn number(value: &Value, path: &str) -> f64 {
    let found = path.split('.').fold(value, |value, key| &value[key]);
    found.as_f64().unwrap_or_else(|| panic!("no {path}"))
}

/// The limits of `--check`.
#[test]
fn nothing_jumps() {
    let (json, said) = all();
    for path in ["dolly", "orbit", "flydown"] {
        let jump = number(json, &format!("{path}.jump"));
        let tiles = number(json, &format!("{path}.tile_jump"));
        assert!(jump <= 0.005 && tiles <= 0.10, "{path}: {jump} {tiles}\n{said}");
    }
}

/// `--check` asks for 0.02, which these small pictures, of few and large clusters, do not reach: chance
/// alone is half of it (`drift.error`). A little above what was measured (0.138, 0.061, 0.003); they may
/// only fall.
const DRIFT: [(&str, f64); 3] = [("coverage", 0.145), ("luminance", 0.066), ("colour", 0.006)];

#[test]
fn drift_grows_no_further() {
    let (json, said) = all();
    for (what, most) in DRIFT {
        let drift = number(json, &format!("drift.{what}"));
        assert!(drift <= most, "{what}: {drift}\n{said}");
        let told = said.contains(&format!("error: drift.{what} is "));
        assert_eq!(told, drift > 0.02, "{said}");
    }
}

#[test]
fn a_still_camera_sees_equal_frames() {
    let (json, said) = all();
    assert_eq!(json["still"]["equal"], true, "{said}");
    assert_eq!(json["still"]["frames"], 30);
}

#[test]
fn every_number_is_there_and_sensible() {
    let (json, said) = all();
    let flip = number(json, "flip.mean");
    // Never equal, and far from what another picture would give.
    assert!(flip > 0.001 && flip < 0.25, "{said}");
    assert!(number(json, "flip.p99") > flip && number(json, "flip.grass_mean") >= flip);
    for path in ["dolly", "orbit", "flydown"] {
        let frames = json[path]["frames"].as_array().unwrap();
        assert_eq!(frames.len(), 4);
        // A run of neighbours
        assert_eq!(frames.iter().filter(|frame| frame["jump"].is_null()).count(), 1);
    }
    for view in json["drift"]["views"].as_array().unwrap() {
        let bins = view["bins"].as_array().unwrap();
        assert!(bins.len() >= 3, "{said}");
        assert!(bins.iter().flat_map(|bin| bin["error"].as_array().unwrap()).all(|error| {
            let error = error.as_f64().unwrap();
            error > 0.0 && error < 0.2
        }));
    }
    assert!(!json["drift"]["views"][0]["changes"].as_array().unwrap().is_empty(), "{said}");
}

/// Every blade drawn, as wide as it is: only levels and 4 samples tell it from the reference.
#[test]
fn all_blades_are_as_the_reference() {
    let folder = Folder::new();
    let extra = ["--without", "culling", "--parts", "drift"];
    let (code, said) = measured(&folder, "blades", &extra);
    assert_eq!(code, Some(0), "{said}");
    let json = std::fs::read_to_string(folder.path("q.json")).unwrap();
    let json: Value = serde_json::from_str(&json).unwrap();
    assert!(json["flip"].is_null() && json["dolly"].is_null() && json["still"].is_null());
    for bin in json["drift"]["views"][0]["bins"].as_array().unwrap() {
        // Nearer than was measured before, and steeply from above: the upper part of a bent blade shows
        // more than the lower one, which is wider, and one segment has the same width for both.
        let steep = bin["range_m"][1].as_f64().unwrap() < 3.5;
        // Blades of one segment are darker than those of eight.
        for (what, most) in [("coverage", if steep { 0.12 } else { 0.07 }), ("luminance", 0.14)] {
            let [reference, test] = [0, 1].map(|i| bin[what][i].as_f64().unwrap());
            assert!((test / reference - 1.0).abs() < most, "{what}: {bin}");
        }
    }
}

#[test]
fn bad_input() {
    let folder = Folder::new();
    let scene = scene("quality.ron");
    for (extra, cause) in [
        (["--frames", "1"], "--frames"),
        (["--frames", "121"], "--frames"),
        (["--size", "0x9"], "--size"),
        (["--parts", "colour"], "--parts"),
        (["--technique", "magic"], "--technique"),
        (["--camera", "none"], "none"),
        (["--samples", "3"], "--samples 3"),
        (["--json", "/dev/null/q.json"], "--json"),
    ] {
        let output = folder.sward(&["quality", &scene, extra[0], extra[1]]);
        let error = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{extra:?}: {error}");
        assert!(error.starts_with("error: ") && error.contains(cause), "{extra:?}: {error}");
        assert_eq!(error.lines().count(), 1, "{error}");
    }
}
