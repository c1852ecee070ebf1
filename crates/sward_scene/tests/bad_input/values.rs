//! Values out of their range.

use super::error;
use std::path::Path;
use sward_scene::parse;

#[test]
fn values_out_of_range_name_line_and_key() {
    let field = |keys: &str| format!("(\n  fields: [(\n    on: Plane(),\n    {keys}\n  )],\n)");
    let cases = [
        ("density: -3", "scene.ron:4:14: fields[0].density: -3 is out of range"),
        ("density: NaN", "scene.ron:4:14: fields[0].density: NaN is out of range"),
        ("density: 5, count: 3", "fields[0].count: give `density` or `count`"),
        ("species: []", "fields[0].species: 0 kinds"),
        (
            "species: [(height_m: (2, 1))]",
            "scene.ron:4:26: fields[0].species[0].height_m: (2, 1): the first",
        ),
        (
            "species: [(), (width_m: 0)]",
            "fields[0].species[1].width_m: 0 is out of range: it must be above 0",
        ),
        ("species: [(shape: TriangleTip(1))]", "fields[0].species[0].shape"),
        (
            "species: [(root_color: ((2, 0, 0), \"#00ff00\"))]",
            "species[0].root_color: 2 is out of range",
        ),
        (
            "species: [(form: Strip(fold_deg: 151))]",
            "scene.ron:4:38: fields[0].species[0].form.fold_deg: 151 is out of range",
        ),
        ("species: [(form: Strip(sway: -0.1))]", "form.sway: -0.1 is out of range"),
        ("species: [(form: Strip(orange: NaN))]", "form.orange: NaN is out of range"),
        ("species: [(form: Strip(few_rings_px: 0))]", "form.few_rings_px: 0 is out of range"),
        ("species: [(form: Strip(rings: 3))]", "rings"),
        ("species: [(form: Leaf)]", "Leaf"),
        ("tufts: (share: 1.5)", "fields[0].tufts.share: 1.5 is out of range: it must be 0 to 1"),
        ("color_mix: 2", "scene.ron:4:16: fields[0].color_mix: 2 is out of range"),
        ("color: Surface", "fields[0].color: object 'ground of field 0' has no colour"),
        ("color: Fur", "unknown kind 'Fur'; known here: Texture, Surface, VertexColor"),
        (
            "color: Texture(\"a.png\"), inside: (center: (0, 0), radius_m: 1)",
            "fields[0].color: `inside` maps its part anew",
        ),
        ("patch_size: 100", "fields[0].patch_size: 100 is no multiple of 64"),
        ("max_slope_deg: 200", "fields[0].max_slope_deg: 200"),
        ("inside: (center: (900, 0), radius_m: 1)", "fields[0].inside: nothing of the object"),
    ];
    for (keys, expected) in cases {
        let text = error(&field(keys));
        assert!(text.contains(expected), "{keys}: {text}");
    }
}

/// Each of these keys beside a field is refused in these words.
fn refused(cases: &[(&str, &str)]) {
    for (keys, expected) in cases {
        let text = error(&format!("(fields: [(on: Plane())], {keys})"));
        assert!(text.starts_with("scene.ron:") && text.contains(expected), "{keys}: {text}");
    }
}

#[test]
fn winds_out_of_range_name_their_key() {
    refused(&[
        ("wind: [Waves(direction: (0, 0))]", "wind[0].direction"),
        ("wind: [Gusts(), Waves(wavelength_m: 0)]", "wind[1].wavelength_m: 0"),
        // What the library refuses is refused here, where the line is known.
        ("wind: [Waves(wavelength_m: 0.001)]", "wind[0].wavelength_m: 0.001"),
        ("wind: [Gusts(size_m: 20000)]", "wind[0].size_m: 20000"),
        ("wind: [Cosine(direction: (0, 0))]", "wind[0].direction"),
        ("wind: [Cosine(wavelength_m: 0)]", "wind[0].wavelength_m: 0"),
        ("wind: [Rotor(radius_m: 0)]", "scene.ron:1:50: wind[0].radius_m: 0"),
        ("wind: [Rotor(blades: 0)]", "wind[0].blades: 0"),
        ("wind: [Rotor(strength: 21)]", "wind[0].strength: 21 is out of range"),
        ("wind: [Rotor(at: (0, NaN, 0))]", "wind[0].at: NaN"),
        ("wind: [Rotor(above: \"moon\")]", "wind[0].above: no object 'moon'"),
        (
            "wind: [Rotor(path: [(1, 0, 9, 0), (1, 1, 9, 0)])]",
            "wind[0].path[1]: time 1 must be after",
        ),
        ("wind: [Texture(gusts: 65)]", "wind[0].gusts: 65"),
        ("wind: [Texture(size_m: 0)]", "wind[0].size_m: 0"),
        ("wind: [Texture(file: \"w.png\", seed: 2)]", "wind[0].file: give `file`, or `gusts`"),
        ("wind: [Vortex(range_m: -3)]", "wind[0].range_m: -3"),
        ("wind: [Vortex(path: [])]", "wind[0].path: is empty"),
        ("wind: [Fan(direction: (0, 0, 0))]", "wind[0].direction"),
        ("wind: [Fan(half_angle_deg: 90)]", "wind[0].half_angle_deg: 90"),
    ]);
}

