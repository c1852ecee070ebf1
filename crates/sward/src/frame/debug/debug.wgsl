// Blades as a debug view shows them. Every triangle has vertices of its own, so that its edges can be
// found without a feature of the adapter.

// Indices of one blade
override INDICES: u32 = 90u;
// Most indices of a blade, in vectors of four
const CORNER_STRIDE: u32 = 24u;

// Vertex of each index of a blade, by bucket of blades
@group(3) @binding(1) var<uniform> corners: array<vec4<u32>, 192>;

struct DebugVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) color: vec3<f32>,
    @location(1) @interpolate(perspective, centroid) place: vec3<f32>,
    // 1 at a corner and 0 along the edge across from it
    @location(2) @interpolate(linear, centroid) weights: vec3<f32>,
    @location(3) @interpolate(flat) lobed: u32,
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

@fragment
fn fs_debug(in: DebugVertex) -> Cut {
    let inside = samples_of(in.place, in.lobed);
    let pixels = in.weights / max(fwidth(in.weights), vec3<f32>(1e-6));
    let edges = edge_samples(min(pixels.x, min(pixels.y, pixels.z)));
    // A leaf's edges are those of its strip
    let samples = select(inside, edges, debug.mode == WIREFRAME);
    if samples == 0u {
        discard;
    }
    return Cut(vec4<f32>(max(in.color, vec3<f32>(0.0)), 1.0), samples);
}
