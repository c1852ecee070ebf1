//! Work on meshes: checks, transforms, joining.

use glam::{Affine3A, Mat3A, Vec2, Vec3, Vec3A};
use sward::Mesh;

use crate::check::MAX_M;

/// Checks the meshes of one file; the message names the vertex or triangle.
pub(crate) fn check<'a>(meshes: impl Iterator<Item = &'a Mesh>) -> Result<(), String> {
    let (mut triangles, mut area) = (0, 0.0);
    for mesh in meshes {
        check_numbers(mesh)?;
        triangles += mesh.triangles.len();
        area += mesh.triangles.iter().map(|&t| f64::from(triangle_area(mesh, t))).sum::<f64>();
    }
    if triangles == 0 {
        return Err("the mesh is empty: it has no triangles; export it with its faces".into());
    }
    if area <= 0.0 {
        return Err("the mesh has no area: all of its triangles are degenerate".into());
    }
    Ok(())
}

pub(crate) fn check_numbers(mesh: &Mesh) -> Result<(), String> {
    for (i, p) in mesh.positions.iter().enumerate() {
        if !p.is_finite() {
            return Err(format!("vertex {i}: position {p} is not a finite number"));
        }
        if p.abs().max_element() > MAX_M {
            return Err(format!(
                "vertex {i}: position {p} is farther than {MAX_M} m; scale it down"
            ));
        }
    }
    let count = mesh.positions.len();
    for (i, triangle) in mesh.triangles.iter().enumerate() {
        if let Some(index) = triangle.iter().find(|&&index| index as usize >= count) {
            return Err(format!("triangle {i}: index {index} is out of range: {count} vertices"));
        }
    }
    Ok(())
}

fn corner(mesh: &Mesh, index: u32) -> Vec3 {
    mesh.positions.get(index as usize).copied().unwrap_or(Vec3::ZERO)
}

pub(crate) fn corners(mesh: &Mesh, triangle: [u32; 3]) -> [Vec3; 3] {
    triangle.map(|index| corner(mesh, index))
}

fn triangle_area(mesh: &Mesh, triangle: [u32; 3]) -> f32 {
    let [a, b, c] = corners(mesh, triangle);
    0.5 * (b - a).cross(c - a).length()
}

/// Moves a mesh. A mirroring transform also turns the triangles, so that they stay facing outwards.
pub(crate) fn transform(mesh: &mut Mesh, world_from_mesh: Affine3A) {
    for p in &mut mesh.positions {
        *p = world_from_mesh.transform_point3(*p);
    }
    let m = world_from_mesh.matrix3;
    // The cofactor matrix is the inverse transpose times the determinant: it also serves where a
    // scale is 0.
    let cofactor = Mat3A::from_cols(
        m.y_axis.cross(m.z_axis),
        m.z_axis.cross(m.x_axis),
        m.x_axis.cross(m.y_axis),
    );
    let mirrors = m.determinant() < 0.0;
    let side = if mirrors { -1.0 } else { 1.0 };
    for n in &mut mesh.normals {
        *n = Vec3::from(cofactor * Vec3A::from(*n) * side).normalize_or_zero();
    }
    if mirrors {
        for triangle in &mut mesh.triangles {
            triangle.swap(1, 2);
        }
    }
    drop_broken_normals(mesh);
}

/// A normal that is zero or not finite cannot be mended alone; without any, they are computed.
pub(crate) fn drop_broken_normals(mesh: &mut Mesh) {
    let good = |n: &Vec3| n.is_finite() && n.length_squared() > 1e-12;
    if mesh.normals.len() != mesh.positions.len() || !mesh.normals.iter().all(good) {
        mesh.normals.clear();
    }
}

/// Appends `other`. An attribute that only one of them has is filled in with a neutral value, but
/// normals are dropped, to be computed for all.
pub(crate) fn append(mesh: &mut Mesh, other: &Mesh) {
    let first = mesh.positions.len();
    if first == 0 {
        mesh.clone_from(other);
        return;
    }
    mesh.positions.extend_from_slice(&other.positions);
    let total = mesh.positions.len();
    if mesh.normals.is_empty() || other.normals.is_empty() {
        mesh.normals.clear();
    } else {
        mesh.normals.extend_from_slice(&other.normals);
    }
    join(&mut mesh.uvs, &other.uvs, first, total, Vec2::ZERO);
    join(&mut mesh.colors, &other.colors, first, total, [1.0; 4]);
    // Files are limited to 1 GiB and copies to 10,000, far below 2^32 vertices in memory.
    let offset = |index: &u32| index.saturating_add(first as u32);
    mesh.triangles.extend(other.triangles.iter().map(|t| t.each_ref().map(offset)));
}

fn join<T: Copy>(all: &mut Vec<T>, more: &[T], first: usize, total: usize, neutral: T) {
    if all.is_empty() && more.is_empty() {
        return;
    }
    all.resize(first, neutral);
    all.extend_from_slice(more);
    all.resize(total, neutral);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> Mesh {
        Mesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
            normals: vec![Vec3::Z; 3],
            triangles: vec![[0, 1, 2]],
            ..Mesh::default()
        }
    }

    fn face_normal(mesh: &Mesh) -> Vec3 {
        let [a, b, c] = corners(mesh, mesh.triangles[0]);
        (b - a).cross(c - a).normalize()
    }

    #[test]
    fn mirroring_keeps_faces_and_normals_together() {
        for scale in [Vec3::new(-1.0, 1.0, 1.0), Vec3::new(2.0, 1.0, -3.0), Vec3::splat(-1.0)] {
            let mut mesh = triangle();
            transform(&mut mesh, Affine3A::from_scale(scale));
            assert!(face_normal(&mesh).dot(mesh.normals[0]) > 0.999, "{scale}");
        }
    }

    #[test]
    fn joining_fills_in_what_one_lacks() {
        let mut mesh = triangle();
        let other = Mesh { normals: vec![], uvs: vec![Vec2::ONE; 3], ..triangle() };
        append(&mut mesh, &other);
        assert_eq!(mesh.triangles, [[0, 1, 2], [3, 4, 5]]);
        assert!(mesh.normals.is_empty());
        assert_eq!(mesh.uvs.len(), 6);
        assert_eq!((mesh.uvs[0], mesh.uvs[5]), (Vec2::ZERO, Vec2::ONE));
    }

    #[test]
    fn broken_meshes_are_named() {
        let mut mesh = triangle();
        mesh.triangles[0] = [0, 1, 3];
        assert!(check([&mesh].into_iter()).is_err_and(|e| e.contains("index 3")));
        mesh.triangles[0] = [0, 1, 1];
        assert!(check([&mesh].into_iter()).is_err_and(|e| e.contains("no area")));
        mesh.positions[1].y = f32::NAN;
        assert!(check([&mesh].into_iter()).is_err_and(|e| e.contains("vertex 1")));
        assert!(check(std::iter::empty()).is_err_and(|e| e.contains("empty")));
    }
}
