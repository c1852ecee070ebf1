//! The scene file: its keys, units, ranges and defaults. Unknown keys are errors; every key may be
//! left out except where it says so. Distances are metres, angles degrees, y is up. Colours are
//! `"#rrggbb"` (sRGB) or `(r, g, b)` (linear, 0..=1). A range is `(min, max)` or one number. Paths
//! are relative to the scene file.

mod bodies;
mod collide;
mod effects;
mod field;
mod form;
mod light;
mod motion;
mod object;
mod picture;
mod plants;
mod source;
mod value;
mod wind;

pub use bodies::{BodiesFile, BodyShapeFile};
pub use collide::{CollideFile, PackedFile};
pub use effects::{DepthOfFieldFile, FogFile};
pub use field::{
    ColorFile, DensityMapFile, FieldFile, InsideFile, MetricFile, OrderFile, ShapeFile,
    SpeciesFile, TuftsFile,
};
pub use form::{FormFile, StripFile};
pub use light::{
    CullingFile, DaylightFile, GravityFile, GroundFile, PhysicsFile, SkyFile, SunFile,
    TechniqueFile, ToneFile,
};
pub use motion::{PathFile, PathKeyFile};
pub use object::{ObjectFile, Scale, ScatterFile};
pub use picture::PictureFile;
pub use plants::{BandsFile, PlantFile, ShadeFile};
pub use source::{
    HeightmapFile, MobiusFile, PlaneFile, RockFile, Source, SphereMeshFile, TerrainFile, TorusFile,
    TreeFile,
};
pub(crate) use value::linear_from_srgb;
pub use value::{Color, Span};
pub use wind::{
    CosineFile, FanFile, GustsFile, RotorFile, VortexFile, WavesFile, WindFile, WindTextureFile,
};

use serde::Deserialize;

/// The whole file.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SceneFile {
    /// Name; default: the file's stem.
    pub name: Option<String>,
    /// Opaque things; default none.
    pub objects: Vec<ObjectFile>,
    /// What grows; at least one is needed.
    pub fields: Vec<FieldFile>,
    /// Cameras, the first is the default; default: one that frames the first field.
    pub cameras: Vec<CameraFile>,
    /// Terms of the wind; default: a breeze with waves and gusts; `[]` is still air.
    pub wind: Vec<WindFile>,
    /// Spheres that push blades; default none.
    pub spheres: Vec<SphereFile>,
    /// Rigid bodies, which fall, bounce, roll and push blades; default none.
    pub bodies: Vec<BodiesFile>,
    /// The sun; default: a warm one at 38 degrees.
    pub sun: Option<SunFile>,
    /// Sky and haze; default: clear.
    pub sky: Option<SkyFile>,
    /// Sun and sky by the time of day, in place of `sun` and `sky`; default none.
    pub light: Option<DaylightFile>,
    /// Stops that the picture is exposed by, -20..=20; default: with `light` as many as suit it, else 0.
    pub exposure_ev: Option<f32>,
    /// How light becomes colours: `Neutral`, or `Agx`, the default with `light`.
    pub tone: Option<ToneFile>,
    /// Fog by distance; default none.
    pub fog: Option<FogFile>,
    /// Depth of field; default none: all is in focus.
    pub depth_of_field: Option<DepthOfFieldFile>,
    /// Look of bare ground.
    pub ground: GroundFile,
    /// Gravity.
    pub gravity: GravityFile,
    /// Physical model: `Sward` (default) or `Paper`.
    pub physics: PhysicsFile,
    /// Which forms plants are drawn in: `Blades`, `Strips`, `Billboards` or `Continuum` (default).
    pub technique: TechniqueFile,
    /// Which tests cull blades.
    pub culling: CullingFile,
    /// Where plants change from models to quads.
    pub bands: BandsFile,
    /// What moves between the field and the sun: clouds, or crowns of trees; default nothing.
    pub shade: Option<ShadeFile>,
    /// Seconds simulated before time 0, 0..=60; default 3. Longer starts later and in fuller motion.
    pub warm_up_s: f32,
    /// Frames a second, 1..=1000; default 30.
    pub fps: f32,
}

impl Default for SceneFile {
    fn default() -> Self {
        Self {
            name: None,
            objects: Vec::new(),
            fields: Vec::new(),
            cameras: Vec::new(),
            wind: vec![
                WindFile::Waves(WavesFile::default()),
                WindFile::Gusts(GustsFile::default()),
            ],
            spheres: Vec::new(),
            bodies: Vec::new(),
            sun: None,
            sky: None,
            light: None,
            exposure_ev: None,
            tone: None,
            fog: None,
            depth_of_field: None,
            ground: GroundFile::default(),
            gravity: GravityFile::default(),
            physics: PhysicsFile::default(),
            technique: TechniqueFile::default(),
            culling: CullingFile::default(),
            bands: BandsFile::default(),
            shade: None,
            warm_up_s: 3.0,
            fps: 30.0,
        }
    }
}

/// A camera.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CameraFile {
    /// Name; default `camera N`, N from 0.
    #[serde(default)]
    pub name: Option<String>,
    /// Where it stands. Needed.
    pub eye: [f32; 3],
    /// What it looks at. Needed; must differ from `eye`.
    pub target: [f32; 3],
    /// Which way is up; default `(0, 1, 0)`; must not be along the line of sight.
    #[serde(default = "up")]
    pub up: [f32; 3],
    /// Vertical field of view, 1..=170; default 50.
    #[serde(default = "fov")]
    pub vertical_fov_deg: f32,
    /// Nearest distance drawn, above 0; default 0.1.
    #[serde(default = "near")]
    pub near_m: f32,
    /// Farthest distance drawn, above `near_m`; default 1000.
    #[serde(default = "far")]
    pub far_m: f32,
    /// An object by name: then the heights (y) of `eye` and `target` are above that object.
    #[serde(default)]
    pub above: Option<String>,
}

fn up() -> [f32; 3] {
    [0.0, 1.0, 0.0]
}
fn fov() -> f32 {
    50.0
}
fn near() -> f32 {
    0.1
}
fn far() -> f32 {
    1000.0
}

/// A sphere that pushes blades: `at` for one that rests, or `path` for one that moves.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SphereFile {
    /// Name; default `sphere N`.
    pub name: Option<String>,
    /// Radius, above 0; default 0.5.
    pub radius_m: f32,
    /// Centre of a sphere that rests; default `(0, 0, 0)`.
    pub at: [f32; 3],
    /// Where it moves, in place of `at`; default none.
    pub path: Option<PathFile>,
    /// An object by name: then y is the height of the sphere's lowest point above that object, and
    /// the path follows it. Where it touches, it rolls.
    pub above: Option<String>,
    /// Whether it is drawn; default true.
    pub visible: bool,
    /// Colour; default a warm grey.
    pub base_color: Color,
    /// Colour of every other stripe, by which its turning shows; default none: it is plain.
    pub stripe_color: Option<Color>,
    /// Roughness, 0..=1; default 0.5.
    pub roughness: f32,
}

impl Default for SphereFile {
    fn default() -> Self {
        Self {
            name: None,
            radius_m: 0.5,
            at: [0.0; 3],
            path: None,
            above: None,
            visible: true,
            base_color: Color([0.42, 0.38, 0.34]),
            stripe_color: None,
            roughness: 0.5,
        }
    }
}
