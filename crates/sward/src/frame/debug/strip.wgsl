// Strips as a debug view shows them.

struct DebugStripVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) place: vec2<f32>,
    @location(1) @interpolate(perspective, centroid) grid: vec2<f32>,
    @location(2) @interpolate(flat) layer: u32,
    @location(3) @interpolate(flat) color: vec3<f32>,
}

@vertex
fn vs_debug_strip(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> DebugStripVertex {
    let own = strip_vertex(vertex, instance);
    let grid = grid_place(vertex % VERTICES, 3u);
    let color = debug_color_of(listed_plant(vertex, instance));
    return DebugStripVertex(own.clip, own.place, grid, own.look.x, color);
}

@fragment
fn fs_debug_strip(in: DebugStripVertex) -> DebugPixel {
    let uv = vec2<f32>(0.5 + 0.5 * in.place.x, 1.0 - in.place.y);
    let texel = textureSample(plant_color, picture_sampler, uv, in.layer);
    let pixel = debug_pixel(in.color, in.place.y, outline_alpha(texel.a, 1.0), in.grid);
    if pixel.samples == 0u {
        discard;
    }
    return pixel;
}
