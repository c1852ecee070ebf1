//! Keys for rigid bodies.

use super::{Color, Span};
use serde::Deserialize;

/// Bodies of one kind, which fall, bounce, roll and push blades.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct BodiesFile {
    /// Name; default `bodies N`.
    pub name: Option<String>,
    /// Shape; default `Sphere()`.
    pub shape: BodyShapeFile,
    /// How many, 1..=10000; default 1.
    pub count: u32,
    /// How much bigger or smaller each is, above 0; default 1.
    pub copy_scale: Span,
    /// Middle of the box that they start in; default `(0, 1, 0)`.
    pub at: [f32; 3],
    /// Half the box's edges, 0 or more; default 0.
    pub spread_m: [f32; 3],
    /// An object by name: heights then are those of the lowest point over it. Default: none.
    pub above: Option<String>,
    /// Velocity at the start, metres a second; default 0.
    pub velocity_mps: [f32; 3],
    /// Most that each one's own velocity differs, 0 or more; default 0.
    pub velocity_spread_mps: f32,
    /// Spin at the start, turns a second about each axis; default 0.
    pub spin_rps: [f32; 3],
    /// Most that each one's own spin differs, 0 or more; default 0.
    pub spin_spread_rps: f32,
    /// When the first starts, 0..=100000 seconds; default 0. Until it starts a body is not there.
    pub start_s: f32,
    /// Seconds from one to the next, 0..=1000; default 0: all at once.
    pub every_s: f32,
    /// How high they bounce, 0..=1; default 0.4.
    pub restitution: f32,
    /// Coulomb friction, 0..=10; default 0.7.
    pub friction: f32,
    /// Density, 0.001..=100000 kilograms a cubic metre; default 200, a light ball. It matters only
    /// where bodies meet.
    pub density_kgpm3: f32,
    /// How much grass slows what is in it, 0..=100; default 1: deep in it, by 1 m/s each second and
    /// by 60 % of its speed.
    pub grass_drag: f32,
    /// Same seed, same throw; default 1.
    pub seed: u64,
    /// Whether they are drawn; default true.
    pub visible: bool,
    /// Colours that they take in turn; default a warm grey.
    pub colors: Vec<Color>,
    /// Colour of every other stripe of a sphere; default none: they are plain.
    pub stripe_color: Option<Color>,
    /// Roughness, 0..=1; default 0.5.
    pub roughness: f32,
}

impl Default for BodiesFile {
    fn default() -> Self {
        Self {
            name: None,
            shape: BodyShapeFile::Sphere { radius_m: 0.15 },
            count: 1,
            copy_scale: Span(1.0, 1.0),
            at: [0.0, 1.0, 0.0],
            spread_m: [0.0; 3],
            above: None,
            velocity_mps: [0.0; 3],
            velocity_spread_mps: 0.0,
            spin_rps: [0.0; 3],
            spin_spread_rps: 0.0,
            start_s: 0.0,
            every_s: 0.0,
            restitution: 0.4,
            friction: 0.7,
            density_kgpm3: 200.0,
            grass_drag: 1.0,
            seed: 1,
            visible: true,
            colors: vec![Color([0.42, 0.38, 0.34])],
            stripe_color: None,
            roughness: 0.5,
        }
    }
}

/// What a body is.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum BodyShapeFile {
    /// A ball.
    Sphere {
        /// Radius, above 0; default 0.15.
        #[serde(default = "ball")]
        radius_m: f32,
    },
    /// A box.
    Box {
        /// Edges, above 0; default 0.3 each.
        #[serde(default = "edges")]
        size_m: [f32; 3],
    },
    /// A ball drawn out along y.
    Capsule {
        /// Radius, above 0; default 0.1.
        #[serde(default = "rod")]
        radius_m: f32,
        /// Length from end to end, more than twice the radius; default 0.5.
        #[serde(default = "long")]
        length_m: f32,
    },
}

fn ball() -> f32 {
    0.15
}
fn edges() -> [f32; 3] {
    [0.3; 3]
}
fn rod() -> f32 {
    0.1
}
fn long() -> f32 {
    0.5
}
