// Mean of the samples of each pixel.

@group(1) @binding(0) var samples: texture_2d<f32>;

@fragment
fn average(in: Fullscreen) -> @location(0) vec4<f32> {
    let side = i32(frame.samples_a_side);
    let first = vec2<i32>(in.position.xy) * side;
    var sum = vec4(0.0);
    for (var y = 0; y < side; y++) {
        for (var x = 0; x < side; x++) {
            sum += shown(textureLoad(samples, first + vec2(x, y), 0));
        }
    }
    return sum / f32(side * side);
}
