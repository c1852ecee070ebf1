// The position target: world position of what is nearest in a pixel, and the share of the pixel's
// light that fog lets through, as the mean of its samples: at the edge of a near blade most of a
// pixel may be far ground.

override SAMPLES: u32 = 1u;

// The sky is put this far off: no thing is, and squares of it still fit.
const SKY_M = 1e9;

fn world_at(ndc: vec2<f32>, depth: f32) -> vec3<f32> {
    if depth >= 1.0 {
        return frame.eye.xyz + ray(ndc) * SKY_M;
    }
    let view = frame.view_from_clip * vec4(ndc, depth, 1.0);
    return (frame.world_from_view * vec4(view.xyz / view.w, 1.0)).xyz;
}

@fragment
fn position(in: Fullscreen) -> @location(0) vec4<f32> {
    // A reference's depth has many texels a pixel
    let side = u32(frame.samples_a_side);
    let first = vec2<i32>(in.position.xy) * i32(side);
    let count = side * side * SAMPLES;
    var nearest = 1.0;
    var clear = 0.0;
    for (var i = 0u; i < count; i++) {
        let texel = i / SAMPLES;
        let depth = depth_at(first + vec2<i32>(vec2(texel % side, texel / side)), i % SAMPLES);
        nearest = min(nearest, depth);
        if depth < 1.0 {
            clear += fog_clear(world_at(in.ndc, depth));
        } else {
            // The sky stays sky
            clear += 1.0;
        }
    }
    return vec4(world_at(in.ndc, nearest), clear / f32(count));
}
