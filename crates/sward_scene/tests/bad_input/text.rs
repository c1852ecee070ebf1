//! Texts that are no scene, and names that nothing has.

use super::error;
use std::path::Path;
use sward_scene::parse;

#[test]
fn syntax_errors_name_line_and_column() {
    let cases = [
        (
            "(\n  fields: [(on: Plane(),\n    densty: 3)],\n)",
            "scene.ron:3:",
            "unknown key 'densty'",
        ),
        ("(\n  fields: [(on: Plain())],\n)", "scene.ron:2:", "unknown kind 'Plain'"),
        ("(\n  fields: [(density: 3)],\n)", "scene.ron:2:", "the key 'on' is missing"),
        ("(\n  fields: 7,\n)", "scene.ron:2:", ""),
        ("(\n  fields: [(on: Plane(), density: \"much\")],\n)", "scene.ron:2:", ""),
        ("(\n  fields: [(on: Plane(),", "scene.ron:2:", ""),
        (
            "(fields: [(on: Plane(), species: [(root_color: (\"green\", \"#123456\"))])])",
            "scene.ron:1:",
            "not a colour",
        ),
        ("", "scene.ron:1:", ""),
    ];
    for (text, place, cause) in cases {
        let error = error(text);
        assert!(error.starts_with(place) && error.contains(cause), "{text}: {error}");
    }
    assert!(error("()").contains("fields: the scene grows nothing"));
}

#[test]
fn an_unknown_camera_lists_those_that_there_are() {
    let scene = parse("(fields: [(on: Plane())])", Path::new("scene.ron")).expect("a scene");
    assert!(scene.camera(None).is_ok() && scene.camera(Some("default")).is_ok());
    let error = scene.camera(Some("sky")).expect_err("no such camera").to_string();
    assert_eq!(error, "scene.ron: no camera 'sky'; there are: default");
}
