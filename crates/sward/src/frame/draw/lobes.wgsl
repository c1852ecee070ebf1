// The outline of a dandelion leaf, ours: a stalk, lobes that grow towards the tip and hang back
// towards the root, a blunt end. It is tested at each pixel, so that the lobes do not depend on how
// many segments the blade has.

const STALK: f32 = 0.1;
// Waves of the outline above the stalk: five lobes, the last cut short by the tip
const LOBE_WAVES: f32 = 4.8;
// How much faster a wave rises than it falls
const LOBE_SKEW: f32 = 0.8;
// Width between two lobes, of that of the lobes
const LOBE_NOTCH: f32 = 0.25;
// How far a lobe's point at full width hangs back, in lengths of the blade
const LOBE_SLANT: f32 = 0.08;

// Share of the width at a share of the length, before the lobes hang back.
fn leaf_width(along: f32) -> f32 {
    let t = clamp((along - STALK) / (1.0 - STALK), 0.0, 1.0);
    let phase = 6.2831853 * LOBE_WAVES * t;
    let wave = 0.5 - 0.5 * cos(phase + LOBE_SKEW * sin(phase));
    let grown = sin(1.5707963 * min(1.25 * t, 1.0));
    let lobed = STALK + (1.0 - STALK) * grown * mix(LOBE_NOTCH, 1.0, wave);
    let end = clamp((along - 0.9) / 0.1, 0.0, 1.0);
    return lobed * sqrt(1.0 - end * end);
}

// How far inside the outline a point is, across, in half widths; `side` is 0 at the middle line and
// 1 at the edge. Below 0 it is outside.
fn leaf_inside(along: f32, side: f32) -> f32 {
    let slant = LOBE_SLANT * side * clamp(8.0 * (1.0 - along), 0.0, 1.0);
    return leaf_width(along + slant) - side;
}

// The samples of a pixel to draw. `place`: share of the length, place across from 0 to 1, share of
// the correction of equation 24, which ends as the full width.
fn leaf_samples(place: vec3<f32>) -> u32 {
    let inside = leaf_inside(place.x, abs(2.0 * place.y - 1.0)) + 3.0 * place.z * place.z;
    let covered = clamp(inside / max(fwidth(inside), 1e-6) + 0.5, 0.0, 1.0);
    return (1u << u32(round(covered * f32(SAMPLES)))) - 1u;
}
