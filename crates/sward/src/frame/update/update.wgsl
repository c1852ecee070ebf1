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

var<workgroup> tested: atomic<u32>;
// Sum of the tips of the patch's first band, in 1/65536 of a height: integers add up to the same in
// any order
var<workgroup> tips: array<atomic<i32>, 3>;

fn add_tip(tip: vec3<f32>) {
    let steps = vec3<i32>(round(tip * 65536.0));
    atomicAdd(&tips[0], steps.x);
    atomicAdd(&tips[1], steps.y);
    atomicAdd(&tips[2], steps.z);
}

fn mean_tip(axis: u32, count: u32) -> f32 {
    return f32(atomicLoad(&tips[axis])) / (65536.0 * f32(count));
}

// What one lane writes of a band whose blades were advanced; a patch's first band holds its mean tip.
fn note_advance(band_index: u32, is_first: bool, blades: u32) {
    bands[band_index].step = frame.step;
    bands[band_index].ticks = frame.ticks;
    bands[band_index].tested = atomicLoad(&tested);
    if is_first {
        bands[band_index].sway_x = mean_tip(0u, blades);
        bands[band_index].sway_y = mean_tip(1u, blades);
        bands[band_index].sway_z = mean_tip(2u, blades);
    }
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
            if group.y == 0u {
                add_tip(state.tip);
            }
        }
        if TEST {
            let place = Place(local, count, (f32(local) + 0.5) / f32(count), 1.0);
            decision = decide(blade, state, place, (entry.x >> 31u) == 1u);
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
            note_advance(band_index, group.y == 0u, min(count, BAND));
        }
        if TEST {
            bands[band_index].counts = array<vec4<u32>, 2>(bucket_counts(0u), bucket_counts(8u));
            bands[band_index].culled = vec2<u32>(pair_count(BUCKETS), pair_count(BUCKETS + 2u));
        }
    }
    if TEST && lane < BAND / 2u {
        decisions[band_index * (BAND / 2u) + lane] = atomicLoad(&packed[lane]);
    }
}
