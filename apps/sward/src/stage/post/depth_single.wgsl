// The depth of a target with one sample a pixel.

@group(1) @binding(0) var depth: texture_depth_2d;

fn depth_at(pixel: vec2<i32>, sample: u32) -> f32 {
    return textureLoad(depth, pixel, 0);
}
