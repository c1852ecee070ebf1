// Depth of the opaque scene, one sample a pixel: group 3, the host's.

@group(3) @binding(0) var opaque_depth: texture_depth_2d;

fn opaque_depth_at(pixel: vec2<i32>) -> f32 {
    return textureLoad(opaque_depth, pixel, 0);
}
