// What shows of grass as a whole, at rest and in wind: see bake/canopy.rs. Needs a variable `canopy`.

// Elevations of view: their sines are 1/32, 1/16, .. 1
const CANOPY_ROWS: u32 = 6u;

// The mean over what shows. x lies to the right of the eye, y up, z level towards the eye
struct GpuLook {
    // Of the sun's light, by the function: rgb what goes with the cosine, w what is mirrored
    waves: array<vec4<f32>, 15>,
    // rgb albedo in the sky's light, w share of the ground that shows none of the grass
    around: vec4<f32>,
    // rgb the same times how far the normal points up, w how much of the sky is mirrored
    tilt: vec4<f32>,
}

// In a wind: the mean over all sides that it blows from, and what goes with the cosines of the angle
// between where it blows to and the eye, of its double and of its triple
struct GpuBent {
    mean: GpuLook,
    first: GpuLook,
    second: GpuLook,
    third: GpuLook,
    // Of the functions that change with x, by the sines of that angle and of its double
    across: array<vec4<f32>, 10>,
    across_double: array<vec4<f32>, 10>,
}

struct GpuCanopyRow {
    // rgb mean of the albedo in the canopy's own shade, or of the texels of clusters where there are any;
    // w mean height: 0 root, 1 tip
    shown: vec4<f32>,
    rest: GpuLook,
    winds: array<GpuBent, 3>,
}

struct GpuCanopy {
    // Half width and height of a cluster, mean height of the grass, metres; share of the sky at the
    // roots
    size: vec4<f32>,
    // How far the three winds move the mean tip, and how high that is at rest, in heights
    pose: vec4<f32>,
    // Of a field whose blades take its surface's colours: rgb mean colour but for those, w what they
    // are multiplied by; and their mean. Zero but for `tint_mean` 1 elsewhere
    tint: vec4<f32>,
    tint_mean: vec4<f32>,
    // Clusters seen from 0, 15, .. 90 degrees: w the share of a card that they cover; rgb the mean of their
    // texels that show, from 30 degrees on (`rows` has it up to there). The last: x clusters a square metre
    cards: array<vec4<f32>, 8>,
    rows: array<GpuCanopyRow, 6>,
}

// How a canopy is looked at and bent.
struct CanopyView {
    right: vec3<f32>,
    up: vec3<f32>,
    toward: vec3<f32>,
    // Elevation: 0 to 5
    row: f32,
    // Of rest and the three winds
    shares: vec4<f32>,
    // Cosines of the angle to where the wind blows, of its double and its triple, with 1 before them
    cosines: vec4<f32>,
    // Sines of the angle and its double
    sines: vec2<f32>,
}

// Which elevation, 0 to 5, from the sine of the angle between the ray and the ground.
fn canopy_row(sine: f32) -> f32 {
    return clamp(5.0 + log2(max(abs(sine), 0.001)), 0.0, 5.0);
}

// How much rest and the three winds count where the mean tip is moved so far: a cubic through all four.
fn canopy_shares(moved: f32) -> vec4<f32> {
    // Apart, also where wind moves the grass hardly or not at all
    let a = max(canopy.pose.x, 0.01);
    let b = max(canopy.pose.y, a + 0.01);
    let c = max(canopy.pose.z, b + 0.01);
    let x = clamp(moved, 0.0, canopy.pose.z);
    return vec4<f32>(
        (x - a) * (x - b) * (x - c) / (-a * b * c),
        x * (x - b) * (x - c) / (a * (a - b) * (a - c)),
        x * (x - a) * (x - c) / (b * (b - a) * (b - c)),
        x * (x - a) * (x - b) / (c * (c - a) * (c - b)),
    );
}

