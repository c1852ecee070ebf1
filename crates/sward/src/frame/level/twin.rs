//! The CPU reference of level.wgsl.

use super::{FULL_DETAIL_PX, MORPH_SHARE};

const FADE_SHARE: f32 = 0.3;

/// Level and how far it has turned into the next.
pub(crate) fn choose_level(height_px: f32) -> (u32, f32) {
    let x = (0.5 * (FULL_DETAIL_PX / height_px.max(1e-3)).log2()).clamp(0.0, 3.999);
    let index = (x as u32).min(3);
    let t = ((x - index as f32 - (1.0 - MORPH_SHARE)) / MORPH_SHARE).clamp(0.0, 1.0);
    (index, if index == 3 { 0.0 } else { t * t * (3.0 - 2.0 * t) })
}

/// Width left of the blade of this rank.
pub(crate) fn rank_fade(share: f32, rank: f32) -> f32 {
    ((share - rank) / (FADE_SHARE * share)).clamp(0.0, 1.0)
}

/// Widening of the survivors.
pub(crate) fn widening(share: f32) -> f32 {
    if share <= 1.0 {
        return 1.0 / (share.max(1e-4) * (1.0 - 0.5 * FADE_SHARE));
    }
    let shy = (1.0 - share * (1.0 - FADE_SHARE)).max(0.0);
    1.0 / (1.0 - shy * shy / (2.0 * FADE_SHARE * share))
}

#[cfg(test)]
mod tests {
    use super::{choose_level, rank_fade, widening};

    #[test]
    fn a_level_ends_as_the_next_begins() {
        for boundary in [120.0, 30.0, 7.5] {
            let (above, below) = (choose_level(boundary * 1.0001), choose_level(boundary * 0.9999));
            assert_eq!(above.0 + 1, below.0);
            assert!(above.1 > 0.999 && below.1 < 0.001, "{above:?} {below:?}");
        }
        assert_eq!(choose_level(1e9), (0, 0.0));
        assert_eq!(choose_level(0.0), (3, 0.0));
        assert_eq!(choose_level(f32::INFINITY).0, 0);
    }

    /// Cook's rule: what is lost by blades that shrink or go, the others gain in width.
    #[test]
    fn thinning_keeps_the_covered_area() {
        let count = 20_000;
        for share in [0.05, 0.3, 0.7, 0.99, 1.0, 1.2, 1.42, 1.5, 4.0] {
            let kept: f64 = (0..count)
                .map(|i| f64::from(rank_fade(share, (i as f32 + 0.5) / count as f32)))
                .sum();
            let area = kept / f64::from(count) * f64::from(widening(share));
            assert!((area - 1.0).abs() < 2e-3, "share {share}: area {area}");
        }
    }

    #[test]
    fn blades_shrink_before_they_go() {
        for rank in [0.1, 0.5, 0.9] {
            let mut last = 0.0;
            for step in 0..200 {
                // Each share is a hundredth more than the last: one step towards the blade
                let fade = rank_fade(0.5 * rank * 1.01_f32.powi(step), rank);
                assert!(fade >= last && fade - last < 0.05, "a jump at rank {rank}");
                last = fade;
            }
            assert_eq!(last, 1.0);
        }
    }
}
