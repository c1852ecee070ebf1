// The mean light of what shows of each patch that a view sees: one thread a patch of the seen blocks. Plants that are thin
// on the screen are drawn in it more and more, see draw/thin.wgsl.

@group(2) @binding(1) var<storage, read> bands: array<GpuBand>;
@group(2) @binding(2) var<uniform> canopy: GpuCanopy;
// rgb mean radiance; a blades that a ray meets on its way to the ground, or 0 where nothing is known of
// the field's mean
@group(2) @binding(3) var<storage, read_write> patch_light: array<vec4<f32>>;
@group(2) @binding(4) var<uniform> seen_blocks: array<vec4<u32>, 68>;

// Plants of a patch, spread over it, that its place is taken from.
const PLACES: u32 = 4u;

@compute @workgroup_size(64)
fn patch_lights(@builtin(global_invocation_id) thread: vec3<u32>) {
    let index = seen_patch(thread.x);
    if index >= page.field.patch_count || !see_patch(patches[index]).visible {
        return;
    }
    let first = index * page.field.patch_size;
    let places = min(PLACES, patch_blades(index));
    var up = vec3<f32>(0.0);
    var root = vec3<f32>(0.0);
    for (var i = 0u; i < places; i++) {
        let blade = unpack_blade(first + i);
        up += blade.up;
        root += blade.root / f32(places);
    }
    up = unit_or(up, vec3<f32>(0.0, 1.0, 0.0));
    let band = bands[index * bands_per_patch()];
    let sway = unpack_sway(band.sway);
    let to_eye = -view_ray(root + up * (0.5 * page.field.cluster.x));
    let light = canopy_radiance(up, to_eye, sway, sun_shade(root));
    let met = -log(max(1.0 - canopy_coverage(up, to_eye, sway), 1e-4));
    patch_light[index] = vec4<f32>(light, select(0.0, max(met, 1e-3), canopy.size.z > 0.0));
}
