// The host's pattern of shade.

fn sun_shade(place: vec3<f32>) -> f32 {
    let offset = vec2<f32>(frame.shade_x, frame.shade_y);
    return shade_pattern(place, frame.to_sun.xyz, frame.shade, offset);
}
