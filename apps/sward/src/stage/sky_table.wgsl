// Background: the table of a sky by physics, and the disc of the sun or the moon.

@group(1) @binding(0) var dome: texture_2d<f32>;

// Half the angle that the disc is wide, radians
const DISC = 0.00465;
// Most radiance of the disc: thousands of times more is what it has, but that is white as well, and a
// pixel's mean of it would spread over its neighbours
const DISC_MOST = 60.0;

// Between the texels, as on the CPU.
fn dome_radiance(direction: vec3<f32>) -> vec3<f32> {
    let toward = vec2(frame.zenith.w, frame.horizon.w);
    let level = direction.xz;
    let across = level.x * toward.y - level.y * toward.x;
    // What has no direction along the ground is overhead, where all azimuths are one
    let around = atan2(abs(across), dot(level, toward) + 1e-9);
    let up = atan2(max(direction.y, 0.0), length(level));
    let last = vec2<f32>(textureDimensions(dome) - 1u);
    let place = clamp(vec2(around / PI, sqrt(up / (0.5 * PI))), vec2(0.0), vec2(1.0)) * last;
    let first = vec2<i32>(min(place, last - 1.0));
    let share = place - vec2<f32>(first);
    var row: array<vec3<f32>, 2>;
    for (var y = 0; y < 2; y++) {
        let left = textureLoad(dome, first + vec2(0, y), 0).rgb;
        row[y] = mix(left, textureLoad(dome, first + vec2(1, y), 0).rgb, share.x);
    }
    return mix(row[0], row[1], share.y);
}

// Darker and redder towards its edge, as the sun's is. The edge is a pixel wide.
fn disc_radiance(off: f32, pixel: f32) -> vec3<f32> {
    let covered = clamp((DISC - off) / max(pixel, 1e-6) + 0.5, 0.0, 1.0);
    let inward = sqrt(max(1.0 - off * off / (DISC * DISC), 0.0));
    let limb = 1.0 - vec3(0.4, 0.5, 0.65) * (1.0 - inward);
    let light = frame.sun.rgb / (PI * DISC * DISC);
    let most = max(light.r, max(light.g, light.b));
    return light * limb * (min(1.0, DISC_MOST / max(most, 1e-6)) * covered * frame.to_sun.w);
}

fn sky_radiance(direction: vec3<f32>) -> vec3<f32> {
    let off = length(direction - frame.to_sun.xyz);
    let disc = disc_radiance(off, fwidth(off)) * f32(direction.y > 0.0);
    // Below the horizon the ground's light dims the haze.
    let below = smoothstep(0.0, 0.5, -direction.y);
    return dome_radiance(direction) * mix(1.0, 0.62, below) + disc;
}
