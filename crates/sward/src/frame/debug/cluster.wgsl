// Clusters as a debug view shows them: one colour each, cut as their pictures are.

struct DebugClusterVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) uv: vec2<f32>,
    @location(1) @interpolate(flat) color: vec3<f32>,
    @location(2) @interpolate(flat) cells: vec2<f32>,
    @location(3) @interpolate(flat) layer: u32,
    @location(4) @interpolate(flat) seed: u32,
    @location(5) @interpolate(flat) alpha: f32,
    @location(6) @interpolate(flat) mip: f32,
}

@vertex
fn vs_debug_cluster(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> DebugClusterVertex {
    let own = cluster_vertex(vertex, instance);
    let listed = listed_plant(vertex, instance);
    let mean = canopy.rows[3].shown.rgb;
    let color = debug_color(listed.index, 0.0, mean);
    return DebugClusterVertex(
        own.clip,
        own.uv,
        color,
        own.cells,
        own.layer,
        own.seed,
        own.alpha,
        own.mip,
    );
}

// Whether a pixel lies on the card's rim.
fn on_rim(uv: vec2<f32>) -> bool {
    let pixels = min(uv, 1.0 - uv) / max(fwidth(uv), vec2<f32>(1e-6));
    return min(pixels.x, pixels.y) < 1.0;
}

@fragment
fn fs_debug_cluster(in: DebugClusterVertex) -> ClusterPixel {
    let texel = textureSampleLevel(cluster_color, picture_sampler, in.uv, in.layer, in.mip);
    let rim = on_rim(in.uv);
    let inside = samples_covered(texel.a * in.alpha, grain(in.uv, in.cells, in.seed), in.seed);
    let samples = select(inside, select(0u, (1u << SAMPLES) - 1u, rim), debug.mode == WIREFRAME);
    if samples == 0u {
        discard;
    }
    // Darker towards the roots, as blades are
    let shade = mix(1.0, 0.35, in.uv.y);
    return ClusterPixel(vec4<f32>(in.color * shade, 1.0), samples);
}
