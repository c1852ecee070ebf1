//! Meshes to test with, and counting of what spheres cover.

use glam::{Mat3, UVec2, Vec3};
use sward::shared::noise_twin::hash01;
use sward::{Mesh, Packing, Solid};

/// A closed box of half a side a half extent, about a centre.
pub fn cuboid(half: Vec3, center: Vec3) -> Mesh {
    let corner = |i: u32| {
        let side = |bit: u32| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
        center + half * Vec3::new(side(0), side(1), side(2))
    };
    let quads =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    Mesh {
        positions: (0..8).map(corner).collect(),
        triangles: quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect(),
        ..Mesh::default()
    }
}

pub fn torus() -> Mesh {
    Mesh::torus(2.0, 0.7, UVec2::new(64, 32)).unwrap()
}

pub fn sphere(radius: f32) -> Mesh {
    Mesh::sphere(radius, 24).unwrap()
}

/// The Stanford bunny that the scenes use.
pub fn bunny() -> Mesh {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/assets/bunny.obj");
    let mut mesh = Mesh::default();
    for line in std::fs::read_to_string(file).unwrap().lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.as_slice() {
            ["v", x, y, z] => {
                let number = |word: &str| word.parse::<f32>().unwrap();
                mesh.positions.push(Vec3::new(number(x), number(y), number(z)));
            }
            ["f", a, b, c] => {
                let index = |word: &str| word.split('/').next().unwrap().parse::<u32>().unwrap();
                mesh.triangles.push([a, b, c].map(|word| index(word) - 1));
            }
            _ => {}
        }
    }
    mesh
}

pub fn moved(mesh: &Mesh, change: impl Fn(Vec3) -> Vec3) -> Mesh {
    let positions = mesh.positions.iter().map(|&p| change(p)).collect();
    Mesh { positions, normals: Vec::new(), ..mesh.clone() }
}

pub fn turned(mesh: &Mesh) -> Mesh {
    let turn = Mat3::from_euler(glam::EulerRot::XYZ, 0.7, -0.4, 1.1);
    moved(mesh, |p| turn * p)
}

pub fn joined(a: &Mesh, b: &Mesh) -> Mesh {
    let first = a.positions.len() as u32;
    let shifted = b.triangles.iter().map(|t| t.map(|v| v + first));
    Mesh {
        positions: [a.positions.clone(), b.positions.clone()].concat(),
        triangles: a.triangles.iter().copied().chain(shifted).collect(),
        ..Mesh::default()
    }
}

/// A point of a box by chance.
pub fn chance((low, high): (Vec3, Vec3), i: u32) -> Vec3 {
    low + (high - low) * Vec3::new(hash01(i, 11), hash01(i, 12), hash01(i, 13))
}

/// Share of the solid's volume that the spheres cover, by points at random: independent of the
/// packer's grid.
pub fn coverage(solid: &Solid, packing: &Packing, points: u32) -> f32 {
    let tried = (0..points * 100).map(|i| chance(solid.bounds(), i));
    let inside = tried.filter(|&point| solid.contains(point)).take(points as usize);
    let within = |point: Vec3| {
        packing.spheres.iter().any(|s| s.center.distance_squared(point) <= s.radius * s.radius)
    };
    let covered = inside.map(|point| u32::from(within(point))).collect::<Vec<_>>();
    assert!(covered.len() > 500, "{} points are inside", covered.len());
    covered.iter().sum::<u32>() as f32 / covered.len() as f32
}

/// Farthest that any sphere reaches over the surface, as a share of the diagonal. Exact for a
/// centre inside: the nearest point of the surface lies on the way to the sphere's farthest point.
pub fn worst_bulge(solid: &Solid, packing: &Packing) -> f32 {
    let (low, high) = solid.bounds();
    let over = packing.spheres.iter().map(|s| s.radius + solid.distance(s.center));
    over.fold(0.0, f32::max) / low.distance(high)
}
