// The light that a leaf sends on: a thin sheet that mirrors at its face, scatters back and lets through.
// Directions are in the leaf's own frame: x across it, y along it, z its normal; any length-1 pair, either
// side. No bindings; docs/equations.md derives it.

struct Leaf {
    // Share of the light that it scatters back, and that passes, of what is not mirrored
    reflects: vec3<f32>,
    passes: vec3<f32>,
    // Squares of the GGX roughness across and along
    rough: vec2<f32>,
    // Over 1 less the share that is mirrored in the mean over all directions
    inner: f32,
}

const LEAF_PI: f32 = 3.14159265;
// Mirrored share of light that comes straight: the wax of a leaf, index 1.5
const LEAF_FACING: f32 = 0.04;
// Roughness across and along, dry and wet. Veins run along the blade and roughen it across
const LEAF_DRY: vec2<f32> = vec2<f32>(0.45, 0.28);
const LEAF_WET: vec2<f32> = vec2<f32>(0.2, 0.12);
// How much more of what passes goes straight on than to the sides
const LEAF_STRAIGHT: f32 = 1.8;
// Mean of `leaf_straight_mean` over all directions, 17/72
const LEAF_STRAIGHT_MEAN: f32 = 0.23611111;
// Share that a leaf without colour scatters back, and how much farther light goes that passes. What is left of
// a wide band of colours falls less the farther it went: the more so in red, of which leaves let some pass
const LEAF_BACK: f32 = 0.55;
const LEAF_THIN: f32 = 0.8;
const LEAF_WAY: vec3<f32> = vec3<f32>(1.15, 1.25, 1.4);

// What passes a leaf of that reflectance: Beer and Lambert's law. Its colour says what is absorbed on
// light's way in and out again; light that passes goes farther. Thickness 1 is a
// blade of grass; a thin petal's colour is that of its own thickness, and holds through it too.
fn leaf_passes(reflects: vec3<f32>, thickness: f32) -> vec3<f32> {
    let a = clamp(reflects, vec3<f32>(1e-4), vec3<f32>(1.0));
    // What it would scatter back if it absorbed nothing: more where it scatters more
    let rest = LEAF_BACK * (1.0 - a);
    let back = sqrt(a * a + rest * rest);
    return (1.0 - back) * pow(a / back, LEAF_WAY * max(thickness, LEAF_THIN));
}

// Squares of the roughness; 0 dry, 1 wet.
fn leaf_rough(wetness: f32) -> vec2<f32> {
    let rough = mix(LEAF_DRY, LEAF_WET, wetness);
    return rough * rough;
}

// A leaf without its colours.
fn leaf_face(wetness: f32) -> Leaf {
    let mean = 0.0457 + wetness * (0.0137 + wetness * 0.0046);
    return Leaf(vec3<f32>(0.0), vec3<f32>(0.0), leaf_rough(wetness), 1.0 / (1.0 - mean));
}

// Share of light that the face mirrors, all in all, from a direction: fitted to the integral of
// `leaf_gloss` for an even roughness, that of the leaf towards there.
fn leaf_mirrored(rough: vec2<f32>, d: vec3<f32>) -> f32 {
    let level = d.xy * d.xy;
    let q = dot(level, rough) / max(level.x + level.y, 1e-6);
    let i = 1.0 / (q + 0.02);
    let x = 1.0 - min(abs(d.z), 1.0);
    let x4 = x * x * x * x;
    let low = 0.0151 * i + 0.0445 + 0.0174 * q + x4 * (0.022 - 0.0059 * i - 0.006 * q);
    return 0.0478 - 0.0002 * i - 0.0736 * q + x4 * low;
}

// Fresnel's law after Schlick, from the cosine of half the angle between light and eye.
fn leaf_fresnel(cosine: f32) -> f32 {
    let x = 1.0 - clamp(cosine, 0.0, 1.0);
    let x2 = x * x;
    return LEAF_FACING + (1.0 - LEAF_FACING) * (x2 * x2 * x);
}

// What the face mirrors but for Fresnel's share: GGX facets that hide each other by Smith's rule, of both
// directions together, over the sphere of directions. Both lie on the side of z.
fn leaf_gloss(rough: vec2<f32>, v: vec3<f32>, l: vec3<f32>, half_way: vec3<f32>) -> f32 {
    let spread = dot(half_way.xy * half_way.xy, 1.0 / rough) + half_way.z * half_way.z;
    let facets = inverseSqrt(rough.x * rough.y) / (LEAF_PI * spread * spread);
    let hide_v = sqrt(v.z * v.z + dot(v.xy * v.xy, rough));
    let hide_l = sqrt(l.z * l.z + dot(l.xy * l.xy, rough));
    return 0.5 * facets / max(v.z * hide_l + l.z * hide_v, 1e-6);
}

// Mean of the fourth power of the cosine between a direction and those on the other side.
fn leaf_straight_mean(cosine: f32) -> f32 {
    let c2 = cosine * cosine;
    return 0.125 + c2 * (0.25 - c2 * (1.0 / 24.0));
}

// How much more than in the mean passes from a direction to another: its means over either are 1.
fn leaf_straight(v: vec3<f32>, l: vec3<f32>) -> f32 {
    let along = dot(v, l);
    let a2 = along * along;
    let means = leaf_straight_mean(v.z) + leaf_straight_mean(l.z) - LEAF_STRAIGHT_MEAN;
    return 1.0 + LEAF_STRAIGHT * (a2 * a2 - means);
}

// Radiance towards v for light from l of irradiance 1 across its way, over the cosine of l: a number
// that stays if v and l change places.
fn leaf_bsdf(leaf: Leaf, v: vec3<f32>, l: vec3<f32>) -> vec3<f32> {
    let kept = (1.0 - leaf_mirrored(leaf.rough, v)) * (1.0 - leaf_mirrored(leaf.rough, l));
    let scattered = kept * leaf.inner / LEAF_PI;
    if v.z * l.z <= 0.0 {
        return leaf.passes * (scattered * leaf_straight(v, l));
    }
    let side = sign(v.z);
    let sum = v + l;
    let span = sqrt(max(dot(sum, sum), 1e-12));
    let gloss = leaf_gloss(leaf.rough, v * side, l * side, sum * (side / span));
    return leaf.reflects * scattered + vec3<f32>(gloss * leaf_fresnel(0.5 * span));
}
