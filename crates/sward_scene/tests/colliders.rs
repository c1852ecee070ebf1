//! How objects push grass aside: defaults, shapes, places, and the files that keep packed meshes.

use glam::Vec3;
use std::fs;
use std::path::{Path, PathBuf};
use sward::{ColliderShape, Obstacle};
use sward_scene::{Object, Scene, SceneError, parse};

/// A folder of this test's own, with an OBJ of a box in it, 2 x 1 x 4 m.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("sward_{name}_{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        let corners = (0..8).map(|i| {
            let side = |bit: i32, half: f32| if i >> bit & 1 == 1 { half } else { -half };
            format!("v {} {} {}\n", side(0, 1.0), side(1, 0.5), side(2, 2.0))
        });
        let faces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
        fs::write(folder.join("box.obj"), corners.collect::<String>() + faces).unwrap();
        let sheet = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
        fs::write(folder.join("sheet.obj"), sheet).unwrap();
        Self(folder)
    }
    fn parse(&self, objects: &str) -> Result<Scene, SceneError> {
        let text =
            format!("(objects: [{objects}], fields: [(name: \"lawn\", on: Plane(), density: 20)])");
        parse(&text, &self.0.join("s.ron"))
    }
    fn packs(&self) -> Vec<PathBuf> {
        let files = fs::read_dir(&self.0).unwrap().map(|entry| entry.unwrap().path());
        files.filter(|file| file.to_string_lossy().ends_with(".pack")).collect()
    }
    fn leftovers(&self) -> usize {
        let files = fs::read_dir(&self.0).unwrap();
        files
            .filter(|f| f.as_ref().unwrap().path().extension().is_some_and(|e| e == "partial"))
            .count()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn kind(object: &Object) -> &'static str {
    match object.collider.first().map(|piece| piece.shape()) {
        None => "none",
        Some(ColliderShape::Sphere { .. }) => "sphere",
        Some(ColliderShape::Capsule { .. }) => "capsule",
        Some(ColliderShape::Cuboid { .. }) => "box",
        Some(ColliderShape::Spheres(_)) => "packed",
        Some(_) => "other",
    }
}

