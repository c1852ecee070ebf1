// What techniques choose from: a plant's size on the screen, its place in its patch, and the blade of
// J, which is the near form of most species.

struct Size {
    // Pixels
    width: f32,
    height: f32,
    // Share of the blades of this size that are kept
    keep: f32,
    distance: f32,
}

fn projected_size(blade: Blade) -> Size {
    var size: Size;
    size.distance = distance_to(blade.root + blade.up * (0.5 * blade.height));
    let scale = pixels_per_metre(size.distance);
    size.width = blade.width * scale;
    size.height = blade.height * scale;
    size.keep = 1e6;
    if has(CULL_DISTANCE) && !has(CULL_PAPER) {
        size.keep = keep_share(size.width);
    }
    return size;
}

// Blades end within the last tenth of the farthest distance by shrinking.
fn range_fade(distance: f32) -> f32 {
    return clamp((view.max_distance - distance) / (0.1 * view.max_distance), 0.0, 1.0);
}

fn level_of(size: Size) -> Level {
    let height = size.height * view.detail * view.level_scale;
    return choose_level(clamp(height, view.level_height.x, view.level_height.y));
}

// Where a plant stands in its patch.
struct Place {
    // Number in the patch's order, and blades of the patch
    local: u32,
    count: u32,
    // 0..1, the first 0
    rank: f32,
    // Share of all plants that the technique leaves here, beside those of their size
    left: f32,
}

// How a technique draws a plant.
struct Choice {
    // NO_BUCKET: too far away
    bucket: u32,
    // 0: the level's own form; 1: the next level's
    morph: f32,
    // What is left of its width, 0..1
    fade: f32,
    // How many times as wide as it stands there
    widened: f32,
    // Metres that what is drawn reaches beyond the blade's own curve
    margin: f32,
    // One blade: seen edge-on it does not show
    single: bool,
}

// A blade: thinned in the order of its patch where blades are thin on the screen, the others wider.
fn choose_blade(blade: Blade, size: Size, place: Place) -> Choice {
    let level = level_of(size);
    var choice: Choice;
    choice.bucket = page.species[blade.species].first_bucket + level.index;
    choice.morph = level.morph;
    choice.fade = 1.0;
    choice.widened = widening(size.keep);
    choice.margin = blade.width * choice.widened;
    choice.single = true;
    if has(CULL_DISTANCE) && !has(CULL_PAPER) {
        choice.fade = rank_fade(thinned(size.keep, place.left), place.rank) * range_fade(size.distance);
        if choice.fade <= 0.0 {
            choice.bucket = NO_BUCKET;
        }
    }
    return choice;
}

// Blades of the patch's order that any of its points may keep.
fn kept_as_blades(home: GpuPatch, count: u32, nearest: f32) -> u32 {
    let share = keep_share(home.max_width * pixels_per_metre(nearest));
    return u32(clamp(ceil(share * f32(count)), 0.0, f32(count)));
}
