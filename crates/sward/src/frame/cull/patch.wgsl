// What a view sees of a patch.

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
fn kept_blades(index: u32, home: GpuPatch, count: u32, nearest: f32) -> u32 {
    if !has(CULL_DISTANCE) || has(CULL_PAPER) {
        return count;
    }
    switch technique() {
        case STRIPS: { return kept_strips(home, count, nearest); }
        case BILLBOARDS: { return kept_bands(home, count, nearest); }
        case CONTINUUM: { return kept_continuum(index, home, count, nearest); }
        default: { return kept_as_blades(home, count, nearest); }
    }
}

// Metres that what is drawn of a patch may reach beyond its blades' poses.
fn patch_margin(home: GpuPatch) -> f32 {
    if technique() != CONTINUUM {
        return 0.0;
    }
    let cluster = page.field.cluster;
    let scale = pixels_per_metre(nearest_of(home));
    if cluster_progress(cluster.x * scale) <= 0.0 {
        return 0.0;
    }
    return cluster.y * max(widening(cluster_share(cluster, scale)), 1.0);
}

fn see_patch(home: GpuPatch) -> Seen {
    var seen = Seen(true, true);
    if has(CULL_FRUSTUM) {
        let margin = vec3<f32>(patch_margin(home));
        seen = box_in_frustum(home.reach_min - margin, home.reach_max + margin);
    }
    return seen;
}

// Distance to the nearest point of any of its poses.
fn nearest_of(home: GpuPatch) -> f32 {
    return distance_to(clamp(view.eye.xyz, home.reach_min, home.reach_max));
}

fn is_too_far(nearest: f32) -> bool {
    return has(CULL_DISTANCE) && nearest > view.max_distance;
}
