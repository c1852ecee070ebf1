// The picture as it is, in linear light.

@group(1) @binding(0) var color: texture_2d<f32>;

@fragment
fn linear(in: Fullscreen) -> @location(0) vec4<f32> {
    return vec4(textureLoad(color, vec2<i32>(in.position.xy), 0).rgb, 1.0);
}
