//! Height of the ground that grass grows on, under a point.

use glam::{Quat, Vec2, Vec3, Vec3Swizzles};
use sward_scene::Scene;

/// The triangles of all fields' surfaces, turned so that a given direction is up.
#[derive(Debug)]
pub(super) struct Ground {
    triangles: Vec<[Vec3; 3]>,
}

impl Ground {
    pub fn new(scene: &Scene, turn: Quat) -> Self {
        let mut triangles = Vec::new();
        for field in &scene.fields {
            let mesh = field.surface.mesh();
            let corner = |i: u32| mesh.positions.get(i as usize).map(|p| turn * *p);
            for [a, b, c] in mesh.triangles.iter().map(|t| t.map(corner)) {
                if let (Some(a), Some(b), Some(c)) = (a, b, c) {
                    triangles.push([a, b, c]);
                }
            }
        }
        Self { triangles }
    }

    /// The highest ground at a place; `None` beside it.
    pub fn height(&self, at: Vec3) -> Option<f32> {
        let heights = self.triangles.iter().filter_map(|corners| height(*corners, at.xz()));
        heights.reduce(f32::max)
    }

    /// Largest distance of any of it from a point, metres.
    pub fn farthest(&self, from: Vec3) -> f32 {
        let corners = self.triangles.iter().flatten();
        corners.fold(0.0, |far, corner| far.max(corner.distance(from)))
    }
}

fn height([a, b, c]: [Vec3; 3], at: Vec2) -> Option<f32> {
    let (ab, ac, ap) = (b.xz() - a.xz(), c.xz() - a.xz(), at - a.xz());
    let area = ab.perp_dot(ac);
    let (u, v) = (ap.perp_dot(ac) / area, ab.perp_dot(ap) / area);
    // A little slack, so that no point falls between two triangles; none is in one without an area
    let inside = u >= -1e-4 && v >= -1e-4 && u + v <= 1.0 + 1e-4;
    inside.then_some(a.y + u * (b.y - a.y) + v * (c.y - a.y))
}
