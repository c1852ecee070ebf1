//! Mip chains that keep the share of what the alpha test lets through: plain means thin far grass
//! out, as narrow things fall below the threshold. After I. Castano, "Computing alpha mipmaps",
//! 2010; but the share is measured as it is drawn, between texels too.

use super::ALPHA_TEST;
use super::raster::Tile;

/// The smallest level's edge, texels: fewer cannot hold a share.
const LEAST: u32 = 4;
/// Halvings of the interval that holds a level's scale.
const STEPS: u32 = 20;
/// The share is found to within this.
const CLOSE: f32 = 2e-3;

/// Levels, each of half the size of the one before; the last has an edge of [`LEAST`] texels, or is
/// the first.
pub(crate) type Chain = Vec<Tile>;

/// A tile with its mips, whose alphas are scaled level by level, the first one too, so that the
/// share that passes the alpha test is `target`: a tile's coverage, where it shows things
/// narrower than its texels, or the share of the first level itself ([`passing`]), which then
/// stays as it is.
pub(crate) fn chain(base: Tile, target: f32) -> Chain {
    let mut levels = plain(base);
    for level in &mut levels {
        keep_share(level, target);
        level.dilate();
    }
    levels
}

/// A tile with its mips as they are: their alphas are coverages, for what is not tested against one
/// threshold but covers as many pixels in the mean.
pub(crate) fn plain(base: Tile) -> Chain {
    let mut levels = vec![base];
    while let Some(last) = levels.last()
        && last.size.iter().all(|n| *n >= 2 * LEAST)
    {
        let mut next = last.halved();
        next.dilate();
        levels.push(next);
    }
    levels
}

/// Share of a tile's area where alpha, interpolated between texels, passes the test.
pub(crate) fn passing(tile: &Tile) -> f32 {
    let alphas: Vec<f32> = tile.texels.iter().map(|t| t.alpha).collect();
    share(tile.size, &alphas, 1.0)
}

/// Of scaled alphas; beyond the rim they stay.
fn share(size: [u32; 2], alphas: &[f32], scale: f32) -> f32 {
    let [width, height] = size.map(|n| n as i32);
    let at = |x: i32, y: i32| {
        let (x, y) = (x.clamp(0, width - 1), y.clamp(0, height - 1));
        (alphas[(y * width + x) as usize] * scale).min(1.0)
    };
    let count = places(size);
    let mut passed = 0;
    for y in -1..height {
        for x in -1..width {
            let corners = [at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)];
            // Of the cells about the rim, only the part within the tile
            let (low_x, high_x) = within(x, width, count);
            let (low_y, high_y) = within(y, height, count);
            let places = (low_x..high_x, low_y..high_y);
            if corners.iter().all(|a| *a >= ALPHA_TEST) {
                passed += places.0.len() * places.1.len();
            } else if corners.iter().any(|a| *a >= ALPHA_TEST) {
                passed += passing_cell(corners, count, places);
            }
        }
    }
    passed as f32 / (size[0] * size[1] * count * count) as f32
}

/// Places of a cell, from the middle of texel `from` to the next one's, that lie in the tile.
fn within(from: i32, size: i32, count: u32) -> (u32, u32) {
    let half = count / 2;
    if from < 0 {
        (count - half, count)
    } else if from == size - 1 {
        (0, half)
    } else {
        (0, count)
    }
}

fn passing_cell(
    corners: [f32; 4],
    count: u32,
    (across, down): (std::ops::Range<u32>, std::ops::Range<u32>),
) -> usize {
    let at = |i: u32| (i as f32 + 0.5) / count as f32;
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
    down.map(|j| {
        let left = mix(corners[0], corners[2], at(j));
        let right = mix(corners[1], corners[3], at(j));
        across.clone().filter(|i| mix(left, right, at(*i)) >= ALPHA_TEST).count()
    })
    .sum()
}

/// Places a side of a texel where the share is measured; even, so that a tile holds all of them.
fn places(size: [u32; 2]) -> u32 {
    (64 / size[0].min(size[1])).next_multiple_of(2).clamp(2, 8)
}

/// Scales a level's alphas.
fn keep_share(tile: &mut Tile, target: f32) {
    let alphas: Vec<f32> = tile.texels.iter().map(|t| t.alpha).collect();
    let most = alphas.iter().copied().fold(0.0, f32::max);
    if most <= 0.0 || target <= 0.0 || share(tile.size, &alphas, 1.0) == target {
        return;
    }
    // The share grows with the scale: a bisection of its logarithm
    let (mut low, mut high) = (ALPHA_TEST / most, 256.0_f32);
    for _ in 0..STEPS {
        let middle = (low * high).sqrt();
        let found = share(tile.size, &alphas, middle);
        if found < target {
            low = middle;
        } else {
            high = middle;
        }
        if (found - target).abs() < CLOSE {
            high = middle;
            break;
        }
    }
    for texel in &mut tile.texels {
        texel.alpha = (texel.alpha * high).min(1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::super::raster::Texel;
    use super::*;
    use glam::Vec3;

    /// Thin slanted strokes, at places that fall everywhere.
    fn strokes(size: u32, width: f32, gap: f32) -> Tile {
        let texel = |x: u32, y: u32| {
            let at = |i: u32| x as f32 + 0.37 * y as f32 + (i as f32 + 0.5) / 16.0;
            let covered = (0..16).filter(|i| at(*i).rem_euclid(gap) < width).count();
            let albedo = Vec3::splat(0.5);
            Texel { albedo, alpha: covered as f32 / 16.0, normal: Vec3::Z, ..Texel::EMPTY }
        };
        let texels = (0..size * size).map(|i| texel(i % size, i / size)).collect();
        Tile { size: [size; 2], texels }
    }

    #[test]
    fn every_level_keeps_the_share() {
        for (width, gap) in [(0.4, 3.3), (1.0, 4.1), (0.3, 1.7), (5.0, 17.0)] {
            let base = strokes(64, width, gap);
            let target = base.coverage();
            for level in chain(base, target) {
                let kept = passing(&level);
                let off = (kept - target).abs();
                assert!(
                    off < 0.03,
                    "{} texels, {width} of {gap}: {kept} of {target}",
                    level.size[0]
                );
            }
        }
    }

    /// What Castano is needed for: plain means let nothing through.
    #[test]
    fn plain_means_would_thin_out() {
        let base = strokes(64, 1.0, 4.1);
        let small = base.halved().halved().halved();
        assert_eq!(passing(&small), 0.0, "all are about 0.25");
    }

    #[test]
    fn a_level_of_its_own_share_stays() {
        let base = strokes(32, 5.0, 16.0);
        let target = passing(&base);
        assert_eq!(chain(base.clone(), target)[0], base);
    }

    #[test]
    fn levels_halve_down_to_four_texels() {
        let sizes: Vec<_> = chain(strokes(64, 1.0, 3.0), 0.3).iter().map(|t| t.size[0]).collect();
        assert_eq!(sizes, [64, 32, 16, 8, 4]);
        assert_eq!(chain(strokes(2, 1.0, 3.0), 0.3).len(), 1);
    }

    #[test]
    fn empty_tiles_stay_empty() {
        let empty = Tile { size: [8, 8], texels: vec![Texel::EMPTY; 64] };
        assert!(chain(empty, 0.5).iter().all(|level| level.coverage() == 0.0));
    }
}
