// Weighted sum of pictures in linear light, by two targets that take turns.

@group(1) @binding(0) var picture: texture_2d<f32>;
@group(1) @binding(1) var sum: texture_2d<f32>;

@fragment
fn accumulate(in: Fullscreen) -> @location(0) vec4<f32> {
    let pixel = vec2<i32>(in.position.xy);
    return textureLoad(sum, pixel, 0) + textureLoad(picture, pixel, 0) * frame.weight;
}
