//! What a packing promises: inside, enough, few, and the same every time.

use crate::shapes::*;
use glam::Vec3;
use std::time::Instant;
use sward::{Error, Mesh, PackDesc, Packing, Solid};

fn pack(mesh: &Mesh, spheres: u32) -> (Solid, Packing) {
    let solid = Solid::new(mesh).unwrap();
    let packing = solid.pack(&PackDesc { spheres, ..PackDesc::default() }).unwrap();
    (solid, packing)
}

/// Every promise that holds for any mesh; `least` is the share to cover.
fn check(name: &str, mesh: &Mesh, spheres: u32, bulge: f32, least: f32) -> Packing {
    let solid = Solid::new(mesh).unwrap();
    let packing = solid.pack(&PackDesc { spheres, bulge }).unwrap();
    let covered = coverage(&solid, &packing, 5_000);
    let worst = worst_bulge(&solid, &packing);
    let count = packing.spheres.len();
    println!("{name}: {count} spheres, {covered:.4} ({:.4}), bulge {worst:.5}", packing.coverage);
    assert!(count <= spheres as usize && count > 0, "{name}: {count}");
    assert!(covered >= least, "{name}: {covered} covered");
    assert!((covered - packing.coverage).abs() < 0.02, "{name}: {covered}, {}", packing.coverage);
    assert!(worst <= bulge * 1.001 + 1e-6, "{name}: bulge {worst}");
    for sphere in &packing.spheres {
        assert!(solid.contains(sphere.center), "{name}: a centre outside");
        assert!(sphere.radius > 0.0 && sphere.radius.is_finite(), "{name}");
    }
    packing
}

#[test]
fn the_bunny_into_a_thousand_spheres() {
    let (solid, start) = (Solid::new(&bunny()).unwrap(), Instant::now());
    let packing = solid.pack(&PackDesc::default()).unwrap();
    let seconds = start.elapsed().as_secs_f64();
    let covered = coverage(&solid, &packing, 30_000);
    let bulge = worst_bulge(&solid, &packing);
    println!("bunny: {covered:.4} covered, bulge {bulge:.5} of the diagonal, {seconds:.2} s");
    assert_eq!(packing.spheres.len(), 1000);
    assert!(covered >= 0.95, "{covered} covered");
    assert!(bulge <= 0.01, "bulge {bulge}");
    // Nor does any sphere leave it, by points on spheres a little smaller.
    let (low, high) = solid.bounds();
    let diagonal = low.distance(high);
    for (i, sphere) in packing.spheres.iter().enumerate() {
        for k in 0..40 {
            let toward = chance((Vec3::NEG_ONE, Vec3::ONE), i as u32 * 40 + k).normalize();
            let point = sphere.center + toward * (sphere.radius - 0.02 * diagonal).max(0.0);
            assert!(solid.contains(point), "sphere {i} leaves the bunny");
        }
    }
    assert!(seconds < 10.0, "{seconds} s");
}

#[test]
fn shapes_of_all_kinds_are_filled() {
    check("ball", &sphere(1.0), 100, 0.001, 0.97);
    check("torus", &torus(), 200, 0.001, 0.9);
    check("box", &cuboid(Vec3::new(1.0, 2.0, 0.5), Vec3::X * 9.0), 300, 0.005, 0.95);
    let two = joined(&sphere(0.5), &moved(&torus(), |p| p + Vec3::Y * 3.0));
    let packing = check("two bodies", &two, 200, 0.002, 0.9);
    let (ball, ring): (Vec<sward::Sphere>, Vec<_>) =
        packing.spheres.iter().copied().partition(|s| s.center.y < 1.0);
    assert!(!ball.is_empty() && ring.len() > 20, "{} and {}", ball.len(), ring.len());
}