#[test]
fn what_stands_in_the_grass_collides_and_what_carries_it_does_not() {
    let folder = Folder::new("defaults");
    let text = "(objects: [
            (name: \"ground\", source: Terrain(size_m: 20, divisions: 8)),
            (name: \"rock\", source: Rock()),
            (name: \"tree\", source: Tree()),
            (name: \"ball\", source: Sphere(segments: 16)),
            (name: \"egg\", source: Sphere(segments: 16), scale: (1, 2, 1)),
            (name: \"ring\", source: Torus(segments: 24)),
            (name: \"floor\", source: Plane()),
            (name: \"mesh\", source: File(\"box.obj\")),
            (name: \"furry\", source: File(\"box.obj\"), translate: (5, 0, 0)),
            (name: \"hidden\", source: Rock(), visible: false),
            (name: \"off\", source: Rock(), collide: None),
            (name: \"sheet\", source: File(\"sheet.obj\")),
        ],
        fields: [(on: Object(\"ground\"), density: 5), (on: Object(\"furry\"), density: 5)])";
    let scene = parse(text, &folder.0.join("s.ron")).unwrap();
    let kinds: Vec<_> = scene.objects.iter().map(|o| (o.name.as_str(), kind(o))).collect();
    let expected = [
        ("ground", "none"),
        ("rock", "packed"),
        ("tree", "capsule"),
        ("ball", "sphere"),
        ("egg", "packed"),
        ("ring", "packed"),
        ("floor", "none"),
        ("mesh", "packed"),
        ("furry", "none"),
        ("hidden", "none"),
        ("off", "none"),
        ("sheet", "none"),
    ];
    assert_eq!(kinds, expected);
    let note = scene.notes.iter().find(|note| note.contains("'sheet'")).unwrap();
    assert!(note.contains("pushes no grass") && note.contains("close it"), "{note}");
    // Rock, tree, ball, egg, ring, mesh
    assert!(scene.fields.iter().all(|field| field.desc.obstacles.len() == 6));
}

/// Share of an object's vertices that its collider holds, grown by `slack`, and farthest that a
/// sphere's or box's own points are from the mesh's box.
fn held(object: &Object, slack: f32) -> f32 {
    let obstacles: Vec<Obstacle> = object.collider.iter().map(|piece| piece.obstacle()).collect();
    let middle = |p: Vec3| {
        let centers = object.collider.iter().map(|piece| piece.pose.translation);
        let nearest = centers.min_by(|a, b| a.distance(p).total_cmp(&b.distance(p))).unwrap();
        p + (nearest - p) * slack
    };
    let inside = object
        .mesh
        .positions
        .iter()
        .filter(|&&p| obstacles.iter().any(|obstacle| obstacle.contains(middle(p))));
    inside.count() as f32 / object.mesh.positions.len() as f32
}

#[test]
fn colliders_stand_where_their_meshes_are_drawn() {
    let folder = Folder::new("places");
    let place = "scale: (2, 1, 0.5), rotate_deg: (20, 130, -40), translate: (3, 1, -2)";
    let even = "scale: 1.7, rotate_deg: (20, 130, -40), translate: (3, 1, -2), \
                at: [(4, 4), (-50, 2)], copy_scale: (0.5, 2)";
    let mirrored = "scale: (-1, 1, 1), rotate_deg: (20, 130, -40), translate: (3, 1, -2)";
    for keys in [place, even, mirrored] {
        for collide in ["Box", "Sphere", "Capsule", "Packed(spheres: 60)"] {
            let text = format!("(source: File(\"box.obj\"), {keys}, collide: {collide})");
            let scene = folder.parse(&text).unwrap();
            let object = &scene.objects[0];
            let copies = if keys == even { 2 } else { 1 };
            assert_eq!(object.collider.len(), copies);
            let share = held(object, 0.02);
            assert!(share > 0.999, "{keys}, {collide}: {share}");
            // And not where they are not: spheres lie within the mesh's bounds.
            for piece in &object.collider {
                if let ColliderShape::Spheres(spheres) = piece.shape() {
                    let mesh = sward::Solid::new(&object.mesh).unwrap();
                    let outside =
                        spheres.iter().filter(|s| mesh.distance(piece.pose.point(s.center)) > 0.0);
                    assert_eq!(outside.count(), 0, "{keys}");
                }
            }
        }
    }
}

#[test]
fn what_moves_keeps_no_roots_out_and_what_rests_does() {
    let folder = Folder::new("roots");
    let scene = folder
        .parse("(source: Rock(radius_m: 2)), (source: Tree(), translate: (6, 0, 0))")
        .unwrap();
    let field = &scene.fields[0];
    let grown = sward::Field::grow(&field.surface, &field.desc).unwrap();
    let inside = |p: Vec3| field.desc.obstacles.iter().any(|o| o.contains(p));
    assert_eq!(field.desc.obstacles.len(), 2);
    assert!(inside(Vec3::Y * 0.01) && inside(Vec3::new(6.0, 0.01, 0.0)));
    assert!(grown.blades().iter().all(|blade| !inside(blade.root)));
    assert!(grown.blades().len() < 20 * 400 - 100, "{}", grown.blades().len());
    let moving =
        folder.parse("(source: Rock(radius_m: 2), path: [(0, 0, 0, 0), (2, 1, 0, 0)])").unwrap();
    assert!(moving.fields[0].desc.obstacles.is_empty());
    assert_eq!(moving.objects[0].collider.len(), 1);
}

#[test]
fn a_packed_mesh_is_kept_and_read_again() {
    let folder = Folder::new("kept");
    let text = "(name: \"b\", source: File(\"box.obj\"), collide: Packed(spheres: 50))";
    let first = folder.parse(text).unwrap();
    assert!(
        first.notes.len() == 1 && first.notes[0].contains("packed 'b' into 50 spheres: covers")
    );
    assert_eq!((folder.packs().len(), folder.leftovers()), (1, 0));
    let second = folder.parse(text).unwrap();
    assert!(second.notes.is_empty(), "{:?}", second.notes);
    assert_eq!(spheres(&first), spheres(&second));
    // Another setting or mesh is another file; an even scale and a place are not.
    folder.parse(&text.replace("50", "40")).unwrap();
    folder.parse(&text.replace("collide", "scale: 2, translate: (1, 2, 3), collide")).unwrap();
    assert_eq!(folder.packs().len(), 2);
    folder.parse(&text.replace("collide", "scale: (1, 2, 1), collide")).unwrap();
    assert_eq!(folder.packs().len(), 3);
}

fn spheres(scene: &Scene) -> Vec<sward::Sphere> {
    match scene.objects[0].collider[0].shape() {
        ColliderShape::Spheres(spheres) => spheres.to_vec(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_broken_pack_file_is_never_trusted() {
    let folder = Folder::new("broken");
    let text = "(name: \"b\", source: File(\"box.obj\"), collide: Packed(spheres: 50))";
    let whole = spheres(&folder.parse(text).unwrap());
    let file = folder.packs().remove(0);
    let good = fs::read(&file).unwrap();
    let changed = |at: usize, to: u8| {
        let mut bytes = good.clone();
        bytes[at] = to;
        bytes
    };
    let mut cases = vec![
        (Vec::new(), "cut off"),
        (good[..20].to_vec(), "cut off"),
        (good[..good.len() - 7].to_vec(), "cut off"),
        ([good.clone(), vec![0]].concat(), "too long"),
        (vec![7; 100_000], "too long"),
        (changed(7, b'9'), "version"),
        (changed(9, good[9] ^ 1), "another mesh"),
        (changed(24, 0), "number of spheres"),
        (changed(26, 255), "number of spheres"),
        (changed(30, good[30] ^ 16), "checksum"),
        (changed(60, good[60] ^ 16), "checksum"),
        (changed(good.len() - 1, good[good.len() - 1] ^ 1), "checksum"),
    ];
    cases.push((good.iter().map(|b| b ^ 255).collect(), "version"));
    for (bytes, why) in cases {
        fs::write(&file, &bytes).unwrap();
        let scene = folder.parse(text).unwrap();
        assert!(scene.notes.len() == 1 && scene.notes[0].contains(why), "{why}: {:?}", scene.notes);
        assert_eq!(spheres(&scene), whole);
        assert_eq!(fs::read(&file).unwrap(), good, "{why}: written again");
    }
}

#[test]
fn a_folder_that_cannot_be_written_is_told_and_no_error() {
    let folder = Folder::new("unwritable");
    let text = "(name: \"b\", source: File(\"box.obj\"), collide: Packed(spheres: 50))";
    folder.parse(text).unwrap();
    // A folder in the file's place: root may write everywhere, but not over this.
    let file = folder.packs().remove(0);
    fs::remove_file(&file).unwrap();
    fs::create_dir(&file).unwrap();
    let scene = folder.parse(text).unwrap();
    assert_eq!(scene.notes.len(), 1);
    assert!(scene.notes[0].contains("cannot be written"), "{:?}", scene.notes);
    assert_eq!((spheres(&scene).len(), folder.leftovers()), (50, 0));
}

#[test]
fn bad_settings_are_named() {
    let folder = Folder::new("bad");
    let sheet = "(name: \"s\", source: File(\"sheet.obj\"), collide: Packed())";
    let cases = [
        ("(source: Rock(), collide: Packed(spheres: 0))", "objects[0].collide.spheres: 0 is out"),
        ("(source: Rock(), collide: Packed(spheres: 70000))", "collide.spheres: 70000 is out"),
        ("(source: Rock(), collide: Packed(bulge: 0.5))", "objects[0].collide.bulge: 0.5 is out"),
        ("(source: Rock(), collide: Packed(bulge: -1))", "collide.bulge: -1 is out"),
        ("(source: Rock(), collide: Cone)", "unknown kind 'Cone'"),
        ("(source: Rock(), collide: Packed(balls: 3))", "unknown key 'balls'"),
        (sheet, "objects[0].collide: mesh: nothing lies inside"),
        ("(source: Plane(), collide: Box)", "objects[0].collide: it is flat"),
    ];
    for (objects, expected) in cases {
        let error = folder.parse(objects).unwrap_err().to_string();
        assert!(error.contains(expected) && !error.contains('\n'), "{objects}: {error}");
        assert!(error.contains("s.ron:1:"), "{error}");
    }
    let many = "(name: \"g\", source: Plane(size_m: (90, 90))), (source: Rock(), above: \"g\", \
                scatter: (count: 100), collide: Packed(spheres: 60000))";
    let error = folder.parse(many).unwrap_err().to_string();
    assert!(error.contains("100 copies of 60000 spheres"), "{error}");
}

#[test]
fn a_mesh_with_a_hole_is_packed_and_told() {
    let folder = Folder::new("hole");
    let text = fs::read_to_string(folder.0.join("box.obj")).unwrap();
    // Without its top.
    fs::write(folder.0.join("box.obj"), text.replace("f 3 7 8 4\n", "")).unwrap();
    let scene = folder.parse("(name: \"b\", source: File(\"box.obj\"))").unwrap();
    assert!(scene.notes[0].contains("open at 4 edges"), "{:?}", scene.notes);
    let inside = spheres(&scene).iter().filter(|s| s.center.y < 0.5).count();
    assert!(inside > 100, "{inside}");
    assert!(Path::new(&folder.packs()[0]).exists());
}

/// 2,500 copies: more than 1,000,000 spheres at 1,000 each.
#[test]
fn many_copies_share_a_million_spheres_and_it_is_told() {
    let folder = Folder::new("many");
    let ground = "(name: \"g\", source: Plane(size_m: (90, 90)))";
    let boxes = "(name: \"b\", source: File(\"box.obj\"), above: \"g\", scatter: (count: 2500))";
    let scene = folder.parse(&format!("{ground}, {boxes}")).unwrap();
    let pieces = &scene.objects[1].collider;
    let counts = pieces.iter().map(|piece| match piece.shape() {
        ColliderShape::Spheres(spheres) => spheres.len(),
        other => panic!("{other:?}"),
    });
    let all: usize = counts.sum();
    assert!(pieces.len() == 2500 && all > 500_000 && all <= 1_000_000, "{all}");
    let told = |note: &String| note.contains("'b': 2500 copies have 400 spheres each, not 1000");
    assert!(scene.notes.iter().any(told), "{:?}", scene.notes);
    // Several of them are too many for a scene, and the one that is too many is named.
    let three = [1, 2, 3].map(|i| boxes.replace("\"b\"", &format!("\"b{i}\"")));
    let error = folder.parse(&format!("{ground}, {}", three.join(", "))).unwrap_err().to_string();
    assert!(error.contains("objects[3].collide: with the objects before it"), "{error}");
}

#[test]
fn many_rocks_are_packed_as_few_are() {
    let folder = Folder::new("rocks");
    let rocks = |count: usize| {
        let ground = "(name: \"g\", source: Plane(size_m: (90, 90)))";
        let rocks = format!("(source: Rock(), above: \"g\", scatter: (count: {count}))");
        folder.parse(&format!("{ground}, {rocks}")).unwrap().objects.remove(1)
    };
    let (few, many) = (rocks(3), rocks(300));
    let spheres = |object: &Object, i: usize| match object.collider[i].shape() {
        ColliderShape::Spheres(spheres) => spheres.to_vec(),
        other => panic!("{other:?}"),
    };
    for i in 0..3 {
        assert_eq!(spheres(&few, i), spheres(&many, i));
        // The shapes come again, where meshes and spheres still agree.
        assert_eq!(spheres(&many, i), spheres(&many, i + 64));
        assert_ne!(spheres(&many, i), spheres(&many, i + 1));
    }
    assert_eq!(many.collider.len(), 300);
    let copies = many.mesh.positions.chunks(many.mesh.positions.len() / 300);
    for (i, (piece, copy)) in many.collider.iter().zip(copies).enumerate() {
        let middle = copy.iter().sum::<Vec3>() / copy.len() as f32;
        // Its vertices drawn in a little lie inside: it is the shape that is drawn there.
        let drawn = copy.iter().step_by(40).map(|p| middle + (*p - middle) * 0.95);
        let held = drawn.filter(|p| piece.obstacle().contains(*p)).count();
        assert!(held * 10 > copy.len().div_ceil(40) * 9, "{i}: {held}");
    }
}
