// Blade update: one thread a blade, one workgroup a band of 64, or the anchors of several far patches.
// Physics, the blade tests, the level.

override SIMULATE: bool = true;
override TEST: bool = true;

@group(2) @binding(1) var<storage, read_write> bands: array<GpuBand>;
@group(2) @binding(2) var<storage, read> work: array<vec2<u32>>;
@group(2) @binding(3) var<storage, read_write> dynamics: array<vec2<u32>>;
// Chunks near each patch
@group(2) @binding(4) var<storage, read> near: array<u32>;
// Two blades a word, 16 bits each: bucket 4, morph 5, fade 5
@group(2) @binding(5) var<storage, read_write> decisions: array<u32>;

// Step and time when blades were last advanced.
struct Clock {
    step: u32,
    ticks: u32,
}

fn advance(blade: Blade, state: BladeState, clock: Clock, patch_index: u32) -> BladeState {
    var gap = frame.dt_s;
    if clock.step + 1u != frame.step {
        gap = f32(frame.ticks - clock.ticks) / 16384.0;
    }
    if is_paper_model() {
        return advance_paper(blade, state, gap, patch_index);
    }
    return advance_sward(blade, state, gap, patch_index);
}

// Tests against primitives, and the sum of the anchors' displacements from rest in 1/65536 of a height,
// by patch: integers add up to the same in any order
var<workgroup> tested: array<atomic<u32>, 32>;
var<workgroup> displaced: array<atomic<i32>, 96>;

// Which patch of the group's.
fn patch_slot(lane: u32) -> u32 {
    if ANCHORS {
        return lane / anchor_lanes();
    }
    return 0u;
}

fn add_displacement(slot: u32, displacement: vec3<f32>) {
    let steps = vec3<i32>(round(displacement * 65536.0));
    atomicAdd(&displaced[3u * slot], steps.x);
    atomicAdd(&displaced[3u * slot + 1u], steps.y);
    atomicAdd(&displaced[3u * slot + 2u], steps.z);
}

fn mean_displacement(slot: u32, count: u32) -> vec3<f32> {
    let sum = vec3<i32>(
        atomicLoad(&displaced[3u * slot]),
        atomicLoad(&displaced[3u * slot + 1u]),
        atomicLoad(&displaced[3u * slot + 2u]),
    );
    return vec3<f32>(sum) / (65536.0 * f32(count));
}

// What a leader writes of blades that were advanced.
fn note_advance(task: Task, slot: u32) {
    let band = task_band(task);
    // Some may have been advanced before in this step: the anchors, for another view
    var tests = atomicLoad(&tested[slot]);
    if bands[band].anchor_step == frame.step {
        tests += bands[band].tested;
    } else if task.local == 0u {
        let sway = mean_displacement(slot, anchor_count(task.count));
        bands[band].sway = pack_sway(sway);
    }
    bands[band].tested = tests;
    bands[band].anchor_step = frame.step;
    bands[band].anchor_ticks = frame.ticks;
    if !ANCHORS {
        bands[band].step = frame.step;
        bands[band].ticks = frame.ticks;
    }
}

fn note_tests(task: Task, lane: u32) {
    let band = task_band(task);
    let beside = lanes_beside(lane);
    // Of a far patch's first band only the anchors are run
    let idle = select(0u, min(task.count, BAND) - anchor_count(task.count), ANCHORS);
    bands[band].counts = array<vec4<u32>, 2>(bucket_counts(0u, beside), bucket_counts(8u, beside));
    bands[band].culled = failed_counts(beside) + (idle << 16u);
}

// When the blade was last advanced.
fn clock_of(task: Task) -> Clock {
    let band = task_band(task);
    if task.local < anchor_count(task.count) {
        return Clock(bands[band].anchor_step, bands[band].anchor_ticks);
    }
    return Clock(bands[band].step, bands[band].ticks);
}

@compute @workgroup_size(64)
fn update(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let task = task_of(group.x, lane);
    let slot = patch_slot(lane);
    let index = task.patch_index * page.field.patch_size + task.local;
    let clock = clock_of(task);
    let stale = SIMULATE && clock.step != frame.step;
    // Whether a leader has anything to write: all others of a band are no anchors
    let band_step = bands[task_band(task)].step;
    var decision = Decision(NO_BUCKET, 0u);
    if task.given && (stale || TEST) {
        let blade = unpack_blade(index);
        var state = unpack_state(blade, dynamics[index]);
        if stale {
            state = advance(blade, state, clock, task.patch_index);
            if tests_made > 0u {
                atomicAdd(&tested[slot], tests_made);
            }
            let bits = pack_state(blade, state);
            dynamics[index] = bits;
            // Test what will be drawn: the quantised state
            state = unpack_state(blade, bits);
            if task.local < anchor_count(task.count) {
                add_displacement(slot, state.tip - rest_tip(blade));
            }
        }
        if TEST {
            let rank = (f32(task.local) + 0.5) / f32(task.count);
            decision = decide(blade, state, Place(task.local, task.count, rank, 1.0), task.inside);
        }
    }
    if TEST {
        vote(lane, decision);
    }
    workgroupBarrier();
    // All have read the band before it is written
    storageBarrier();
    if is_leader(lane) && task.given {
        if stale || (SIMULATE && !ANCHORS && band_step != frame.step) {
            note_advance(task, slot);
        }
        if TEST {
            note_tests(task, lane);
        }
    }
    if TEST && task.given && (lane & 1u) == 0u {
        let word = (task_band(task) * BAND + task.local % BAND) / 2u;
        decisions[word] = atomicLoad(&packed[lane >> 1u]);
    }
}
