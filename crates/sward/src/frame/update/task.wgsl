// What a lane does: a blade of a band, or of a far patch's anchors.

struct Task {
    patch_index: u32,
    // Number of the blade in its patch
    local: u32,
    // Blades of the patch
    count: u32,
    // No part of the patch is out of view
    inside: bool,
    // False for lanes that have nothing to do
    given: bool,
}

fn task_of(group: u32, lane: u32) -> Task {
    var entry: vec2<u32>;
    var local: u32;
    if ANCHORS {
        let lanes = anchor_lanes();
        entry = work[first_far_entry() + group * far_patches_a_group() + lane / lanes];
        local = lane & (lanes - 1u);
    } else {
        entry = work[group];
        local = (entry.y >> 16u) * BAND + lane;
    }
    var task: Task;
    task.patch_index = entry.x & 0x7fffffffu;
    task.local = local;
    task.count = patch_blades(task.patch_index);
    task.inside = (entry.x >> 31u) == 1u;
    // The last group of far patches may have fewer, and patches fewer anchors than lanes
    let end = select(task.count, anchor_count(task.count), ANCHORS);
    task.given = (entry.y & 0xffffu) != 0u && local < end;
    return task;
}

fn task_band(task: Task) -> u32 {
    return task.patch_index * bands_per_patch() + task.local / BAND;
}

// Lanes of the same band, or of the same patch's anchors, as bits of two words.
fn lanes_beside(lane: u32) -> vec2<u32> {
    if !ANCHORS {
        return vec2<u32>(0xffffffffu);
    }
    let lanes = anchor_lanes();
    let bits = (0xffffffffu >> (32u - lanes)) << (lane & 31u & ~(lanes - 1u));
    return select(vec2<u32>(bits, 0u), vec2<u32>(0u, bits), lane >= 32u);
}

// The first of them writes what all have found.
fn is_leader(lane: u32) -> bool {
    if ANCHORS {
        return (lane & (anchor_lanes() - 1u)) == 0u;
    }
    return lane == 0u;
}
