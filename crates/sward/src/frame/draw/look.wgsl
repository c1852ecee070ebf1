// What plants of quads and modelled plants have in common: variants, tone, the light that they keep
// away from themselves.

const LOOK_SALT: u32 = 41u;
// Pictures of a variant: seen from three sides, 60 degrees apart
const PICTURE_VIEWS: u32 = 3u;

// Which variant of its kind a plant is; a row in the models' table counts them on.
fn variant_of(look: vec4<u32>, id: u32) -> u32 {
    let variants = max(look.z / PICTURE_VIEWS, 1u);
    return min(u32(hash01(id, LOOK_SALT) * f32(variants)), variants - 1u);
}

// The picture of a quad: of the variant, from the side that the quad shows. A picture of a host's own
// has one layer.
fn quad_layer(look: vec4<u32>, id: u32, quad: u32) -> u32 {
    if look.z < PICTURE_VIEWS {
        return look.y;
    }
    return look.y + variant_of(look, id) * PICTURE_VIEWS + quad % PICTURE_VIEWS;
}

// Where the plant's middle line is at a share of its height, in heights, and which way it runs there.
struct Spine {
    center: vec3<f32>,
    along: vec3<f32>,
}

fn spine_at(blade: Blade, tip: vec3<f32>, share: f32) -> Spine {
    let knee = middle_point(tip, blade.up, blade.arch);
    // Upright, the curve is at 2v - v v of its height
    let v = 1.0 - sqrt(clamp(1.0 - share, 0.0, 1.0));
    let a = knee * v;
    let b = mix(knee, tip, v);
    let along = unit_or(b - a, blade.up);
    // What lies under the root goes straight down
    return Spine(mix(a, b, v) + along * min(share, 0.0), along);
}

// How light a plant is, beside its kind: each a little otherwise, and lighter as wind bends it.
fn plant_tone(id: u32, lean: f32, wind_tint: f32) -> f32 {
    return (0.85 + 0.3 * hash01(id, 22u)) * (1.0 + wind_tint * (lean - 0.1));
}

// Radii of the plant that light from the sun passes in the mean.
const MEAN_WAY: f32 = 0.85;

// Share of the sun's light that the plant keeps away on its way to a point in it, beyond what it does in
// the mean, which is canopy_open's: Beer and Lambert's law over the way through a cylinder about it. Below
// 0 where it keeps away less, so that a plant is as bright in all as single blades in its place. `offset`
// is from its middle line, `size` its width and height, `share` the point's share of the height.
fn absorbed_within(
    offset: vec3<f32>,
    up: vec3<f32>,
    size: vec2<f32>,
    share: f32,
    absorption: f32,
) -> f32 {
    let radius = 0.5 * size.x;
    let rise = dot(frame.to_sun.xyz, up);
    let level = frame.to_sun.xyz - up * rise;
    let flat_offset = offset - up * dot(offset, up);
    let speed2 = max(dot(level, level), 1e-4);
    let ahead = dot(flat_offset, level);
    let room = max(radius * radius - dot(flat_offset, flat_offset), 0.0);
    let to_side = (sqrt(ahead * ahead + speed2 * room) - ahead) / speed2;
    let to_top = size.y * (1.0 - share) / max(rise, 0.05);
    return 1.0 - exp(-absorption * (min(to_side, to_top) / max(radius, 1e-4) - MEAN_WAY));
}
