// What every pass round the grass reads: group 0.

struct GpuStageFrame {
    clip_from_world: mat4x4<f32>,
    view_from_clip: mat4x4<f32>,
    world_from_view: mat4x4<f32>,
    // Metres
    eye: vec4<f32>,
    // xyz unit direction from the ground to the sun, w the share of its disc that shows
    to_sun: vec4<f32>,
    // Irradiance of the sun, of the sky from above, of the ground from below
    sun: vec4<f32>,
    sky: vec4<f32>,
    ground: vec4<f32>,
    // Radiance of the background overhead and at the horizon; w of both: x and z of the horizontal
    // direction to the sun, where the background is a table
    zenith: vec4<f32>,
    horizon: vec4<f32>,
    // rgb colour of the haze, w share of the light lost to it a metre
    haze: vec4<f32>,
    // rgb colour of the fog, w share of the light lost to it a metre
    fog: vec4<f32>,
    // x metres from the eye to where it starts, y height where it is that dense, z 1 over the metres
    // of height in which it thins to 1/e
    fog_shape: vec4<f32>,
    // x metres in focus, y pixels across of the disc that is infinitely far, z and w standard
    // deviations of the two blurred copies in pixels
    lens: vec4<f32>,
    exposure: f32,
    // Samples of the target that a side of a pixel has: what is a pixel wide is so many of them
    samples_a_side: f32,
    // 1 where ground stands for the grass that is too far to be drawn, 0 where all is drawn
    stands_in: f32,
    // Share of the picture that is seen without colour, as by the moon
    rods: f32,
    // Moving shade, as the library's
    shade: vec4<f32>,
    shade_offset: vec2<f32>,
    reserved_more: vec2<f32>,
}

@group(0) @binding(0) var<uniform> frame: GpuStageFrame;

const PI = 3.14159265;

// Unit direction, in the world, of the ray through a point of the screen.
fn ray(ndc: vec2<f32>) -> vec3<f32> {
    let far = frame.view_from_clip * vec4(ndc, 1.0, 1.0);
    return normalize((frame.world_from_view * vec4(far.xyz / far.w, 0.0)).xyz);
}
