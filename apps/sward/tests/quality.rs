//! A small `sward quality`: pictures of 160 x 90 pixels, short runs of each path, few slabs of
//! distance. What is seen must not change where plants change their form.

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
        let files = ["--markdown", "q.md", "--plots", "plots", "--frames", "8"];
        let (code, said) = measured(&folder, "continuum", &files);
        // Without an adapter this fails, loudly, as it should.
        assert_eq!(code, Some(0), "{said}");
        let read = |name| std::fs::read_to_string(folder.path(name)).unwrap();
        assert_eq!(said, read("q.md"));
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

#[test]
fn nothing_drifts() {
    let (json, said) = all();
    for what in ["coverage", "luminance", "colour"] {
        let drift = number(json, &format!("drift.{what}"));
        assert!(drift <= 0.02, "{what}: {drift}\n{said}");
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
        assert_eq!(frames.len(), 8);
        // Two runs of four neighbours
        assert_eq!(frames.iter().filter(|frame| frame["jump"].is_null()).count(), 2);
    }
    for view in json["drift"]["views"].as_array().unwrap() {
        assert!(view["bins"].as_array().unwrap().len() >= 4, "{said}");
        assert!(!view["changes"].as_array().unwrap().is_empty(), "{said}");
    }
}

/// Every blade drawn as wide as it is, with 4 samples: what the reference shows, but for noise.
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
        for what in ["coverage", "luminance"] {
            let [reference, test] = [0, 1].map(|i| bin[what][i].as_f64().unwrap());
            assert!((test / reference - 1.0).abs() < 0.1, "{what}: {bin}");
        }
    }
}

#[test]
fn exceeded_limits_are_an_error_where_they_are_checked() {
    let folder = Folder::new();
    // One segment a blade, whatever its size: not what the reference shows.
    let extra = ["--parts", "paths", "--frames", "2", "--check"];
    let (code, said) = measured(&folder, "blades", &extra);
    let errors = said.lines().filter(|line| line.starts_with("error: ")).count();
    match code {
        Some(0) => assert_eq!(errors, 0, "{said}"),
        Some(1) => assert!(errors > 0, "{said}"),
        _ => panic!("{code:?}: {said}"),
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
