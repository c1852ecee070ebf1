//! Keys for fields and species.

use super::{Color, FormFile, PlantFile, Source, Span};
use serde::Deserialize;

/// What grows, and on what.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FieldFile {
    /// Name; default `field N`, N from 0.
    #[serde(default)]
    pub name: Option<String>,
    /// The surface: `Object("name")`, or any source, which then is an object of its own. Needed.
    pub on: Source,
    /// Blades a square metre before thinning, above 0; default 400. Not with `count`.
    #[serde(default)]
    pub density: Option<f32>,
    /// Blades in all, 1 or more, before thinning by map, slope and height. Not with `density`.
    #[serde(default)]
    pub count: Option<u64>,
    /// Same seed, same field; default 1.
    #[serde(default = "first_seed")]
    pub seed: u64,
    /// The mix, 1 to 256 kinds; default: one, of default grass. Not with `plants`.
    #[serde(default)]
    pub species: Option<Vec<SpeciesFile>>,
    /// Plants by probability, in place of `species`; default none.
    #[serde(default)]
    pub plants: Vec<PlantFile>,
    /// From grassland, 0, to garden, 1: the share of flowers among `plants`. Grasses among each other and
    /// flowers among each other keep their probabilities. Default: the probabilities as they are.
    #[serde(default)]
    pub garden: Option<f32>,
    /// Tufts; default none.
    #[serde(default)]
    pub tufts: Option<TuftsFile>,
    /// Map that thins the density; default none.
    #[serde(default)]
    pub density_map: Option<DensityMapFile>,
    /// Only a disk of the surface, seen from above; default all of it. Not with `density_map`.
    #[serde(default)]
    pub inside: Option<InsideFile>,
    /// Map that colours the blades, each by the surface at its root; default none: the species'
    /// colours alone. A texture not with `inside`.
    #[serde(default)]
    pub color: Option<ColorFile>,
    /// How far that map replaces the species' colours, 0..=1; default 0.9.
    #[serde(default = "color_mix")]
    pub color_mix: f32,
    /// Steepest slope that bears grass, 0..=180 from level; default 180, no limit.
    #[serde(default = "any_slope")]
    pub max_slope_deg: f32,
    /// Heights (y) that bear grass; default all.
    #[serde(default = "any_height")]
    pub height_limits_m: Span,
    /// 0 (default) grows along the surface's normal, 1 straight up.
    #[serde(default)]
    pub upright: f32,
    /// Blades a patch: a multiple of 64, 64..=1024; default 256.
    #[serde(default = "patch_size")]
    pub patch_size: u32,
    /// Distance that groups blades: `Euclidean` (default) or `Manhattan`.
    #[serde(default)]
    pub metric: MetricFile,
    /// Order inside a patch: `Progressive` (default), `Morton` or `Lexicographic`.
    #[serde(default)]
    pub order: OrderFile,
    /// Most blades to grow, 1 or more; more is an error; default no limit.
    #[serde(default = "no_limit")]
    pub max_blades: u64,
}

fn first_seed() -> u64 {
    1
}
fn any_slope() -> f32 {
    180.0
}
fn any_height() -> Span {
    Span(f32::NEG_INFINITY, f32::INFINITY)
}
fn patch_size() -> u32 {
    sward::FieldDesc::default().patch_size
}
fn color_mix() -> f32 {
    sward::FieldDesc::default().color_mix
}
fn no_limit() -> u64 {
    u64::MAX
}

/// Tufts.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct TuftsFile {
    /// Share of the blades that grow in tufts, 0..=1; default 0.5.
    pub share: f32,
    /// Least distance between tufts, above 0; default 0.5.
    pub radius_m: f32,
    /// How far from its centre a tuft's blades stand, above 0; default 0.15.
    pub spread_m: f32,
}

impl Default for TuftsFile {
    fn default() -> Self {
        Self { share: 0.5, radius_m: 0.5, spread_m: 0.15 }
    }
}

