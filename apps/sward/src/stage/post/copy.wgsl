// The copies that are blurred, at half the size. `behind` holds only what is out of focus behind
// the plane in focus, times how much it is so: what is sharp, or nearer, then leaves no halo on it.
// `all` holds everything, and in w how far out of focus before the plane it is: there the
// surroundings show through the edges.

@group(1) @binding(0) var color: texture_2d<f32>;
@group(1) @binding(1) var position: texture_2d<f32>;

struct Copies {
    @location(0) behind: vec4<f32>,
    @location(1) all: vec4<f32>,
}

@fragment
fn copy(in: Fullscreen) -> Copies {
    let first = 2 * vec2<i32>(in.position.xy);
    let last = vec2<i32>(textureDimensions(color)) - 1;
    let variances = copy_variances();
    var copies = Copies(vec4(0.0), vec4(0.0));
    for (var i = 0; i < 4; i++) {
        let pixel = min(first + vec2(i & 1, i >> 1u), last);
        let light = textureLoad(color, pixel, 0).rgb;
        let depth_m = depth_along_sight(textureLoad(position, pixel, 0).xyz);
        let variance = blur_variance(depth_m);
        let before = depth_m < frame.lens.x;
        let behind = select(min(variance / variances.x, 1.0), 0.0, before);
        copies.behind += 0.25 * vec4(light * behind, behind);
        copies.all += 0.25 * vec4(light, select(0.0, variance / variances.y, before));
    }
    return copies;
}
