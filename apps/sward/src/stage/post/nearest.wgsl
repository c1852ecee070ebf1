// Of the positions of many pictures of one place the nearest, and the weighted sum of what fog
// lets through.

@group(1) @binding(0) var position: texture_2d<f32>;
@group(1) @binding(1) var sum: texture_2d<f32>;

@fragment
fn nearest(in: Fullscreen) -> @location(0) vec4<f32> {
    let pixel = vec2<i32>(in.position.xy);
    let before = textureLoad(sum, pixel, 0);
    let now = textureLoad(position, pixel, 0);
    let nearer = distance(now.xyz, frame.eye.xyz) < distance(before.xyz, frame.eye.xyz);
    // A new target is all zero: nothing is seen at no share of its light
    let first = all(before == vec4(0.0));
    return vec4(select(before.xyz, now.xyz, nearer || first), before.w + now.w * frame.weight);
}
