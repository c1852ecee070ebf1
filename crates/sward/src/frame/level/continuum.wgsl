// From single plants to clusters of them to bare ground. A patch's first plants are anchors, one of 32:
// far off each is drawn as a cluster that stands for its share, and the others are not drawn. Which
// anchor changes when, and which plants go first, follows from the plant alone: there is no ring.

// Clusters are drawn at most so many times as wide as they are, to leave no more of the ground open
const MOST_WIDER: f32 = 1.5;
// Share of the change over which one cluster grows
const CLUSTER_GROWS: f32 = 0.25;
// Share over which the anchor itself shrinks before
const ANCHOR_SHRINKS: f32 = 0.1;

// How far the change has gone where the grass is so many pixels high: 0 begins, 1 over; down to -1
// before it.
fn cluster_progress(height_px: f32) -> f32 {
    if has(CULL_PAPER) || !has(CULL_DISTANCE) || height_px <= 0.0 {
        return -1.0;
    }
    let range = view.cluster_height;
    return clamp(log2(range.x / max(height_px, 1e-6)) / log2(range.x / range.y), -1.0, 1.0);
}

// Mean growth of the clusters then, which each begin at a point of their own, evenly spread.
fn clusters_grown(change: f32) -> f32 {
    let progress = max(change, 0.0);
    let last = 1.0 - CLUSTER_GROWS;
    let whole = max(progress - CLUSTER_GROWS, 0.0);
    let yet = max(progress - last, 0.0);
    let growing = progress - whole;
    return (whole + (growing * growing - yet * yet) / (2.0 * CLUSTER_GROWS)) / last;
}

// How many of the clusters of this size are kept, as a share that goes beyond 1 up close.
fn cluster_share(cluster: vec4<f32>, scale: f32) -> f32 {
    return max(2.0 * cluster.y * scale / view.least_cluster, 1e-3);
}

// How many times as wide as its picture a cluster is drawn, with what the last ones of a patch lack.
fn cluster_widening(cluster: vec4<f32>, scale: f32, count: u32) -> f32 {
    let stands_for = f32(count) / f32(CLUSTER_BLADES * anchor_count(count));
    return widening(cluster_share(cluster, scale)) * stands_for;
}

// A cluster, `grown` so far.
fn choose_cluster(blade: Blade, size: Size, place: Place, grown: f32) -> Choice {
    let cluster = page.field.cluster;
    let scale = pixels_per_metre(size.distance);
    let gone = canopy_gone(cluster.x * scale * view.detail);
    let kept = mean_kept(cluster_share(cluster, scale)) * (1.0 - gone);
    let rank = (f32(place.local) + 0.5) / f32(anchor_count(place.count));
    var choice: Choice;
    choice.fade = grown * rank_fade(share_that_keeps(kept), rank) * range_fade(size.distance);
    choice.bucket = select(CLUSTER_BUCKET, NO_BUCKET, choice.fade <= 0.0);
    choice.widened = cluster_widening(cluster, scale, place.count);
    choice.margin = cluster.y * max(choice.widened, 1.0) * MOST_WIDER + cluster.z;
    choice.single = false;
    return choice;
}

// A single plant, where so much is left of all of them.
fn choose_near(blade: Blade, size: Size, place: Place, left: f32) -> Choice {
    let own = Place(place.local, place.count, place.rank, left);
    switch form_of(blade.species) {
        case FORM_STRIP: { return choose_strip(blade, size, own); }
        case FORM_BILLBOARD: { return choose_band(blade, size, own); }
        default: { return choose_blade(blade, size, own); }
    }
}

fn choose_continuum(blade: Blade, size: Size, place: Place) -> Choice {
    let height = page.field.cluster.x * pixels_per_metre(size.distance);
    let progress = cluster_progress(height);
    let enough = enough_share(blade, size.width);
    let is_anchor = place.local < anchor_count(place.count);
    let begins = hash01(blade.id, 41u) * (1.0 - CLUSTER_GROWS);
    // Of a far patch nothing else is left
    if ANCHORS || (is_anchor && progress > begins) {
        let grown = min((progress - begins) / CLUSTER_GROWS, 1.0);
        return choose_cluster(blade, size, place, grown);
    }
    var choice = choose_near(blade, size, place, enough * (1.0 - clusters_grown(progress)));
    if is_anchor {
        // The plant itself shrinks before its cluster grows
        choice.fade *= clamp((begins - progress) / ANCHOR_SHRINKS, 0.0, 1.0);
        choice.bucket = select(choice.bucket, NO_BUCKET, choice.fade <= 0.0);
    }
    return choice;
}

// Blades of a patch, spread over it, that tell how it lies.
const LYING: u32 = 4u;

// The most that is enough at any of its points.
fn enough_of_patch(index: u32, home: GpuPatch, count: u32, nearest: f32) -> f32 {
    var sine = 0.0;
    for (var i = 0u; i < min(LYING, count); i++) {
        let blade = unpack_blade(index * page.field.patch_size + i);
        sine = max(sine, abs(dot(blade.up, view_ray(blade.root))));
    }
    let across = 0.5 * distance(home.reach_min, home.reach_max) / max(nearest, 1e-3);
    return enough_at(sine + across, home.max_width * pixels_per_metre(nearest));
}

// Plants of the patch's order that any of its points may keep.
fn kept_continuum(index: u32, home: GpuPatch, count: u32, nearest: f32) -> u32 {
    let cluster = page.field.cluster;
    let scale = pixels_per_metre(nearest);
    let progress = cluster_progress(cluster.x * scale);
    let enough = enough_of_patch(index, home, count, nearest);
    if progress <= 0.0 && enough >= 1.0 {
        return kept_near(home, count, nearest);
    }
    let left = enough * (1.0 - clusters_grown(progress));
    let share = share_that_keeps(left * mean_kept(keep_share(home.max_width * scale)));
    let anchors = anchor_count(count);
    let most = cluster_share(cluster, scale);
    let clusters = select(0.0, ceil(min(most * f32(anchors) + 0.01, f32(anchors))), progress > 0.0);
    let singles = ceil(clamp(share * 1.001 * f32(count), 0.0, f32(count)));
    return u32(max(singles, clusters));
}

// Whether all that is left of a patch are clusters.
fn is_clusters_only(nearest: f32) -> bool {
    let height = page.field.cluster.x * pixels_per_metre(nearest);
    return technique() == CONTINUUM && cluster_progress(height) >= 1.0;
}

// The same where there are no clusters.
fn kept_near(home: GpuPatch, count: u32, nearest: f32) -> u32 {
    return kept_as_blades(home, count, nearest);
}
