// Blade update: one thread a blade, one workgroup a band of 64. Physics, the blade tests, the level.

override SIMULATE: bool = true;
override TEST: bool = true;

@group(2) @binding(1) var<storage, read_write> bands: array<GpuBand>;
@group(2) @binding(2) var<storage, read> work: array<vec2<u32>>;
@group(2) @binding(3) var<storage, read_write> dynamics: array<vec2<u32>>;
// Chunks near each patch
@group(2) @binding(4) var<storage, read> near: array<u32>;
// Two blades a word, 16 bits each: bucket 4, morph 5, fade 5
@group(2) @binding(5) var<storage, read_write> decisions: array<u32>;

const NO_BUCKET: u32 = 15u;

struct Decision {
    // Bucket 4 bits, morph 5, fade 5
    bits: u32,
    // Bits of the failed tests: orientation, frustum, distance, occlusion
    failed: u32,
}

fn advance(blade: Blade, state: BladeState, band: GpuBand, patch_index: u32) -> BladeState {
    var gap = frame.dt_s;
    if band.step + 1u != frame.step {
        gap = f32(frame.ticks - band.ticks) / 16384.0;
    }
    if frame.physics_model == 1u {
        return advance_paper(blade, state, gap, patch_index);
    }
    return advance_sward(blade, state, gap, patch_index);
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
    let height = clamp(size.height * view.detail, view.level_height.x, view.level_height.y);
    let level = choose_level(height);
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
var<workgroup> tested: atomic<u32>;

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

@compute @workgroup_size(64)
fn update(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let entry = work[group.x];
    let patch_index = entry.x & 0x7fffffffu;
    let first = group.y * BAND;
    if first >= entry.y {
        return;
    }
    let band_index = patch_index * bands_per_patch() + group.y;
    let local = first + lane;
    let count = patch_blades(patch_index);
    let index = patch_index * field.patch_size + local;
    let band = bands[band_index];
    let stale = SIMULATE && band.step != frame.step;
    var decision = Decision(NO_BUCKET, 0u);
    if local < count && (stale || TEST) {
        let blade = unpack_blade(index);
        var state = unpack_state(blade, dynamics[index]);
        if stale {
            state = advance(blade, state, band, patch_index);
            if tests_made > 0u {
                atomicAdd(&tested, tests_made);
            }
            let bits = pack_state(blade, state);
            dynamics[index] = bits;
            // Test what will be drawn: the quantised state
            state = unpack_state(blade, bits);
        }
        if TEST {
            let rank = (f32(local) + 0.5) / f32(count);
            decision = decide(blade, state, local, rank, (entry.x >> 31u) == 1u);
        }
    }
    if TEST {
        vote(lane, decision);
    }
    workgroupBarrier();
    // All have read the band before it is written
    storageBarrier();
    if lane == 0u {
        if stale {
            bands[band_index].step = frame.step;
            bands[band_index].ticks = frame.ticks;
            bands[band_index].tested = atomicLoad(&tested);
        }
        if TEST {
            bands[band_index].counts =
                vec4<u32>(pair_count(0u), pair_count(2u), pair_count(4u), pair_count(6u));
            bands[band_index].culled = vec2<u32>(pair_count(8u), pair_count(10u));
        }
    }
    if TEST && lane < BAND / 2u {
        decisions[band_index * (BAND / 2u) + lane] = atomicLoad(&packed[lane]);
    }
}
