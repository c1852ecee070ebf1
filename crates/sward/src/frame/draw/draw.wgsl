// Blades: near ones are lit at each pixel, far ones at their vertices, of which they have fewer than
// pixels are shaded where blades lie over each other.

// At the centroid of the covered samples: at a pixel's centre, which a sliver may miss by many of
// its own widths, a colour would be extrapolated to white or black.
struct NearVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) normal: vec3<f32>,
    @location(1) @interpolate(perspective, centroid) albedo: vec3<f32>,
    @location(2) @interpolate(perspective, centroid) position: vec3<f32>,
    @location(3) @interpolate(perspective, centroid) height_share: f32,
    @location(4) @interpolate(flat) up: vec3<f32>,
    @location(5) @interpolate(flat) root_open: f32,
    @location(6) @interpolate(flat) lean: f32,
    @location(7) @interpolate(flat) look: vec4<f32>,
}

struct FarVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) color: vec3<f32>,
}

fn lit(point: BladePoint) -> vec3<f32> {
    let to_eye = -view_ray(point.position);
    var surface: BladeSurface;
    surface.albedo = point.albedo;
    surface.normal = unit_or(point.normal, point.up);
    surface.up = point.up;
    surface.height_share = point.height_share;
    surface.root_open = point.root_open;
    surface.lean = point.lean;
    surface.shaded = sun_shade(point.position);
    let color = as_shown(shade_blade(surface, to_eye), point.look);
    return with_haze(color, distance_to(point.position));
}

fn near_vertex(point: BladePoint) -> NearVertex {
    if point.hidden {
        var out: NearVertex;
        out.clip = HIDDEN;
        return out;
    }
    return NearVertex(
        point.clip,
        point.normal,
        point.albedo,
        point.position,
        point.height_share,
        point.up,
        point.root_open,
        point.lean,
        point.look,
    );
}

fn near_color(in: NearVertex) -> vec4<f32> {
    var point: BladePoint;
    point.position = in.position;
    point.normal = in.normal;
    point.albedo = in.albedo;
    point.up = in.up;
    point.height_share = in.height_share;
    point.root_open = in.root_open;
    point.lean = in.lean;
    point.look = in.look;
    return vec4<f32>(lit(point), 1.0);
}

@vertex
fn vs_near(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> NearVertex {
    return near_vertex(blade_point(vertex, instance));
}

@fragment
fn fs_near(in: NearVertex) -> @location(0) vec4<f32> {
    return near_color(in);
}

@vertex
fn vs_far(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> FarVertex {
    let point = blade_point(vertex, instance);
    if point.hidden {
        return FarVertex(HIDDEN, vec3<f32>(0.0));
    }
    return FarVertex(point.clip, lit(point));
}

@fragment
fn fs_far(in: FarVertex) -> @location(0) vec4<f32> {
    return vec4<f32>(max(in.color, vec3<f32>(0.0)), 1.0);
}
