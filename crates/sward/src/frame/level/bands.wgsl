// Three bands of distance (Wang and Yao): modelled plants, quads, and fewer and coarser quads.

// The last share of the middle band over which quads turn into the far ones.
const BAND_MORPH: f32 = 0.5;
// Over how much of a distance, beyond the middle band, plants thin out
const BAND_THIN: f32 = 1.0;
const BAND_SALT: u32 = 31u;

// How many times as far as the settings say this plant changes: its own share, which is the same for
// all of its changes and for every frame, so that it never goes back and forth.
fn band_stretch(id: u32) -> f32 {
    return view.detail * (1.0 + view.bands.w * (2.0 * hash01(id, BAND_SALT) - 1.0));
}

fn smooth_share(x: f32) -> f32 {
    let t = clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// How far the plant is on its way to the far form: 0 in the near band, 1 from the far band on.
fn band_morph(distance: f32, stretch: f32) -> f32 {
    let end = view.bands.y * stretch;
    let start = mix(view.bands.y, view.bands.x, BAND_MORPH) * stretch;
    if distance <= start {
        return 0.0;
    }
    return smooth_share((distance - start) / (end - start));
}

fn is_modelled(species: u32) -> bool {
    return (page.species[species].look.w & 0x100u) != 0u;
}

// As `Size.keep`, of a plant so wide.
fn plant_keep(width: f32, distance: f32) -> f32 {
    return keep_share(width * pixels_per_metre(distance));
}

// Share of the plants that are kept, beyond 1 where none has begun to go.
fn band_keep(distance: f32, stretch: f32, keep: f32) -> f32 {
    let end = view.bands.y * stretch;
    if !has(CULL_DISTANCE) || has(CULL_PAPER) {
        return 1e6;
    }
    var share = 1.0 / (1.0 - FADE_SHARE);
    if distance > end {
        share = mix(share, view.far_share, smooth_share((distance / end - 1.0) / BAND_THIN));
    }
    return min(share, keep);
}

// A plant of quads.
fn choose_plant(blade: Blade, size: Size, place: Place) -> Choice {
    let stretch = band_stretch(blade.id);
    let share = band_keep(size.distance, stretch, size.keep);
    var choice: Choice;
    choice.morph = band_morph(size.distance, stretch);
    choice.widened = widening(share);
    choice.margin = 0.5 * blade.width * choice.widened;
    choice.single = false;
    choice.bucket = select(BILLBOARD_BUCKET, FAR_BILLBOARD_BUCKET, choice.morph >= 1.0);
    if size.distance < view.bands.x * stretch && is_modelled(blade.species) {
        choice.bucket = MODEL_BUCKET;
        choice.morph = smooth_share(size.distance / (view.bands.x * stretch) * 2.0 - 1.0);
    }
    choice.fade = 1.0;
    if has(CULL_DISTANCE) && !has(CULL_PAPER) {
        let end = clamp((1.0 - size.distance / (view.bands.z * stretch)) * 10.0, 0.0, 1.0);
        choice.fade = rank_fade(thinned(share, place.left), place.rank) * range_fade(size.distance) * end;
        if choice.fade <= 0.0 {
            choice.bucket = NO_BUCKET;
        }
    }
    return choice;
}

fn choose_band(blade: Blade, size: Size, place: Place) -> Choice {
    if form_of(blade.species) == FORM_BILLBOARD {
        return choose_plant(blade, size, place);
    }
    return choose_blade(blade, size, place);
}

// Plants go where blades of their width would, or before.
fn kept_bands(home: GpuPatch, count: u32, nearest: f32) -> u32 {
    return kept_as_blades(home, count, nearest);
}
