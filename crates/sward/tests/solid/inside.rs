//! What is inside, how far, and what has no inside.

use crate::shapes::*;
use glam::{UVec2, Vec2, Vec3};
use sward::{Error, Mesh, Solid};

fn refused(mesh: &Mesh) -> String {
    match Solid::new(mesh) {
        Err(Error::Mesh(cause)) => {
            assert!(!cause.contains('\n'));
            cause
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_ball_and_a_box_are_where_they_should_be() {
    let ball = Solid::new(&Mesh::sphere(2.0, 96).unwrap()).unwrap();
    let half = Vec3::new(1.0, 2.0, 0.5);
    let cuboid = Solid::new(&cuboid(half, Vec3::new(5.0, 0.0, -3.0))).unwrap();
    for i in 0..3000 {
        let point = chance((Vec3::splat(-3.0), Vec3::splat(3.0)), i);
        let exact = point.length() - 2.0;
        assert!((ball.distance(point) - exact).abs() < 0.004, "{point}");
        if exact.abs() > 0.004 {
            assert_eq!(ball.contains(point), exact < 0.0, "{point}");
        }
        let over = point.abs() - half;
        let exact = over.max(Vec3::ZERO).length() + over.max_element().min(0.0);
        let found = cuboid.distance(point + Vec3::new(5.0, 0.0, -3.0));
        assert!((found - exact).abs() < 1e-5, "{point}: {found}, not {exact}");
    }
    assert_eq!(ball.open_edges(), 0);
    assert!(!ball.contains(Vec3::NAN) && ball.distance(Vec3::NAN) == f32::INFINITY);
}

#[test]
fn holes_overlaps_and_loose_triangles_do_no_harm() {
    let whole = sphere(1.0);
    let mut holed = whole.clone();
    holed.triangles.retain(|t| t.iter().all(|&v| whole.positions[v as usize].y < 0.93));
    let solid = Solid::new(&holed).unwrap();
    assert!(solid.open_edges() > 20, "{}", solid.open_edges());
    let mut wrong = 0;
    for i in 0..4000 {
        let point = chance((Vec3::splat(-1.2), Vec3::splat(1.2)), i);
        // The film across the hole is level.
        let inside = point.length() < 0.99 && point.y < 0.9;
        let outside = point.length() > 1.0 || point.y > 0.95;
        wrong += u32::from(inside && !solid.contains(point) || outside && solid.contains(point));
    }
    assert!(wrong < 12, "{wrong} of 4000");
    // Two that overlap, and a triangle on its own
    let mut soup = joined(&sphere(1.0), &moved(&sphere(1.0), |p| p + Vec3::X));
    soup.positions.extend([Vec3::new(-4.0, 0.0, 0.0), Vec3::new(-4.0, 1.0, 0.0), Vec3::X * -5.0]);
    let last = soup.positions.len() as u32;
    soup.triangles.push([last - 3, last - 2, last - 1]);
    let solid = Solid::new(&soup).unwrap();
    for (x, inside) in [(-0.9, true), (0.5, true), (1.9, true), (2.1, false), (-4.2, false)] {
        assert_eq!(solid.contains(Vec3::new(x, 0.1, 0.05)), inside, "{x}");
    }
}

#[test]
fn a_mesh_turned_inside_out_is_turned_back() {
    let mut mesh = torus();
    mesh.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    let (turned, plain) = (Solid::new(&mesh).unwrap(), Solid::new(&torus()).unwrap());
    for point in (0..500).map(|i| chance(plain.bounds(), i)) {
        assert_eq!(turned.contains(point), plain.contains(point), "{point}");
    }
    assert!(turned.contains(Vec3::X * 2.0) && !turned.contains(Vec3::ZERO));
}

#[test]
fn size_and_place_change_nothing() {
    let plain = Solid::new(&turned(&torus())).unwrap();
    for (scale, shift) in [(1e-9, Vec3::ZERO), (1e-3, Vec3::X * 0.5), (3e8, Vec3::Y * 1e8)] {
        let place = |p: Vec3| p * scale + shift;
        let solid = Solid::new(&moved(&turned(&torus()), place)).unwrap();
        for point in (0..400).map(|i| chance(plain.bounds(), i)) {
            let (found, exact) = (solid.distance(place(point)) / scale, plain.distance(point));
            assert!((found - exact).abs() < 2e-4, "{scale}: {found}, not {exact}");
        }
    }
}

#[test]
fn what_has_no_inside_is_refused() {
    assert!(refused(&Mesh::default()).contains("empty"));
    let plane = Mesh::plane(Vec2::splat(4.0), UVec2::splat(8)).unwrap();
    for mesh in [&plane, &turned(&plane)] {
        let cause = refused(mesh);
        assert!(cause.contains("nothing lies inside") && cause.contains("close it"), "{cause}");
    }
    // A sheet with a back lies on itself.
    let mut two_sided = plane.clone();
    two_sided.triangles.extend(plane.triangles.iter().map(|&[a, b, c]| [a, c, b]));
    assert!(refused(&two_sided).contains("nothing lies inside"));
    let point = Mesh { positions: vec![Vec3::ONE; 3], triangles: vec![[0, 1, 2]], ..plane.clone() };
    assert!(refused(&point).contains("one point"));
    let line = moved(&sphere(1.0), |p| Vec3::X * p.x);
    assert!(refused(&line).contains("nothing lies inside"));
    let mut broken = sphere(1.0);
    broken.positions[7].y = f32::NAN;
    assert!(refused(&broken).contains("vertex 7"));
    broken.positions[7].y = 1e20;
    assert!(refused(&broken).contains("vertex 7"));
    let mut broken = sphere(1.0);
    broken.triangles[3][1] = 1_000_000;
    assert!(refused(&broken).contains("triangle 3 uses vertex 1000000"));
}

#[test]
fn an_open_bowl_is_full_to_its_rim() {
    let mut bowl = Mesh::sphere(1.0, 48).unwrap();
    let positions = bowl.positions.clone();
    bowl.triangles.retain(|t| t.iter().all(|&v| positions[v as usize].y < 0.01));
    let solid = Solid::new(&bowl).unwrap();
    assert!(solid.contains(Vec3::NEG_Y * 0.1) && !solid.contains(Vec3::Y * 0.1));
}
