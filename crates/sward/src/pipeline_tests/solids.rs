//! Grass round a packed mesh: how much of it ends up inside the mesh itself.

use super::decoded::{decode, pose, states};
use super::rig::Rig;
use super::scenes::see_all;
use crate::{
    Collider, ColliderShape, Field, FieldDesc, Frame, Mesh, Obstacle, PackDesc, PhysicsModel, Pose,
    Range, Solid, Species, Sphere, Surface, Wind,
};
use glam::{UVec2, Vec2, Vec3};
use std::sync::Arc;

/// The bunny, 0.6 m high, feet a little in the ground.
fn bunny() -> Mesh {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/assets/bunny.obj");
    let mut mesh = Mesh::default();
    for line in std::fs::read_to_string(file).unwrap().lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        if let ["v", place @ ..] = words.as_slice() {
            let number = |i: usize| place[i].parse::<f32>().unwrap();
            mesh.positions.push(Vec3::new(number(0), number(1), number(2)));
        } else if let ["f", a, b, c] = words.as_slice() {
            let index = |word: &str| word.split('/').next().unwrap().parse::<u32>().unwrap();
            mesh.triangles.push([a, b, c].map(|word| index(word) - 1));
        }
    }
    let (low, high) = Solid::new(&mesh).unwrap().bounds();
    let (middle, scale) = ((low + high) * 0.5, 0.6 / (high.y - low.y));
    let foot = Vec3::new(middle.x, low.y, middle.z);
    mesh.positions.iter_mut().for_each(|p| *p = (*p - foot) * scale - Vec3::Y * 0.02);
    mesh
}

/// A boulder with lumps, a third of it in the ground.
fn rock() -> Mesh {
    let mut mesh = Mesh::sphere(0.4, 28).unwrap();
    for p in &mut mesh.positions {
        let waves = (p.x * 11.0 + 1.0).sin() * (p.z * 9.0).sin() + (p.y * 14.0).sin();
        *p = *p * (1.0 + 0.13 * waves) * Vec3::new(1.1, 0.8, 0.9) + Vec3::Y * 0.12;
    }
    mesh
}

/// Grass of 0.15 to 0.45 m on 1.8 m of lawn, no root inside.
fn grass(solid: &Arc<Solid>) -> Field {
    let surface = Surface::new(Mesh::plane(Vec2::splat(1.8), UVec2::ONE).unwrap()).unwrap();
    let species = Species {
        height_m: Range::new(0.15, 0.45),
        width_m: Range::new(0.01, 0.02),
        arch: 0.3,
        ..Species::default()
    };
    let obstacle = Obstacle::Solid { solid: solid.clone(), pose: Pose::default(), scale: 1.0 };
    let desc = FieldDesc {
        species: vec![species],
        obstacles: vec![obstacle],
        density: 1200.0,
        ..FieldDesc::default()
    };
    Field::grow(&surface, &desc).unwrap()
}

/// Of the blades whose roots are nearer to the solid than they are high.
#[derive(Debug)]
struct Inside {
    near: usize,
    /// Shares whose curves pass deeper than 1 cm into it, and deeper than 5 % of their height.
    centimetre: f64,
    twentieth: f64,
    /// Share deeper than 1 cm in one of its spheres: what the push leaves, the packing aside.
    spheres: f64,
}

fn inside(rig: &Rig, solid: &Solid, spheres: &[Sphere]) -> Inside {
    let blades = decode(&rig.field);
    let states = states(&blades, &rig.states(), PhysicsModel::Sward);
    let [mut near, mut centimetre, mut twentieth, mut balls] = [0_u32; 4];
    for (blade, state) in blades.iter().zip(&states) {
        let height = blade.blade.height;
        if solid.distance(blade.blade.root) > height {
            continue;
        }
        let curve = pose(&blade.physics, state);
        let points: Vec<Vec3> = (0..=24)
            .map(|i| {
                let t = i as f32 / 24.0;
                let (a, b) = (curve.root.lerp(curve.knee, t), curve.knee.lerp(curve.tip, t));
                a.lerp(b, t)
            })
            .collect();
        let depth = points.iter().map(|&p| -solid.distance(p)).fold(0.0, f32::max);
        let deep = |s: &Sphere| points.iter().any(|p| p.distance(s.center) < s.radius - 0.01);
        near += 1;
        centimetre += u32::from(depth > 0.01);
        twentieth += u32::from(depth > 0.05 * height);
        balls += u32::from(spheres.iter().any(deep));
    }
    let share = |count: u32| f64::from(count) / f64::from(near);
    Inside {
        near: near as usize,
        centimetre: share(centimetre),
        twentieth: share(twentieth),
        spheres: share(balls),
    }
}

/// Blades inside without and with the colliders, after two seconds; `most`: shares of those near
/// that may be deeper than 1 cm, and than 5 % of their height.
fn check(name: &str, mesh: &Mesh, desc: &PackDesc, most: [f64; 2]) {
    let solid = Arc::new(Solid::new(mesh).unwrap());
    let packing = solid.pack(desc).unwrap();
    let colliders = [Collider {
        shape: ColliderShape::Spheres(&packing.spheres),
        pose: Pose::default(),
        last_pose: None,
    }];
    let wind = Wind::new(Vec::new()).unwrap();
    let mut rig = Rig::new(grass(&solid));
    let mut settle = |colliders: &[Collider]| {
        let field = rig.field.clone();
        rig.replace(field);
        for _ in 0..60 {
            rig.step(&Frame { colliders, ..Frame::new(1.0 / 30.0, &wind) }, &[see_all()]);
        }
        inside(&rig, &solid, &packing.spheres)
    };
    let (free, pushed) = (settle(&[]), settle(&colliders));
    println!("{name}, {:.3} covered: {free:?} free, {pushed:?} pushed", packing.coverage);
    assert!(free.near > 300 && free.near == pushed.near, "{}", free.near);
    let shares = [pushed.centimetre, pushed.twentieth];
    assert!(pushed.spheres <= 0.012, "{name}: {} in spheres", pushed.spheres);
    assert!(shares[0] <= most[0] && shares[1] <= most[1], "{name}: {shares:?}");
    assert!(free.centimetre > most[0] && free.twentieth > most[1], "{name}: {free:?}");
}

/// What is left in the rock stands in corners that so few spheres leave bare.
#[test]
fn few_blades_reach_into_a_rock() {
    check("rock", &rock(), &PackDesc { spheres: 80, bulge: 0.006 }, [0.03, 0.01]);
}

#[test]
fn few_blades_reach_into_the_bunny() {
    check("bunny", &bunny(), &PackDesc::default(), [0.012, 0.008]);
}
