// One page of a field: group 1. The layout and its precision are documented in gpu/layout.rs.

struct GpuField {
    blade_count: u32,
    patch_count: u32,
    patch_size: u32,
    // Index in the field of the page's first blade
    first_id: u32,
    // Mean length of the field's blades; half width and height of a cluster; mean width of the blades,
    // metres; all 0 where none is baked
    cluster: vec4<f32>,
    // Blades that a ray meets on its way to the ground, in the mean: x a level one, for each metre on the
    // ground over metre of height that it takes, y one from straight above; 0 where it is not known
    layers: vec2<f32>,
    reserved_a: f32,
    reserved_b: f32,
}

struct GpuPatch {
    // Corner of the roots' box, and the edge of the cube that roots are quantised in
    origin: vec3<f32>,
    edge: f32,
    // Box of every pose
    reach_min: vec3<f32>,
    // Column times 65536 plus row of its cell, in pages that lie about level
    cell: u32,
    reach_max: vec3<f32>,
    max_width: f32,
}

struct GpuSpecies {
    // min, span
    height: vec2<f32>,
    width: vec2<f32>,
    response: vec2<f32>,
    droop: vec2<f32>,
    gust: f32,
    arch: f32,
    // First bucket of its topology: 0 pointed, 4 flat tip
    first_bucket: u32,
    // How far the surface's colour replaces the species' own, 0 to 1
    tint: f32,
    // Ridge; where the taper of a triangle-tip begins; light at the roots; shape: 0 quad, 1 triangle,
    // 2 quadratic, 3 triangle-tip, 4 dandelion
    form: vec4<f32>,
    // Per level: width factor that keeps the outline's area when it is drawn with few segments
    area_scale: vec4<f32>,
    // Root from and to, tip from and to: 10 bits a channel, square root encoded
    colors: vec4<u32>,
    // Near form: 0 blade, 1 strip, 2 billboard; first of its layers in the plants' pictures, how many;
    // quads (8 bits), and whether it has a model (bit 8)
    look: vec4<u32>,
    // Angle between quads, radians; three of the form's own
    look_values: vec4<f32>,
}

const FORM_BLADE: u32 = 0u;
const FORM_STRIP: u32 = 1u;
const FORM_BILLBOARD: u32 = 2u;

// False in pipelines for fields of blades alone
override OTHER_FORMS: bool = true;

// One uniform, as groups 0 to 2 have one in front: see ARCHITECTURE.md on software Vulkan
struct GpuPage {
    field: GpuField,
    species: array<GpuSpecies, 256>,
}

@group(1) @binding(0) var<uniform> page: GpuPage;
@group(1) @binding(1) var<storage, read> blades: array<vec4<u32>>;
@group(1) @binding(2) var<storage, read> patches: array<GpuPatch>;

const BAND: u32 = 64u;
// Draw lists: 0 to 7 blades (pointed ones of 8, 4, 2, 1 segments, then flat-tipped ones), 8 clusters,
// 9 and 10 strips of many and few rings, 11 and 12 billboards near and far, 13 modelled plants
const BUCKETS: u32 = 16u;
const CLUSTER_BUCKET: u32 = 8u;
const STRIP_BUCKET: u32 = 9u;
const BILLBOARD_BUCKET: u32 = 11u;
const FAR_BILLBOARD_BUCKET: u32 = 12u;
const MODEL_BUCKET: u32 = 13u;
// In no list
const NO_BUCKET: u32 = 15u;
// Words of a patch's list of near colliders: 2, and 3 for each of up to 10 chunks
const NEAR_STRIDE: u32 = 32u;
const NEAR_SLOTS: u32 = 10u;

fn form_of(species: u32) -> u32 {
    if OTHER_FORMS {
        return page.species[species].look.x;
    }
    return FORM_BLADE;
}

fn bands_per_patch() -> u32 {
    return page.field.patch_size / BAND;
}

fn patch_blades(patch_index: u32) -> u32 {
    return min(page.field.patch_size, page.field.blade_count - patch_index * page.field.patch_size);
}

fn oct_decode(e: vec2<f32>) -> vec3<f32> {
    // y is the axis that the octahedron folds about: most grass points up
    let y = 1.0 - abs(e.x) - abs(e.y);
    let fold = max(-y, 0.0);
    let x = e.x - select(-fold, fold, e.x >= 0.0);
    let z = e.y - select(-fold, fold, e.y >= 0.0);
    return normalize(vec3<f32>(x, y, z));
}

struct Frame3 {
    first: vec3<f32>,
    second: vec3<f32>,
}

// Two unit vectors perpendicular to up and to each other. No sign switch anywhere near +y or the
// horizon, where the stages could otherwise round to different sides of it. The seam is well above
// -y, towards which 1 / (1 + y) magnifies the rounding.
fn tangent_frame(up: vec3<f32>) -> Frame3 {
    if up.y < -0.55 {
        let s = normalize(vec3<f32>(0.0, up.z, -up.y));
        return Frame3(cross(s, up), s);
    }
    let a = 1.0 / (1.0 + up.y);
    let b = -up.x * up.z * a;
    return Frame3(
        vec3<f32>(1.0 - up.x * up.x * a, -up.x, b),
        vec3<f32>(b, -up.z, 1.0 - up.z * up.z * a),
    );
}

fn unpack_blade(index: u32) -> Blade {
    let w = blades[index];
    let home = patches[index / page.field.patch_size];
    let kind = (w.y >> 16u) & 0xffu;
    let id = page.field.first_id + index;
    let q = vec3<f32>(f32(w.x & 0xffffu), f32(w.x >> 16u), f32(w.y & 0xffffu));
    var blade: Blade;
    blade.root = home.origin + q * (home.edge / 65535.0);
    blade.up = oct_decode(unpack2x16snorm(w.z));
    let axes = tangent_frame(blade.up);
    let angle = f32(w.w & 0xfffu) * (6.2831853 / 4096.0);
    blade.facing = axes.first * cos(angle) + axes.second * sin(angle);
    let height = f32((w.w >> 12u) & 0xfffu) / 4095.0;
    let width = f32(w.w >> 24u) / 255.0;
    let response = f32(w.y >> 24u) / 255.0;
    blade.height = page.species[kind].height.x + page.species[kind].height.y * height;
    blade.width = page.species[kind].width.x + page.species[kind].width.y * width;
    blade.response = page.species[kind].response.x + page.species[kind].response.y * response;
    blade.droop = page.species[kind].droop.x
        + page.species[kind].droop.y * hash01(id, 11u);
    blade.gust = page.species[kind].gust;
    blade.arch = page.species[kind].arch;
    blade.species = kind;
    blade.id = id;
    return blade;
}
