// The picture behind its fog.

@group(1) @binding(0) var color: texture_2d<f32>;
@group(1) @binding(1) var position: texture_2d<f32>;

@fragment
fn fogged(in: Fullscreen) -> @location(0) vec4<f32> {
    let pixel = vec2<i32>(in.position.xy);
    let clear = textureLoad(position, pixel, 0).w;
    return vec4(mix(frame.fog.rgb, textureLoad(color, pixel, 0).rgb, clear), 1.0);
}
