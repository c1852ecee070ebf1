// The tests of a blade and its level, and how a band's blades vote.

struct Decision {
    // Bucket 4 bits, morph 5, fade 5
    bits: u32,
    // Bits of the failed tests: orientation, frustum, distance, occlusion
    failed: u32,
}

// By the technique of the view, each in a file of its own.
fn choose_form(blade: Blade, size: Size, place: Place) -> Choice {
    switch technique() {
        case STRIPS: { return choose_strip(blade, size, place); }
        case BILLBOARDS: { return choose_band(blade, size, place); }
        case CONTINUUM: { return choose_continuum(blade, size, place); }
        default: { return choose_blade(blade, size, place); }
    }
}

fn decide(blade: Blade, state: BladeState, place: Place, inside: bool) -> Decision {
    let pose = pose_of(blade, state);
    let size = projected_size(blade);
    var choice = choose_form(blade, size, place);
    var failed = select(0u, 4u, choice.bucket == NO_BUCKET);
    if has(CULL_DISTANCE) && has(CULL_PAPER) {
        failed |= select(0u, 4u, fails_distance_paper(blade, place.local));
    }
    if has(CULL_ORIENTATION) && choice.single {
        if has(CULL_PAPER) {
            failed |= select(0u, 1u, fails_orientation_paper(blade));
        } else {
            let wide = size.width * choice.widened;
            let shown = shown_width(blade, pose, wide, page.species[blade.species].form.x);
            let turn = clamp((shown - 0.1) / 0.2, 0.0, 1.0);
            failed |= select(0u, 1u, turn <= 0.0);
            choice.fade *= turn;
        }
    }
    if has(CULL_FRUSTUM) && !inside {
        failed |= select(0u, 2u, fails_frustum(pose, choice.margin));
    }
    if has(CULL_OCCLUSION) && has(HAS_DEPTH) {
        var hidden = false;
        if choice.single {
            hidden = fails_occlusion(pose);
        } else {
            hidden = fails_occlusion_wide(pose, blade.up, choice.margin);
        }
        failed |= select(0u, 8u, hidden);
    }
    let bucket = select(choice.bucket, NO_BUCKET, failed != 0u);
    let morph = u32(round(choice.morph * 31.0));
    let shrink = u32(clamp(ceil(choice.fade * 31.0), 1.0, 31.0));
    return Decision(bucket | (morph << 4u) | (shrink << 9u), failed);
}

// Bit masks of the lanes: 16 buckets, then 4 failed tests, two words each.
var<workgroup> masks: array<atomic<u32>, 40>;
var<workgroup> packed: array<atomic<u32>, 32>;

// Of the lanes `beside`.
fn mask_count(index: u32, beside: vec2<u32>) -> u32 {
    return countOneBits(atomicLoad(&masks[2u * index]) & beside.x)
        + countOneBits(atomicLoad(&masks[2u * index + 1u]) & beside.y);
}

fn pair_count(index: u32, beside: vec2<u32>) -> u32 {
    return mask_count(index, beside) | (mask_count(index + 1u, beside) << 16u);
}

// Survivors of 8 buckets, two a word.
fn bucket_counts(first: u32, beside: vec2<u32>) -> vec4<u32> {
    return vec4<u32>(
        pair_count(first, beside),
        pair_count(first + 2u, beside),
        pair_count(first + 4u, beside),
        pair_count(first + 6u, beside),
    );
}

// Failed tests, 8 bits each.
fn failed_counts(beside: vec2<u32>) -> u32 {
    return mask_count(BUCKETS, beside)
        | (mask_count(BUCKETS + 1u, beside) << 8u)
        | (mask_count(BUCKETS + 2u, beside) << 16u)
        | (mask_count(BUCKETS + 3u, beside) << 24u);
}

fn vote(lane: u32, decision: Decision) {
    let word = lane >> 5u;
    let bit = 1u << (lane & 31u);
    let bucket = decision.bits & 15u;
    if bucket != NO_BUCKET {
        atomicOr(&masks[2u * bucket + word], bit);
    }
    for (var test = 0u; test < 4u; test++) {
        if (decision.failed & (1u << test)) != 0u {
            atomicOr(&masks[2u * (BUCKETS + test) + word], bit);
        }
    }
    atomicOr(&packed[lane >> 1u], (decision.bits & 0xffffu) << (16u * (lane & 1u)));
}
