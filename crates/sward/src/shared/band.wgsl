// What is kept for each run of 64 blades: the unit of a workgroup.

struct GpuBand {
    // Step and time when its blades were last advanced
    step: u32,
    ticks: u32,
    // Blades that failed a test, two a word: orientation, frustum | distance, occlusion
    culled: vec2<u32>,
    // Survivors by bucket, two a word; after the scan, their offset in the block of 256 bands
    counts: array<vec4<u32>, 2>,
    // Tests against primitives made
    tested: u32,
    // Of a patch's first band: mean of its blades' tips when they were last advanced, in heights
    sway_x: f32,
    sway_y: f32,
    sway_z: f32,
}

// Bands of one block of the scan.
const BLOCK: u32 = 256u;

struct GpuBlock {
    // Survivors by bucket; after scan_totals, the place of the block's first one in the list
    buckets: array<u32, 16>,
    // Failed tests: orientation, frustum, distance, occlusion; tests against primitives; blades
    // moved; 2 unused
    counted: array<u32, 8>,
}
