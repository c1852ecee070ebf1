//! Keys for plants by probability, and for the bands that they are drawn in.

use super::{PictureFile, Span};
use serde::Deserialize;

/// One kind of plant. Its defaults are those of [`sward::Species::plant`] and [`sward::Billboard`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlantFile {
    /// `meadow-grass`, `tall-grass`, `fine-grass`, `clover`, `daisy`, `poppy`, `cornflower` or
    /// `dandelion-clock`. Needed, but with `picture`.
    #[serde(default)]
    pub kind: Option<String>,
    /// Pictures of the scene's own in place of the library's; such a plant has no model. Without a
    /// kind it is as wide as high.
    #[serde(default)]
    pub picture: Option<PictureFile>,
    /// Whether it counts as a flower for `garden`; default: kinds that are no grass, and pictures.
    #[serde(default)]
    pub flower: Option<bool>,
    /// How likely a plant is of this kind, 0 or more. Needed. All together should add up to 1; where
    /// they do not, each is divided by their sum.
    pub probability: f32,
    /// Height, above 0; default: that of the kind, `(0.25, 0.5)` without one.
    #[serde(default)]
    pub height_m: Option<Span>,
    /// Times its common width, 0.1..=10; default 1.
    #[serde(default = "one")]
    pub stretch: f32,
    /// How common small, medium and large ones are, relative to each other, 0 or more and not all 0:
    /// the lower, middle and upper third of its heights; default `(0.3, 0.5, 0.2)`.
    #[serde(default = "sizes")]
    pub sizes: (f32, f32, f32),
    /// Quads, 1..=6; default 3.
    #[serde(default = "three")]
    pub quads: u32,
    /// Angle from one quad to the next, 0..=180; default 180 over the number of quads.
    #[serde(default)]
    pub angle_deg: Option<f32>,
    /// How plants are turned about their up direction; default any way, `(0, 360)`.
    #[serde(default = "any_turn")]
    pub turn_deg: Span,
    /// How strongly wind acts, 0..=10; default 1.
    #[serde(default = "one")]
    pub gust: f32,
    /// How far wind from the side turns it, 0..=4; default 1.
    #[serde(default = "one")]
    pub wind_turn: f32,
    /// How much lighter it gets as wind bends it, 0..=1; default 0.3.
    #[serde(default = "tint")]
    pub wind_tint: f32,
    /// How much light it keeps from what is behind it, 0..=2; default 0.4.
    #[serde(default = "absorption")]
    pub absorption: f32,
}

fn one() -> f32 {
    1.0
}
fn three() -> u32 {
    3
}
fn sizes() -> (f32, f32, f32) {
    let sward::Sizes { small, medium, large } = sward::Sizes::default();
    (small, medium, large)
}
fn any_turn() -> Span {
    Span(0.0, 360.0)
}
fn tint() -> f32 {
    0.3
}
fn absorption() -> f32 {
    0.4
}

/// Where plants change from models to quads to coarser quads. Its defaults are those of
/// [`sward::Bands`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct BandsFile {
    /// Where the near, the middle and the far band end, three rising distances above 0; default
    /// `[6, 30, inf]`.
    pub distances_m: Vec<f32>,
    /// How much a plant's own distances differ from these, as a share of them, 0..=0.9; default 0.25.
    pub jitter: f32,
    /// Share of the plants that are kept far off, above 0 and at most 1; default 0.7.
    pub far_share: f32,
    /// Height of plants far off, above 0 and at most 1; default 0.92.
    pub far_size: f32,
}

impl Default for BandsFile {
    fn default() -> Self {
        let bands = sward::Bands::default();
        Self {
            distances_m: vec![bands.near_m, bands.middle_m, bands.far_m],
            jitter: bands.jitter,
            far_share: bands.far_share,
            far_size: bands.far_size,
        }
    }
}

/// What moves between the field and the sun. Its defaults are those of [`sward::Shade`], but for the depth.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ShadeFile {
    /// Share of the sun kept away where it is darkest, 0..=1; default 0.6.
    pub depth: f32,
    /// Size of its patches, 0.01..=100000; default 12.
    pub size_m: f32,
    /// Its height (y); default 40. The higher, the farther its shadows move with the sun.
    pub height_m: f32,
    /// How it drifts, `(x, z)`, metres a second, -1000..=1000 each; default `(1.5, 0.5)`.
    pub drift_mps: [f32; 2],
}

impl Default for ShadeFile {
    fn default() -> Self {
        let shade = sward::Shade::default();
        Self { depth: 0.6, size_m: shade.size_m, height_m: shade.height_m, drift_mps: [1.5, 0.5] }
    }
}
