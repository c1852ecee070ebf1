// What a sample of the colour target shows: its alpha is above 0 where that is grass, 0 for other
// things, and minus the share of canopy where ground stands for grass that is not drawn.

// rgb as it is, w the share of grass.
fn shown(color: vec4<f32>) -> vec4<f32> {
    return vec4(color.rgb, select(clamp(-color.a, 0.0, 1.0), 1.0, color.a > 0.0));
}
