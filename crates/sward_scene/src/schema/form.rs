//! Keys for what a plant is drawn as.

use super::PictureFile;
use serde::Deserialize;

/// What a plant is drawn as near the camera, in views whose technique leaves the choice.
#[derive(Debug, Clone, Default, Deserialize)]
pub enum FormFile {
    /// A curved blade.
    #[default]
    Blade,
    /// Two textured strips; `Strip()` for all defaults.
    Strip(StripFile),
}

/// Two textured strips that share their middle line. Its defaults are those of [`sward::Strip`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct StripFile {
    /// Angle that the two are folded towards each other by, 0..=150; default 60. 0 is flat.
    pub fold_deg: f32,
    /// Radians that the tip swings on a sinusoid of its own phase at wind of strength 1, 0..=1;
    /// default 0.2.
    pub sway: f32,
    /// Most orange in the tint of a plant, 0..=1; default 0.35.
    pub orange: f32,
    /// Height in pixels about which it changes to fewer rings, above 0; default 70.
    pub few_rings_px: f32,
    /// A picture of the blade, in greys that the species' colours tint; default: the library's own.
    pub texture: Option<PictureFile>,
}

impl Default for StripFile {
    fn default() -> Self {
        let sward::Strip { fold_deg, sway, orange, few_rings_px, .. } = sward::Strip::default();
        Self { fold_deg, sway, orange, few_rings_px, texture: None }
    }
}
