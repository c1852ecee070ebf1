// Patch culling: one thread a patch. Lists the patches that a view can see.

@group(2) @binding(1) var<storage, read_write> bands: array<GpuBand>;
@group(2) @binding(2) var<storage, read_write> work: array<vec2<u32>>;
@group(2) @binding(3) var<storage, read_write> work_size: array<atomic<u32>, 8>;

struct Seen {
    visible: bool,
    // No part is outside: its blades need no frustum test
    inside: bool,
}

fn box_in_frustum(low: vec3<f32>, high: vec3<f32>) -> Seen {
    var seen = Seen(true, true);
    for (var i = 0u; i < 6u; i++) {
        let plane = view.planes[i];
        let far_corner = select(low, high, plane.xyz > vec3<f32>(0.0));
        let near_corner = select(high, low, plane.xyz > vec3<f32>(0.0));
        if dot(plane.xyz, far_corner) + plane.w < 0.0 {
            seen.visible = false;
        }
        if dot(plane.xyz, near_corner) + plane.w < 0.0 {
            seen.inside = false;
        }
    }
    return seen;
}

// Blades of the patch's order that any of its points may keep.
fn kept_blades(home: GpuPatch, count: u32, nearest: f32) -> u32 {
    if !has(CULL_DISTANCE) || has(CULL_PAPER) {
        return count;
    }
    let share = keep_share(home.max_width * pixels_per_metre(nearest));
    return u32(clamp(ceil(share * f32(count)), 0.0, f32(count)));
}

@compute @workgroup_size(64)
fn cull(@builtin(global_invocation_id) thread: vec3<u32>) {
    let index = thread.x;
    if index >= field.patch_count {
        return;
    }
    let home = patches[index];
    let count = patch_blades(index);
    var seen = Seen(true, true);
    if has(CULL_FRUSTUM) {
        seen = box_in_frustum(home.reach_min, home.reach_max);
    }
    let nearest_point = clamp(view.eye.xyz, home.reach_min, home.reach_max);
    let nearest = distance_to(nearest_point);
    if has(CULL_DISTANCE) && nearest > view.max_distance {
        seen.visible = false;
    }
    var kept = 0u;
    if seen.visible {
        kept = kept_blades(home, count, nearest);
    }
    for (var b = 0u; b < bands_per_patch(); b++) {
        let band = index * bands_per_patch() + b;
        let first = b * BAND;
        var thinned = 0u;
        if seen.visible && first >= kept && first < count {
            thinned = min(count - first, BAND);
        }
        bands[band].counts = vec4<u32>(0u);
        bands[band].culled = vec2<u32>(0u, thinned);
    }
    if !seen.visible {
        return;
    }
    atomicAdd(&work_size[4], count);
    let slot = atomicAdd(&work_size[0], 1u);
    work[slot] = vec2<u32>(index | (u32(seen.inside) << 31u), kept);
}
