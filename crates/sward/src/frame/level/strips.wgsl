// Strips (O section 4): more rings near, fewer far away.

// Octaves of size over which plants change, each at one of its own: no line of it shows
const STRIP_SPREAD: f32 = 1.0;
// Octaves over which a plant turns into the form with few rings before it does
const STRIP_MORPH: f32 = 0.7;

// 0 many rings, 1 few.
fn strip_level(height_px: f32, few_px: f32, threshold: f32) -> Level {
    let change = few_px * exp2((threshold - 0.5) * STRIP_SPREAD);
    let octaves = clamp(log2(max(height_px, 1e-3) / change), -30.0, 30.0);
    let t = 1.0 - clamp(octaves / STRIP_MORPH, 0.0, 1.0);
    if octaves < 0.0 {
        return Level(1u, 0.0);
    }
    return Level(0u, t * t * (3.0 - 2.0 * t));
}

// Thinned as blades are. Folded, it shows from every side.
fn choose_strip(blade: Blade, size: Size, place: Place) -> Choice {
    var choice = choose_blade(blade, size, place);
    choice.single = false;
    if choice.bucket == NO_BUCKET {
        return choice;
    }
    let height = clamp(size.height * view.detail, view.level_height.x, view.level_height.y);
    let level = strip_level(height, strip_values(blade.species).w, hash01(blade.id, 26u));
    choice.bucket = STRIP_BUCKET + level.index;
    choice.morph = level.morph;
    // The sway bends a strip off its curve
    choice.margin += 0.5 * blade.height * strip_values(blade.species).y;
    return choice;
}

fn kept_strips(home: GpuPatch, count: u32, nearest: f32) -> u32 {
    return kept_as_blades(home, count, nearest);
}
