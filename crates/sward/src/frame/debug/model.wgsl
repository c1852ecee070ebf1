// Modelled plants as a debug view shows them.

struct DebugModelVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) height_share: f32,
    @location(1) @interpolate(perspective, centroid) grid: vec2<f32>,
    @location(2) @interpolate(flat) color: vec3<f32>,
}

@vertex
fn vs_debug_model(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> DebugModelVertex {
    let own = model_vertex(vertex, instance);
    let grid = grid_place(vertex % VERTICES, 2u);
    let color = debug_color_of(listed_plant(vertex, instance));
    return DebugModelVertex(own.clip, own.place.x, grid, color);
}

@fragment
fn fs_debug_model(in: DebugModelVertex) -> DebugPixel {
    let pixel = debug_pixel(in.color, in.height_share, 1.0, in.grid);
    if pixel.samples == 0u {
        discard;
    }
    return pixel;
}
