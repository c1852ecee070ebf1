// The copies at half their size.

@group(1) @binding(0) var behind: texture_2d<f32>;
@group(1) @binding(1) var all_of_it: texture_2d<f32>;

struct Copies {
    @location(0) behind: vec4<f32>,
    @location(1) all: vec4<f32>,
}

@fragment
fn halve(in: Fullscreen) -> Copies {
    let first = 2 * vec2<i32>(in.position.xy);
    let last = vec2<i32>(textureDimensions(behind)) - 1;
    var copies = Copies(vec4(0.0), vec4(0.0));
    for (var i = 0; i < 4; i++) {
        let pixel = min(first + vec2(i & 1, i >> 1u), last);
        copies.behind += 0.25 * textureLoad(behind, pixel, 0);
        copies.all += 0.25 * textureLoad(all_of_it, pixel, 0);
    }
    return copies;
}
