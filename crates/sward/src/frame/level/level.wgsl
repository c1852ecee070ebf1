// Levels of detail: 8, 4, 2, 1 segments, and thinning.

// A quarter of this projected height, in pixels, ends the first level; a quarter of that the next.
const FULL_DETAIL_PX: f32 = 480.0;
const LEVELS: u32 = 4u;
// The last share of a level over which it turns into the next.
const MORPH_SHARE: f32 = 0.3;
// Share of the kept that shrink before they go (Cook et al. 2007).
const FADE_SHARE: f32 = 0.3;

struct Level {
    index: u32,
    // 0: the level's own form; 1: the next level's
    morph: f32,
}

fn choose_level(height_px: f32) -> Level {
    let x = clamp(0.5 * log2(FULL_DETAIL_PX / max(height_px, 1e-3)), 0.0, 3.999);
    let index = min(u32(x), LEVELS - 1u);
    let t = clamp((x - f32(index) - (1.0 - MORPH_SHARE)) / MORPH_SHARE, 0.0, 1.0);
    return Level(index, select(t * t * (3.0 - 2.0 * t), 0.0, index == LEVELS - 1u));
}

// How many of the blades of this width are kept, as a share that goes beyond 1 up close.
fn keep_share(width_px: f32) -> f32 {
    return width_px / view.least_width;
}

// Width of the blade of this rank (0..1 in its patch), as a share: 0 is gone, 1 whole.
fn rank_fade(share: f32, rank: f32) -> f32 {
    return clamp((share - rank) / (FADE_SHARE * share), 0.0, 1.0);
}

// Widening of the survivors that keeps the covered area: one over the mean of rank_fade.
fn widening(share: f32) -> f32 {
    if share <= 1.0 {
        return 1.0 / (max(share, 1e-4) * (1.0 - 0.5 * FADE_SHARE));
    }
    let shy = max(1.0 - share * (1.0 - FADE_SHARE), 0.0);
    return 1.0 / (1.0 - shy * shy / (2.0 * FADE_SHARE * share));
}

// What `rank_fade` leaves of all plants in the mean.
fn mean_kept(share: f32) -> f32 {
    return 1.0 / widening(share);
}

// The share that leaves so much: the inverse of `mean_kept`.
fn share_that_keeps(mean: f32) -> f32 {
    let half = 1.0 - 0.5 * FADE_SHARE;
    if mean <= half {
        return mean / half;
    }
    let shy = 1.0 - FADE_SHARE;
    let b = shy + FADE_SHARE * (1.0 - mean);
    return (b - sqrt(max(b * b - shy * shy, 0.0))) / (shy * shy);
}

// The share of which so much is left.
fn thinned(share: f32, left: f32) -> f32 {
    if left >= 1.0 {
        return share;
    }
    return share_that_keeps(left * mean_kept(share));
}
