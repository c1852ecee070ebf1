//! Colours that blades take from their surface.

use super::{desc, plane};
use glam::Vec3;
use sward::{BladeOrder, ColorImage, ColorMap, Error, Field, FieldDesc, Mesh, Metric, Surface};

const SIZE: f32 = 10.0;

/// The colour that the test's maps have at a root.
fn expected(root: Vec3) -> Vec3 {
    Vec3::new(root.x / SIZE + 0.5, root.z / SIZE + 0.5, 0.25)
}

fn colored() -> Surface {
    let mut mesh = plane(SIZE).mesh().clone();
    let color = |p: &Vec3| expected(*p).extend(1.0).to_array();
    mesh.colors = mesh.positions.iter().map(color).collect();
    Surface::new(mesh).expect("a plane")
}

/// Largest difference between a blade's colour and that of its place.
fn worst(field: &Field) -> f32 {
    let off = |(i, blade): (usize, &sward::grow::Blade)| {
        let color: Vec3 = field.color(i).expect("a colour a blade").into();
        (color - expected(blade.root)).abs().max_element()
    };
    field.blades().iter().enumerate().map(off).fold(0.0, f32::max)
}

#[test]
fn every_blade_has_the_colour_of_its_root_in_any_order() {
    let surface = colored();
    for order in [BladeOrder::Progressive, BladeOrder::Morton, BladeOrder::Lexicographic] {
        for metric in [Metric::Euclidean, Metric::Manhattan] {
            let color_map = Some(ColorMap::VertexColor);
            let base = desc(&surface, 5000.0, 0.4);
            let field =
                Field::grow(&surface, &FieldDesc { color_map, order, metric, ..base }).unwrap();
            // 10 bits of a square root: steps of up to 1 in 512
            assert!(worst(&field) < 2.5e-3, "{order:?}, {metric:?}: {}", worst(&field));
        }
    }
}

#[test]
fn a_map_changes_no_blade() {
    let surface = colored();
    let plain = desc(&surface, 3000.0, 0.3);
    let mapped = FieldDesc { color_map: Some(ColorMap::VertexColor), ..plain.clone() };
    let plain = Field::grow(&surface, &plain).unwrap();
    assert_eq!(plain.blades(), Field::grow(&surface, &mapped).unwrap().blades());
    assert_eq!(plain.color(0), None);
}

#[test]
fn a_texture_colours_through_uvs() {
    let surface = plane(SIZE);
    let side = 64_u32;
    let uv_is = |i: u32| (i as f32 + 0.5) / side as f32;
    let texels = (0..side * side).map(|i| [uv_is(i % side), uv_is(i / side), 0.25]).collect();
    let map = ColorMap::Texture(ColorImage { width: side, height: side, texels });
    let base = desc(&surface, 4000.0, 0.3);
    let field = Field::grow(&surface, &FieldDesc { color_map: Some(map), ..base }).unwrap();
    // Within half a texel of the rim the map wraps, so that its two sides blend
    let rim = SIZE / 2.0 - SIZE / side as f32;
    for (i, blade) in field.blades().iter().enumerate() {
        let root = blade.root;
        let color: Vec3 = field.color(i).unwrap().into();
        let flipped = Vec3::new(color.x, 1.0 - color.y, color.z);
        let near = |c: Vec3| (c - expected(root)).abs().max_element() < 4e-3;
        let inside = root.x.abs().max(root.z.abs()) < rim;
        assert!(!inside || near(color) || near(flipped), "{root}: {color}");
    }
}

/// Two squares side by side, of two materials; the vertex colours darken both.
#[test]
fn each_material_colours_its_own_part() {
    let mut mesh = Mesh::default();
    for x in [0.0, 1.0] {
        let first = mesh.positions.len() as u32;
        let corners = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
        mesh.positions.extend(corners.map(|(dx, z)| Vec3::new(x + dx, 0.0, z)));
        mesh.triangles.extend([[0, 1, 2], [0, 2, 3]].map(|t| t.map(|v| v + first)));
    }
    mesh.colors = vec![[0.5, 0.5, 0.5, 1.0]; 8];
    // A triangle without area is dropped, and shifts those after it
    mesh.triangles.insert(0, [0, 0, 1]);
    let surface = Surface::new(mesh).unwrap();
    let plain = |color| ColorImage { width: 1, height: 1, texels: vec![color] };
    let images = vec![plain([1.0, 0.0, 0.0]), plain([0.0, 0.0, 1.0])];
    let of_vertex = vec![0, 0, 0, 0, 1, 1, 1, 1];
    let map = ColorMap::Materials { images, of_vertex };
    let base = FieldDesc { density: 500.0, ..FieldDesc::default() };
    let field = Field::grow(&surface, &FieldDesc { color_map: Some(map), ..base }).unwrap();
    for (i, blade) in field.blades().iter().enumerate() {
        let [r, g, b] = field.color(i).unwrap();
        let (own, other) = if blade.root.x < 1.0 { (r, b) } else { (b, r) };
        assert!((own - 0.5).abs() < 2e-3 && other == 0.0 && g == 0.0, "{}", blade.root);
    }
}

#[test]
fn bad_maps_are_errors_that_name_the_setting() {
    let surface = plane(3.0);
    let image = |width, texels| ColorImage { width, height: 1, texels };
    let mut bare = surface.mesh().clone();
    bare.uvs.clear();
    let bare = Surface::new(bare).unwrap();
    let grey = [0.5; 3];
    let materials = |images, of_vertex| ColorMap::Materials { images, of_vertex };
    let bad = [
        (&surface, ColorMap::Texture(image(2, vec![grey])), "texels"),
        (&surface, ColorMap::Texture(image(0, vec![])), "texels"),
        (&surface, ColorMap::Texture(image(1, vec![[0.0, f32::NAN, 0.0]])), "0 to 1"),
        (&surface, ColorMap::Texture(image(1, vec![[1.5, 0.0, 0.0]])), "0 to 1"),
        (&surface, ColorMap::VertexColor, "vertex colours"),
        (&bare, ColorMap::Texture(image(2, vec![grey; 2])), "texture coordinates"),
        (&bare, materials(vec![image(2, vec![grey; 2])], vec![0; 4]), "texture coordinates"),
        (&surface, materials(vec![image(1, vec![grey])], vec![0; 3]), "give each one"),
        (&surface, materials(vec![image(1, vec![grey])], vec![0, 0, 0, 1]), "counted from 0"),
    ];
    for (surface, map, word) in bad {
        let desc = FieldDesc { color_map: Some(map.clone()), ..desc(surface, 500.0, 0.0) };
        let error = Field::grow(surface, &desc).unwrap_err();
        let named = matches!(&error, Error::Setting { setting, .. } if setting == "color_map");
        assert!(named && error.to_string().contains(word), "{map:?}: {error}");
    }
    let desc = FieldDesc { color_mix: f32::NAN, ..desc(&surface, 500.0, 0.0) };
    let error = Field::grow(&surface, &desc).unwrap_err();
    assert!(error.to_string().starts_with("color_mix"), "{error}");
}