#[test]
fn light_and_lens_out_of_range_name_their_key() {
    refused(&[
        ("sun: (elevation_deg: 91)", "sun.elevation_deg: 91"),
        ("sky: (haze_m: 0)", "sky.haze_m: 0"),
        (
            "light: (time_h: 25)",
            "scene.ron:1:43: light.time_h: 25 is out of range: it must be 0 to 24",
        ),
        ("light: (time_h: NaN)", "light.time_h: NaN is out of range"),
        ("light: (latitude_deg: -91)", "light.latitude_deg: -91"),
        ("light: (day_of_year: 0)", "light.day_of_year: 0 is out of range: it must be 1 to 366"),
        ("light: (hours_per_s: inf)", "light.hours_per_s: inf"),
        ("light: (haze_m: 0)", "light.haze_m: 0"),
        ("light: (), sun: ()", "light: it sets sun and sky by the time of day; leave out `sun`"),
        ("sky: (), light: ()", "scene.ron:1:43: light: it sets sun and sky by the time of day"),
        ("light: (moon: 1)", "unknown key 'moon'; known here: time_h, hours_per_s"),
        ("fog: (density_per_m: -1)", "scene.ron:1:48: fog.density_per_m: -1 is out of range"),
        ("fog: (density_per_m: NaN)", "fog.density_per_m: NaN is out of range: it must be 0 to 10"),
        ("fog: (start_m: -1)", "fog.start_m: -1"),
        ("fog: (base_m: inf)", "fog.base_m: inf"),
        ("fog: (falloff_m: 0)", "fog.falloff_m: 0 is out of range: it must be at least 0.01"),
        ("fog: (color: (-1, 0, 0))", "fog.color: -1 is out of range"),
        ("fog: (density: 1)", "unknown key 'density'; known here: color, density_per_m"),
        ("depth_of_field: (focus_m: 0)", "depth_of_field.focus_m: 0 is out of range"),
        ("depth_of_field: (focus_m: inf)", "depth_of_field.focus_m: inf is out of range"),
        ("depth_of_field: (aperture_mm: -1)", "depth_of_field.aperture_mm: -1 is out of range"),
        (
            "depth_of_field: (aperture: 2)",
            "unknown key 'aperture'; known here: focus_m, aperture_mm",
        ),
    ]);
}

#[test]
fn scene_values_out_of_range_name_their_key() {
    refused(&[
        ("fps: 0", "scene.ron:1:32: fps: 0 is out of range"),
        ("warm_up_s: -1", "warm_up_s: -1"),
        ("gravity: (direction: (0, 0, 0))", "gravity.direction"),
        ("culling: (max_distance_m: -1)", "culling.max_distance_m: -1"),
        (
            "cameras: [(eye: (0, 1, 0), target: (0, 1, 0))]",
            "cameras[0].target: is where the eye is",
        ),
        ("cameras: [(eye: (0, 1, 0), target: (0, 9, 0))]", "cameras[0].up: is along"),
        ("cameras: [(eye: (0, 1, 0), target: (1, 1, 0), near_m: 9, far_m: 2)]", "cameras[0].far_m"),
        ("cameras: [(eye: (0, NaN, 0), target: (1, 1, 0))]", "cameras[0].eye: NaN"),
        ("spheres: [(radius_m: -1)]", "spheres[0].radius_m: -1"),
        (
            "spheres: [(path: [(1, 0, 0, 0), (1, 0, 0, 0)])]",
            "spheres[0].path[1]: time 1 must be after",
        ),
        ("spheres: [(above: \"moon\")]", "spheres[0].above: no object 'moon'"),
        ("objects: [(source: Rock(), scale: 0)]", "objects[0].scale: 0 flattens"),
        ("objects: [(source: Rock(), above: \"x\")]", "objects[0].above: no object 'x'"),
        ("objects: [(source: Rock(), scatter: (count: 3))]", "objects[0].scatter: needs `above`"),
        ("objects: [(source: Torus(tube_m: 9))]", "objects[0].source"),
        (
            "objects: [(name: \"a\", source: Rock()), (name: \"a\", source: Rock())]",
            "objects[1].name",
        ),
        ("objects: [(source: Object(\"a\"))]", "objects[0].source: Object(\"a\") is for"),
    ]);
}

#[test]
fn bands_out_of_order_are_refused() {
    refused(&[
        ("bands: (distances_m: [])", "bands.distances_m: 0 bands: there are three"),
        ("bands: (distances_m: [3, 9])", "bands.distances_m: 2 bands"),
        ("bands: (distances_m: [9, 3, 20])", "bands.distances_m: 9, 3, 20 are out of order"),
        ("bands: (distances_m: [3, 9, 9])", "out of order"),
        ("bands: (distances_m: [0, 9, 20])", "bands.distances_m[0]: 0"),
        ("bands: (distances_m: [3, NaN, 20])", "bands.distances_m[1]: NaN"),
        ("bands: (jitter: 1)", "bands.jitter: 1 is out of range"),
        ("bands: (far_share: 0)", "bands.far_share: 0"),
        ("shade: (depth: 1.1)", "shade.depth: 1.1"),
        ("shade: (size_m: 0)", "shade.size_m: 0"),
        ("shade: (drift_mps: (0, NaN))", "shade.drift_mps: NaN"),
    ]);
}

#[test]
fn more_wind_than_is_taken_is_refused() {
    let scene = |count| format!("(fields: [(on: Plane())], wind: [{}])", "Waves(), ".repeat(count));
    assert!(parse(&scene(64), Path::new("scene.ron")).is_ok());
    let text = error(&scene(65));
    assert!(text.contains("scene.ron:1:33: wind: 65 sources: at most 64"), "{text}");
}
