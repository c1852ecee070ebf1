//! A solid sampled on a regular grid: which points lie inside, and how far the outside is.

use super::{Solid, distances};
use glam::{UVec3, Vec3};
use rayon::prelude::*;

/// Points of the whole grid, at most: what a thin shell may cost.
const MOST: f32 = 4e6;
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
        let coarse = Self::measure(solid, (volume / COARSE).cbrt());
        // As many points share the volume inside as are wanted, where the whole is not too many.
        let finest = (volume / MOST).cbrt();
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
        // Odd, so that one lies in the middle: what is symmetric has its largest sphere there.
        let size = ((high - low) / (2.0 * step)).ceil().as_uvec3() * 2 + 3;
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
