// Depth of the opaque scene, several samples a pixel: group 3, the host's.

@group(3) @binding(0) var opaque_depth: texture_depth_multisampled_2d;

// The farthest sample: a pixel hides a point only where all of it does.
fn opaque_depth_at(pixel: vec2<i32>) -> f32 {
    var farthest = 0.0;
    let count = i32(textureNumSamples(opaque_depth));
    for (var i = 0; i < count; i++) {
        farthest = max(farthest, textureLoad(opaque_depth, pixel, i));
    }
    return farthest;
}
