//! Bad input: exit code 2, one line that says what is wrong, and no file left behind.

mod common;

use common::{Folder, scene, stderr, stdout};

/// Runs, expects a refusal that mentions `cause`, and nothing new in the folder.
fn refused(arguments: &[&str], cause: &str) {
    let folder = Folder::new();
    std::fs::write(folder.path("file.txt"), "not a folder").unwrap();
    let output = folder.sward(arguments);
    let error = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {error}");
    assert_eq!(error.lines().count(), 1, "{arguments:?}: {error}");
    assert!(error.starts_with("error: ") && error.contains(cause), "{arguments:?}: {error}");
    assert!(!error.contains('\x1b'), "coloured though no terminal: {error}");
    assert_eq!(stdout(&output), "", "{arguments:?}");
    assert_eq!(folder.names(), ["file.txt"], "{arguments:?}");
}

fn render(extra: &[&str], cause: &str) {
    let scene = scene("tiny.ron");
    refused(&[&["render", &scene], extra].concat(), cause);
}

#[test]
fn usage() {
    refused(&[], "subcommand");
    refused(&["paint"], "unrecognized subcommand 'paint'");
    refused(&["render", "--colour"], "--colour");
    refused(&["render", "x.ron"], "--output");
}

#[test]
fn scenes() {
    refused(&["render", "missing.ron", "-o", "a.png"], "missing.ron");
    refused(&["check", "missing.ron"], "missing.ron");
    refused(&["bench", "missing.ron"], "missing.ron");
    refused(&["check", "file.txt"], "file.txt");
    refused(&["check", &scene("unknown_key.ron")], "unknown_key.ron:3");
}

#[test]
fn sizes() {
    for size in ["0x0", "0x64", "64", "64x", "-64x64", "64x64x64", "wide"] {
        render(&["-o", "a.png", &format!("--size={size}")], "--size");
    }
    render(&["-o", "a.png", "--size", "100000x64"], "max_texture_dimension_2d");
}

#[test]
fn frames_and_times() {
    for frames in ["3..3", "5..2", "5", "a..b", "-1..3"] {
        render(&["-o", "%d.png", &format!("--frames={frames}")], "--frames");
    }
    for fps in ["0", "NaN", "-30", "inf"] {
        render(&["-o", "a.png", &format!("--fps={fps}")], "--fps");
    }
    for time in ["-1", "NaN", "inf"] {
        render(&["-o", "a.png", &format!("--time={time}")], "--time");
    }
    render(&["-o", "a.png", "--frames", "0..3"], "%04d");
    render(&["-o", "%04d.png"], "--frames");
}

#[test]
fn states() {
    render(&["-o", "%d.png", "--frames", "0..2", "--state-every", "0"], "--state-every");
    render(&["-o", "%d.png", "--frames", "0..2", "--state-every", "x"], "--state-every");
    render(&["-o", "a.png", "--state-every", "3"], "--frames");
    render(&["-o", "a.png", "--states", "s"], "--frames");
    let folder = ["--state-every", "1", "--states", "file.txt/s"];
    render(&[&["-o", "%d.png", "--frames", "0..2"], &folder[..]].concat(), "--states file.txt/s");
}

#[test]
fn debug_views_and_cameras() {
    let known = "patches, culling, level, awake, crush, wireframe, half-wireframe";
    render(&["-o", "a.png", "--debug", "fancy"], known);
    render(&["-o", "a.png", "--debug", "level", "--reference"], "--reference");
    render(&["-o", "a.png", "--culling-camera", "roof"], "main, side");
    render(&["-o", "a.png", "--level", "4"], "0..=3");
}

#[test]
fn samples() {
    render(&["-o", "a.png", "--samples", "3"], "this adapter has 1, 4");
    render(&["-o", "a.png", "--samples", "0"], "this adapter has 1, 4");
    render(&["-o", "a.png", "--samples", "many"], "--samples");
}

#[test]
fn cameras() {
    render(&["-o", "a.png", "--camera", "attic"], "main, side");
}

#[test]
fn outputs() {
    render(&["-o", "a"], "no extension");
    render(&["-o", "a.jpg"], ".png");
    render(&["-o", "a.png", "--light", "sunset"], "dawn, noon, golden-hour, overcast, moonlit");
    render(&["-o", "/proc/none/a.exr"], "-o /proc/none/a.exr");
    render(&["-o", "a.exr", "--labels"], "a.exr");
    render(&["-o", "a.mp4"], "a film needs --frames");
    render(&["-o", "a.gif"], "a film needs --frames");
    render(&["-o", "a.mp4", "--frames", "0..2", "--size", "1x9"], "at least 2 pixels");
    render(&["-o", "file.txt/a.mp4", "--frames", "0..2"], "file.txt");
    render(&["-o", "%s.png", "--frames", "0..2"], "%04d");
    render(&["-o", "file.txt/a.png"], "file.txt");
    render(&["-o", "."], "extension");
    render(&["-o", "new.png/"], "is a folder");
}

#[test]
#[cfg(unix)]
fn devices_are_no_outputs_and_stay() {
    let scene = scene("tiny.ron");
    refused(&["bench", &scene, "--json", "/dev/null"], "--json /dev/null: is not a file");
    assert!(!std::fs::metadata("/dev/null").unwrap().is_file());
}

