// The light of grass as a whole: the mean of what `shade_blade` gives over all that shows of it, at rest
// and in wind. Needs light.wgsl and a variable `canopy`. See bake/harmonics.rs.

// Elevations of view: their sines are 1/32, 1/16, .. 1
const CANOPY_ROWS: u32 = 6u;
// Functions on the sphere that do not change where x changes its sign, and those that change with it;
// of each the first are of even degree
const CANOPY_EVEN: u32 = 15u;
const CANOPY_EVEN_BOTH: u32 = 9u;
const CANOPY_ODD: u32 = 10u;
const CANOPY_ODD_BOTH: u32 = 6u;

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
    // rgb mean of the albedo in the canopy's own shade, w mean height: 0 root, 1 tip
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
    let a = canopy.pose.x;
    let b = canopy.pose.y;
    let c = canopy.pose.z;
    if a < 0.01 || b - a < 0.01 || c - b < 0.01 {
        return vec4<f32>(1.0, 0.0, 0.0, 0.0);
    }
    let x = clamp(moved, 0.0, c);
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

// The functions themselves, without their factors; the twin of `basis` in bake/harmonics.rs.
fn canopy_basis(d: vec3<f32>) -> array<f32, 25> {
    let x = d.x;
    let y = d.y;
    let z = d.z;
    let xx = x * x;
    let yy = y * y;
    let zz = z * z;
    return array<f32, 25>(
        1.0,
        y * z,
        3.0 * zz - 1.0,
        xx - yy,
        y * z * (3.0 * xx - yy),
        y * z * (7.0 * zz - 3.0),
        (35.0 * zz - 30.0) * zz + 3.0,
        (xx - yy) * (7.0 * zz - 1.0),
        (xx - 6.0 * yy) * xx + yy * yy,
        y,
        z,
        y * (3.0 * xx - yy),
        y * (5.0 * zz - 1.0),
        z * (5.0 * zz - 3.0),
        z * (xx - yy),
        x * y,
        x * z,
        x * y * (xx - yy),
        x * y * (7.0 * zz - 1.0),
        x * z * (7.0 * zz - 3.0),
        x * z * (xx - 3.0 * yy),
        x,
        x * y * z,
        x * (5.0 * zz - 1.0),
        x * (xx - 3.0 * yy),
    );
}

// Sums over the functions: what is lit from the front and from behind, with its mirrored part, and what
// comes from all around.
struct CanopySum {
    // Of even and of odd degree
    both: vec3<f32>,
    apart: vec3<f32>,
    gloss: f32,
    around: vec4<f32>,
    tilt: vec4<f32>,
}

fn canopy_wave(row: u32, wind: u32, i: u32, view: CanopyView) -> vec4<f32> {
    return canopy.rows[row].winds[wind].mean.waves[i]
        + canopy.rows[row].winds[wind].first.waves[i] * view.cosines.y
        + canopy.rows[row].winds[wind].second.waves[i] * view.cosines.z
        + canopy.rows[row].winds[wind].third.waves[i] * view.cosines.w;
}

fn canopy_sum(row: u32, view: CanopyView, to_sun: vec3<f32>, mirrored: vec3<f32>) -> CanopySum {
    var sum: CanopySum;
    var of_sun = canopy_basis(to_sun);
    var of_gloss = canopy_basis(mirrored);
    let bent = view.shares.x < 0.999;
    for (var i = 0u; i < CANOPY_EVEN; i++) {
        var wave = canopy.rows[row].rest.waves[i] * view.shares.x;
        if bent {
            wave += canopy_wave(row, 0u, i, view) * view.shares.y
                + canopy_wave(row, 1u, i, view) * view.shares.z
                + canopy_wave(row, 2u, i, view) * view.shares.w;
        }
        let lit = wave.rgb * of_sun[i];
        sum.both += select(vec3<f32>(0.0), lit, i < CANOPY_EVEN_BOTH);
        sum.apart += select(lit, vec3<f32>(0.0), i < CANOPY_EVEN_BOTH);
        sum.gloss += wave.w * of_gloss[i];
    }
    sum.around = canopy.rows[row].rest.around * view.shares.x;
    sum.tilt = canopy.rows[row].rest.tilt * view.shares.x;
    if !bent {
        return sum;
    }
    for (var k = 0u; k < 3u; k++) {
        let share = view.shares[k + 1u];
        sum.around += share * (canopy.rows[row].winds[k].mean.around
            + canopy.rows[row].winds[k].first.around * view.cosines.y
            + canopy.rows[row].winds[k].second.around * view.cosines.z
            + canopy.rows[row].winds[k].third.around * view.cosines.w);
        sum.tilt += share * (canopy.rows[row].winds[k].mean.tilt
            + canopy.rows[row].winds[k].first.tilt * view.cosines.y
            + canopy.rows[row].winds[k].second.tilt * view.cosines.z
            + canopy.rows[row].winds[k].third.tilt * view.cosines.w);
    }
    for (var i = 0u; i < CANOPY_ODD; i++) {
        var wave = vec4<f32>(0.0);
        for (var k = 0u; k < 3u; k++) {
            wave += view.shares[k + 1u] * (canopy.rows[row].winds[k].across[i] * view.sines.x
                + canopy.rows[row].winds[k].across_double[i] * view.sines.y);
        }
        let lit = wave.rgb * of_sun[CANOPY_EVEN + i];
        sum.both += select(vec3<f32>(0.0), lit, i < CANOPY_ODD_BOTH);
        sum.apart += select(lit, vec3<f32>(0.0), i < CANOPY_ODD_BOTH);
        sum.gloss += wave.w * of_gloss[CANOPY_EVEN + i];
    }
    return sum;
}

