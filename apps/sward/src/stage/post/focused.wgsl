// The picture as a lens shows it: mixed with its blurred copies by the distance to the plane in focus.

@group(1) @binding(0) var color: texture_2d<f32>;
@group(1) @binding(1) var position: texture_2d<f32>;
@group(1) @binding(2) var behind_1: texture_2d<f32>;
@group(1) @binding(3) var all_1: texture_2d<f32>;
@group(1) @binding(4) var behind_2: texture_2d<f32>;
@group(1) @binding(5) var all_2: texture_2d<f32>;

// A copy between its texels; `scale` of the picture's pixels are one.
fn between(copy: texture_2d<f32>, at: vec2<f32>, scale: f32) -> vec4<f32> {
    let place = at / scale - 0.5;
    let first = vec2<i32>(floor(place));
    let last = vec2<i32>(textureDimensions(copy)) - 1;
    let share = place - floor(place);
    var row: array<vec4<f32>, 2>;
    for (var y = 0; y < 2; y++) {
        let left = clamp(first + vec2(0, y), vec2(0), last);
        let right = clamp(first + vec2(1, y), vec2(0), last);
        row[y] = mix(textureLoad(copy, left, 0), textureLoad(copy, right, 0), share.x);
    }
    return mix(row[0], row[1], share.y);
}

// Of three pictures blurred more and more: the mix has that variance.
fn blurred(sharp: vec3<f32>, one: vec3<f32>, two: vec3<f32>, variance: f32) -> vec3<f32> {
    let v = copy_variances();
    if variance < v.x {
        return mix(sharp, one, variance / v.x);
    }
    return mix(one, two, clamp((variance - v.x) / max(v.y - v.x, 1e-6), 0.0, 1.0));
}

// What a weighted copy holds; where it holds nothing, the other.
fn weighed(copy: vec4<f32>, other: vec3<f32>) -> vec3<f32> {
    return mix(other, copy.rgb / max(copy.a, 1e-3), clamp(copy.a * 100.0, 0.0, 1.0));
}

@fragment
fn focused(in: Fullscreen) -> @location(0) vec4<f32> {
    let at = in.position.xy;
    let pixel = vec2<i32>(at);
    let sharp = textureLoad(color, pixel, 0).rgb;
    let depth_m = depth_along_sight(textureLoad(position, pixel, 0).xyz);
    let variance = blur_variance(depth_m);
    let before = depth_m < frame.lens.x;
    var light = sharp;
    if !before && variance > 0.0 {
        let one = weighed(between(behind_1, at, 2.0), sharp);
        light = blurred(sharp, one, weighed(between(behind_2, at, 4.0), one), variance);
    }
    let all_one = between(all_1, at, 2.0);
    let all_two = between(all_2, at, 4.0);
    // What is blurred before the plane spreads over what lies behind it: at its edge half of its
    // surroundings is as blurred as it is itself
    let most = copy_variances().y;
    let own = select(0.0, variance / most, before);
    let spread = clamp(max(own, 2.0 * all_two.a - own), 0.0, 1.0) * most;
    return vec4(blurred(light, all_one.rgb, all_two.rgb, spread), 1.0);
}
