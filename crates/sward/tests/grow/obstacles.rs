//! No root inside an obstacle, and every other blade as it is without.

use super::{desc, hills, plane};
use glam::{Quat, UVec2, Vec3};
use std::collections::HashMap;
use std::sync::Arc;
use std::time::Instant;
use sward::grow::Blade;
use sward::{Error, Field, FieldDesc, Mesh, Obstacle, Pose, Solid, Sphere, Surface};

fn key(blade: &Blade) -> [u32; 3] {
    blade.root.to_array().map(f32::to_bits)
}

fn pose(x: f32, y: f32, z: f32) -> Pose {
    Pose { translation: Vec3::new(x, y, z), rotation: Quat::from_rotation_x(0.7) }
}

fn one_of_each() -> Vec<Obstacle> {
    let torus = Solid::new(&Mesh::torus(1.0, 0.35, UVec2::new(48, 24)).unwrap()).unwrap();
    vec![
        Obstacle::Sphere(Sphere { center: Vec3::new(-5.0, 0.0, -5.0), radius: 2.5 }),
        Obstacle::Capsule { from: Vec3::X * 3.0, to: Vec3::new(8.0, 1.0, -6.0), radius: 1.2 },
        Obstacle::Cuboid { half_extents: Vec3::new(1.0, 4.0, 2.0), pose: pose(6.0, 0.0, 6.0) },
        Obstacle::Solid {
            solid: Arc::new(torus),
            pose: Pose::at(Vec3::new(-6.0, 0.0, 6.0)),
            scale: 2.0,
        },
    ]
}

/// Grows with and without; returns how many each obstacle removed.
fn removed(surface: &Surface, free: &FieldDesc, obstacles: Vec<Obstacle>) -> Vec<usize> {
    let all = Field::grow(surface, free).unwrap();
    let desc = FieldDesc { obstacles, ..free.clone() };
    let rest = Field::grow(surface, &desc).unwrap();
    let mut rest: HashMap<_, Blade> = rest.blades().iter().map(|b| (key(b), *b)).collect();
    let mut counts = vec![0; desc.obstacles.len()];
    for blade in all.blades() {
        let inside: Vec<bool> = desc.obstacles.iter().map(|o| o.contains(blade.root)).collect();
        let kept = rest.remove(&key(blade));
        let expected = (!inside.contains(&true)).then_some(*blade);
        assert_eq!(kept, expected, "exactly those inside are gone, all others as they were");
        for (count, inside) in counts.iter_mut().zip(inside) {
            *count += usize::from(inside);
        }
    }
    assert!(rest.is_empty(), "{} grew that did not grow before", rest.len());
    counts
}

#[test]
fn no_root_inside_and_all_others_as_they_were() {
    for (surface, tufts) in [(plane(20.0), 0.0), (plane(20.0), 0.6), (hills(), 0.3)] {
        let counts = removed(&surface, &desc(&surface, 20_000.0, tufts), one_of_each());
        assert!(counts.iter().all(|&count| count > 100), "{counts:?}");
    }
}

#[test]
fn the_ground_inside_is_bare_and_its_area_right() {
    let surface = plane(20.0);
    let counts = removed(&surface, &desc(&surface, 40_000.0, 0.0), one_of_each());
    // 100 blades a square metre: the disk, and the ring's level cut.
    let disk = 100.0 * std::f32::consts::PI * 2.5 * 2.5;
    let ring = 100.0 * std::f32::consts::PI * (2.7 * 2.7 - 1.3 * 1.3);
    assert!((counts[0] as f32 - disk).abs() < 0.04 * disk, "{} of {disk}", counts[0]);
    assert!((counts[3] as f32 - ring).abs() < 0.05 * ring, "{} of {ring}", counts[3]);
}

#[test]
fn hundreds_of_obstacles_cost_little() {
    let surface = plane(40.0);
    let free = desc(&surface, 300_000.0, 0.0);
    let rock = Arc::new(Solid::new(&Mesh::sphere(0.4, 28).unwrap()).unwrap());
    let rocks = (0..400).map(|i| {
        let pose = pose((i % 20) as f32 * 2.0 - 19.0, 0.1, (i / 20) as f32 * 2.0 - 19.0);
        Obstacle::Solid { solid: rock.clone(), pose, scale: 1.0 }
    });
    let timed = |desc: &FieldDesc| {
        let start = Instant::now();
        let blades = Field::grow(&surface, desc).unwrap().blades().len();
        (blades, start.elapsed().as_secs_f64())
    };
    let (all, plain_s) = timed(&free);
    let (kept, s) = timed(&FieldDesc { obstacles: rocks.collect(), ..free });
    println!("{all} blades in {plain_s:.3} s, {kept} beside 400 rocks in {s:.3} s");
    assert!(kept < all * 9 / 10 && kept > all / 2, "{kept} of {all}");
    // About 1.2 times alone; other tests run beside this one.
    assert!(s < 3.0 * plain_s + 0.2, "{s} s, {plain_s} s without");
}

#[test]
fn broken_obstacles_are_named() {
    let nan = Pose::at(Vec3::NAN);
    let none = Pose { rotation: Quat::from_xyzw(0.0, 0.0, 0.0, 0.0), ..Pose::default() };
    let cases = [
        (Obstacle::Sphere(Sphere { center: Vec3::ZERO, radius: 0.0 }), "radius"),
        (Obstacle::Sphere(Sphere { center: Vec3::NAN, radius: 1.0 }), "center"),
        (Obstacle::Capsule { from: Vec3::ZERO, to: Vec3::INFINITY, radius: 1.0 }, "to"),
        (Obstacle::Capsule { from: Vec3::ZERO, to: Vec3::X, radius: f32::NAN }, "radius"),
        (Obstacle::Cuboid { half_extents: Vec3::new(1.0, 0.0, 1.0), pose: none }, "half_extents"),
        (Obstacle::Cuboid { half_extents: Vec3::ONE, pose: none }, "pose"),
        (Obstacle::Cuboid { half_extents: Vec3::ONE, pose: nan }, "pose"),
    ];
    let surface = plane(2.0);
    for (obstacle, part) in cases {
        let fine = Obstacle::Sphere(Sphere { center: Vec3::ZERO, radius: 0.1 });
        let desc = FieldDesc { obstacles: vec![fine, obstacle.clone()], ..Default::default() };
        match Field::grow(&surface, &desc) {
            Err(Error::Setting { setting, .. }) => {
                assert_eq!(setting, format!("obstacles[1].{part}"), "{obstacle:?}");
            }
            other => panic!("{obstacle:?}: {:?}", other.map(|field| field.blades().len())),
        }
    }
}

#[test]
fn a_field_under_one_obstacle_says_so() {
    let all = Obstacle::Sphere(Sphere { center: Vec3::ZERO, radius: 90.0 });
    let desc = FieldDesc { obstacles: vec![all], ..Default::default() };
    match Field::grow(&plane(2.0), &desc) {
        Err(Error::Mesh(cause)) => assert!(cause.contains("obstacles"), "{cause}"),
        other => panic!("{:?}", other.map(|field| field.blades().len())),
    }
}
