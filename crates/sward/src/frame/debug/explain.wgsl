// Why each blade is drawn or not, and whether it moved: one thread a blade of the whole page. It
// runs after the lists are made, and has every blade listed, so that those that failed show too.

@group(2) @binding(1) var<storage, read_write> bands: array<GpuBand>;
@group(2) @binding(2) var<storage, read> dynamics: array<vec2<u32>>;
@group(2) @binding(3) var<storage, read> near: array<u32>;
@group(2) @binding(4) var<storage, read_write> decisions: array<u32>;
// Bits: 0 to 3 failed tests as in a decision; 4 advanced in this step, 5 a collider that moves near
@group(2) @binding(5) var<storage, read_write> explained: array<u32>;

const ADVANCED: u32 = 16u;
const TOUCHED: u32 = 32u;

// Failed tests of a patch as a whole, and of a blade beyond the prefix that it keeps.
fn failed_with_patch(index: u32, local: u32, count: u32) -> u32 {
    let home = patches[index];
    let nearest = nearest_of(home);
    var failed = select(0u, 2u, !see_patch(home).visible);
    let too_far = is_too_far(nearest) || local >= kept_blades(index, home, count, nearest);
    return failed | select(0u, 4u, too_far);
}

// The decision of a blade that is drawn in any case, at full width where it failed.
fn shown(blade: Blade, decision: Decision, failed: u32) -> u32 {
    if failed == 0u {
        return decision.bits;
    }
    let whole = 31u << 9u;
    // In the coarsest form that the technique has for it: they are many
    if technique() == STRIPS || (technique() == CONTINUUM && form_of(blade.species) == FORM_STRIP) {
        return (STRIP_BUCKET + 1u) | whole;
    }
    if technique() != BLADES && form_of(blade.species) == FORM_BILLBOARD {
        return FAR_BILLBOARD_BUCKET | whole;
    }
    let level = level_of(projected_size(blade));
    let bucket = page.species[blade.species].first_bucket + level.index;
    return bucket | (u32(round(level.morph * 31.0)) << 4u) | whole;
}

@compute @workgroup_size(64)
fn explain(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let patch_index = group.x;
    let band_index = patch_index * bands_per_patch() + group.y;
    let local = group.y * BAND + lane;
    let count = patch_blades(patch_index);
    let index = patch_index * page.field.patch_size + local;
    var decision = Decision(NO_BUCKET, 0u);
    if local < count {
        let blade = unpack_blade(index);
        let state = unpack_state(blade, dynamics[index]);
        let place = Place(local, count, (f32(local) + 0.5) / f32(count), 1.0);
        let own = decide(blade, state, place, false);
        let failed = own.failed | failed_with_patch(patch_index, local, count);
        decision.bits = shown(blade, own, failed);
        let is_anchor = local < anchor_count(count);
        let step = select(bands[band_index].step, bands[band_index].anchor_step, is_anchor);
        let advanced = select(0u, ADVANCED, step == frame.step);
        // What rests wakes no one
        let slots = near[patch_index * NEAR_STRIDE];
        let touched = select(0u, TOUCHED, (slots >> 8u) > (slots & 0xffu));
        explained[index] = failed | advanced | touched;
    }
    vote(lane, decision);
    workgroupBarrier();
    if lane == 0u {
        let all = vec2<u32>(0xffffffffu);
        bands[band_index].counts = array<vec4<u32>, 2>(bucket_counts(0u, all), bucket_counts(8u, all));
    }
    if lane < BAND / 2u {
        decisions[band_index * (BAND / 2u) + lane] = atomicLoad(&packed[lane]);
    }
}
