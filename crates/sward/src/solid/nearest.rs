//! Distance from a point to a triangle.

use glam::Vec3;

/// Squared distance to a triangle that has an area. The face counts where the point lies over it,
/// else the nearest edge: slivers, over which f32 never lies surely, still have their edges.
pub(super) fn distance_squared([a, b, c]: &[Vec3; 3], point: Vec3) -> f32 {
    let (ab, bc, ca) = (*b - *a, *c - *b, *a - *c);
    let (pa, pb, pc) = (point - *a, point - *b, point - *c);
    let normal = ca.cross(ab);
    let over = [(ab, pa), (bc, pb), (ca, pc)];
    if over.iter().all(|(edge, from)| normal.cross(*edge).dot(*from) >= 0.0) {
        let along = normal.dot(pa);
        return along * along / normal.length_squared();
    }
    let edges = [edge(ab, pa), edge(bc, pb), edge(ca, pc)];
    edges[0].min(edges[1]).min(edges[2])
}

/// Squared distance from `from`, seen from an edge's start, to the edge.
fn edge(edge: Vec3, from: Vec3) -> f32 {
    let along = from.dot(edge) / edge.length_squared().max(f32::MIN_POSITIVE);
    (from - edge * along.clamp(0.0, 1.0)).length_squared()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_edges_and_corners_are_near() {
        let triangle = [Vec3::ZERO, Vec3::X * 4.0, Vec3::Y * 4.0];
        let turned = [triangle[0], triangle[2], triangle[1]];
        for (x, y, z, distance) in [
            (1.0, 1.0, 3.0, 3.0),
            (1.0, 1.0, -3.0, 3.0),
            (2.0, -3.0, 4.0, 5.0),
            (-3.0, -4.0, 0.0, 5.0),
            (4.0, 4.0, 0.0, 8.0_f32.sqrt()),
            (7.0, 0.0, 4.0, 5.0),
        ] {
            for corners in [&triangle, &turned] {
                let found = distance_squared(corners, Vec3::new(x, y, z)).sqrt();
                assert!((found - distance).abs() < 1e-6, "({x}, {y}, {z}): {found}");
            }
        }
    }
}
