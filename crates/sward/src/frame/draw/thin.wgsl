// Plants that are thin on the screen. A pixel shows the mean of all that lies in it; where one sample
// picks one of several blades, far grass flickers between them. So their look goes towards the mean of
// the patch, by as much as the pixels of many samples would: its spread was measured on fields drawn
// with 64 samples a pixel, as share of that of one sample, by the width of blades in pixels w:
// 0.43 at 0.77, 0.49 at 0.94, 0.59 at 1.53, 0.69 at 2.2, 0.79 at 3, 0.85 at 3.8. What is drawn is
// w w / (w w + 0.7): the same where blades are thinner than a pixel, of which there are most, and nearer to
// the blade's own look where it is wider, so that single blades can be told apart.

@group(2) @binding(4) var<uniform> canopy: GpuCanopy;
// By patch: rgb the mean radiance; a blades that a ray meets, 0 where none is known
@group(2) @binding(3) var<storage, read> patch_light: array<vec4<f32>>;

// How far one plant's look differs from the mean: 1 as it is, 0 not at all.
fn contrast(width_px: f32) -> f32 {
    let one = width_px * width_px / (width_px * width_px + 0.7);
    // Samples of one pixel have that much in common
    let in_all = one * one;
    return one * inverseSqrt(in_all + (1.0 - in_all) / f32(SAMPLES));
}

// rgb the mean that a plant of this width is drawn towards; a how far it differs.
fn thin_look(index: u32, width_px: f32) -> vec4<f32> {
    if technique() != CONTINUUM {
        return vec4<f32>(0.0, 0.0, 0.0, 1.0);
    }
    let mean = patch_light[index / page.field.patch_size];
    var color = mean.rgb;
    if TINTED {
        color = canopy_tinted(color, unpack_color(tints[index]));
    }
    return vec4<f32>(color, select(1.0, contrast(width_px), mean.a > 0.0));
}

// A plant's light as a pixel shows it.
fn as_shown(own: vec3<f32>, look: vec4<f32>) -> vec3<f32> {
    return mix(look.rgb, own, look.a);
}
