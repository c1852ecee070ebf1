//! The colours of a field's blades, as blade_point.wgsl gives them.

use crate::Species;
use crate::gpu::quantize::{pack_color, unpack_color};
use crate::shared::noise_twin::hash01;
use glam::Vec3;

/// Tones that a surface's colour is multiplied by at the root and at the tip.
const TINT_TONES: [f32; 2] = [0.8, 1.05];

/// Colours of a blade at tones 0, its root, and 1: between them they are mixed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Tones {
    /// Without what it takes of its surface's colour.
    pub plain: [Vec3; 2],
    /// What the surface's colour is multiplied by, and added.
    pub tint: [f32; 2],
}

/// `id` is the blade's index in its field, `mix` how far the surface's colour replaces its own.
pub(crate) fn tones(species: &Species, id: u32, mix: f32) -> Tones {
    let (pick, other) = (hash01(id, 21), hash01(id, 22));
    let kept = |color| Vec3::from(unpack_color(pack_color(color)));
    let (low, high) = (&species.root_color, &species.tip_color);
    let root = kept(low.from).lerp(kept(low.to), other);
    let tip = kept(high.from).lerp(kept(high.to), pick);
    let bright = 0.85 + 0.3 * other;
    Tones {
        plain: [root, tip].map(|color| color * (bright * (1.0 - mix))),
        tint: TINT_TONES.map(|tone| tone * bright * mix),
    }
}

/// Of a plant of quads whose pictures have that mean colour: the twin of `plant_tone` in look.wgsl,
/// without wind.
pub(crate) fn plant_tones(mean: Vec3, id: u32) -> Tones {
    Tones { plain: [mean * (0.85 + 0.3 * hash01(id, 22)); 2], tint: [0.0; 2] }
}

/// Tone at the curve's parameter.
pub(crate) fn tone_at(v: f32) -> f32 {
    v * (1.5 - 0.5 * v)
}

impl Tones {
    /// On a surface of that colour.
    pub(crate) fn on(&self, surface: Vec3) -> [Vec3; 2] {
        [0, 1].map(|end| self.plain[end] + surface * self.tint[end])
    }
}
