// Looked at along the ground, grass hides itself: rays meet a dozen blades before the ground, and all
// but the first few are drawn for nothing. So where plants are thin on the screen only as many are kept
// as hide what all would.

// Blades that a ray meets on its way to the ground which are enough: e to the minus so many is left open.
const ENOUGH_LAYERS: f32 = 8.0;
// At least this share is kept: what stands against the sky has nothing behind it.
const LEAST_ENOUGH: f32 = 0.45;
// Widths in pixels between which plants begin to matter one by one.
const ENOUGH_WIDTH_PX: vec2<f32> = vec2<f32>(1.0, 3.5);

// Share of the plants that is enough, where rays meet the ground at this sine, for plants so wide.
fn enough_at(sine: f32, width_px: f32) -> f32 {
    if technique() != CONTINUUM {
        return 1.0;
    }
    let s = clamp(sine, 0.01, 1.0);
    let met = page.field.layers.x * sqrt(1.0 - s * s) / s + page.field.layers.y;
    let share = clamp(ENOUGH_LAYERS / max(met, 1e-6), LEAST_ENOUGH, 1.0);
    let range = ENOUGH_WIDTH_PX;
    return mix(share, 1.0, clamp((width_px * view.detail - range.x) / (range.y - range.x), 0.0, 1.0));
}

fn enough_share(blade: Blade, width_px: f32) -> f32 {
    return enough_at(abs(dot(blade.up, view_ray(blade.root))), width_px);
}

// How much of the depth that the missing plants would make is put back where light is reckoned.
const DEPTH_KEPT: f32 = 0.6;

// A place of the grass, so high in it: fewer plants let one look deeper into it, where it is darker than
// what all of them would show.
fn depth_among(height_share: f32, enough: f32) -> f32 {
    return 1.0 - (1.0 - height_share) * mix(1.0, enough, DEPTH_KEPT);
}
