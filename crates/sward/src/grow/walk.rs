//! Walking on a surface: straight on through the triangles, unfolding each edge.

use super::surface::{Spot, Surface, face_normal};
use super::weld::{Adjacency, NONE};
use glam::{DVec3, Vec2};

/// Triangles that one walk may cross; a longer walk ends early, on the surface.
const MOST_STEPS: usize = 512;

/// Where a walk ended.
#[derive(Debug, Clone, Copy)]
pub(crate) struct End {
    pub(crate) spot: Spot,
    /// The way it was going, unit, in the plane of the triangle.
    pub(crate) direction: DVec3,
    /// How far it came, metres: less than asked for where the surface ends.
    pub(crate) walked_m: f64,
}

/// A triangle's plane, for one step.
struct Face {
    corners: [DVec3; 3],
    normal: DVec3,
    /// Twice the area.
    area2: f64,
}

impl Face {
    fn new(surface: &Surface, triangle: u32) -> Self {
        let [a, b, c] = surface.corners(triangle);
        let corners = [a, b, c].map(|p| p.as_dvec3());
        let area2 = (corners[1] - corners[0]).cross(corners[2] - corners[0]).length();
        Self { corners, normal: face_normal(a, b, c), area2 }
    }

    /// Inward distance from an edge as a share of the triangle's height over it: the barycentric
    /// weight of the corner opposite, for a point given from the edge's start.
    fn weight(&self, side: usize, from_start: DVec3) -> f64 {
        let edge = self.corners[(side + 1) % 3] - self.corners[side];
        edge.cross(from_start).dot(self.normal) / self.area2
    }

    fn spot(&self, surface: &Surface, triangle: u32, point: DVec3) -> Spot {
        // The weights of the second and third corner, kept inside against rounding.
        let b = self.weight(2, point - self.corners[2]).clamp(0.0, 1.0);
        let c = self.weight(0, point - self.corners[0]).clamp(0.0, 1.0);
        let over = (b + c).max(1.0);
        surface.spot(triangle, Vec2::new((b / over) as f32, (c / over) as f32))
    }
}

/// A unit direction in the plane of a spot's triangle, `angle` radians about its normal.
pub(crate) fn direction(surface: &Surface, spot: &Spot, angle: f32) -> DVec3 {
    let [a, b, c] = surface.corners(spot.triangle);
    let along = (b - a).as_dvec3().normalize_or(DVec3::X);
    let across = face_normal(a, b, c).cross(along);
    let (sin, cos) = f64::from(angle).sin_cos();
    along * cos + across * sin
}

/// Walks `length_m` from a spot, straight on.
pub(crate) fn walk(
    surface: &Surface,
    adjacency: &Adjacency,
    from: &Spot,
    toward: DVec3,
    length_m: f64,
) -> End {
    let mut triangle = from.triangle;
    let mut point = from.position.as_dvec3();
    let mut direction = toward;
    let mut walked_m = 0.0;
    let mut entered = None;
    let mut face = Face::new(surface, triangle);
    for _ in 0..MOST_STEPS {
        let left = length_m - walked_m;
        let Some((side, step)) = exit(&face, point, direction, entered).filter(|e| e.1 < left)
        else {
            point += direction * left;
            walked_m = length_m;
            break;
        };
        point += direction * step;
        walked_m += step;
        let next = adjacency.across(triangle, side);
        if next == NONE {
            break;
        }
        let next_face = Face::new(surface, next);
        let edge = (face.corners[(side + 1) % 3] - face.corners[side]).normalize_or(DVec3::X);
        // Both point away from the triangle that is left, in either's plane.
        let (out, on) = (edge.cross(face.normal), edge.cross(next_face.normal));
        let unfolded = edge * direction.dot(edge) + on * direction.dot(out).max(0.0);
        direction = unfolded.normalize_or(on);
        entered = (0..3).find(|&s| adjacency.across(next, s) == triangle);
        (triangle, face) = (next, next_face);
    }
    End { spot: face.spot(surface, triangle, point), direction, walked_m }
}

/// The edge that a ray leaves by, and the way to it.
fn exit(
    face: &Face,
    point: DVec3,
    direction: DVec3,
    entered: Option<usize>,
) -> Option<(usize, f64)> {
    (0..3)
        .filter(|&side| Some(side) != entered)
        .filter_map(|side| {
            let rate = face.weight(side, direction);
            let weight = face.weight(side, point - face.corners[side]).max(0.0);
            (rate < 0.0).then(|| (side, weight / -rate))
        })
        .min_by(|a, b| a.1.total_cmp(&b.1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Mesh;
    use glam::UVec2;

    fn start(surface: &Surface) -> Spot {
        surface.spot(5, Vec2::new(0.3, 0.3))
    }

    #[test]
    fn a_walk_on_a_plane_is_straight() {
        let mesh = Mesh::plane(Vec2::splat(10.0), UVec2::splat(37)).unwrap();
        let surface = Surface::new(mesh).unwrap();
        let adjacency = Adjacency::new(&surface);
        let from = surface.spot(37 * 37, Vec2::new(0.2, 0.3));
        for i in 0..50 {
            let toward = direction(&surface, &from, i as f32 * 0.13);
            let end = walk(&surface, &adjacency, &from, toward, 3.0);
            let expected = from.position.as_dvec3() + toward * 3.0;
            assert!((end.walked_m - 3.0).abs() < 1e-9);
            assert!(end.spot.position.as_dvec3().distance(expected) < 1e-5, "{expected}");
        }
        let end = walk(&surface, &adjacency, &from, DVec3::X, 100.0);
        assert!((end.spot.position.x - 5.0).abs() < 1e-5, "stops at the rim");
        assert!((end.walked_m - f64::from(5.0 - from.position.x)).abs() < 1e-5);
    }

    #[test]
    fn a_walk_round_a_ball_comes_home() {
        let surface = Surface::new(Mesh::sphere(1.0, 64).unwrap()).unwrap();
        let adjacency = Adjacency::new(&surface);
        let from = start(&surface);
        // Half of a great circle ends at the far side.
        let toward = direction(&surface, &from, 0.7);
        let end = walk(&surface, &adjacency, &from, toward, std::f64::consts::PI);
        let far = end.spot.position.normalize().dot(from.position.normalize());
        assert!(far < -0.99, "{far}");
    }

    #[test]
    fn a_walk_never_changes_to_the_back_of_a_strip() {
        // Both sides of a Mobius strip are meshed: each edge has four triangles.
        let surface = Surface::new(Mesh::mobius(2.0, 1.0, UVec2::new(40, 4)).unwrap()).unwrap();
        let adjacency = Adjacency::new(&surface);
        let from = start(&surface);
        for i in 0..60 {
            let toward = direction(&surface, &from, i as f32 * 0.1);
            let end = walk(&surface, &adjacency, &from, toward, 0.4);
            assert!(from.normal.dot(end.spot.normal) > 0.8, "{:?}", end.spot);
        }
    }
}
