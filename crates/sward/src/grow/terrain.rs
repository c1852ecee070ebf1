//! A noise terrain: rolling hills.

use super::noise::gradient;
use super::random::{Purpose, Stream};
use super::surface::Mesh;
use crate::Error;
use crate::error::{above_zero, within};
use glam::{Mat2, Vec2};
use rayon::prelude::*;

/// Shrink of the features from one octave to the next.
const LACUNARITY: f32 = 2.03;
/// Share of the height that the next octave has.
const GAIN: f32 = 0.38;
/// How far the ground is warped, as a share of the feature size: bends valleys.
const WARP: f32 = 0.3;
/// Range of one octave of the noise that is reached in practice.
const SPAN: f32 = 1.5;

/// Rolling hills: gradient noise of several octaves over a warped ground, valleys smoother than
/// ridges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NoiseTerrain {
    /// Side of the square, metres, about the origin.
    pub size_m: f32,
    /// Height from the lowest valley to the highest hill, about, metres; the mean lies near y = 0.
    pub height_m: f32,
    /// Distance from hill to hill, about, metres: larger is gentler.
    pub feature_m: f32,
    /// Octaves, 1 to 12: more add finer bumps.
    pub octaves: u32,
    /// Same seed, same hills.
    pub seed: u64,
    /// Cells a side, 1 to 8192: two triangles each.
    pub resolution: u32,
}

impl Default for NoiseTerrain {
    fn default() -> Self {
        Self { size_m: 100.0, height_m: 8.0, feature_m: 40.0, octaves: 5, seed: 1, resolution: 256 }
    }
}

impl Mesh {
    /// A noise terrain.
    ///
    /// # Errors
    /// [`Error::Setting`] for a value out of its range.
    pub fn terrain(terrain: NoiseTerrain) -> Result<Self, Error> {
        terrain.check()?;
        let side = terrain.resolution + 1;
        let step_m = terrain.size_m / terrain.resolution as f32;
        let mut heights = vec![0.0; side as usize * side as usize];
        heights.par_chunks_mut(side as usize).enumerate().for_each(|(j, row)| {
            for (i, height) in row.iter_mut().enumerate() {
                *height = terrain.height(Vec2::new(i as f32, j as f32) * step_m);
            }
        });
        Self::heightmap(side, side, &heights, Vec2::splat(terrain.size_m))
    }
}

impl NoiseTerrain {
    fn check(&self) -> Result<(), Error> {
        above_zero("terrain.size_m", self.size_m, 1e6)?;
        within("terrain.height_m", self.height_m, 0.0, 1e5)?;
        above_zero("terrain.feature_m", self.feature_m, 1e6)?;
        for (setting, value, most) in
            [("terrain.octaves", self.octaves, 12), ("terrain.resolution", self.resolution, 8192)]
        {
            if value == 0 || value > most {
                let cause = format!("{value} is out of range; use 1 to {most}");
                return Err(Error::setting(setting, cause));
            }
        }
        Ok(())
    }

    fn height(&self, at_m: Vec2) -> f32 {
        let stream = Stream::new(self.seed, Purpose::Terrain);
        let seed = |octave: u32| stream.at(u64::from(octave)).bits();
        let mut at = at_m / self.feature_m;
        let warp = Vec2::new(gradient(seed(100), at), gradient(seed(101), at));
        // Each octave is turned, or its grid would line up with the last one's.
        let turn = Mat2::from_angle(0.7) * LACUNARITY;
        let (mut sum, mut share, mut total) = (0.0f32, 1.0, 0.0);
        for octave in 0..self.octaves {
            // Low ground is smooth, as if washed out; high ground keeps its detail.
            let rough = if octave == 0 { 1.0 } else { (0.6 + sum).clamp(0.15, 1.0) };
            // The warp bends hills and valleys; it would draw small bumps out into streaks.
            let bent = if octave < 2 { at + WARP * warp } else { at };
            sum += share * rough * gradient(seed(octave), bent);
            total += share;
            share *= GAIN;
            at = turn * at;
        }
        sum / total.sqrt() * self.height_m / SPAN
    }
}
