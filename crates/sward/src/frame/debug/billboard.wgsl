// Plants of quads as a debug view shows them.

struct DebugQuadVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) place: vec2<f32>,
    @location(1) @interpolate(perspective, centroid) grid: vec2<f32>,
    @location(2) @interpolate(perspective, centroid) position: vec3<f32>,
    @location(3) @interpolate(perspective, centroid) side: vec3<f32>,
    @location(4) @interpolate(perspective, centroid) along: vec3<f32>,
    @location(5) @interpolate(flat) up: vec3<f32>,
    @location(6) @interpolate(flat) gone_whole: vec2<f32>,
    @location(7) @interpolate(flat) layer: u32,
    @location(8) @interpolate(flat) color: vec3<f32>,
}

@vertex
fn vs_debug_quad(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> DebugQuadVertex {
    let own = quad_vertex(vertex, instance);
    return DebugQuadVertex(
        own.clip,
        own.place,
        grid_place(vertex % VERTICES, 2u),
        own.position,
        own.side,
        own.along,
        own.up,
        own.size.zw,
        own.layer,
        debug_color_of(listed_plant(vertex, instance)),
    );
}

@fragment
fn fs_debug_quad(in: DebugQuadVertex) -> DebugPixel {
    let uv = vec2<f32>(in.place.x, 1.0 - in.place.y);
    let texel = textureSample(plant_color, picture_sampler, uv, in.layer);
    let to_eye = -view_ray(in.position);
    let face = unit_or(cross(in.side, in.along), in.up);
    let shown = facing_share(face, in.up, to_eye, in.gone_whole);
    let pixel = debug_pixel(in.color, in.place.y, outline_alpha(texel.a, shown), in.grid);
    if pixel.samples == 0u {
        discard;
    }
    return pixel;
}
