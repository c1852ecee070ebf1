// Offsets of the survivors, by prefix sums over the bands: the same frame gives the same list.

struct IndirectDraw {
    index_count: u32,
    instance_count: u32,
    first_index: u32,
    base_vertex: i32,
    first_instance: u32,
}

@group(2) @binding(1) var<storage, read_write> bands: array<GpuBand>;
@group(2) @binding(2) var<storage, read_write> blocks: array<GpuBlock>;
@group(2) @binding(3) var<storage, read_write> draws: array<GpuDraw, 16>;
@group(2) @binding(4) var<storage, read_write> indirect: array<IndirectDraw, 16>;
@group(2) @binding(5) var<storage, read_write> counted: array<u32, 8>;
// Indices that one plant takes in each bucket
@group(2) @binding(6) var<uniform> blade_indices: array<vec4<u32>, 4>;
@group(2) @binding(7) var<uniform> seen_blocks: array<vec4<u32>, 68>;

var<workgroup> low_sums: array<vec4<u32>, 256>;
var<workgroup> high_sums: array<vec4<u32>, 256>;
// What a block counts beside its survivors
const COUNTED: u32 = 8u;
var<workgroup> failed: array<atomic<u32>, 8>;

// Blades of a band that were advanced in this step: all, or the anchors only.
fn blades_moved(band: u32) -> u32 {
    let first = (band % bands_per_patch()) * BAND;
    let count = patch_blades(band / bands_per_patch());
    if bands[band].step == frame.step {
        return min(max(count, first) - first, BAND);
    }
    let anchors = first == 0u && bands[band].anchor_step == frame.step;
    return select(0u, anchor_count(count), anchors);
}

@compute @workgroup_size(256)
fn scan_blocks(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let band_count = page.field.patch_count * bands_per_patch();
    let block = seen_block(group.x);
    let index = block * bands_a_block() + lane;
    let is_band = lane < bands_a_block() && index < band_count;
    var own = array<vec4<u32>, 2>();
    if is_band {
        own = bands[index].counts;
        let culled = bands[index].culled;
        atomicAdd(&failed[0], culled & 0xffu);
        atomicAdd(&failed[1], (culled >> 8u) & 0xffu);
        atomicAdd(&failed[2], (culled >> 16u) & 0xffu);
        atomicAdd(&failed[3], culled >> 24u);
        let moved = blades_moved(index);
        if moved > 0u {
            atomicAdd(&failed[4], bands[index].tested);
            atomicAdd(&failed[5], moved);
        }
    }
    // 256 bands of 64 blades: a half word holds the sum
    low_sums[lane] = own[0];
    high_sums[lane] = own[1];
    workgroupBarrier();
    for (var step = 1u; step < BLOCK; step *= 2u) {
        var low = vec4<u32>(0u);
        var high = vec4<u32>(0u);
        if lane >= step {
            low = low_sums[lane - step];
            high = high_sums[lane - step];
        }
        workgroupBarrier();
        low_sums[lane] += low;
        high_sums[lane] += high;
        workgroupBarrier();
    }
    if is_band {
        bands[index].counts[0] = low_sums[lane] - own[0];
        bands[index].counts[1] = high_sums[lane] - own[1];
    }
    if lane < BUCKETS {
        let pairs = array<vec4<u32>, 2>(low_sums[BLOCK - 1u], high_sums[BLOCK - 1u]);
        let pair = pairs[lane / 8u][(lane / 2u) % 4u];
        blocks[block].buckets[lane] = (pair >> (16u * (lane & 1u))) & 0xffffu;
    }
    if lane < COUNTED {
        blocks[block].counted[lane] = atomicLoad(&failed[lane]);
    }
}

const LANES: u32 = 16u;
var<workgroup> lane_sums: array<u32, 256>;
var<workgroup> totals: array<u32, 16>;
var<workgroup> starts: array<u32, 16>;

fn write_draw(bucket: u32) {
    let start = min(starts[bucket], view.capacity);
    let end = min(starts[bucket] + totals[bucket], view.capacity);
    draws[bucket] = GpuDraw(start, end - start, totals[bucket] - (end - start), 0u);
    let indices = blade_indices[bucket / 4u][bucket % 4u];
    indirect[bucket] = IndirectDraw(indices * BAND, (end - start + BAND - 1u) / BAND, 0u, 0, 0u);
}

// One workgroup: 16 buckets by 16 lanes, each lane a run of blocks.
@compute @workgroup_size(256)
fn scan_totals(@builtin(local_invocation_index) thread: u32) {
    let block_count = seen_block_count();
    let bucket = thread / LANES;
    let lane = thread % LANES;
    let run = (block_count + LANES - 1u) / LANES;
    let begin = min(lane * run, block_count);
    let end = min(begin + run, block_count);
    var sum = 0u;
    var tests = 0u;
    for (var b = begin; b < end; b++) {
        let block = seen_block(b);
        sum += blocks[block].buckets[bucket];
        tests += blocks[block].counted[bucket % COUNTED];
    }
    lane_sums[thread] = sum;
    if bucket < COUNTED {
        atomicAdd(&failed[bucket], tests);
    }
    workgroupBarrier();
    var before = 0u;
    for (var l = 0u; l < lane; l++) {
        before += lane_sums[bucket * LANES + l];
    }
    if lane == LANES - 1u {
        totals[bucket] = before + sum;
    }
    workgroupBarrier();
    if lane == 0u {
        var start = 0u;
        for (var b = 0u; b < bucket; b++) {
            start += totals[b];
        }
        starts[bucket] = start;
        if bucket < COUNTED {
            counted[bucket] = atomicLoad(&failed[bucket]);
        }
        write_draw(bucket);
    }
    workgroupBarrier();
    var place = starts[bucket] + before;
    for (var b = begin; b < end; b++) {
        let block = seen_block(b);
        let own = blocks[block].buckets[bucket];
        blocks[block].buckets[bucket] = place;
        place += own;
    }
}
