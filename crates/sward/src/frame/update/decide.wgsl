// The tests of a blade and its level, and how a band's blades vote.

const NO_BUCKET: u32 = 15u;

struct Decision {
    // Bucket 4 bits, morph 5, fade 5
    bits: u32,
    // Bits of the failed tests: orientation, frustum, distance, occlusion
    failed: u32,
}

struct Size {
    // Pixels
    width: f32,
    height: f32,
    // Share of the blades of this size that are kept
    keep: f32,
    distance: f32,
}

fn projected_size(blade: Blade) -> Size {
    var size: Size;
    size.distance = distance_to(blade.root + blade.up * (0.5 * blade.height));
    let scale = pixels_per_metre(size.distance);
    size.width = blade.width * scale;
    size.height = blade.height * scale;
    size.keep = 1e6;
    if has(CULL_DISTANCE) && !has(CULL_PAPER) {
        size.keep = keep_share(size.width);
    }
    return size;
}

// Blades end within the last tenth of the farthest distance by shrinking.
fn range_fade(distance: f32) -> f32 {
    return clamp((view.max_distance - distance) / (0.1 * view.max_distance), 0.0, 1.0);
}

fn level_of(size: Size) -> Level {
    let height = size.height * view.detail;
    return choose_level(clamp(height, view.level_height.x, view.level_height.y));
}

fn decide(blade: Blade, state: BladeState, local: u32, rank: f32, inside: bool) -> Decision {
    let pose = pose_of(blade, state);
    let size = projected_size(blade);
    var fade = 1.0;
    var failed = 0u;
    if has(CULL_DISTANCE) {
        if has(CULL_PAPER) {
            failed |= select(0u, 4u, fails_distance_paper(blade, local));
        } else {
            fade = rank_fade(size.keep, rank) * range_fade(size.distance);
            failed |= select(0u, 4u, fade <= 0.0);
        }
    }
    if has(CULL_ORIENTATION) {
        if has(CULL_PAPER) {
            failed |= select(0u, 1u, fails_orientation_paper(blade));
        } else {
            let wide = size.width * widening(size.keep);
            let shown = shown_width(blade, pose, wide, species_table[blade.species].form.x);
            let turn = clamp((shown - 0.1) / 0.2, 0.0, 1.0);
            failed |= select(0u, 1u, turn <= 0.0);
            fade *= turn;
        }
    }
    if has(CULL_FRUSTUM) && !inside {
        failed |= select(0u, 2u, fails_frustum(pose, blade.width * widening(size.keep)));
    }
    if has(CULL_OCCLUSION) && has(HAS_DEPTH) {
        failed |= select(0u, 8u, fails_occlusion(pose));
    }
    let level = level_of(size);
    let bucket = select(
        species_table[blade.species].first_bucket + level.index,
        NO_BUCKET,
        failed != 0u,
    );
    let morph = u32(round(level.morph * 31.0));
    let shrink = u32(clamp(ceil(fade * 31.0), 1.0, 31.0));
    return Decision(bucket | (morph << 4u) | (shrink << 9u), failed);
}

// Bit masks of the lanes: 8 buckets, then 4 failed tests, two words each.
var<workgroup> masks: array<atomic<u32>, 24>;
var<workgroup> packed: array<atomic<u32>, 32>;

fn mask_count(index: u32) -> u32 {
    return countOneBits(atomicLoad(&masks[2u * index]))
        + countOneBits(atomicLoad(&masks[2u * index + 1u]));
}

fn pair_count(index: u32) -> u32 {
    return mask_count(index) | (mask_count(index + 1u) << 16u);
}

fn vote(lane: u32, decision: Decision) {
    let word = lane >> 5u;
    let bit = 1u << (lane & 31u);
    let bucket = decision.bits & 15u;
    if bucket < BUCKETS {
        atomicOr(&masks[2u * bucket + word], bit);
    }
    for (var test = 0u; test < 4u; test++) {
        if (decision.failed & (1u << test)) != 0u {
            atomicOr(&masks[2u * (BUCKETS + test) + word], bit);
        }
    }
    atomicOr(&packed[lane >> 1u], (decision.bits & 0xffffu) << (16u * (lane & 1u)));
}