// Radiance of what shows of the grass at one elevation: as `shade_blade`. `shaded` is the share of the
// sun that something keeps away.
fn canopy_row_radiance(row: u32, view: CanopyView, to_eye: vec3<f32>, shaded: f32) -> vec3<f32> {
    let to_sun = frame.to_sun.xyz;
    let half_vector = to_sun + to_eye;
    let h = half_vector * inverseSqrt(max(dot(half_vector, half_vector), 1e-6));
    let sun = vec3<f32>(dot(to_sun, view.right), dot(to_sun, view.up), dot(to_sun, view.toward));
    let mirrored = vec3<f32>(dot(h, view.right), dot(h, view.up), dot(h, view.toward));
    let sum = canopy_sum(row, view, sun, mirrored);
    let reflected = max(sum.both + sum.apart, vec3<f32>(0.0));
    let through = max(sum.both - sum.apart, vec3<f32>(0.0));
    let toward = max(dot(-to_eye, to_sun), 0.0);
    let against = toward * toward * toward * toward;
    var color = reflected * BLADE_REFLECTS
        + through * BLADE_TINT * (BLADE_PASSES + BLADE_PASSES_AGAINST * against)
        + max(sum.gloss, 0.0) * BLADE_GLOSS;
    color *= frame.sun.rgb * (1.0 - shaded);
    color += 0.5 * (frame.ground.rgb + frame.sky.rgb) * sum.around.rgb;
    color += 0.5 * (frame.sky.rgb - frame.ground.rgb) * sum.tilt.rgb;
    return color + frame.sky.rgb * (sum.tilt.w * SKY_SHEEN);
}

// Mean radiance of the grass, seen from `to_eye`. `sway`: how far wind moves the mean tip, in heights.
fn canopy_radiance(up: vec3<f32>, to_eye: vec3<f32>, sway: vec3<f32>, shaded: f32) -> vec3<f32> {
    let view = canopy_view(up, to_eye, sway);
    let low = min(u32(view.row), CANOPY_ROWS - 2u);
    return mix(
        canopy_row_radiance(low, view, to_eye, shaded),
        canopy_row_radiance(low + 1u, view, to_eye, shaded),
        view.row - f32(low),
    );
}

// What a texel of a cluster's picture is multiplied by, so that the mean over what shows is the
// canopy's radiance. `dither`, 0 to 1, picks one of the two elevations next to the view's.
fn canopy_light(
    up: vec3<f32>,
    to_eye: vec3<f32>,
    sway: vec3<f32>,
    shaded: f32,
    dither: f32,
) -> vec3<f32> {
    let view = canopy_view(up, to_eye, sway);
    let row = u32(clamp(view.row + dither, 0.0, 5.0));
    let mean = max(canopy.rows[row].shown.rgb, vec3<f32>(1e-4));
    return canopy_row_radiance(row, view, to_eye, shaded) / mean;
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
    let part = view.row - f32(low);
    return 1.0 - mix(canopy_row_open(low, view), canopy_row_open(low + 1u, view), part);
}

// Colour of a plant whose surface has that colour, relative to the field's mean.
fn canopy_tint(own: vec3<f32>) -> vec3<f32> {
    let mean = canopy.tint.rgb + canopy.tint.w * canopy.tint_mean.rgb;
    return (canopy.tint.rgb + canopy.tint.w * own) / max(mean, vec3<f32>(1e-4));
}
