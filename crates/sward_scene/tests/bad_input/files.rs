//! Files of ground, masks and winds.

use super::{Folder, one_line, png};
use sward_scene::load;

pub(super) const HILLS: &str = r#"(fields: [(on: Heightmap(file: "h.png", size_m: (20, 10)))])"#;

#[test]
fn missing_files_are_named() {
    let folder = Folder::new("missing");
    let none = one_line(load(&folder.0.join("none.ron")));
    assert!(none.contains("none.ron: no such file"), "{none}");
    assert!(one_line(load(&folder.0)).contains("not a file"));
    folder.write("text.ron", &[0xff, 0xfe, 0]);
    assert!(one_line(load(&folder.0.join("text.ron"))).contains("not UTF-8"));
    let cases = [
        (r#"(fields: [(on: File("b.obj"))])"#, "b.obj: no such file"),
        (r#"(fields: [(on: File("b.stl"))])"#, "b.stl: '.stl' is no mesh format"),
        (HILLS, "h.png: no such file"),
        (r#"(fields: [(on: Plane(), density_map: Texture("d.png"))])"#, "d.png: no such file"),
        (r#"(fields: [(on: Plane())], wind: [Texture(file: "w.png")])"#, "w.png: no such file"),
        (r#"(fields: [(on: Object("hill"))])"#, "fields[0].on: no object 'hill' before this"),
    ];
    for (text, expected) in cases {
        let error = folder.error(text);
        assert!(error.contains(expected), "{text}: {error}");
    }
}

#[test]
fn broken_meshes_are_named() {
    let folder = Folder::new("meshes");
    let cases = [
        ("", "the mesh is empty"),
        ("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "no area"),
        ("v 0 0 0\nv nan 0 0\n", "line 2: position"),
        ("v 0 0 0\nv 1 0 0\nf 1 2 3\n", "line 3: vertex index 3 is out of range"),
    ];
    for (obj, expected) in cases {
        folder.write("b.obj", obj.as_bytes());
        let error = folder.error(r#"(fields: [(on: File("b.obj"))])"#);
        assert!(error.contains("b.obj: ") && error.contains(expected), "{obj}: {error}");
    }
    folder.write("b.glb", b"glTF\x02\0\0\0\xff\0\0\0");
    assert!(folder.error(r#"(fields: [(on: File("b.glb"))])"#).contains("b.glb: truncated GLB"));
}

#[test]
fn broken_images_are_named() {
    let folder = Folder::new("images");
    let whole = png(9, 7, true);
    folder.write("h.png", &whole[..whole.len() / 2]);
    assert!(folder.error(HILLS).contains("h.png: broken or unsupported image"));
    folder.write("h.png", b"not an image at all");
    assert!(folder.error(HILLS).contains("h.png: is no PNG or JPEG"));
    folder.write("h.png", &png(1, 1, true));
    assert!(folder.error(HILLS).contains("1 x 1 pixels; a height image needs at least 2 x 2"));
    folder.write("h.png", &png(9000, 2, true));
    assert!(folder.error(HILLS).contains("9000 x 2 pixels: sides must be 1 to 8192"));
    // A header that claims 60,000 x 60,000 pixels: refused before that is allocated.
    let mut huge = whole;
    huge[16..24].copy_from_slice(&[0, 0, 0xea, 0x60, 0, 0, 0xea, 0x60]);
    folder.write("h.png", &huge);
    assert!(folder.error(HILLS).contains("h.png: "));
    let color = image::DynamicImage::new_rgb8(4, 4);
    color.save_with_format(folder.0.join("h.png"), image::ImageFormat::Png).expect("saved");
    assert!(folder.error(HILLS).contains("colour image"));
}

#[test]
fn wind_maps_are_read_and_broken_ones_named() {
    const SCENE: &str = r#"(fields: [(on: Plane())], wind: [Texture(file: "w.png", strength: 1)])"#;
    let folder = Folder::new("winds");
    folder.write("w.png", &png(3000, 2, false));
    assert!(
        folder.error(SCENE).contains("w.png: 3000 x 2 pixels: a map of winds has at most 2048")
    );
    folder.write("w.png", b"wind");
    assert!(folder.error(SCENE).contains("w.png: is no PNG or JPEG"));
    let winds = |folder: &Folder| match &folder.parse(SCENE).expect("a scene").wind[0].source {
        sward::WindSource::Texture(texture) => texture.map.winds().to_vec(),
        other => panic!("{other:?}"),
    };
    for sixteen in [false, true] {
        folder.write("w.png", &png(9, 7, sixteen));
        let winds = winds(&folder);
        assert!(winds.len() == 63 && winds.iter().all(|w| w[1] == 0.0));
        assert!((winds[10][0] - 20.0 / 255.0).abs() < 1e-4, "{:?}", winds[10]);
    }
    let mut color = image::RgbImage::new(2, 1);
    color.put_pixel(0, 0, image::Rgb([255, 0, 128]));
    color.save(folder.0.join("w.png")).expect("saved");
    assert_eq!(winds(&folder), [[1.0, -1.0], [-1.0, -1.0]]);
}

#[test]
fn height_images_of_8_and_16_bits_are_read() {
    let folder = Folder::new("heights");
    folder.write("h.png", &png(9, 7, true));
    let scene = folder.parse(HILLS).expect("16 bits");
    assert!(scene.notes.is_empty(), "{:?}", scene.notes);
    let mesh = &scene.objects[0].mesh;
    assert!(mesh.positions.iter().all(|p| p.x.abs() <= 10.0 && p.z.abs() <= 5.0 && p.y >= 0.0));
    assert!(mesh.positions.iter().any(|p| p.y > 2.0));
    folder.write("h.png", &png(9, 7, false));
    let scene = folder.parse(HILLS).expect("8 bits");
    assert!(scene.notes.iter().any(|note| note.contains("8 bits")), "{:?}", scene.notes);
}
