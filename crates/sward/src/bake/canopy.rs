//! What a field looks like as a whole, from each elevation, at rest and in wind from each side.

use super::cards::set_cards;
use super::cluster::Clusters;
use super::cover::{Cover, ROWS, look, sine};
use super::harmonics::Look;
use super::stand::{POSES, Posed, Stand, Stands, WINDS, level};
use crate::gpu::layout::{GpuBent, GpuCanopy, GpuCanopyRow, GpuLook};
use glam::Vec3;
use rayon::prelude::*;
use std::f32::consts::{FRAC_PI_3, PI};

/// Samples a side of a stand at rest, and in wind.
const GRIDS: [u32; 2] = [64, 36];
/// Angles from the eye to where the wind blows: towards the eye, two to its right, away from it.
const SIDES: [f32; 4] = [0.0, FRAC_PI_3, 2.0 * FRAC_PI_3, PI];
/// Looks at a row: at rest, and in each wind from each side.
const LOOKS: usize = 1 + WINDS.len() * SIDES.len();

/// What shows from an elevation, in each look, with the share of the ground that shows.
type Row = [(Look, f32); LOOKS];
/// Less of the ground that is open does not show in so few samples.
const LEAST_OPEN: f32 = 5e-4;

/// Looks at stands from all elevations. `clusters` gives the size of theirs.
pub(crate) fn canopy(stands: &Stands, clusters: Option<&Clusters>) -> GpuCanopy {
    let fitted = stands.fitted();
    let posed: Vec<[Posed; POSES]> =
        fitted.par_iter().map(|s| std::array::from_fn(|pose| s.posed(pose))).collect();
    // The lowest rows take longest and come first
    let jobs: Vec<(usize, usize)> =
        (0..ROWS).flat_map(|row| (0..LOOKS).map(move |which| (row, which))).collect();
    let looks: Vec<(Look, f32)> = (jobs.par_iter())
        .map(|&(row, which)| look_at(&fitted, &posed, row, which, stands.root_open))
        .collect();
    let mut result = GpuCanopy::empty();
    for (row, looks) in looks.chunks(LOOKS).enumerate() {
        if let Ok(looks) = looks.try_into() {
            result.rows[row] = gpu_row(looks);
        }
    }
    let means = &stands.means;
    let (radius, height) = clusters.map_or((0.0, 0.0), |c| (c.size.radius, c.size.height));
    result.size = [radius, height, means.height, stands.root_open];
    if let Some(clusters) = clusters {
        set_cards(&mut result, clusters, stands.each_m2);
    }
    result.pose = pose(&fitted);
    result.tint = means.plain.extend(means.tint).to_array();
    result.tint_mean = means.surface.extend(0.0).to_array();
    result
}

/// What shows of all stands.
fn look_at(
    stands: &[Stand],
    posed: &[[Posed; POSES]],
    row: usize,
    which: usize,
    root_open: f32,
) -> (Look, f32) {
    let (pose, side, grid) = match which.checked_sub(1) {
        None => (0, 1.0, GRIDS[0]),
        Some(bent) => (1 + bent / SIDES.len(), SIDES[bent % SIDES.len()], GRIDS[1]),
    };
    let cover = stands.iter().zip(posed).fold(Cover::default(), |sum, (stand, posed)| {
        sum.with(look(&posed[pose], stand.period, stand.downwind - side, row, grid))
    });
    (Look::of(&cover.shown, root_open), cover.open())
}

/// As `GpuCanopy::pose` has it: how far each wind moves the mean tip, and how high that is at rest; in
/// heights.
fn pose(stands: &[Stand]) -> [f32; 4] {
    let count = stands.len().max(1) as f32;
    let rest = stands.iter().map(|s| s.mean_tip(0)).sum::<Vec3>() / count;
    let moved = |wind: usize| {
        let along = |s: &Stand| (s.mean_tip(1 + wind) - s.mean_tip(0)).dot(level(s.downwind));
        (stands.iter().map(along).sum::<f32>() / count).max(0.0)
    };
    [moved(0), moved(1), moved(2), rest.y.clamp(0.05, 1.2)]
}

