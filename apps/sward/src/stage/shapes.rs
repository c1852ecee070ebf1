//! Meshes of balls, boxes and capsules, with normals.

use glam::{Vec2, Vec3};
use std::f32::consts::{PI, TAU};
use sward::Mesh;
use sward_scene::BodyShape;

/// Rings of a ball that is looked at by itself.
pub(super) const FINE: u32 = 32;
/// Rings of one of many.
pub(super) const COARSE: u32 = 13;

/// A unit ball of latitudes and longitudes.
pub(super) fn ball(rings: u32) -> Mesh {
    capsule(rings, 1.0, 0.0)
}

/// A body's shape, of a scale of 1.
pub(super) fn body(shape: BodyShape, rings: u32) -> Mesh {
    match shape {
        BodyShape::Sphere(radius) => capsule(rings, radius, 0.0),
        BodyShape::Box(half) => cuboid(half),
        // No ring lies where the halves meet, so that each vertex belongs to one of them
        BodyShape::Capsule { radius, half } => capsule(rings | 1, radius, half),
    }
}

/// A ball whose upper and lower half are `half` away from the middle.
fn capsule(rings: u32, radius: f32, half: f32) -> Mesh {
    let sectors = 2 * rings;
    let mut mesh = Mesh::default();
    for ring in 0..=rings {
        let (sin_t, cos_t) = (PI * ring as f32 / rings as f32).sin_cos();
        for sector in 0..=sectors {
            let (sin_p, cos_p) = (TAU * sector as f32 / sectors as f32).sin_cos();
            let normal = Vec3::new(sin_t * cos_p, cos_t, -sin_t * sin_p);
            mesh.positions.push(normal * radius + Vec3::Y * half * cos_t.signum());
            mesh.normals.push(normal);
            mesh.uvs.push(Vec2::new(sector as f32 / sectors as f32, ring as f32 / rings as f32));
        }
    }
    for ring in 0..rings {
        for sector in 0..sectors {
            let a = ring * (sectors + 1) + sector;
            let b = a + sectors + 1;
            mesh.triangles.extend([[a, b, b + 1], [a, b + 1, a + 1]]);
        }
    }
    mesh
}

fn cuboid(half: Vec3) -> Mesh {
    let mut mesh = Mesh::default();
    for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
        for normal in [axis, -axis] {
            // u x v is the normal, also where that is negative
            let (u, v) =
                (Vec3::new(axis.z, axis.x, axis.y), Vec3::new(normal.y, normal.z, normal.x));
            let first = mesh.positions.len() as u32;
            for (s, t) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                mesh.positions.push((normal + u * s + v * t) * half);
                mesh.normals.push(normal);
                mesh.uvs.push(Vec2::new(s, t) * 0.5 + 0.5);
            }
            mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        }
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;

    fn volume(mesh: &Mesh) -> f32 {
        let corners = mesh.triangles.iter().map(|t| t.map(|i| mesh.positions[i as usize]));
        corners.map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum()
    }

    /// Closed, and facing outward: else the volume would be another, or negative.
    #[test]
    fn shapes_have_their_volumes() {
        let full = 4.0 / 3.0 * PI;
        assert!((volume(&ball(FINE)) / full - 1.0).abs() < 0.01);
        let half = Vec3::new(0.5, 1.0, 2.0);
        assert!((volume(&body(BodyShape::Box(half), FINE)) / 8.0 - 1.0).abs() < 1e-5);
        let rod = body(BodyShape::Capsule { radius: 0.5, half: 2.0 }, FINE);
        let expected = full / 8.0 + PI * 0.25 * 4.0;
        assert!((volume(&rod) / expected - 1.0).abs() < 0.01, "{}", volume(&rod));
        assert!(rod.positions.iter().all(|p| p.y.abs() <= 2.5 + 1e-5));
    }

    #[test]
    fn normals_are_of_the_faces() {
        for mesh in [ball(COARSE), body(BodyShape::Box(Vec3::ONE), COARSE)] {
            for triangle in &mesh.triangles {
                let [a, b, c] = triangle.map(|i| mesh.positions[i as usize]);
                let face = (b - a).cross(c - a);
                let normal = mesh.normals[triangle[0] as usize];
                assert!(face.length() < 1e-6 || face.normalize().dot(normal) > 0.8);
            }
        }
    }
}
