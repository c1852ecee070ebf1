@fragment
fn sky(in: Fullscreen) -> @location(0) vec4<f32> {
    return vec4(sky_radiance(ray(in.ndc)), 0.0);
}