#[test]
fn thin_plates_are_filled_level_or_turned() {
    for thickness in [0.02, 0.004] {
        let plate = cuboid(Vec3::new(1.0, thickness / 2.0, 1.0), Vec3::ZERO);
        check(&format!("plate of {thickness}"), &plate, 4000, 0.01, 0.9);
        check(&format!("turned plate of {thickness}"), &turned(&plate), 4000, 0.01, 0.85);
    }
}

#[test]
fn one_sphere_is_enough_for_a_ball_and_more_cover_more() {
    let (_, packing) = pack(&sphere(3.0), 1);
    assert!(packing.coverage > 0.97 && (packing.spheres[0].radius - 3.0).abs() < 0.1);
    assert!(packing.spheres[0].center.length() < 0.15);
    let mut before = 0.0;
    for spheres in [1, 4, 16, 64, 256] {
        let (_, packing) = pack(&bunny(), spheres);
        assert_eq!(packing.spheres.len(), spheres as usize);
        assert!(packing.coverage > before, "{spheres}: {}", packing.coverage);
        before = packing.coverage;
    }
}

#[test]
fn the_largest_come_first() {
    let (solid, packing) = pack(&bunny(), 200);
    let deepest = (0..20_000).map(|i| -solid.distance(chance(solid.bounds(), i)));
    let deepest = deepest.fold(0.0, f32::max);
    let first = packing.spheres[0].radius;
    assert!(packing.spheres.iter().all(|s| s.radius <= first * 1.001), "the first is the largest");
    assert!(first > deepest * 0.98, "{first}, but {deepest} fits");
    // What each one wins never rises: counted on points of our own, ten at a time.
    let points: Vec<_> = (0..60_000).map(|i| chance(solid.bounds(), i)).collect();
    let mut bare: Vec<_> = points.into_iter().filter(|&p| solid.contains(p)).collect();
    let all = bare.len() as f32;
    let mut last = f32::INFINITY;
    for ten in packing.spheres.chunks(10) {
        let before = bare.len();
        bare.retain(|p| ten.iter().all(|s| s.center.distance(*p) > s.radius));
        let won = (before - bare.len()) as f32;
        assert!(won <= last + 0.004 * all, "{won} after {last}");
        last = won;
    }
}

#[test]
fn the_same_spheres_for_any_number_of_threads() {
    let pack = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| pack(&bunny(), 60).1)
    };
    let (one, five) = (pack(1), pack(5));
    assert_eq!(one, five);
}

#[test]
fn size_and_place_change_nothing() {
    let (_, plain) = pack(&torus(), 40);
    for (scale, shift) in [(1.0 / 1024.0, 0.0), (1e-6, 0.0), (1e7, 0.0), (1.0, 64.0)] {
        let place = |p: Vec3| p * scale + Vec3::X * shift;
        let (_, packing) = pack(&moved(&torus(), place), 40);
        assert!((packing.coverage - plain.coverage).abs() < 0.01, "{scale}");
        let (first, other) = (plain.spheres[0], packing.spheres[0]);
        assert!((other.radius / scale - first.radius).abs() < 0.01, "{scale}, {shift}");
        assert!(packing.bulge_m / scale < 1.01 * plain.bulge_m + 1e-5);
    }
}

#[test]
fn settings_out_of_range_are_refused() {
    let solid = Solid::new(&sphere(1.0)).unwrap();
    let refused = |spheres, bulge| match solid.pack(&PackDesc { spheres, bulge }) {
        Err(Error::Setting { setting, .. }) => setting,
        other => panic!("{other:?}"),
    };
    assert_eq!(refused(0, 0.005), "spheres");
    assert_eq!(refused(u32::MAX, 0.005), "spheres");
    for bulge in [-0.1, 0.2, f32::NAN, f32::INFINITY] {
        assert_eq!(refused(10, bulge), "bulge");
    }
    // No bulge at all is allowed: then every sphere lies inside.
    let packing = solid.pack(&PackDesc { spheres: 10, bulge: 0.0 }).unwrap();
    assert!(packing.bulge_m <= 1e-5, "{}", packing.bulge_m);
}
