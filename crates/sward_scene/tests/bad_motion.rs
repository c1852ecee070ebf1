//! Bad paths and bodies: one line that names the file, the place and the cause.

use std::path::Path;
use sward_scene::parse;

fn error(text: &str) -> String {
    let error = parse(text, Path::new("scene.ron")).expect_err("bad input").to_string();
    assert!(!error.contains('\n') && error.starts_with("scene.ron:"), "{error}");
    error
}

/// A scene with a plane `g` under grass and more keys.
fn with(keys: &str) -> String {
    format!("(objects: [(name: \"g\", source: Plane())], fields: [(on: Object(\"g\"))],\n {keys})")
}

#[test]
fn paths() {
    let cases = [
        ("[]", "scene.ron:2:19: spheres[0].path: is empty"),
        ("(keys: [])", "spheres[0].path.keys: is empty"),
        ("[(0, 0, 0, 0), (2, 0, 0, 0), (1, 0, 0, 0)]", "path[2]: time 1 must be after"),
        ("[(NaN, 0, 0, 0)]", "path[0]: NaN is out of range"),
        ("[(0, 0, NaN, 0)]", "path[0]: NaN is out of range"),
        ("[(0, 0, 0)]", "scene.ron:2"),
        ("[(0, 0, 0, 0, 0)]", "scene.ron:2"),
        (
            "[(time_s: 0, place: (0, 0, 0))]",
            "unknown key 'place'; known here: time_s, at, rotate_deg",
        ),
        (
            "(keys: [(0, 0, 0, 0)], speed: 3)",
            "unknown key 'speed'; known here: keys, smooth, repeat",
        ),
        ("(smooth: true)", "the key 'keys' is missing"),
        ("(keys: [(0, 0, 0, 0), (1, 1, 0, 0)], repeat: true)", "path.repeat: the last key must be"),
        ("(keys: [(0, 0, 0, 0)], repeat: true)", "path.repeat: needs two keys"),
        ("7", "scene.ron:2"),
    ];
    for (path, expected) in cases {
        let error = error(&with(&format!("spheres: [(path: {path})]")));
        assert!(error.contains(expected), "{path}: {error}");
    }
    let long = (0..=100_000).map(|i| format!("({i}, 0, 0, 0)")).collect::<Vec<_>>().join(",");
    let error = error(&with(&format!("spheres: [(path: [{long}])]")));
    assert!(error.contains("at most 100000 are taken"), "{error}");
}

#[test]
fn objects_that_move() {
    let objects = |keys: &str, on: &str| {
        format!(
            "(objects: [(name: \"a\", source: Plane()), (name: \"b\", source: Plane(), {keys})],
            fields: [(on: Object(\"{on}\"))])"
        )
    };
    let path = "path: [(0, 0, 0, 0), (1, 1, 0, 0)]";
    let cases = [
        (
            objects(&format!("{path}, at: [(0, 0)]"), "a"),
            "objects[1].path: a thing that moves has no copies",
        ),
        (objects(path, "b"), "fields[0].on: 'b' has a path: name an object that rests"),
        (objects(&format!("{path}, above: \"c\""), "a"), "no object 'c'"),
        (objects("path: [(1, 0, 0, 0), (1, 0, 0, 0)]", "a"), "objects[1].path[1]: time 1"),
    ];
    for (text, expected) in cases {
        let error = error(&text);
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn bodies() {
    let cases = [
        ("count: 0", "bodies[0].count: 0 is out of range"),
        ("count: 10001", "bodies[0].count: 10001 is out of range"),
        ("count: 6000), (count: 6000", "bodies[1].count: makes 12000 bodies"),
        ("shape: Sphere(radius_m: 0)", "bodies[0].shape.radius_m: 0 is out of range"),
        ("shape: Sphere(radius: 1)", "unknown key 'radius'; known here: radius_m"),
        ("shape: Box(size_m: (1, 1, -1))", "bodies[0].shape.size_m: -1 is out of range"),
        ("shape: Capsule(radius_m: 1, length_m: 2)", "shape.length_m: 2 must be above twice"),
        ("shape: Cone()", "unknown kind 'Cone'; known here: Sphere, Box, Capsule"),
        ("copy_scale: (1, 0)", "bodies[0].copy_scale: 0 is out of range"),
        ("at: (0, NaN, 0)", "bodies[0].at: NaN"),
        ("spread_m: (1, -1, 0)", "bodies[0].spread_m: [1, -1, 0] must not be below 0"),
        ("above: \"h\"", "bodies[0].above: no object 'h'"),
        ("above: \"g\", at: (500, 0, 0)", "bodies[0].at: is beside the object"),
        ("velocity_mps: (inf, 0, 0)", "bodies[0].velocity_mps: inf"),
        ("velocity_spread_mps: -1", "bodies[0].velocity_spread_mps: -1"),
        ("spin_rps: (NaN, 0, 0)", "bodies[0].spin_rps: NaN"),
        ("spin_spread_rps: -1", "bodies[0].spin_spread_rps: -1"),
        ("start_s: -1", "bodies[0].start_s: -1"),
        ("every_s: NaN", "bodies[0].every_s: NaN"),
        ("restitution: 1.5", "bodies[0].restitution: 1.5"),
        ("friction: -0.1", "bodies[0].friction: -0.1"),
        ("density_kgpm3: 0", "bodies[0].density_kgpm3: 0 is out of range"),
        ("grass_drag: -1", "bodies[0].grass_drag: -1"),
        ("colors: []", "bodies[0].colors: is empty"),
        ("colors: [(2, 0, 0)]", "bodies[0].colors[0]: 2 is out of range"),
        ("roughness: 2", "bodies[0].roughness: 2"),
        ("mass: 2", "unknown key 'mass'"),
    ];
    for (keys, expected) in cases {
        let error = error(&with(&format!("bodies: [({keys})]")));
        assert!(error.contains(expected), "{keys}: {error}");
    }
}
