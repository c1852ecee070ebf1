// Mean of the samples of each pixel, of a multisampled target.

@group(1) @binding(0) var samples: texture_multisampled_2d<f32>;

@fragment
fn average(in: Fullscreen) -> @location(0) vec4<f32> {
    let pixel = vec2<i32>(in.position.xy);
    let count = i32(textureNumSamples(samples));
    var sum = vec4(0.0);
    for (var i = 0; i < count; i++) {
        sum += shown(textureLoad(samples, pixel, i));
    }
    return sum / f32(count);
}