// `sway`: how far wind moves the mean tip, in heights; what it has along `up` does not count.
fn canopy_view(up: vec3<f32>, to_eye: vec3<f32>, sway: vec3<f32>) -> CanopyView {
    var view: CanopyView;
    let sine = dot(up, to_eye);
    let level = to_eye - up * sine;
    let square = dot(level, level);
    // Straight from above any direction will do
    let aside = select(vec3<f32>(1.0, 0.0, 0.0), vec3<f32>(0.0, 0.0, 1.0), abs(up.x) > 0.7);
    let other = normalize(aside - up * dot(aside, up));
    view.up = up;
    view.toward = select(other, level * inverseSqrt(max(square, 1e-12)), square > 1e-8);
    view.right = cross(up, view.toward);
    view.row = canopy_row(sine);
    let ahead = dot(sway, view.toward);
    let sideways = dot(sway, view.right);
    let moved = sqrt(ahead * ahead + sideways * sideways);
    let each = 1.0 / max(moved, 1e-6);
    let c = ahead * each;
    let double = 2.0 * c * c - 1.0;
    view.cosines = vec4<f32>(1.0, c, double, c * (2.0 * double - 1.0));
    view.sines = vec2<f32>(sideways * each, 2.0 * sideways * each * c);
    view.shares = canopy_shares(moved);
    return view;
}

// Square of metres along the ground over metres of height.
fn canopy_along(sine: f32) -> f32 {
    return 1.0 / (sine * sine) - 1.0;
}

// Blades that a ray meets between two elevations, where so much of the ground is open from these: what
// shows of each is taken as an ellipsoid, by squares of how far along the ground the ray runs.
fn canopy_met(low: u32, open: vec2<f32>, sine: f32) -> f32 {
    let first = exp2(f32(low) - 5.0);
    let from_along = canopy_along(first);
    let to_along = canopy_along(2.0 * first);
    let along = canopy_along(clamp(abs(sine), first, 2.0 * first));
    let met = -log(max(open, vec2<f32>(5e-4)));
    let part = (from_along - along) / (from_along - to_along);
    return sqrt(mix(met.x * met.x, met.y * met.y, part));
}

fn canopy_row_open(row: u32, view: CanopyView) -> f32 {
    var open = canopy.rows[row].rest.around.w * view.shares.x;
    for (var k = 0u; k < 3u; k++) {
        let share = view.shares[k + 1u];
        open += share * (canopy.rows[row].winds[k].mean.around.w
            + canopy.rows[row].winds[k].first.around.w * view.cosines.y
            + canopy.rows[row].winds[k].second.around.w * view.cosines.z
            + canopy.rows[row].winds[k].third.around.w * view.cosines.w);
    }
    return clamp(open, 0.0, 1.0);
}

// Share of the ground that the grass hides, seen from `to_eye`.
fn canopy_coverage(up: vec3<f32>, to_eye: vec3<f32>, sway: vec3<f32>) -> f32 {
    let view = canopy_view(up, to_eye, sway);
    let low = min(u32(view.row), CANOPY_ROWS - 2u);
    let open = vec2<f32>(canopy_row_open(low, view), canopy_row_open(low + 1u, view));
    return 1.0 - exp(-canopy_met(low, open, dot(up, to_eye)));
}

fn canopy_luminance(color: vec3<f32>) -> f32 {
    return dot(color, vec3<f32>(0.2126, 0.7152, 0.0722));
}

// The mean radiance, of plants whose surface has that colour in place of the field's mean one. The more
// of their colour is the surface's, the more it is that colour in the mean's brightness: a ratio of
// colours would multiply mirrored light, which has none of it.
fn canopy_tinted(radiance: vec3<f32>, own: vec3<f32>) -> vec3<f32> {
    let color = canopy.tint.rgb + canopy.tint.w * own;
    let mean = max(canopy.tint.rgb + canopy.tint.w * canopy.tint_mean.rgb, vec3<f32>(1e-4));
    let received = canopy_luminance(radiance) / canopy_luminance(mean);
    let share = canopy.tint.w * canopy_luminance(canopy.tint_mean.rgb) / canopy_luminance(mean);
    let near = radiance * clamp(color / mean, vec3<f32>(0.5), vec3<f32>(2.0));
    return mix(near, color * received, clamp(share, 0.0, 1.0));
}
