//! Heights of a mesh above points of the xz plane, to stand things on it.

use crate::assets::mesh::corners;
use glam::{Vec2, Vec3, Vec3Swizzles};
use sward::Mesh;

/// The triangles of a mesh, by the cell of the xz plane that they cover.
#[derive(Debug)]
pub(crate) struct Ground {
    mesh: Mesh,
    pub(crate) min: Vec3,
    pub(crate) max: Vec3,
    side: usize,
    cells: Vec<Vec<u32>>,
}

impl Ground {
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let fold = |f: fn(Vec3, Vec3) -> Vec3, from| mesh.positions.iter().copied().fold(from, f);
        let (min, max) = (fold(Vec3::min, Vec3::INFINITY), fold(Vec3::max, Vec3::NEG_INFINITY));
        let side = ((mesh.triangles.len() as f32).sqrt() as usize / 2).clamp(1, 512);
        let cells = vec![Vec::new(); side * side];
        let mut ground = Self { mesh: mesh.clone(), min, max, side, cells };
        for (i, &triangle) in mesh.triangles.iter().enumerate() {
            let [a, b, c] = corners(mesh, triangle);
            let (low, high) =
                (ground.cell(a.min(b).min(c).xz()), ground.cell(a.max(b).max(c).xz()));
            for z in low.1..=high.1 {
                for x in low.0..=high.0 {
                    if let Some(cell) = ground.cells.get_mut(z * side + x) {
                        cell.push(i as u32);
                    }
                }
            }
        }
        ground
    }

    fn cell(&self, point: Vec2) -> (usize, usize) {
        let extent = (self.max - self.min).xz().max(Vec2::splat(1e-6));
        let at = (point - self.min.xz()) / extent * self.side as f32;
        let clamp = |c: f32| (c.max(0.0) as usize).min(self.side - 1);
        (clamp(at.x), clamp(at.y))
    }

    /// The highest point of the mesh at (x, z); `None` beside it.
    pub(crate) fn height(&self, point: Vec2) -> Option<f32> {
        Some(self.highest(point)?.0)
    }

    /// Upward unit normal of the triangle at that point.
    pub(crate) fn normal(&self, point: Vec2) -> Option<Vec3> {
        let (_, [a, b, c]) = self.highest(point)?;
        let normal = (b - a).cross(c - a).normalize_or(Vec3::Y);
        Some(if normal.y < 0.0 { -normal } else { normal })
    }

    fn highest(&self, point: Vec2) -> Option<(f32, [Vec3; 3])> {
        let (x, z) = self.cell(point);
        let cell = self.cells.get(z * self.side + x)?;
        let triangles = cell.iter().filter_map(|&i| self.mesh.triangles.get(i as usize));
        let heights = triangles.filter_map(|&t| {
            let corners = corners(&self.mesh, t);
            Some((height_on(corners, point)?, corners))
        });
        heights.reduce(|a, b| if b.0 > a.0 { b } else { a })
    }
}

fn height_on([a, b, c]: [Vec3; 3], point: Vec2) -> Option<f32> {
    let (ab, ac, ap) = (b.xz() - a.xz(), c.xz() - a.xz(), point - a.xz());
    let area = ab.perp_dot(ac);
    if area.abs() < 1e-12 {
        return None;
    }
    let (u, v) = (ap.perp_dot(ac) / area, ab.perp_dot(ap) / area);
    // A little slack, so that no point falls between two triangles.
    let inside = u >= -1e-4 && v >= -1e-4 && u + v <= 1.0 + 1e-4;
    inside.then_some(a.y + u * (b.y - a.y) + v * (c.y - a.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slope_has_its_height_everywhere_and_none_beside_it() {
        let heights: Vec<f32> =
            (0..40 * 30).map(|i| (i % 40) as f32 / 39.0 * 8.0 + (i / 40) as f32 / 29.0).collect();
        let mesh = Mesh::heightmap(40, 30, &heights, Vec2::new(8.0, 6.0)).expect("a slope");
        let ground = Ground::new(&mesh);
        for (x, z) in [(0.0, 0.0), (3.99, -2.9), (-4.0, 3.0), (1.234, 0.77)] {
            let height = ground.height(Vec2::new(x, z)).expect("inside");
            assert!((height - (x + 4.0 + (z + 3.0) / 6.0)).abs() < 1e-4);
        }
        assert_eq!(ground.height(Vec2::new(4.1, 0.0)), None);
    }
}
