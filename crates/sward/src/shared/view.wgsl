// A camera or a shadow cascade: group 2, binding 0 of the stages that need it.

struct GpuView {
    clip_from_world: mat4x4<f32>,
    // xyz eye in metres; w 1 for perspective, 0 for orthographic
    eye: vec4<f32>,
    // World to distance along the view direction: dot(xyz, p) + w
    depth_row: vec4<f32>,
    // Inward planes: left, right, bottom, top, near, far
    planes: array<vec4<f32>, 6>,
    // Linear depth = (x - d y) / (d z - w) for a depth value d
    depth_from_value: vec4<f32>,
    size: vec2<f32>,
    // Pixels that a metre covers at distance 1 (perspective) or at any (orthographic)
    focal: f32,
    // Multiplies projected sizes where detail is chosen
    detail: f32,
    // Blades thinner than this many pixels are thinned out and widened to it
    least_width: f32,
    max_distance: f32,
    // Bits: 0 frustum, 1 distance, 2 orientation, 3 occlusion, 4 paper, 5 width correction, 6 depth,
    // 7 swept
    flags: u32,
    // Most entries of the draw list
    capacity: u32,
    // Heights in pixels, times detail, that levels are chosen within: one level, where it is forced
    level_height: vec2<f32>,
    // Mean height of the grass in pixels where blades begin to turn into clusters, and where all have
    cluster_height: vec2<f32>,
    // 0 blades, 1 strips, 2 billboards, 3 continuum
    technique: u32,
    // Clusters narrower than this many pixels are thinned out and widened to it
    least_cluster: f32,
    // Of plants far off: share that is kept, and height
    far_share: f32,
    far_size: f32,
    // Where the bands of distance end, metres, and how much a plant's own differ
    bands: vec4<f32>,
    // Multiplies heights where segments are chosen
    level_scale: f32,
    reserved_a: f32,
    reserved_b: f32,
    reserved_c: f32,
}

const BLADES: u32 = 0u;
const STRIPS: u32 = 1u;
const BILLBOARDS: u32 = 2u;
const CONTINUUM: u32 = 3u;

@group(2) @binding(0) var<uniform> view: GpuView;

const CULL_FRUSTUM: u32 = 1u;
const CULL_DISTANCE: u32 = 2u;
const CULL_ORIENTATION: u32 = 4u;
const CULL_OCCLUSION: u32 = 8u;
const CULL_PAPER: u32 = 16u;
const WIDTH_CORRECTION: u32 = 32u;
const HAS_DEPTH: u32 = 64u;
// A sweep has found the cells that the view may see
const GROUND_SWEPT: u32 = 128u;

// Flags and technique of the views that a pipeline is made for: some drivers make a pipeline anew in
// each frame for what branches on a uniform. All bits, and 4: as the view says
override FLAGS: u32 = 0xffffffffu;
override TECHNIQUE: u32 = 4u;

fn has(flag: u32) -> bool {
    if FLAGS != 0xffffffffu {
        return (FLAGS & flag) != 0u;
    }
    return (view.flags & flag) != 0u;
}

fn technique() -> u32 {
    if TECHNIQUE < 4u {
        return TECHNIQUE;
    }
    return view.technique;
}

// Metres from the eye; of an orthographic view, from the plane of its eye.
fn distance_to(p: vec3<f32>) -> f32 {
    let ahead = abs(dot(view.depth_row.xyz, p) + view.depth_row.w);
    return select(ahead, distance(p, view.eye.xyz), view.eye.w > 0.5);
}

// Unit direction in which the view sees a point.
fn view_ray(p: vec3<f32>) -> vec3<f32> {
    let ray = (p - view.eye.xyz) / max(distance(p, view.eye.xyz), 1e-6);
    return select(view.depth_row.xyz, ray, view.eye.w > 0.5);
}

// Pixels that a metre covers at a distance; the same wherever the camera turns.
fn pixels_per_metre(distance: f32) -> f32 {
    return view.focal / select(1.0, max(distance, 0.01), view.eye.w > 0.5);
}
