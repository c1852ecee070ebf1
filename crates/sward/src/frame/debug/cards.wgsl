// Plants of textured quads, strips and models as a debug view shows them: one colour each, cut as their
// pictures are.

struct DebugPixel {
    @location(0) color: vec4<f32>,
    @builtin(sample_mask) samples: u32,
}

// Where a vertex is in the grid of its form: columns are side by side, rows from bottom to top. Between
// four of them lie two triangles, parted from the lower right to the upper left.
fn grid_place(corner: u32, columns: u32) -> vec2<f32> {
    return vec2<f32>(f32(corner % columns), f32(corner / columns));
}

// Pixels to the nearest edge of the triangle.
fn pixels_to_edge(grid: vec2<f32>) -> f32 {
    let cell = fract(grid);
    let sides = min(cell, 1.0 - cell) / max(fwidth(grid), vec2<f32>(1e-6));
    let parted = abs(cell.x + cell.y - 1.0) / max(fwidth(grid.x + grid.y), 1e-6);
    return min(min(sides.x, sides.y), parted);
}

// A pixel of which so much is covered, `height_share` up its plant.
fn debug_pixel(color: vec3<f32>, height_share: f32, alpha: f32, grid: vec2<f32>) -> DebugPixel {
    let inside = samples_of_share(alpha);
    let edges = edge_samples(pixels_to_edge(grid));
    let samples = select(inside, edges, debug.mode == WIREFRAME);
    // Darker towards the roots, as blades are
    let shade = mix(0.35, 1.0, clamp(height_share, 0.0, 1.0));
    return DebugPixel(vec4<f32>(color * shade, 1.0), samples);
}

fn debug_color_of(listed: Listed) -> vec3<f32> {
    let own = blade_color(unpack_blade(listed.index), 1.0);
    return debug_color(listed.index, listed.morph, own);
}
