// What is kept for each run of 64 blades: the unit of a workgroup.

struct GpuBand {
    // Step and time when its blades were last advanced, but for anchors
    step: u32,
    ticks: u32,
    // Blades that failed a test, 8 bits each: orientation, frustum, distance, occlusion
    culled: u32,
    // Tests against primitives made in that step
    tested: u32,
    // Survivors by bucket, two a word; after the scan, their offset in the block of 256 bands
    counts: array<vec4<u32>, 2>,
    // Of a patch's first band: step and time when its anchors were last advanced
    anchor_step: u32,
    anchor_ticks: u32,
    // Likewise: what the wind has moved their tips by in the mean, see `pack_sway`
    sway: vec2<u32>,
}

// In heights; 16 bits an axis, up to 2.
fn pack_sway(sway: vec3<f32>) -> vec2<u32> {
    let half = 0.5 * sway;
    return vec2<u32>(pack2x16snorm(half.xy), pack2x16snorm(vec2<f32>(half.z, 0.0)));
}

fn unpack_sway(bits: vec2<u32>) -> vec3<f32> {
    return 2.0 * vec3<f32>(unpack2x16snorm(bits.x), unpack2x16snorm(bits.y).x);
}

// Plants that a cluster stands for.
const CLUSTER_BLADES: u32 = 32u;

// Whether a pipeline runs the anchors of far patches, in place of bands.
override ANCHORS: bool = false;

// Plants of a patch of so many that may be drawn as clusters: the first of its order.
fn anchor_count(count: u32) -> u32 {
    return (count + CLUSTER_BLADES - 1u) / CLUSTER_BLADES;
}

// Most bands of a block, which is what one group of the scan sums up: whole patches.
const BLOCK: u32 = 256u;

fn patches_a_block() -> u32 {
    return BLOCK / bands_per_patch();
}

fn bands_a_block() -> u32 {
    return patches_a_block() * bands_per_patch();
}

struct GpuBlock {
    // Survivors by bucket; after scan_totals, the place of the block's first one in the list
    buckets: array<u32, 16>,
    // Failed tests: orientation, frustum, distance, occlusion; tests against primitives; blades
    // moved; 2 unused
    counted: array<u32, 8>,
}
