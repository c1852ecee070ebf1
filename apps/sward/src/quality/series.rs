//! FLIP along a path of the camera, and how it jumps from frame to frame.

use super::PATH_STEPS;
use super::pair::Pair;
use super::paths::frames;
use crate::compare::{flip_map, percentile};
use anyhow::Result;
use serde::Serialize;
use sward_scene::Camera;

/// Pixels a side of the tiles whose mean is followed.
const TILE: usize = 16;

/// A path.
#[derive(Debug, Clone, Serialize)]
pub struct PathFlip {
    /// Mean of the frames' means.
    pub mean: f32,
    /// Largest mean of a frame.
    pub worst: f32,
    /// Largest difference of the means of neighbouring frames.
    pub jump: f32,
    /// 99.9th percentile, over all tiles of 16 x 16 pixels and all frames, of the difference of a
    /// tile's mean between neighbouring frames.
    pub tile_jump: f32,
    /// Every frame that was drawn.
    pub frames: Vec<FrameFlip>,
}

/// A frame of a path.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct FrameFlip {
    /// Its number on the path.
    pub frame: u32,
    /// Mean over all pixels.
    pub flip: f32,
    /// Difference of that to the frame before; none where that was not drawn.
    pub jump: Option<f32>,
    /// 99.9th percentile of the tiles' differences to the frame before.
    pub tile_jump: Option<f32>,
}

/// A frame's means.
struct Means {
    frame: u32,
    mean: f32,
    tiles: Vec<f32>,
}

/// Draws the frames of a path, each with its reference.
pub(super) fn along(
    pair: &mut Pair,
    camera: impl Fn(f32) -> Camera,
    count: u32,
    step: &dyn Fn(),
) -> Result<PathFlip> {
    let mut means = Vec::new();
    for frame in frames(count) {
        pair.look_from(&camera(frame as f32 / (PATH_STEPS - 1) as f32))?;
        let (reference, test) = pair.pictures()?;
        let errors = flip_map(&reference, &test)?;
        let mean = errors.iter().map(|&e| f64::from(e)).sum::<f64>() / errors.len().max(1) as f64;
        let tiles = tile_means(&errors, reference.width() as usize);
        means.push(Means { frame, mean: mean as f32, tiles });
        step();
    }
    Ok(PathFlip::new(&means))
}

impl PathFlip {
    fn new(means: &[Means]) -> Self {
        let mut tile_jumps = Vec::new();
        let mut frames: Vec<FrameFlip> = Vec::with_capacity(means.len());
        for (i, now) in means.iter().enumerate() {
            let before = i.checked_sub(1).and_then(|i| means.get(i));
            let before = before.filter(|before| before.frame + 1 == now.frame);
            let jumps = before.map(|before| {
                let both = before.tiles.iter().zip(&now.tiles);
                both.map(|(a, b)| (a - b).abs()).collect::<Vec<_>>()
            });
            tile_jumps.extend(jumps.iter().flatten());
            frames.push(FrameFlip {
                frame: now.frame,
                flip: now.mean,
                jump: before.map(|before| (now.mean - before.mean).abs()),
                tile_jump: jumps.map(high),
            });
        }
        let largest = |values: &mut dyn Iterator<Item = f32>| values.fold(0.0, f32::max);
        Self {
            mean: means.iter().map(|m| m.mean).sum::<f32>() / means.len().max(1) as f32,
            worst: largest(&mut means.iter().map(|m| m.mean)),
            jump: largest(&mut frames.iter().filter_map(|f| f.jump)),
            tile_jump: high(tile_jumps),
            frames,
        }
    }
}

fn high(mut values: Vec<f32>) -> f32 {
    values.sort_by(f32::total_cmp);
    percentile(&values, 0.999)
}

/// Means of the tiles, of which those at the right and lower edge may be cut.
fn tile_means(errors: &[f32], width: usize) -> Vec<f32> {
    let columns = width.div_ceil(TILE).max(1);
    let rows = errors.len().div_ceil(width.max(1)).div_ceil(TILE);
    let mut sums = vec![(0.0, 0_u32); columns * rows];
    for (i, error) in errors.iter().enumerate() {
        let tile = i / width / TILE * columns + i % width / TILE;
        if let Some((sum, count)) = sums.get_mut(tile) {
            (*sum, *count) = (*sum + error, *count + 1);
        }
    }
    sums.into_iter().map(|(sum, count)| sum / count.max(1) as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_have_their_own_pixels_means() {
        let (width, height) = (40, 20);
        let errors: Vec<f32> = (0..width * height)
            .map(|i| ((i % width) / TILE + 10 * (i / width / TILE)) as f32)
            .collect();
        assert_eq!(tile_means(&errors, width), [0.0, 1.0, 2.0, 10.0, 11.0, 12.0]);
    }

    #[test]
    fn jumps_are_those_of_neighbours_only() {
        let frame = |frame, mean, tile| Means { frame, mean, tiles: vec![tile, 0.0] };
        let means =
            [frame(3, 0.10, 0.1), frame(4, 0.11, 0.4), frame(5, 0.11, 0.4), frame(9, 0.9, 0.9)];
        let path = PathFlip::new(&means);
        assert!((path.jump - 0.01).abs() < 1e-6 && (path.tile_jump - 0.3).abs() < 1e-6);
        assert_eq!(path.frames[0].jump, None);
        assert_eq!(path.frames[3].jump, None);
        assert_eq!(path.worst, 0.9);
    }
}
