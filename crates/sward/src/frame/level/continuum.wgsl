// From single plants to clusters of them to bare ground. A patch's first plants are anchors, one of 32:
// far off each is drawn as a cluster that stands for its share, and the others are not drawn. Which
// anchor changes when, and which plants go first, follows from the plant alone: there is no ring.

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

// What `rank_fade` leaves of all plants in the mean.
fn mean_kept(share: f32) -> f32 {
    return 1.0 / widening(share);
}

// The share that leaves so much: the inverse of `mean_kept`.
fn share_that_keeps(mean: f32) -> f32 {
    let half = 1.0 - 0.5 * FADE_SHARE;
    if mean <= half {
        return mean / half;
    }
    let shy = 1.0 - FADE_SHARE;
    let b = shy + FADE_SHARE * (1.0 - mean);
    return (b - sqrt(max(b * b - shy * shy, 0.0))) / (shy * shy);
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
    let cluster = field.cluster;
    let scale = pixels_per_metre(size.distance);
    let gone = canopy_gone(cluster.x * scale * view.detail);
    let kept = mean_kept(cluster_share(cluster, scale)) * (1.0 - gone);
    let rank = (f32(place.local) + 0.5) / f32(anchor_count(place.count));
    var choice: Choice;
    choice.fade = grown * rank_fade(share_that_keeps(kept), rank) * range_fade(size.distance);
    choice.bucket = select(CLUSTER_BUCKET, NO_BUCKET, choice.fade <= 0.0);
    choice.widened = cluster_widening(cluster, scale, place.count);
    choice.margin = cluster.y * max(choice.widened, 1.0) + cluster.z;
    choice.single = false;
    return choice;
}

// A single plant, where so much is left of all of them.
fn choose_near(blade: Blade, size: Size, place: Place, left: f32) -> Choice {
    switch form_of(blade.species) {
        case FORM_STRIP: { return thinned_further(choose_strip(blade, size, place), place, left); }
        case FORM_BILLBOARD: { return thinned_further(choose_band(blade, size, place), place, left); }
        default: {
            let thinned = share_that_keeps(left * mean_kept(size.keep));
            return choose_thinned_blade(blade, size, place, select(thinned, size.keep, left >= 1.0));
        }
    }
}

fn thinned_further(form: Choice, place: Place, left: f32) -> Choice {
    var choice = form;
    if left < 1.0 {
        choice.fade *= rank_fade(share_that_keeps(left), place.rank);
        choice.bucket = select(choice.bucket, NO_BUCKET, choice.fade <= 0.0);
    }
    return choice;
}

fn choose_continuum(blade: Blade, size: Size, place: Place) -> Choice {
    let height = field.cluster.x * pixels_per_metre(size.distance);
    let progress = cluster_progress(height);
    let is_anchor = place.local < anchor_count(place.count);
    let begins = hash01(blade.id, 41u) * (1.0 - CLUSTER_GROWS);
    // Of a far patch nothing else is left
    if ANCHORS || (is_anchor && progress > begins) {
        let grown = min((progress - begins) / CLUSTER_GROWS, 1.0);
        return choose_cluster(blade, size, place, grown);
    }
    var choice = choose_near(blade, size, place, 1.0 - clusters_grown(progress));
    if is_anchor {
        // The plant itself shrinks before its cluster grows
        choice.fade *= clamp((begins - progress) / ANCHOR_SHRINKS, 0.0, 1.0);
        choice.bucket = select(choice.bucket, NO_BUCKET, choice.fade <= 0.0);
    }
    return choice;
}

// Plants of the patch's order that any of its points may keep.
fn kept_continuum(home: GpuPatch, count: u32, nearest: f32) -> u32 {
    let cluster = field.cluster;
    let scale = pixels_per_metre(nearest);
    let progress = cluster_progress(cluster.x * scale);
    if progress <= 0.0 {
        return kept_near(home, count, nearest);
    }
    let left = 1.0 - clusters_grown(progress);
    let share = share_that_keeps(left * mean_kept(keep_share(home.max_width * scale)));
    let anchors = anchor_count(count);
    let clusters = ceil(min(cluster_share(cluster, scale) * f32(anchors), f32(anchors)));
    let singles = ceil(clamp(share * 1.001 * f32(count), 0.0, f32(count)));
    return u32(max(singles, clusters));
}

// Whether all that is left of a patch are clusters.
fn is_clusters_only(nearest: f32) -> bool {
    let height = field.cluster.x * pixels_per_metre(nearest);
    return technique() == CONTINUUM && cluster_progress(height) >= 1.0;
}

// The same where there are no clusters.
fn kept_near(home: GpuPatch, count: u32, nearest: f32) -> u32 {
    return kept_as_blades(home, count, nearest);
}
