// A Gaussian along one axis, of both copies.

// Which copy: 0 is half the picture's size, 1 a quarter, and starts from what 0 left
override LEVEL: u32 = 0u;
override ALONG_X: bool = true;

@group(1) @binding(0) var behind: texture_2d<f32>;
@group(1) @binding(1) var all_of_it: texture_2d<f32>;

struct Copies {
    @location(0) behind: vec4<f32>,
    @location(1) all: vec4<f32>,
}

// Variances, square pixels, of taking means of 2 x 2 to halve the picture, of the same again, and of
// reading between the texels of a copy.
const HALVING = vec2(0.25, 1.0);
const READING = vec2(2.0 / 3.0, 8.0 / 3.0);

// Standard deviation in texels of the copy: what is left to be blurred.
fn blur_sigma() -> f32 {
    let wanted = copy_variances();
    let first = max(wanted.x - HALVING.x - READING.x, 0.0);
    if LEVEL == 0u {
        return 0.5 * sqrt(first);
    }
    return 0.25 * sqrt(max(wanted.y - first - HALVING.x - HALVING.y - READING.y, 0.0));
}

@fragment
fn blur(in: Fullscreen) -> Copies {
    let pixel = vec2<i32>(in.position.xy);
    let last = vec2<i32>(textureDimensions(behind)) - 1;
    let sigma = max(blur_sigma(), 1e-3);
    let reach = i32(ceil(2.5 * sigma));
    let along = select(vec2(0, 1), vec2(1, 0), ALONG_X);
    var copies = Copies(vec4(0.0), vec4(0.0));
    var weights = 0.0;
    for (var i = -reach; i <= reach; i++) {
        let t = f32(i) / sigma;
        let weight = exp(-0.5 * t * t);
        // Beyond the picture's edge it goes on as at the edge
        let at = clamp(pixel + along * i, vec2(0), last);
        copies.behind += weight * textureLoad(behind, at, 0);
        copies.all += weight * textureLoad(all_of_it, at, 0);
        weights += weight;
    }
    return Copies(copies.behind / weights, copies.all / weights);
}