/// A disk seen from above, in which a field grows: thicker grass near a camera costs little there.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InsideFile {
    /// Centre `(x, z)`. Needed.
    pub center: [f32; 2],
    /// Radius, above 0. Needed.
    pub radius_m: f32,
    /// Width of the rim over which the density fades, 0 to `radius_m`; default 0.
    #[serde(default)]
    pub soft_m: f32,
}

/// A map that thins the density.
#[derive(Debug, Clone, Deserialize)]
pub enum DensityMapFile {
    /// A grey image through the surface's UVs: black is bare, white keeps all.
    Texture(String),
    /// The red of the surface's vertex colours.
    VertexColor,
}

/// A map that colours the blades.
#[derive(Debug, Clone, Deserialize)]
pub enum ColorFile {
    /// An image through the surface's UVs, PNG or JPEG.
    Texture(String),
    /// The object's own materials: base colour, texture and vertex colours.
    Surface,
    /// The surface's vertex colours.
    VertexColor,
}

/// Distance that groups blades.
#[derive(Debug, Clone, Copy, Default, Deserialize)]
pub enum MetricFile {
    /// Straight-line.
    #[default]
    Euclidean,
    /// Sum of the axes.
    Manhattan,
}

/// Order inside a patch.
#[derive(Debug, Clone, Copy, Default, Deserialize)]
pub enum OrderFile {
    /// Every prefix is spread evenly.
    #[default]
    Progressive,
    /// Morton order.
    Morton,
    /// By x, then y, then z.
    Lexicographic,
}

/// Outline of a blade.
#[derive(Debug, Clone, Copy, Deserialize)]
pub enum ShapeFile {
    /// Full width to the top.
    Quad,
    /// Tapers evenly to a point.
    Triangle,
    /// One straight edge, one parabolic.
    Quadratic,
    /// Full width up to this share of the length, 0 to below 1, then a triangle.
    TriangleTip(f32),
    /// A narrow stalk, lobes that hang back towards the root, a blunt end.
    Dandelion,
}

/// One kind of plant. Its defaults are those of [`sward::Species`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SpeciesFile {
    /// Name; default `grass`.
    pub name: String,
    /// Share of the mix, relative to the other species', above 0; default 1.
    pub share: f32,
    /// Outline; default `TriangleTip(0.5)`.
    pub shape: ShapeFile,
    /// What it is drawn as near the camera; default `Blade`.
    pub form: FormFile,
    /// Length of a blade, above 0; default `(0.25, 0.5)`.
    pub height_m: Span,
    /// Full width at the root, above 0; default `(0.008, 0.014)`.
    pub width_m: Span,
    /// How fast a blade returns to rest, 1/s, above 0 and at most 1000; default `(3.5, 6.5)`.
    pub response: Span,
    /// Pull of gravity as a share of the height, 0..=10; default `(0.3, 0.6)`: a lean of 6 to 25
    /// degrees.
    pub droop: Span,
    /// How strongly wind acts, 0..=10; default 1.
    pub gust: f32,
    /// How far the tip may hang over, 0..=1; default 0.2.
    pub arch: f32,
    /// Fold along the middle, 0..=1; default 0.5.
    pub ridge: f32,
    /// Two colours that the root lies between.
    pub root_color: (Color, Color),
    /// Two colours that the tip lies between.
    pub tip_color: (Color, Color),
}

impl Default for SpeciesFile {
    fn default() -> Self {
        let grass = sward::Species::default();
        let span = |range: sward::Range| Span(range.min, range.max);
        let colors = |range: sward::ColorRange| (Color(range.from), Color(range.to));
        Self {
            name: grass.name,
            share: grass.share,
            shape: ShapeFile::TriangleTip(0.5),
            form: FormFile::default(),
            height_m: span(grass.height_m),
            width_m: span(grass.width_m),
            response: span(grass.response),
            droop: span(grass.droop),
            gust: grass.gust,
            arch: grass.arch,
            ridge: grass.ridge,
            root_color: colors(grass.root_color),
            tip_color: colors(grass.tip_color),
        }
    }
}
