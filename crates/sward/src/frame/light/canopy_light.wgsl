// The light of grass as a whole: the mean of what `shade_blade` gives over all that shows of it. Needs
// light.wgsl and canopy.wgsl. See bake/harmonics.rs.

// Functions on the sphere that do not change where x changes its sign, and those that change with it;
// of each the first are of even degree
const CANOPY_EVEN: u32 = 15u;
const CANOPY_EVEN_BOTH: u32 = 9u;
const CANOPY_ODD: u32 = 10u;
const CANOPY_ODD_BOTH: u32 = 6u;

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
