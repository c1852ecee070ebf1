//! Coverage, hiding, dilation and broken input of the rasteriser.

use super::Triangle;
use super::raster::*;
use super::ribbon::tests::upright;
use crate::Shape;
use glam::{Vec2, Vec3};

fn window(size: u32, samples: u32) -> Window {
    Window {
        center: Vec3::Y * 0.5,
        right: Vec3::X,
        up: Vec3::Y,
        half: Vec2::splat(0.5),
        size: [size; 2],
        samples,
    }
}

fn blade(shape: Shape, z: f32, shade: f32) -> Vec<Triangle> {
    let mut ribbon = upright(shape, 0.0);
    ribbon.curve = ribbon.curve.map(|p| p + Vec3::Z * z);
    let mut list = Vec::new();
    ribbon.triangles(|_| Vec3::splat(shade), &mut list);
    list
}

#[test]
fn coverage_is_the_area() {
    for (shape, share) in [(Shape::Quad, 0.2), (Shape::TriangleTip { tip: 0.5 }, 0.15)] {
        let list = blade(shape, 0.0, 0.5);
        let seen = window(64, 4).see(&list);
        assert!((seen.coverage() - share).abs() < 2e-3, "{shape:?}: {}", seen.coverage());
        let tile = seen.tile();
        assert!((tile.coverage() - seen.coverage()).abs() < 1e-6);
        assert!((tile.halved().coverage() - seen.coverage()).abs() < 1e-6);
    }
}

/// A sample on the edge that two triangles share belongs to one of them: no gaps, and the
/// thickness of a single ribbon is nowhere 2.
#[test]
fn there_are_no_gaps() {
    let list = blade(Shape::Quad, 0.0, 0.5);
    let seen = window(61, 3).see(&list);
    let tile = seen.tile();
    assert!(tile.texels.iter().filter(|t| t.alpha == 1.0).count() > 61 * 10);
    let drawn = tile.texels.iter().filter(|t| t.alpha > 0.0);
    assert!(drawn.into_iter().all(|t| (t.thickness - 1.0).abs() < 1e-5));
}

#[test]
fn the_nearer_hides_the_farther_whichever_comes_first() {
    let (near, far) = (blade(Shape::Quad, 0.1, 1.0), blade(Shape::Quad, -0.1, 0.0));
    for list in [[near.clone(), far.clone()].concat(), [far, near].concat()] {
        let tile = window(32, 2).see(&list).tile();
        let middle = tile.texels[16 * 32 + 16];
        assert_eq!((middle.albedo, middle.alpha), (Vec3::ONE, 1.0));
        assert_eq!(middle.thickness, 2.0, "light passes both");
        assert_eq!(middle.normal, Vec3::Z, "towards the eye");
    }
}

/// The mean of a texture that is drawn with its rims filtered is no darker than the plant.
#[test]
fn empty_texels_take_a_colour_and_no_cover() {
    let list = blade(Shape::Triangle, 0.0, 0.7);
    let tile = window(32, 4).see(&list).tile();
    assert!(tile.texels.iter().any(|t| t.alpha == 0.0));
    assert!(tile.texels.iter().all(|t| (t.albedo - 0.7).abs().max_element() < 1e-5));
    let nothing = window(8, 2).see(&[]).tile();
    assert!(nothing.texels.iter().all(|t| *t == Texel::EMPTY));
}

/// What is not finite or has no area is left out.
#[test]
fn broken_triangles_are_left_out() {
    let mut list = blade(Shape::Quad, 0.0, 0.5);
    list[0][0].position.x = f32::NAN;
    list[1][0].position = Vec3::splat(f32::INFINITY);
    list.push([list[2][0]; 3]);
    let seen = window(16, 2).see(&list);
    assert!(seen.surfaces().all(|(_, s)| s.albedo.is_finite() && s.normal.is_normalized()));
}
