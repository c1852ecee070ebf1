// Patch culling: one thread a patch of the seen blocks. Lists the patches that a view can see.

@group(2) @binding(1) var<storage, read_write> bands: array<GpuBand>;
@group(2) @binding(2) var<storage, read_write> work: array<vec2<u32>>;
@group(2) @binding(3) var<storage, read_write> work_size: array<atomic<u32>, 12>;

@group(2) @binding(5) var<uniform> seen_blocks: array<vec4<u32>, 68>;

// First row and rows of each column of cells, where the view sweeps
@group(2) @binding(4) var<storage, read> columns: array<vec2<u32>>;

// The sweep answers in place of the patch's own test; it does not know what is wholly inside.
fn see_swept(home: GpuPatch) -> Seen {
    let rows = columns[home.cell >> 16u];
    return Seen((home.cell & 0xffffu) - rows.x < rows.y, false);
}

fn list_far(entry: vec2<u32>) {
    let slot = atomicAdd(&work_size[FAR_PATCHES], 1u);
    work[first_far_entry() + slot] = entry;
    atomicMax(&work_size[FAR_GROUPS], slot / far_patches_a_group() + 1u);
}

@compute @workgroup_size(64)
fn cull(@builtin(global_invocation_id) thread: vec3<u32>) {
    let index = seen_patch(thread.x);
    if index >= page.field.patch_count {
        return;
    }
    let home = patches[index];
    let count = patch_blades(index);
    var seen: Seen;
    if has(GROUND_SWEPT) {
        seen = see_swept(home);
    } else {
        seen = see_patch(home);
    }
    let nearest = nearest_of(home);
    if is_too_far(nearest) {
        seen.visible = false;
    }
    var kept = 0u;
    if seen.visible {
        kept = kept_blades(index, home, count, nearest);
    }
    // All bands, as the scan has left places in their counts, those beyond the last patch's blades included.
    // `count` is never more: with a bound by the uniform alone a driver would unroll the loop anew in each frame
    let end = max(count, page.field.patch_size);
    for (var b = 0u; b * BAND < end; b++) {
        let band = index * bands_per_patch() + b;
        let first = b * BAND;
        var thinned = 0u;
        if seen.visible && first >= kept && first < count {
            thinned = min(count - first, BAND);
        }
        bands[band].counts = array<vec4<u32>, 2>();
        bands[band].culled = thinned << 16u;
    }
    if !seen.visible {
        return;
    }
    atomicAdd(&work_size[PATCHES_VISIBLE], 1u);
    atomicAdd(&work_size[BLADES_VISIBLE], count);
    if is_clusters_only(nearest) {
        list_far(work_entry(index, seen.inside, kept, 0u));
        return;
    }
    let groups = (kept + BAND - 1u) / BAND;
    let slot = atomicAdd(&work_size[BAND_GROUPS], groups);
    for (var b = 0u; b < groups; b++) {
        work[slot + b] = work_entry(index, seen.inside, kept, b);
    }
}
