// One triangle that covers the screen, at the far plane.

struct Fullscreen {
    @builtin(position) position: vec4<f32>,
    @location(0) ndc: vec2<f32>,
}

@vertex
fn fullscreen(@builtin(vertex_index) index: u32) -> Fullscreen {
    let ndc = vec2(f32((index & 1u) * 4u), f32((index >> 1u) * 4u)) - 1.0;
    return Fullscreen(vec4(ndc, 1.0, 1.0), ndc);
}
