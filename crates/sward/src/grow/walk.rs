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
