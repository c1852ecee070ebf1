// Light on a blade: sun on both faces, light through it, sky and ground, the canopy's own shade.

struct BladeSurface {
    albedo: vec3<f32>,
    // Towards the eye's side of the blade
    normal: vec3<f32>,
    // Unit up of the plant
    up: vec3<f32>,
    // 0 root, 1 tip
    height_share: f32,
    // Share of the sky that reaches the roots
    root_open: f32,
    // How far the blade lies over: 0 upright, 1 flat
    lean: f32,
    // Share of the sun that what is between, such as a cloud, keeps away
    shaded: f32,
    // Share of the light that the plant itself keeps away, and scatters; below 0 it keeps away less than
    // the canopy does in the mean
    absorbed: f32,
    // How much less light passes than through a blade of grass: 1 none, below 0 more
    blocked: f32,
}

// What of the sun's light a blade reflects, lets through, lets through towards who looks against the sun,
// and mirrors
const BLADE_REFLECTS: f32 = 0.32;
const BLADE_PASSES: f32 = 0.30;
const BLADE_PASSES_AGAINST: f32 = 0.35;
const BLADE_GLOSS: f32 = 0.05;
// Light through the leaf is yellower than light off it
const BLADE_TINT: vec3<f32> = vec3<f32>(1.15, 1.2, 0.55);
// Share of the light kept away inside a plant that it scatters towards the eye.
const SCATTERED: f32 = 0.35;
// Share of the sky's light that a blade lying flat mirrors.
const SKY_SHEEN: f32 = 0.08;

// Share of the sky that the canopy lets through to a height in it.
fn canopy_open(height_share: f32, root_open: f32) -> f32 {
    let t = clamp(height_share, 0.0, 1.0);
    return mix(root_open, 1.0, t * (1.6 - 0.6 * t));
}

fn shade_blade(surface: BladeSurface, to_eye: vec3<f32>) -> vec3<f32> {
    let to_sun = frame.to_sun.xyz;
    // One that lies over its neighbours is in the light along its length, and its glossy side
    // mirrors the sky: so a gust shows as it passes
    let over = smoothstep(0.15, 0.75, surface.lean);
    let share = mix(surface.height_share, 1.0, 0.7 * over);
    let open = canopy_open(share, surface.root_open) * (1.0 - 0.4 * max(surface.absorbed, 0.0));
    let facing_sun = dot(surface.normal, to_sun);
    let reflected = max(facing_sun, 0.0);
    // Strongest against the sun
    let through = max(-facing_sun, 0.0) * (1.0 - surface.blocked);
    let leaf = surface.albedo * BLADE_TINT;
    let toward = max(dot(-to_eye, to_sun), 0.0);
    let against = toward * toward * toward * toward;
    let arriving = frame.sun.rgb * (open * open * (1.0 - surface.shaded));
    let sun_light = arriving * (1.0 - surface.absorbed);
    var color = surface.albedo * sun_light * reflected * BLADE_REFLECTS;
    color += leaf * sun_light * through * (BLADE_PASSES + BLADE_PASSES_AGAINST * against);
    // What is kept away on the way through the plant comes out of it on all sides, greener
    color += leaf * surface.albedo * arriving * (max(surface.absorbed, 0.0) * SCATTERED * (0.5 + against));
    let half_vector = to_sun + to_eye;
    let h = half_vector * inverseSqrt(max(dot(half_vector, half_vector), 1e-6));
    let shine = max(dot(surface.normal, h), 0.0);
    let shine4 = shine * shine * shine * shine;
    color += sun_light * (shine4 * shine4 * shine4 * BLADE_GLOSS);
    color += frame.sky.rgb * (over * open * SKY_SHEEN);
    let upward = 0.5 + 0.5 * dot(surface.normal, surface.up);
    let around = mix(frame.ground.rgb, frame.sky.rgb, upward);
    return color + surface.albedo * around * open;
}

fn with_haze(color: vec3<f32>, distance: f32) -> vec3<f32> {
    let clear = exp(-frame.haze.w * distance);
    return select(mix(frame.haze.rgb, color, clear), color, frame.haze.w == 0.0);
}
