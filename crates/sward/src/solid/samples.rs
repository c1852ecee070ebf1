//! A solid sampled on a regular grid: which points lie inside, and how far the outside is.

use super::{Solid, distances};
use glam::{UVec3, Vec3};
use rayon::prelude::*;

/// Points of the whole grid, at most: what a thin shell may cost.
const MOST: f64 = 4e6;
/// Points of the coarse grid that measures how much of the box is inside.
const COARSE: f32 = 4e3;
/// Times that an empty grid is made finer.
const RETRIES: u32 = 3;

/// A grid of points over a solid's box, a layer of outside all round.
#[derive(Debug)]
pub(super) struct Samples {
    pub(super) size: UVec3,
    /// The first point, in units of the solid.
    origin: Vec3,
    /// Distance between points, units.
    pub(super) step: f32,
    /// Row-major, x first: for points inside the distance to the outside in steps, else 0.
    pub(super) depths: Vec<f32>,
}

impl Samples {
    /// A grid with about `wanted` points inside, where its size allows. `None` where no point is.
    pub(super) fn inside(solid: &Solid, wanted: u32) -> Option<Self> {
        let (low, high) = solid.bvh.bounds();
        // A box that is flat in one axis still gets a layer of points.
        let volume = (high - low).max(Vec3::splat(1e-6)).element_product();
        let finest = finest(high - low);
        let coarse = Self::measure(solid, (volume / COARSE).cbrt().max(finest));
        // As many points share the volume inside as are wanted, where the whole is not too many.
        let mut step =
            (coarse.step * (coarse.count().max(1) as f32 / wanted as f32).cbrt()).max(finest);
        for _ in 0..RETRIES {
            let samples = Self::measure(solid, step);
            if samples.count() > 0 {
                return Some(samples);
            }
            step = (step * 0.5).max(finest);
        }
        None
    }

    /// Points inside.
    pub(super) fn count(&self) -> usize {
        self.depths.iter().filter(|&&depth| depth > 0.0).count()
    }

    /// A point, in units of the solid.
    pub(super) fn at(&self, cell: UVec3) -> Vec3 {
        self.origin + cell.as_vec3() * self.step
    }

    pub(super) fn cell(&self, index: usize) -> UVec3 {
        let (x, y) = (self.size.x as usize, self.size.y as usize);
        UVec3::new((index % x) as u32, (index / x % y) as u32, (index / x / y) as u32)
    }

    pub(super) fn index(&self, cell: UVec3) -> usize {
        ((cell.z * self.size.y + cell.y) as usize) * self.size.x as usize + cell.x as usize
    }

    fn measure(solid: &Solid, step: f32) -> Self {
        let (low, high) = solid.bvh.bounds();
        let size = size(high - low, step).as_uvec3();
        let origin = (low + high) * 0.5 - (size.as_vec3() - 1.0) * (0.5 * step);
        let depths = vec![0.0; size.element_product() as usize];
        let mut samples = Self { size, origin, step, depths };
        let mut depths = std::mem::take(&mut samples.depths);
        depths
            .par_chunks_mut(size.x as usize)
            .enumerate()
            .for_each(|(row, depths)| samples.measure_row(solid, row as u32, depths));
        samples.depths = depths;
        if solid.open_edges > 0 {
            samples.close_holes();
        }
        samples
    }

    fn measure_row(&self, solid: &Solid, row: u32, depths: &mut [f32]) {
        let mut x = 0;
        while x < depths.len() {
            let point = self.at(UVec3::new(x as u32, row % self.size.y, row / self.size.y));
            let inside = solid.unit_contains(point);
            let depth = solid.unit_distance(point) / self.step;
            if inside {
                depths[x] = depth;
            }
            // Nothing changes side without a surface between, where there are no holes.
            let free = if solid.open_edges > 0 { 0 } else { (depth * 0.999) as usize };
            let end = (x + 1 + free).min(depths.len());
            if inside {
                let mut last = depth;
                for (x, depth) in depths.iter_mut().enumerate().take(end).skip(x + 1) {
                    let cell = UVec3::new(x as u32, row % self.size.y, row / self.size.y);
                    // No point is farther than the one before it by more than a step.
                    let most = (last + 1.001) * self.step;
                    *depth = solid.unit_distance_within(self.at(cell), most) / self.step;
                    last = *depth;
                }
            }
            x = end;
        }
    }

    /// In a hole no triangle bounds the depth: the nearest point outside does.
    fn close_holes(&mut self) {
        let outside = distances::to_zeros(self.size, &self.depths);
        for (depth, outside) in self.depths.iter_mut().zip(outside) {
            *depth = depth.min(outside);
        }
    }
}

/// Points along each side of the grid of a box: odd, so that one lies in the middle, where what is
/// symmetric has its largest sphere; and a layer of outside all round.
fn size(sides: Vec3, step: f32) -> Vec3 {
    (sides / (2.0 * step)).ceil() * 2.0 + 3.0
}

/// The least distance between points that makes no more of them than [`MOST`]. The layers round a
/// flat box may be many times those within it.
fn finest(sides: Vec3) -> f32 {
    let points = |step: f32| size(sides, step).as_dvec3().element_product();
    let volume = sides.max(Vec3::splat(1e-6)).as_dvec3().element_product();
    let mut step = (volume / MOST).cbrt() as f32;
    while points(step) > MOST {
        step *= 1.02;
    }
    step
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Mesh;

    #[test]
    fn no_box_has_too_many_points_and_each_has_one_inside() {
        for sides in [
            Vec3::ONE,
            Vec3::new(1.41, 1.41, 1e-4),
            Vec3::new(1e-6, 1.41, 1.41),
            Vec3::new(2.0, 1e-6, 1e-6),
            Vec3::new(2.0, 0.0, 0.01),
            Vec3::splat(1e-3),
        ] {
            let points = size(sides, finest(sides)).as_dvec3().element_product();
            assert!(points <= MOST && points > 0.5 * MOST, "{sides}: {points}");
        }
        let plate = |p: Vec3| p * Vec3::new(1.0, 1e-4, 1.0);
        let mut ball = Mesh::sphere(1.0, 12).unwrap();
        ball.positions.iter_mut().for_each(|p| *p = plate(*p));
        let solid = Solid::new(&ball).unwrap();
        let samples = Samples::inside(&solid, 400_000).unwrap();
        assert!(samples.depths.len() as f64 <= MOST && samples.count() > 10_000);
    }
}
