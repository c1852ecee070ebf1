// Blades as a debug view shows them. Every triangle has vertices of its own, so that its edges can be
// found without a feature of the adapter.

// Indices of one blade
override INDICES: u32 = 90u;
// Most indices of a blade, in vectors of four
const CORNER_STRIDE: u32 = 24u;

struct GpuDebug {
    // 0 patches, 1 culling, 2 level, 3 awake, 4 crush, 5 wireframe
    mode: u32,
    reserved_a: u32,
    reserved_b: u32,
    reserved_c: u32,
    // Linear RGB by what the view tells apart
    palette: array<vec4<f32>, 8>,
}

@group(3) @binding(0) var<uniform> debug: GpuDebug;
// Vertex of each index of a blade, by bucket
@group(3) @binding(1) var<uniform> corners: array<vec4<u32>, 192>;
@group(3) @binding(2) var<storage, read> explained: array<u32>;

const PATCHES: u32 = 0u;
const CULLING: u32 = 1u;
const LEVEL: u32 = 2u;
const AWAKE: u32 = 3u;
const CRUSH: u32 = 4u;
const WIREFRAME: u32 = 5u;

// Half the width of an edge, pixels: two triangles share it.
const EDGE_PX: f32 = 0.6;

struct DebugVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) color: vec3<f32>,
    @location(1) @interpolate(perspective, centroid) place: vec3<f32>,
    // 1 at a corner and 0 along the edge across from it
    @location(2) @interpolate(linear, centroid) weights: vec3<f32>,
    @location(3) @interpolate(flat) lobed: u32,
}

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

fn debug_color(index: u32, morph: f32, own: vec3<f32>) -> vec3<f32> {
    switch debug.mode {
        case PATCHES: { return patch_color((field.first_id + index) / field.patch_size); }
        case CULLING: { return culling_color(explained[index]); }
        case LEVEL: {
            let next = debug.palette[min(BUCKET % 4u + 1u, 3u)].rgb;
            return mix(debug.palette[BUCKET % 4u].rgb, next, morph);
        }
        case AWAKE: { return awake_color(explained[index]); }
        case CRUSH: { return crush_color(unpack_state(unpack_blade(index), dynamics[index]).crush); }
        default: { return mix(debug.palette[0].rgb, own, 0.5); }
    }
}

@vertex
fn vs_debug(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> DebugVertex {
    let blade = vertex / INDICES;
    let corner = vertex % INDICES;
    let own = corners[BUCKET * CORNER_STRIDE + corner / 4u][corner % 4u];
    let point = blade_point(blade * VERTICES + own, instance);
    var out: DebugVertex;
    out.clip = HIDDEN;
    if point.hidden {
        return out;
    }
    let entry = list[draws[BUCKET].start + instance * BAND + blade];
    let morph = f32((entry >> 22u) & 31u) / 31.0;
    out.clip = point.clip;
    // Darker towards the root, so that blades stand apart
    let shade = mix(0.35, 1.0, clamp(point.height_share, 0.0, 1.0));
    out.color = debug_color(entry & 0x3fffffu, morph, point.albedo) * shade;
    out.place = place_of(point);
    out.weights = vec3<f32>(f32(corner % 3u == 0u), f32(corner % 3u == 1u), f32(corner % 3u == 2u));
    out.lobed = u32(point.shape == LOBED);
    return out;
}

// Samples of a pixel that lie on an edge of the triangle.
fn edge_samples(weights: vec3<f32>) -> u32 {
    let pixels = weights / max(fwidth(weights), vec3<f32>(1e-6));
    let nearest = min(pixels.x, min(pixels.y, pixels.z));
    let covered = clamp(EDGE_PX + 0.5 - nearest, 0.0, 1.0);
    return (1u << u32(round(covered * f32(SAMPLES)))) - 1u;
}

@fragment
fn fs_debug(in: DebugVertex) -> Cut {
    let inside = samples_of(in.place, in.lobed);
    let edges = edge_samples(in.weights);
    // A leaf's edges are those of its strip
    let samples = select(inside, edges, debug.mode == WIREFRAME);
    if samples == 0u {
        discard;
    }
    return Cut(vec4<f32>(max(in.color, vec3<f32>(0.0)), 1.0), samples);
}
