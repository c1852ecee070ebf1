// Blades with a lobed outline: those of draw.wgsl with a place on the blade, by which pixels are cut.

struct LobedNearVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) normal: vec3<f32>,
    @location(1) @interpolate(perspective, centroid) albedo: vec3<f32>,
    @location(2) @interpolate(perspective, centroid) position: vec3<f32>,
    @location(3) @interpolate(perspective, centroid) place: vec3<f32>,
    @location(4) @interpolate(flat) up: vec3<f32>,
    @location(5) @interpolate(flat) root_open: f32,
    @location(6) @interpolate(flat) lean: f32,
    @location(7) @interpolate(flat) look: vec4<f32>,
    @location(8) @interpolate(flat) lobed: u32,
}

struct LobedFarVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) color: vec3<f32>,
    @location(1) @interpolate(perspective, centroid) place: vec3<f32>,
    @location(2) @interpolate(flat) lobed: u32,
}

struct Cut {
    @location(0) color: vec4<f32>,
    @builtin(sample_mask) samples: u32,
}

const WHOLE: u32 = 0xffffffffu;

fn place_of(point: BladePoint) -> vec3<f32> {
    return vec3<f32>(point.height_share, point.u, point.thin);
}

// Derivatives are taken before anything branches.
fn samples_of(place: vec3<f32>, lobed: u32) -> u32 {
    return select(WHOLE, leaf_samples(place), lobed == 1u);
}

@vertex
fn vs_near_lobed(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> LobedNearVertex {
    let point = blade_point(vertex, instance);
    let own = near_vertex(point);
    return LobedNearVertex(
        own.clip,
        own.normal,
        own.albedo,
        own.position,
        place_of(point),
        own.up,
        own.root_open,
        own.lean,
        own.look,
        u32(point.shape == LOBED),
    );
}

@fragment
fn fs_near_lobed(in: LobedNearVertex) -> Cut {
    let samples = samples_of(in.place, in.lobed);
    if samples == 0u {
        discard;
    }
    let own = NearVertex(
        in.clip,
        in.normal,
        in.albedo,
        in.position,
        in.place.x,
        in.up,
        in.root_open,
        in.lean,
        in.look,
    );
    return Cut(near_color(own), samples);
}

@vertex
fn vs_far_lobed(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> LobedFarVertex {
    let point = blade_point(vertex, instance);
    if point.hidden {
        return LobedFarVertex(HIDDEN, vec3<f32>(0.0), vec3<f32>(0.0), 0u);
    }
    return LobedFarVertex(point.clip, lit(point), place_of(point), u32(point.shape == LOBED));
}

@fragment
fn fs_far_lobed(in: LobedFarVertex) -> Cut {
    let samples = samples_of(in.place, in.lobed);
    if samples == 0u {
        discard;
    }
    return Cut(vec4<f32>(max(in.color, vec3<f32>(0.0)), 1.0), samples);
}
