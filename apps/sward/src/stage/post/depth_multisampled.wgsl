// The depth of a target with several samples a pixel.

@group(1) @binding(0) var depth: texture_depth_multisampled_2d;

fn depth_at(pixel: vec2<i32>, sample: u32) -> f32 {
    return textureLoad(depth, pixel, i32(sample));
}
