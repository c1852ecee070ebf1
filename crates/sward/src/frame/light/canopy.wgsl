// The light of grass as a whole, seen from so far that blades are no longer told apart: the mean of
// what `shade_blade` gives on a few representatives of what shows. Needs light.wgsl and a variable
// `canopy`.

// Elevations of view: their sines are 1/32, 1/16, .. 1
const CANOPY_ROWS: u32 = 6u;
// Representatives an elevation
const CANOPY_SURFELS: u32 = 32u;

struct GpuSurfel {
    // On the eye's side: x to the right, y up, z level towards the eye
    normal: vec3<f32>,
    // Share of what shows: one over their number, or 0 where there is no grass
    weight: f32,
    albedo: vec3<f32>,
    // 0 root, 1 tip
    height_share: f32,
}

struct GpuCanopy {
    // Half width and height of a cluster, mean height of the grass, metres; share of the sky at the
    // roots
    size: vec4<f32>,
    // How far blades lean at rest: 0 upright, 1 flat; three unused
    pose: vec4<f32>,
    // Of a field whose blades take its surface's colours: rgb mean colour but for those, w what they
    // are multiplied by; and their mean. Zero but for `tint_mean` 1 elsewhere
    tint: vec4<f32>,
    tint_mean: vec4<f32>,
    // By elevation: mean of the albedo in the canopy's own shade, and share of the ground that shows
    // none of it
    rows: array<vec4<f32>, 6>,
    surfels: array<GpuSurfel, 192>,
}

// Which elevation, 0 to 5, from the sine of the angle between the ray and the ground.
fn canopy_row(sine: f32) -> f32 {
    return clamp(5.0 + log2(max(abs(sine), 0.001)), 0.0, 5.0);
}

// Radiance of what shows of the grass at one elevation. `lean` is how far wind bends the grass over on
// the whole, 0 to 1; `shaded` the share of the sun that something keeps away.
fn canopy_row_radiance(row: u32, up: vec3<f32>, to_eye: vec3<f32>, lean: f32, shaded: f32)
    -> vec3<f32> {
    let level = to_eye - up * dot(to_eye, up);
    let square = dot(level, level);
    // Straight from above any direction will do
    let aside = select(vec3<f32>(1.0, 0.0, 0.0), vec3<f32>(0.0, 0.0, 1.0), abs(up.x) > 0.7);
    let other = normalize(aside - up * dot(aside, up));
    let toward = select(other, level * inverseSqrt(max(square, 1e-12)), square > 1e-8);
    let right = cross(up, toward);
    var surface: BladeSurface;
    surface.up = up;
    surface.root_open = canopy.size.w;
    surface.shaded = shaded;
    surface.lean = min(sqrt(canopy.pose.x * canopy.pose.x + lean * lean), 1.0);
    var sum = vec3<f32>(0.0);
    for (var i = 0u; i < CANOPY_SURFELS; i++) {
        let index = row * CANOPY_SURFELS + i;
        let n = canopy.surfels[index].normal;
        surface.normal = right * n.x + up * n.y + toward * n.z;
        surface.albedo = canopy.surfels[index].albedo;
        surface.height_share = canopy.surfels[index].height_share;
        sum += canopy.surfels[index].weight * shade_blade(surface, to_eye);
    }
    return sum;
}

// Mean radiance of the grass, seen from `to_eye`.
fn canopy_radiance(up: vec3<f32>, to_eye: vec3<f32>, lean: f32, shaded: f32) -> vec3<f32> {
    let row = canopy_row(dot(up, to_eye));
    let low = min(u32(row), CANOPY_ROWS - 2u);
    return mix(
        canopy_row_radiance(low, up, to_eye, lean, shaded),
        canopy_row_radiance(low + 1u, up, to_eye, lean, shaded),
        row - f32(low),
    );
}

// Mean of the texels of clusters that show: of the albedo in the canopy's own shade.
fn canopy_texels(up: vec3<f32>, to_eye: vec3<f32>) -> vec3<f32> {
    let row = canopy_row(dot(up, to_eye));
    let low = min(u32(row), CANOPY_ROWS - 2u);
    let mean = mix(canopy.rows[low].rgb, canopy.rows[low + 1u].rgb, row - f32(low));
    return max(mean, vec3<f32>(1e-4));
}

// Share of the ground that the grass hides, seen from `to_eye`.
fn canopy_coverage(up: vec3<f32>, to_eye: vec3<f32>) -> f32 {
    let row = canopy_row(dot(up, to_eye));
    let low = min(u32(row), CANOPY_ROWS - 2u);
    return 1.0 - mix(canopy.rows[low].w, canopy.rows[low + 1u].w, row - f32(low));
}

// Colour of a plant whose surface has that colour, relative to the field's mean.
fn canopy_tint(own: vec3<f32>) -> vec3<f32> {
    let mean = canopy.tint.rgb + canopy.tint.w * canopy.tint_mean.rgb;
    return (canopy.tint.rgb + canopy.tint.w * own) / max(mean, vec3<f32>(1e-4));
}
