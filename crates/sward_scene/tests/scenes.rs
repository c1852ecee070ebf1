//! Every scene that comes with the project loads, and is what it says.

use std::path::{Path, PathBuf};
use sward_scene::{Scene, load, parse};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

fn scene(name: &str) -> Scene {
    load(&folder().join(name)).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_scene_loads() {
    let mut seen = 0;
    for entry in std::fs::read_dir(folder()).expect("scenes") {
        let path = entry.expect("entry").path();
        if path.extension().is_some_and(|extension| extension == "ron") {
            let scene = load(&path).unwrap_or_else(|error| panic!("{error}"));
            assert!(!scene.fields.is_empty() && !scene.cameras.is_empty(), "{}", path.display());
            // The first time, meshes are packed, which is told.
            let mut notes = scene.notes.iter().filter(|note| !note.starts_with("packed"));
            assert_eq!(notes.next(), None, "{}", path.display());
            seen += 1;
        }
    }
    assert!(seen >= 5, "{seen} scenes in {}", folder().display());
}

#[test]
fn the_smallest_scene_is_three_lines() {
    let text = std::fs::read_to_string(folder().join("minimal.ron")).expect("minimal.ron");
    assert_eq!(text.lines().count(), 3);
    let scene = scene("minimal.ron");
    let eye = scene.cameras[0].eye;
    assert!(eye.is_finite() && eye.y.abs() < 10.0, "{eye}");
}

#[test]
fn the_reference_is_the_authors_field() {
    let scene = scene("reference.ron");
    assert_eq!(scene.fields[0].desc.count, Some(397_881));
    let species = &scene.fields[0].desc.species[0];
    assert_eq!((species.height_m.min, species.height_m.max), (1.3, 2.5));
    assert_eq!((species.width_m.min, species.width_m.max), (0.1, 0.14));
    let positions = &scene.objects[scene.fields[0].object].mesh.positions;
    let mean = positions.iter().map(|p| p.y).sum::<f32>() / positions.len() as f32;
    assert!((mean + 2.5).abs() < 0.7, "{mean}");
    let camera = &scene.cameras[0];
    assert_eq!((camera.eye.to_array(), camera.vertical_fov_deg), ([0.0, 10.0, 50.0], 60.0));
    let ahead = (camera.target - camera.eye).normalize();
    assert_eq!(ahead.to_array(), [0.0, 0.0, -1.0]);
}

#[test]
fn the_five_shapes_stand_side_by_side() {
    let scene = scene("shapes.ron");
    let shapes: Vec<_> =
        scene.fields.iter().map(|f| (f.desc.species[0].shape, f.desc.count)).collect();
    let tip = sward::Shape::TriangleTip { tip: 0.5 };
    use sward::Shape::{Dandelion, Quad, Quadratic, Triangle};
    assert_eq!(shapes, [Quad, Triangle, Quadratic, tip, Dandelion].map(|shape| (shape, Some(1))));
    for field in &scene.fields {
        let grown = sward::Field::grow(&field.surface, &field.desc).expect("a blade");
        let facing = grown.blades()[0].facing.to_degrees();
        assert!((facing - 90.0).abs() < 1.0, "{}: faces the camera, not {facing}", field.name);
    }
}

/// A field takes the colour of the object's own texture: base colour times texel.
#[test]
fn blades_take_an_objects_own_colours() {
    let text =
        "(objects: [(name: \"ball\", source: Sphere(radius_m: 1), base_color: (0.5, 0.25, 0))],
        fields: [(on: Object(\"ball\"), color: Surface, density: 50)])";
    let scene = sward_scene::parse(text, Path::new("s.ron")).expect("a scene");
    let field = &scene.fields[0];
    let grown = sward::Field::grow(&field.surface, &field.desc).expect("blades");
    for i in 0..grown.blades().len() {
        let [r, g, b] = grown.color(i).expect("a colour");
        assert!((r - 0.5).abs() < 2e-3 && (g - 0.25).abs() < 2e-3 && b == 0.0);
    }
}

#[test]
fn balls_roll_on_the_hills() {
    let scene = scene("nature.ron");
    assert_eq!(scene.spheres.len(), 2);
    for sphere in &scene.spheres {
        let (start, end) = (sphere.at(0.0), sphere.at(12.0));
        assert!(start.center.distance(end.center) > 8.0);
        assert!(sphere.path.keys().len() > 100, "follows the ground");
    }
}

#[test]
fn copies_stand_on_what_is_below_them() {
    let text = r#"(
        objects: [
            (name: "hill", source: Terrain(size_m: 40)),
            (source: Sphere(radius_m: 0.1, segments: 8), above: "hill", scatter: (count: 20)),
        ],
        fields: [(on: Object("hill"), density: 1)],
    )"#;
    let scene = parse(text, Path::new("scene.ron")).expect("a scene");
    let (hill, balls) = (&scene.objects[0].mesh, &scene.objects[1].mesh);
    for ball in balls.positions.chunks(balls.positions.len() / 20) {
        let center = ball.iter().sum::<glam::Vec3>() / ball.len() as f32;
        let near = hill.positions.iter().min_by(|a, b| {
            let away = |p: &glam::Vec3| (p.x - center.x).hypot(p.z - center.z);
            away(a).total_cmp(&away(b))
        });
        let ground = near.expect("ground").y;
        assert!((center.y - ground).abs() < 0.2, "{center} over {ground}");
    }
}