#[test]
fn a_failed_render_keeps_the_earlier_picture() {
    let folder = Folder::new();
    std::fs::write(folder.path("a.png"), "earlier").unwrap();
    std::fs::write(
        folder.path("s.ron"),
        "(fields: [(on: Plane(), max_slope_deg: 0, height_limits_m: (5, 6))])",
    )
    .unwrap();
    let output = folder.sward(&["render", "s.ron", "-o", "a.png"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("nothing grows"), "{}", stderr(&output));
    assert_eq!(std::fs::read(folder.path("a.png")).unwrap(), b"earlier");
    assert_eq!(folder.names(), ["a.png", "s.ron"]);
}

/// Density and count far above what fits are refused before anything grows.
#[test]
fn more_blades_than_fit() {
    let folder = Folder::new();
    for keys in ["density: 1e9", "density: 1e30", "count: 1000000000000", "count: 200000000"] {
        let text = format!("(fields: [(on: Plane(size_m: (100, 100)), {keys})])");
        std::fs::write(folder.path("s.ron"), text).unwrap();
        let start = std::time::Instant::now();
        let output = folder.sward(&["check", "s.ron"]);
        let error = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{keys}: {error}");
        assert_eq!(error.lines().count(), 1, "{keys}: {error}");
        let parts =
            ["s.ron: field 'field 0': ", "67104768 blades fit", "max_storage_buffer_binding_size"];
        assert!(parts.iter().all(|part| error.contains(part)), "{keys}: {error}");
        assert!(start.elapsed().as_secs() < 5, "{keys}: not at once");
    }
}

#[test]
fn pictures_to_compare() {
    refused(&["compare", "a.png", "b.png"], "a.png");
    refused(&["compare", "file.txt", "file.txt"], "file.txt: is no PNG picture");
    refused(&["compare", ".", "file.txt"], ".: is not a file");
    let scene = scene("tiny.ron");
    refused(&["bench", &scene, "--compare", "."], "--compare .: is not a file");
}

#[test]
fn earlier_measurements() {
    let scene = scene("tiny.ron");
    refused(&["bench", &scene, "--compare", "none.json"], "none.json");
    refused(&["bench", &scene, "--compare", "file.txt"], "not a file that bench --json wrote");
    refused(&["bench", &scene, "--frames", "0"], "--frames");
    refused(&["bench", &scene, "--without", "sun"], "collisions, culling");
    refused(&["bench", &scene, "--patch-sizes", "100"], "patch_size");
    refused(&["bench", &scene, "--json", "file.txt/a.json"], "file.txt");
}

/// Runs with an environment in which no adapter can be opened.
fn no_adapter(variable: (&str, &str), cause: &str) {
    let folder = Folder::new();
    let arguments: &[&str] = &["render", &scene("tiny.ron"), "-o", "new/a.png"];
    let output = folder.sward_with(arguments, &[variable]);
    let error = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{error}");
    assert_eq!(error.lines().count(), 1, "{error}");
    assert!(error.contains(cause), "{error}");
    assert!(folder.names().is_empty());
}

#[test]
fn adapters() {
    no_adapter(("WGPU_ADAPTER_NAME", "no such card"), "there are: ");
    no_adapter(("WGPU_BACKEND", "gl"), "apt-get install mesa-vulkan-drivers");
    no_adapter(("VK_DRIVER_FILES", "/none.json"), "apt-get install mesa-vulkan-drivers");
}

#[test]
fn maps_of_wind() {
    let scene = scene("tiny.ron");
    let wind = |extra: &[&str], cause| refused(&[&["wind", &scene], extra].concat(), cause);
    wind(&[], "--output");
    wind(&["-o", "a.jpg"], ".png");
    wind(&["-o", "%04d.png"], "a map is one picture");
    wind(&["-o", "a.png", "--size", "20000x10"], "at most 16384");
    wind(&["-o", "a.png", "--size", "0x10"], "--size");
    for height in ["-1", "NaN", "inf", "x"] {
        wind(&["-o", "a.png", &format!("--height={height}")], "--height");
    }
    wind(&["-o", "a.png", "--time=-1"], "--time");
    wind(&["-o", "file.txt/a.png"], "file.txt");
    refused(&["wind", "missing.ron", "-o", "a.png"], "missing.ron");
}

#[test]
fn textures() {
    let paint = |extra: &[&str], cause| refused(&[&["texture"], extra].concat(), cause);
    paint(&["poppy"], "--output");
    paint(&["rose", "-o", "a.png"], "no plant 'rose'; there are: meadow-grass, ");
    paint(&["poppy", "-o", "a.jpg"], ".png");
    paint(&["poppy", "-o", "%04d.png"], "a texture is one picture");
    paint(&["poppy", "-o", "file.txt/a.png"], "file.txt");
    paint(&["poppy", "-o", "a.png", "--normal", "n.jpg"], "--normal n.jpg");
    paint(&["poppy", "-o", "a.png", "--mips", "--normal", "n.png"], "--normal");
    for size in ["0", "1", "5000", "-3", "x"] {
        paint(&["poppy", "-o", "a.png", &format!("--size={size}")], "--size");
    }
    for seed in ["-1", "x", "1.5"] {
        paint(&["poppy", "-o", "a.png", &format!("--seed={seed}")], "--seed");
    }
    for turned in ["NaN", "inf", "x"] {
        paint(&["poppy", "-o", "a.png", "--turned", turned], "--turned");
    }
    paint(&["strip", "-o", "a.png", "--above"], "--above");
    paint(&["atlas", "-o", "a.png", "--mips"], "--mips");
    paint(&["atlas", "-o", "a.png", "--size", "8"], "--size 8");
    paint(&["poppy", "-o", "a.png", "--mips", "--size", "2048"], "--size 2048");
}
