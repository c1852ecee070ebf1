//! What a field looks like as a whole, from each elevation.

use super::cluster::Clusters;
use super::cover::{Cover, ROWS, look, sine};
use super::stand::{Stand, Stands};
use super::surfels::{SURFELS, Weighted, depth_shade, group};
use crate::gpu::layout::GpuCanopy;
use glam::Vec3;
use rayon::prelude::*;

/// Places that are grouped, of an elevation.
const GROUPED: usize = 8192;
/// Less of the ground that is open does not show in so few samples.
const LEAST_OPEN: f32 = 5e-4;

/// Looks at stands from all elevations. `clusters` gives the size of theirs.
pub(crate) fn canopy(stands: &Stands, clusters: Option<&Clusters>) -> GpuCanopy {
    let fit = |stand: &Stand| stand.clone().fitted(usize::MAX, &stands.means);
    let fitted: Vec<Stand> = stands.stands.iter().map(fit).collect();
    let triangles: Vec<_> = fitted.iter().map(|s| s.triangles(usize::MAX, true)).collect();
    let places: Vec<(usize, usize)> =
        (0..ROWS).flat_map(|row| (0..fitted.len()).map(move |stand| (row, stand))).collect();
    // The lowest rows take longest and come first; each stand from a side of its own
    let covers: Vec<Cover> = (places.par_iter())
        .map(|&(row, i)| look(&fitted[i], &triangles[i], 0.4 + 1.7 * i as f32, row))
        .collect();
    let mut result = GpuCanopy::empty();
    for row in 0..ROWS {
        let own = places.iter().zip(&covers).filter(|((of, _), _)| *of == row);
        let cover = own.fold(Cover::default(), |sum, (_, cover)| sum.with(cover.clone()));
        fill(&mut result, row, &cover, stands.root_open);
    }
    let means = &stands.means;
    let blades = || fitted.iter().flat_map(|s| &s.blades);
    let lean = blades().map(|b| b.lean).sum::<f32>() / blades().count().max(1) as f32;
    let (radius, height) = clusters.map_or((0.0, 0.0), |c| (c.radius_m, c.height_m));
    result.size = [radius, height, means.height, stands.root_open];
    result.pose = [lean, 0.0, 0.0, 0.0];
    result.tint = means.plain.extend(means.tint).to_array();
    result.tint_mean = means.surface.extend(0.0).to_array();
    result
}

fn fill(canopy: &mut GpuCanopy, row: usize, cover: &Cover, root_open: f32) {
    let count = cover.shown.len();
    let picked = super::stand::evenly(count, GROUPED).map(|i| cover.shown[i]);
    let places: Vec<_> = picked.map(|shown| Weighted { shown, weight: 1.0 }).collect();
    let tone: Vec3 = (cover.shown.iter())
        .map(|shown| shown.albedo * depth_shade(shown.height_share, root_open))
        .sum();
    canopy.rows[row] = (tone / count.max(1) as f32).extend(cover.open()).to_array();
    canopy.surfels[row * SURFELS..(row + 1) * SURFELS].copy_from_slice(&group(&places, root_open));
}

/// Blades that a ray meets on its way to the ground, in the mean, for each metre along over each metre of
/// height, and straight down; from what is open of the ground (Poisson).
pub(crate) fn layers(canopy: &GpuCanopy) -> [f32; 2] {
    let met = |row: usize| -canopy.rows[row][3].max(LEAST_OPEN).ln();
    let above = met(ROWS - 1);
    let aside = |row: usize| {
        let along = (1.0 - sine(row) * sine(row)).sqrt() / sine(row);
        ((met(row) - above) / along).max(0.0)
    };
    // Where all is closed the number is at least so high
    [(0..ROWS - 1).map(aside).fold(0.0, f32::max), above]
}
