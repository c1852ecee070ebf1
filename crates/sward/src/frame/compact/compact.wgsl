// Survivors to their places in the draw list, band by band.

@group(2) @binding(1) var<storage, read> bands: array<GpuBand>;
@group(2) @binding(2) var<storage, read> blocks: array<GpuBlock>;
@group(2) @binding(3) var<storage, read> work: array<vec2<u32>>;
@group(2) @binding(4) var<storage, read> decisions: array<u32>;
// Blade 22 bits, morph 5, fade 5
@group(2) @binding(5) var<storage, read_write> list: array<u32>;

var<workgroup> masks: array<atomic<u32>, 32>;

@compute @workgroup_size(64)
fn compact(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let task = task_of(group.x, lane);
    let band = task_band(task);
    let pair = decisions[(band * BAND + task.local % BAND) / 2u];
    let decision = (pair >> (16u * (task.local & 1u))) & 0xffffu;
    let bucket = select(NO_BUCKET, decision & 15u, task.given);
    let word = lane >> 5u;
    let bit = 1u << (lane & 31u);
    if bucket != NO_BUCKET {
        atomicOr(&masks[2u * bucket + word], bit);
    }
    workgroupBarrier();
    if bucket == NO_BUCKET {
        return;
    }
    let beside = lanes_beside(lane);
    var rank = countOneBits(atomicLoad(&masks[2u * bucket + word]) & beside[word] & (bit - 1u));
    if word == 1u {
        rank += countOneBits(atomicLoad(&masks[2u * bucket]) & beside.x);
    }
    let in_block = (bands[band].counts[bucket / 8u][(bucket / 2u) % 4u] >> (16u * (bucket & 1u))) & 0xffffu;
    let place = blocks[band / bands_a_block()].buckets[bucket] + in_block + rank;
    if place < view.capacity {
        let index = task.patch_index * page.field.patch_size + task.local;
        list[place] = index | ((decision >> 4u) << 22u);
    }
}
