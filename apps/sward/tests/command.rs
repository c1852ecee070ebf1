//! What the command does when all is well.

mod common;

use common::{Folder, scene, stderr, stdout};

fn succeeds(folder: &Folder, arguments: &[&str]) -> String {
    let output = folder.sward(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", stderr(&output));
    // No terminal, so no progress either.
    assert_eq!(stderr(&output), "", "{arguments:?}");
    stdout(&output)
}

const SMALL: [&str; 2] = ["--size", "64x48"];

fn render(folder: &Folder, extra: &[&str]) -> String {
    let scene = scene("tiny.ron");
    succeeds(folder, &[&["render", &scene], &SMALL[..], extra].concat())
}

#[test]
fn help_has_examples() {
    let folder = Folder::new();
    let commands =
        ["render", "bench", "check", "compare", "info", "paper", "quality", "texture", "wind"];
    for command in commands {
        let help = succeeds(&folder, &[command, "--help"]);
        assert!(help.contains("Examples:"), "{help}");
        assert!(help.contains(&format!("sward {command}")), "{help}");
    }
    let help = succeeds(&folder, &["--help"]);
    assert!(help.contains("render") && help.contains("Examples:"), "{help}");
    assert!(succeeds(&folder, &["--version"]).starts_with("sward "));
}

#[test]
fn says_where_the_picture_is() {
    let folder = Folder::new();
    let said = render(&folder, &["-o", "new/folder/a.png"]);
    assert!(said.contains("new/folder/a.png") && said.contains("rendered in"), "{said}");
    let picture = image::open(folder.path("new/folder/a.png")).unwrap();
    assert_eq!((picture.width(), picture.height()), (64, 48));
    assert_eq!(render(&folder, &["-o", "b.png", "--quiet"]), "");
    assert_eq!(folder.names(), ["b.png", "new"]);
}

#[test]
fn a_frame_is_the_same_alone_and_in_a_run() {
    let folder = Folder::new();
    render(&folder, &["-o", "run%d.png", "--frames", "0..4"]);
    render(&folder, &["-o", "alone%03d.png", "--frames", "3..4"]);
    render(&folder, &["-o", "time.png", "--time", "0.1"]);
    let names = ["alone003.png", "run0.png", "run1.png", "run2.png", "run3.png", "time.png"];
    assert_eq!(folder.names(), names);
    let bytes = |name: &str| std::fs::read(folder.path(name)).unwrap();
    assert!(bytes("run3.png") == bytes("alone003.png"), "frame 3 differs");
    assert!(bytes("run3.png") == bytes("time.png"), "frame 3 is the time 0.1 s at 30 fps");
    assert!(bytes("run0.png") != bytes("run3.png"), "nothing moves in the wind");
}

#[test]
fn reference_and_options_draw() {
    let folder = Folder::new();
    render(&folder, &["-o", "plain.png"]);
    render(&folder, &["-o", "reference.png", "--reference"]);
    render(&folder, &["-o", "paper.png", "--physics", "paper", "--culling", "paper"]);
    render(&folder, &["-o", "side.png", "--camera", "side", "--samples", "1", "--culling", "off"]);
    let said = succeeds(&folder, &["compare", "reference.png", "plain.png", "--json", "f.json"]);
    assert!(said.starts_with("FLIP mean 0."), "{said}");
    let json: serde_json::Value =
        serde_json::from_slice(&std::fs::read(folder.path("f.json")).unwrap()).unwrap();
    let mean = json["flip"]["mean"].as_f64().unwrap();
    assert!(mean > 0.0 && mean < 0.25, "the default is unlike its reference: {mean}");
}

#[test]
fn bench_writes_every_key() {
    let folder = Folder::new();
    let scene = scene("tiny.ron");
    let base = ["bench", &scene, "--frames", "2", "--size", "64x48"];
    let said = succeeds(&folder, &[&base[..], &["--json", "a.json"]].concat());
    assert!(said.contains("blades drawn") && said.contains("visibility"), "{said}");
    let json: serde_json::Value =
        serde_json::from_slice(&std::fs::read(folder.path("a.json")).unwrap()).unwrap();
    for key in [
        "adapter",
        "driver",
        "backend",
        "size",
        "samples",
        "scene",
        "blades_total",
        "patches",
        "blades_drawn",
        "blades_culled",
        "spheres_tested",
        "patches_crowded",
        "vertices",
        "ms",
        "bytes_per_blade",
        "gpu_bytes",
        "grow_s",
    ] {
        assert!(!json[key].is_null(), "{key}");
    }
    for part in ["frame", "physics", "visibility", "draw", "post"] {
        assert!(json["ms"][part]["p50"].as_f64().unwrap() > 0.0, "{part}");
        assert!(json["ms"][part]["p99"].as_f64().unwrap() > 0.0, "{part}");
    }
    let again = [&base[..], &["--compare", "a.json", "--patch-sizes", "64,128"]].concat();
    let said = succeeds(&folder, &again);
    assert!(said.contains("change") && said.contains("patch size"), "{said}");
}

#[test]
fn culling_off_draws_every_blade() {
    let folder = Folder::new();
    let scene = scene("tiny.ron");
    let base = ["bench", &scene, "--frames", "1", "--size", "64x48", "--json", "a.json"];
    succeeds(&folder, &[&base[..], &["--without", "culling", "--blades", "3000"]].concat());
    let json: serde_json::Value =
        serde_json::from_slice(&std::fs::read(folder.path("a.json")).unwrap()).unwrap();
    assert_eq!(json["blades_drawn"], json["blades_total"]);
    let blades = json["blades_total"].as_f64().unwrap();
    assert!((blades / 3000.0 - 1.0).abs() < 0.1, "{blades}");
}

#[test]
fn as_many_blades_as_asked_for_where_the_scene_counts_them() {
    let folder = Folder::new();
    std::fs::write(folder.path("s.ron"), "(fields: [(on: Plane(), count: 700)], warm_up_s: 0)")
        .unwrap();
    let base = ["bench", "s.ron", "--frames", "1", "--size", "64x48", "--json", "a.json"];
    succeeds(&folder, &[&base[..], &["--blades", "3000"]].concat());
    let json: serde_json::Value =
        serde_json::from_slice(&std::fs::read(folder.path("a.json")).unwrap()).unwrap();
    assert_eq!(json["blades_total"], 3000);
}

#[test]
fn check_tells_areas_dropped_triangles_and_notes() {
    let folder = Folder::new();
    let obj = "v 0 0 0\nv 0 0 3\nv 4 0 0\nf 1 2 3\nf 1 2 2\n";
    std::fs::write(folder.path("a.obj"), obj).unwrap();
    // 3 x 2 pixels of 8 bits.
    image::GrayImage::new(3, 2).save(folder.path("h.png")).unwrap();
    let scene = "(objects: [(source: Heightmap(file: \"h.png\"))],
        fields: [(name: \"f\", on: File(\"a.obj\"))], warm_up_s: 0)";
    std::fs::write(folder.path("s.ron"), scene).unwrap();
    let output = folder.sward(&["check", "s.ron"]);
    let (said, told) = (stdout(&output), stderr(&output));
    let row = said.lines().find(|line| line.starts_with("f ")).unwrap();
    let cells: Vec<_> = row.split_whitespace().collect();
    assert_eq!(cells, ["f", "1", "1", "3", "6.000", "yes"], "{said}");
    assert!(told.starts_with("note: h.png: has 8 bits") && told.lines().count() == 1, "{told}");
    let output = folder.sward(&["check", "s.ron", "--quiet"]);
    assert_eq!(stderr(&output), "");
}

#[test]
fn check_and_info_say_what_there_is() {
    let folder = Folder::new();
    let said = succeeds(&folder, &["check", &scene("tiny.ron")]);
    assert!(said.contains("main, side") && said.contains("blades"), "{said}");
    let said = succeeds(&folder, &["info"]);
    assert!(said.contains("max_buffer_size") && said.contains("samples a pixel"), "{said}");
}

#[test]
fn wind_is_drawn_from_above() {
    let folder = Folder::new();
    let scene = scene("tiny.ron");
    let said = succeeds(&folder, &["wind", &scene, "-o", "maps/wind.png", "--size", "320x180"]);
    assert_eq!(said, "maps/wind.png: 320 x 180, 1 wind sources\n");
    let later = ["--time", "2.5", "--height", "3", "--quiet", "--size", "320x180"];
    let said = succeeds(&folder, &[&["wind", &scene, "-o", "later.png"], &later[..]].concat());
    assert_eq!(said, "");
    let open = |name: &str| image::open(folder.path(name)).unwrap().into_rgb8();
    let (now, later) = (open("maps/wind.png"), open("later.png"));
    assert_eq!(now.dimensions(), (320, 180));
    assert_ne!(now, later);
}

#[test]
fn textures_are_painted() {
    let folder = Folder::new();
    let said = succeeds(&folder, &["texture", "daisy", "-o", "new/daisy.png", "--size", "96"]);
    assert_eq!(said, "new/daisy.png: 96 x 96\n");
    let daisy = image::open(folder.path("new/daisy.png")).unwrap().into_rgba8();
    assert_eq!(daisy.dimensions(), (96, 96));
    assert!(daisy.pixels().any(|p| p.0[3] == 0) && daisy.pixels().any(|p| p.0[3] == 255));
    let base = ["texture", "daisy", "--size", "96", "-o", "b.png"];
    succeeds(&folder, &[&base[..], &["--normal", "n.png", "--seed", "1"]].concat());
    let bytes = |name: &str| std::fs::read(folder.path(name)).unwrap();
    assert!(bytes("b.png") == bytes("new/daisy.png"), "the same seed, the same picture");
    assert!(image::open(folder.path("n.png")).unwrap().to_rgb8().pixels().any(|p| p.0[0] > 200));
    for extra in [&["--seed", "2"][..], &["--above"], &["--turned", "-60"]] {
        succeeds(&folder, &[&base[..], extra].concat());
        assert!(bytes("b.png") != bytes("new/daisy.png"), "{extra:?}");
    }
    succeeds(&folder, &["texture", "strip", "-o", "strip.png", "--size", "64"]);
    let said = succeeds(&folder, &["texture", "atlas", "-o", "atlas.png", "--size", "64"]);
    assert!(said.contains("8 plants"), "{said}");
    succeeds(&folder, &["texture", "fine-grass", "-o", "mips.png", "--mips", "--size", "64"]);
    let atlas = image::open(folder.path("atlas.png")).unwrap();
    assert!(atlas.width() > 3 * 96 && atlas.height() > 3 * 64);
}
