//! Ribbons along quadratic curves, with the outlines and the fold of blades (J section 5).

use super::{Corner, Triangle};
use crate::Shape;
use crate::frame::draw::lobes_twin::leaf_width;
use crate::gpu::quantize::outline;
use glam::Vec3;

/// How strongly a blade's normal turns across its width, times its ridge: as blade_point.wgsl.
const ROUNDING: f32 = 1.4;

/// A ribbon: a blade, or a part of a modelled plant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ribbon {
    /// v0, v1, v2: root, middle and tip of the curve, metres.
    pub curve: [Vec3; 3],
    /// Unit direction of the width; need not be perpendicular to the curve.
    pub side: Vec3,
    /// Full width, metres.
    pub width: f32,
    /// Outline.
    pub shape: Shape,
    /// Fold, 0 flat to 1 (J equation 23).
    pub ridge: f32,
    /// Pieces along the curve, 1 or more; a dandelion's lobes need about 40.
    pub segments: u32,
    /// Height share in the whole plant at root and tip: `[0, 1]` for a blade.
    pub height_share: [f32; 2],
    /// Relative to a blade of grass, 1.
    pub thickness: f32,
}

impl Ribbon {
    /// Adds its triangles; `albedo` is the linear colour at a share of the curve parameter.
    pub(crate) fn triangles(&self, albedo: impl Fn(f32) -> Vec3, out: &mut Vec<Triangle>) {
        let segments = self.segments.max(1);
        let columns = if self.ridge > 0.0 { [0.0, 0.5, 1.0].as_slice() } else { &[0.0, 1.0] };
        let ring = |k: u32| {
            let v = k as f32 / segments as f32;
            let color = albedo(v);
            columns.iter().map(|u| self.corner(v, *u, color)).collect::<Vec<_>>()
        };
        let mut low = ring(0);
        for k in 1..=segments {
            let high = ring(k);
            for side in 0..columns.len() - 1 {
                let (a, b, c, d) = (low[side], low[side + 1], high[side], high[side + 1]);
                out.extend([[a, b, c], [b, d, c]].into_iter().filter(has_area));
            }
            low = high;
        }
    }

    /// Makes it so many times as long, from its root, and as wide.
    pub(crate) fn scale(&mut self, longer: f32, wider: f32) {
        let root = self.curve[0];
        self.curve = self.curve.map(|p| root + (p - root) * longer);
        self.width *= wider;
    }

    /// Share of the width left at `v`.
    fn share(&self, v: f32) -> f32 {
        match self.shape {
            // A blade at rest runs so along its curve parameter
            Shape::Dandelion => leaf_width(f64::from(v * (2.0 - v))) as f32,
            shape => outline(shape, v),
        }
    }

    /// Equations 21 to 23.
    fn corner(&self, v: f32, u: f32, albedo: Vec3) -> Corner {
        let [root, middle, tip] = self.curve;
        let (a, b) = (root.lerp(middle, v), middle.lerp(tip, v));
        let along = (b - a).normalize_or((tip - root).normalize_or(Vec3::Y));
        let side = self.side.reject_from(along).normalize_or(self.side);
        let normal = side.cross(along).normalize_or(Vec3::Z);
        let share = self.share(v);
        let across = match self.shape {
            Shape::Quadratic => u * share,
            _ => 0.5 + (u - 0.5) * share,
        };
        let lift = self.ridge * share * (0.5 - (u - 0.5).abs());
        let [low, high] = self.height_share;
        Corner {
            position: a.lerp(b, v) + (side * (across - 0.5) + normal * lift) * self.width,
            normal,
            round: side * ((u - 0.5) * ROUNDING * self.ridge),
            albedo,
            height_share: low + (high - low) * v * (2.0 - v),
            thickness: self.thickness,
        }
    }
}

fn has_area(triangle: &Triangle) -> bool {
    let [a, b, c] = triangle.map(|corner| corner.position);
    (b - a).cross(c - a).length_squared() > 0.0
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// An upright blade of so many segments that its area is its outline's.
    pub(crate) fn upright(shape: Shape, ridge: f32) -> Ribbon {
        Ribbon {
            curve: [Vec3::ZERO, Vec3::Y * 0.5, Vec3::Y],
            side: Vec3::X,
            width: 0.2,
            shape,
            ridge,
            segments: 64,
            height_share: [0.0, 1.0],
            thickness: 1.0,
        }
    }

    fn area(triangles: &[Triangle]) -> f32 {
        let corners = triangles.iter().map(|t| t.map(|corner| corner.position));
        corners.map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum()
    }

    fn made(ribbon: &Ribbon) -> Vec<Triangle> {
        let mut list = Vec::new();
        ribbon.triangles(Vec3::splat, &mut list);
        list
    }

    /// This curve's parameter runs evenly, so the area is the outline's integral over v.
    #[test]
    fn area_is_the_outlines() {
        let shapes = [
            (Shape::Quad, 1.0),
            (Shape::Triangle, 0.5),
            (Shape::Quadratic, 2.0 / 3.0),
            (Shape::TriangleTip { tip: 0.5 }, 0.75),
        ];
        for (shape, share) in shapes {
            let flat = area(&made(&upright(shape, 0.0))) / 0.2;
            assert!((flat - share).abs() < 1e-3, "{shape:?}: {flat}");
        }
        // A fold to a right angle makes each half longer by the square root of 2
        let folded = area(&made(&upright(Shape::Quad, 1.0))) / 0.2;
        assert!((folded - 2.0_f32.sqrt()).abs() < 1e-3, "{folded}");
    }

    #[test]
    fn a_bent_ribbon_keeps_its_width_and_faces_across() {
        let bent = Ribbon {
            curve: [Vec3::ZERO, Vec3::Y, Vec3::new(0.0, 1.0, 1.0)],
            ..upright(Shape::Quad, 0.0)
        };
        for triangle in made(&bent) {
            for corner in triangle {
                assert!((corner.position.x.abs() - 0.1).abs() < 1e-6);
                assert!(corner.normal.is_normalized() && corner.normal.x.abs() < 1e-6);
                assert!((0.0..=1.0).contains(&corner.height_share));
            }
        }
        let first = made(&bent)[0][0].normal;
        assert!(first.z.abs() > 0.99, "at the root it faces along z: {first}");
    }

    /// A ribbon without a length gives nothing that is not a number.
    #[test]
    fn degenerate_ribbons_are_finite() {
        let point =
            Ribbon { curve: [Vec3::ONE; 3], side: Vec3::Y, ..upright(Shape::Triangle, 0.5) };
        let corners = made(&point).into_iter().flatten();
        assert!(corners.into_iter().all(|c| c.position.is_finite() && c.normal.is_finite()));
    }
}
