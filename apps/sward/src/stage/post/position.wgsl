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
    let pixel = vec2<i32>(in.position.xy);
    var nearest = 1.0;
    var clear = 0.0;
    for (var i = 0u; i < SAMPLES; i++) {
        let depth = depth_at(pixel, i);
        nearest = min(nearest, depth);
        if depth < 1.0 {
            clear += fog_clear(world_at(in.ndc, depth));
        } else {
            // The sky stays sky
            clear += 1.0;
        }
    }
    return vec4(world_at(in.ndc, nearest), clear / f32(SAMPLES));
}
