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
    let entry = work[group.x];
    let first = group.y * BAND;
    if first >= entry.y {
        return;
    }
    let patch_index = entry.x & 0x7fffffffu;
    let band = patch_index * bands_per_patch() + group.y;
    let pair = decisions[band * (BAND / 2u) + (lane >> 1u)];
    let decision = (pair >> (16u * (lane & 1u))) & 0xffffu;
    let bucket = decision & 15u;
    let word = lane >> 5u;
    let bit = 1u << (lane & 31u);
    if bucket != NO_BUCKET {
        atomicOr(&masks[2u * bucket + word], bit);
    }
    workgroupBarrier();
    if bucket == NO_BUCKET {
        return;
    }
    var rank = countOneBits(atomicLoad(&masks[2u * bucket + word]) & (bit - 1u));
    if word == 1u {
        rank += countOneBits(atomicLoad(&masks[2u * bucket]));
    }
    let in_block = (bands[band].counts[bucket / 8u][(bucket / 2u) % 4u] >> (16u * (bucket & 1u))) & 0xffffu;
    let place = blocks[band / BLOCK].buckets[bucket] + in_block + rank;
    if place < view.capacity {
        let index = patch_index * field.patch_size + first + lane;
        list[place] = index | ((decision >> 4u) << 22u);
    }
}
