// The host's pattern of shade.

// False in pipelines for frames without one
override SHADED: bool = true;

fn sun_shade(place: vec3<f32>) -> f32 {
    if !SHADED {
        return 0.0;
    }
    let offset = vec2<f32>(frame.shade_x, frame.shade_y);
    return shade_pattern(place, frame.to_sun.xyz, frame.shade, offset);
}
