// How far out of focus what is at a place is: a thin lens.

// Along the line of sight, metres: the focus is a plane, not a sphere round the eye.
fn depth_along_sight(world: vec3<f32>) -> f32 {
    return -dot(world - frame.eye.xyz, frame.world_from_view[2].xyz);
}

// Variance of the blur along each axis, square pixels. A disc c pixels across has c c / 16.
fn blur_variance(depth_m: f32) -> f32 {
    let disc = frame.lens.y * abs(depth_m - frame.lens.x) / max(depth_m, 1e-3);
    return min(disc * disc / 16.0, frame.lens.w * frame.lens.w);
}

// The two blurred copies stand for these variances; each is a picture of half the size of the one
// before, which by itself blurs by about a pixel of that.
fn copy_variances() -> vec2<f32> {
    let sigma = max(frame.lens.zw, vec2(1.0, 2.0));
    return sigma * sigma;
}