/// From the four sides: the mean over all, and what goes with the cosines of the side, its double and its
/// triple; of what changes with x, what goes with the sines of the side and its double.
fn waves_of(sides: [GpuLook; 4], across: [[[f32; 4]; 10]; 2]) -> GpuBent {
    let each = |of: &dyn Fn([f32; 4]) -> f32| {
        let vector = |part: &dyn Fn(&GpuLook) -> [f32; 4]| -> [f32; 4] {
            std::array::from_fn(|i| of(std::array::from_fn(|side| part(&sides[side])[i])))
        };
        GpuLook {
            waves: std::array::from_fn(|i| vector(&|look| look.waves[i])),
            around: vector(&|look| look.around),
            tilt: vector(&|look| look.tilt),
        }
    };
    let [one, two] = across;
    let odd = |sign: f32| {
        std::array::from_fn(|i| {
            std::array::from_fn(|k| (one[i][k] + sign * two[i][k]) / 3.0_f32.sqrt())
        })
    };
    GpuBent {
        mean: each(&|[a, b, c, d]| (a + 2.0 * (b + c) + d) / 6.0),
        first: each(&|[a, b, c, d]| (a + b - c - d) / 3.0),
        second: each(&|[a, b, c, d]| (a - b - c + d) / 3.0),
        third: each(&|[a, b, c, d]| (a - 2.0 * (b - c) - d) / 6.0),
        across: odd(1.0),
        across_double: odd(-1.0),
    }
}

/// A row as the GPU has it.
fn gpu_row(row: &Row) -> GpuCanopyRow {
    let mean = |which: usize| row[which].0.mean(row[which].1);
    let wind = |wind: usize| {
        let sides: [_; 4] = std::array::from_fn(|side| mean(1 + wind * SIDES.len() + side));
        waves_of(sides.map(|(look, _)| look), [sides[1].1, sides[2].1])
    };
    let rest = &row[0].0;
    let count = rest.count.max(1e-9);
    GpuCanopyRow {
        shown: (rest.tone / count).extend(rest.height / count).to_array(),
        rest: mean(0).0,
        winds: std::array::from_fn(wind),
    }
}

/// Blades that a ray of that sine meets on its way to the ground, at rest: the twin of `canopy_met`.
pub(crate) fn met(canopy: &GpuCanopy, sine: f32) -> f32 {
    let last = ROWS - 1;
    let row = last as f32 + sine.abs().clamp(1e-3, 1.0).log2();
    let low = (row.max(0.0) as usize).min(last - 1);
    let along = |sine: f32| 1.0 / (sine * sine) - 1.0;
    let [from, to] = [low, low + 1].map(self::sine);
    let part = (along(from) - along(sine.abs().clamp(from, to))) / (along(from) - along(to));
    let [first, second] =
        [low, low + 1].map(|row| -canopy.rows[row].rest.around[3].max(LEAST_OPEN).ln());
    (first * first * (1.0 - part) + second * second * part).sqrt()
}

/// Blades that a ray meets on its way to the ground, in the mean, for each metre along over each metre of
/// height, and straight down; from what is open of the ground (Poisson).
pub(crate) fn layers(canopy: &GpuCanopy) -> [f32; 2] {
    let met = |row: usize| -canopy.rows[row].rest.around[3].max(LEAST_OPEN).ln();
    let above = met(ROWS - 1);
    let aside = |row: usize| {
        let along = (1.0 - sine(row) * sine(row)).sqrt() / sine(row);
        ((met(row) - above) / along).max(0.0)
    };
    // Where all is closed the number is at least so high
    [(0..ROWS - 1).map(aside).fold(0.0, f32::max), above]
}
