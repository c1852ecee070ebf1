// What debug views show, whichever form a plant has.

struct GpuDebug {
    // 0 patches, 1 culling, 2 level, 3 awake, 4 crush, 5 wireframe
    mode: u32,
    reserved_a: u32,
    reserved_b: u32,
    reserved_c: u32,
    // Linear RGB by what the view tells apart
    palette: array<vec4<f32>, 10>,
}

@group(3) @binding(0) var<uniform> debug: GpuDebug;
@group(3) @binding(2) var<storage, read> explained: array<u32>;

const PATCHES: u32 = 0u;
const CULLING: u32 = 1u;
const LEVEL: u32 = 2u;
const AWAKE: u32 = 3u;
const CRUSH: u32 = 4u;
const WIREFRAME: u32 = 5u;

// Half the width of an edge, pixels: two triangles share it.
const EDGE_PX: f32 = 0.6;

// A colour that no neighbour is likely to have: hue by the golden angle.
fn patch_color(patch_index: u32) -> vec3<f32> {
    let hue = 6.2831853 * hash01(patch_index, 31u);
    let turns = vec3<f32>(hue, hue - 2.0943951, hue + 2.0943951);
    let light = 0.22 + 0.3 * hash01(patch_index, 32u);
    return light * (vec3<f32>(1.0) + 0.85 * cos(turns));
}

// By the first test that fails: frustum, distance, occlusion, orientation.
fn culling_color(reasons: u32) -> vec3<f32> {
    var slot = 0u;
    slot = select(slot, 4u, (reasons & 1u) != 0u);
    slot = select(slot, 3u, (reasons & 8u) != 0u);
    slot = select(slot, 2u, (reasons & 4u) != 0u);
    slot = select(slot, 1u, (reasons & 2u) != 0u);
    return debug.palette[slot].rgb;
}

fn awake_color(reasons: u32) -> vec3<f32> {
    let moved = select(0u, 1u, (reasons & 32u) != 0u);
    return debug.palette[select(2u, moved, (reasons & 16u) != 0u)].rgb;
}

fn crush_color(crush: f32) -> vec3<f32> {
    let low = mix(debug.palette[0].rgb, debug.palette[1].rgb, clamp(crush, 0.0, 1.0));
    return mix(low, debug.palette[2].rgb, clamp(crush - 1.0, 0.0, 1.0));
}

// Clusters, and other forms than blades, come after the levels of blades; of each the finest comes first.
fn level_color(morph: f32) -> vec3<f32> {
    if BUCKET < CLUSTER_BUCKET {
        let next = debug.palette[min(BUCKET % 4u + 1u, 3u)].rgb;
        return mix(debug.palette[BUCKET % 4u].rgb, next, morph);
    }
    let slot = min(max(BUCKET, CLUSTER_BUCKET) - 4u, 9u);
    let turns = BUCKET == STRIP_BUCKET || BUCKET == BILLBOARD_BUCKET || BUCKET == MODEL_BUCKET;
    let next = debug.palette[select(min(slot + 1u, 9u), 7u, BUCKET == MODEL_BUCKET)].rgb;
    return mix(debug.palette[slot].rgb, next, select(0.0, morph, turns));
}

// The samples of a pixel of which so much is covered.
fn samples_of_share(covered: f32) -> u32 {
    return (1u << u32(round(covered * f32(SAMPLES)))) - 1u;
}

// Those that lie on an edge so many pixels away.
fn edge_samples(pixels: f32) -> u32 {
    return samples_of_share(clamp(EDGE_PX + 0.5 - pixels, 0.0, 1.0));
}

// All are reckoned and one is picked: a driver may make a shader anew in each frame for what branches on
// a uniform, and some break at it.
fn debug_color(index: u32, morph: f32, own: vec3<f32>) -> vec3<f32> {
    let reasons = explained[index];
    let crush = unpack_state(unpack_blade(index), dynamics[index]).crush;
    var color = mix(debug.palette[0].rgb, own, 0.5);
    let home = (page.field.first_id + index) / page.field.patch_size;
    color = select(color, patch_color(home), debug.mode == PATCHES);
    color = select(color, culling_color(reasons), debug.mode == CULLING);
    color = select(color, level_color(morph), debug.mode == LEVEL);
    color = select(color, awake_color(reasons), debug.mode == AWAKE);
    return select(color, crush_color(crush), debug.mode == CRUSH);
}
