// Ground that carries grass: soil and short growth in patches, so that what shows between the
// blades, and beyond them, is not one flat colour.

fn hash3(cell: vec3<i32>) -> f32 {
    var h = bitcast<u32>(cell.x) * 0x8da6b343u + bitcast<u32>(cell.y) * 0xd8163841u
        + bitcast<u32>(cell.z) * 0xcb1ab31fu;
    h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12u)) * 0x297a2d39u;
    return f32((h ^ (h >> 15u)) >> 8u) / 16777216.0;
}

// xyz the slope, w the value.
fn value_noise(p: vec3<f32>) -> vec4<f32> {
    let cell = vec3<i32>(floor(p));
    let f = fract(p);
    let s = f * f * (3.0 - 2.0 * f);
    // Values along x and how they differ, at the four corners in y and z
    var at: array<f32, 4>;
    var step: array<f32, 4>;
    for (var i = 0; i < 4; i++) {
        let corner = cell + vec3(0, i & 1, i >> 1u);
        let first = hash3(corner);
        step[i] = hash3(corner + vec3(1, 0, 0)) - first;
        at[i] = first + step[i] * s.x;
    }
    let low = mix(at[0], at[1], s.y);
    let high = mix(at[2], at[3], s.y);
    let slope = vec3(
        mix(mix(step[0], step[1], s.y), mix(step[2], step[3], s.y), s.z),
        mix(at[1] - at[0], at[3] - at[2], s.z),
        high - low,
    );
    return vec4(slope * (6.0 * f * (1.0 - f)), mix(low, high, s.z));
}

const TURN = mat3x3<f32>(0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6);

// Noise of one size, faded to its mean where it would be smaller than two pixels.
// xyz its slope over a size, w its value.
fn octave_sloped(p: vec3<f32>, size_m: f32, pixel_m: f32) -> vec4<f32> {
    let kept = 1.0 - smoothstep(0.25, 0.6, pixel_m / size_m);
    // Turned away from the axes, on which the noise's lattice would show.
    let noise = value_noise(TURN * p / size_m);
    return vec4(noise.xyz * TURN * kept, mix(0.5, noise.w, kept));
}

fn octave(p: vec3<f32>, size_m: f32, pixel_m: f32) -> f32 {
    return octave_sloped(p, size_m, pixel_m).w;
}

struct Ground {
    albedo: vec3<f32>,
    normal: vec3<f32>,
    // Share of it that is sunlit canopy, which light passes through
    canopy: f32,
}

fn ground_material(p: vec3<f32>, normal: vec3<f32>, soil: vec3<f32>, grass: vec4<f32>, pixel_m: f32) -> Ground {
    let broad = octave(p, 4.7, pixel_m);
    let middle = octave(p + 17.3, 0.83, pixel_m);
    let fine_sloped = octave_sloped(p + 31.9, 0.12, pixel_m);
    let fine = fine_sloped.w;
    let grain = octave(p + 5.1, 0.027, pixel_m);
    let cover = clamp(grass.w + (broad - 0.5) * 0.5 + (middle - 0.5) * 0.6 + (fine - 0.5) * 0.5, 0.0, 1.0);
    // Far off one looks on the canopy's tips, which thinned blades no longer draw; close up,
    // between the blades, on their shaded feet.
    let far = smoothstep(0.006, 0.05, pixel_m) * frame.stands_in;
    let share = mix(mix(cover, grass.w, 0.35), 1.0, far * grass.w);
    let shade = mix(0.45 + 0.25 * middle + 0.3 * fine + 0.2 * grain, 1.1 + 0.5 * (broad - 0.5), far);
    let earth = soil * (0.5 + 0.6 * middle + 0.4 * grain);
    let albedo = mix(earth, grass.rgb * shade, share);
    // Relief of the fine noise, over a quarter of its size.
    let slope = 0.25 * fine_sloped.xyz;
    let along = slope - normal * dot(slope, normal);
    return Ground(albedo, normalize(normal - along * 1.3), far * share);
}

// Share of the ground that shows the grass's look in place of grass that is too small to be drawn.
fn grass_on_ground(up: vec3<f32>, place: vec3<f32>, to_eye: vec3<f32>) -> f32 {
    let ahead = -frame.world_from_view[2].xyz;
    let away = distance(frame.eye.xyz, place);
    // On a plane 1 m ahead of the eye, so many metres lie between pixels, the same all over it
    let on_plane = -to_eye / max(dot(-to_eye, ahead), 1e-3);
    let metre_px = 1.0 / max(length(dpdy(on_plane)) * frame.samples_a_side, 1e-7);
    let gone = canopy_gone(canopy.size.z * metre_px / away);
    return canopy_on_ground(canopy_coverage(up, to_eye, stance.yzw), gone);
}
