//! The fields' ground, seen from above.

use super::Frame;
use glam::{IVec2, Vec2, Vec3};
use sward_scene::Scene;

/// Highest ground under each pixel.
pub(super) struct Ground {
    size: IVec2,
    heights: Vec<f32>,
    /// Where there is no ground.
    beyond: f32,
}

impl Ground {
    /// The ground of all fields.
    pub(super) fn below(scene: &Scene, frame: &Frame) -> Self {
        let count = (frame.size.x * frame.size.y) as usize;
        let mut ground =
            Self { size: frame.size, heights: vec![f32::NEG_INFINITY; count], beyond: 0.0 };
        for field in &scene.fields {
            let mesh = field.surface.mesh();
            for triangle in &mesh.triangles {
                let corners = triangle.map(|i| mesh.positions.get(i as usize).copied());
                let [Some(a), Some(b), Some(c)] = corners else { continue };
                ground.raise([a, b, c], frame);
            }
        }
        let known = ground.heights.iter().filter(|height| height.is_finite());
        let (sum, count) =
            known.fold((0.0, 0_u32), |(sum, count), &height| (sum + f64::from(height), count + 1));
        ground.beyond = (sum / f64::from(count.max(1))) as f32;
        ground
    }

    /// Lays a triangle over what is there.
    fn raise(&mut self, corners: [Vec3; 3], frame: &Frame) {
        let [a, b, c] = corners.map(|at| frame.pixel(Vec2::new(at.x, at.z)));
        let area = (b - a).perp_dot(c - a);
        if area.abs() < 1e-9 {
            return;
        }
        let min = a.min(b).min(c).floor().as_ivec2().max(IVec2::ZERO);
        let max = a.max(b).max(c).ceil().as_ivec2().min(self.size);
        for y in min.y..max.y {
            for x in min.x..max.x {
                let at = Vec2::new(x as f32, y as f32) + 0.5;
                let u = (b - a).perp_dot(at - a) / area;
                let v = (at - a).perp_dot(c - a) / area;
                // A little over the edge, so that no pixel between two triangles is left out
                if u < -1e-3 || v < -1e-3 || u + v > 1.001 {
                    continue;
                }
                let [ya, yb, yc] = corners.map(|corner| corner.y);
                let height = ya + (yc - ya) * u + (yb - ya) * v;
                if let Some(highest) = self.heights.get_mut((y * self.size.x + x) as usize) {
                    *highest = highest.max(height);
                }
            }
        }
    }

    fn at(&self, pixel: Vec2) -> f32 {
        let at = pixel.as_ivec2().clamp(IVec2::ZERO, self.size - 1);
        let index = (at.y * self.size.x + at.x) as usize;
        self.heights.get(index).copied().unwrap_or(f32::NEG_INFINITY)
    }

    /// Whether a field lies there.
    pub(super) fn is_field(&self, pixel: Vec2) -> bool {
        self.at(pixel).is_finite()
    }

    /// Height there, metres; beyond the fields their mean.
    pub(super) fn height(&self, pixel: Vec2) -> f32 {
        let height = self.at(pixel);
        if height.is_finite() { height } else { self.beyond }
    }
}
