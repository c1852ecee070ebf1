//! Keys for what a mesh is made from.

use super::Color;
use serde::Deserialize;

/// What a mesh is made from.
#[derive(Debug, Clone, Deserialize)]
pub enum Source {
    /// A mesh file: `.obj`, `.gltf` or `.glb`.
    File(String),
    /// For a field's `on`: an object of the scene, by name.
    Object(String),
    /// A height image: hills, centred on the origin.
    Heightmap(HeightmapFile),
    /// A level rectangle, centred on the origin.
    Plane(PlaneFile),
    /// Hills from noise, centred on the origin.
    Terrain(TerrainFile),
    /// A ball about the origin, smooth or hilly.
    Sphere(SphereMeshFile),
    /// A ring about the y axis.
    Torus(TorusFile),
    /// A band with one side.
    Mobius(MobiusFile),
    /// A boulder that stands on the origin, a third of it below.
    Rock(RockFile),
    /// A broad-leaved tree, its foot at the origin: trunk and crown in one mesh.
    Tree(TreeFile),
}

/// A height image. Black is `base_m`, white `base_m + height_m`. 16-bit grey PNG; 8 bits make
/// steps, which the smoothing hides only partly.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HeightmapFile {
    /// PNG file. Needed.
    pub file: String,
    /// Extent in x and z, above 0; default `(100, 100)`.
    #[serde(default = "hundred")]
    pub size_m: [f32; 2],
    /// Height of white above black; default 10.
    #[serde(default = "ten")]
    pub height_m: f32,
    /// Height of black; default 0.
    #[serde(default)]
    pub base_m: f32,
    /// Radius of a Gaussian blur, 0 or more; default 0. Rounds small bumps off.
    #[serde(default)]
    pub smooth_m: f32,
    /// Vertices along the longer side, 2..=2049; default: the image's own, at least 257. More than
    /// the image has are interpolated smoothly (bicubic), so that hills show no facets.
    #[serde(default)]
    pub samples: Option<u32>,
}

fn ten() -> f32 {
    10.0
}
fn hundred() -> [f32; 2] {
    [100.0; 2]
}

/// A level rectangle.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct PlaneFile {
    /// Extent in x and z, above 0; default `(20, 20)`.
    pub size_m: [f32; 2],
    /// Cells in x and z, 1..=2048; default `(1, 1)`.
    pub divisions: [u32; 2],
}

impl Default for PlaneFile {
    fn default() -> Self {
        Self { size_m: [20.0; 2], divisions: [1; 2] }
    }
}

/// Hills from noise.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct TerrainFile {
    /// Side of the square, above 0; default 60.
    pub size_m: f32,
    /// Height from the lowest valley to the highest hill, about; 0 or more; default 4.
    pub relief_m: f32,
    /// Distance between hills, about; above 0; default 30.
    pub hill_m: f32,
    /// Mean height; default 0.
    pub base_m: f32,
    /// Layers of noise, 1..=10; default 4: more is rougher.
    pub octaves: u32,
    /// Cells along the side, 1..=2048; default 192.
    pub divisions: u32,
    /// Same seed, same hills; default 1.
    pub seed: u64,
}

impl Default for TerrainFile {
    fn default() -> Self {
        Self {
            size_m: 60.0,
            relief_m: 4.0,
            hill_m: 30.0,
            base_m: 0.0,
            octaves: 4,
            divisions: 192,
            seed: 1,
        }
    }
}

/// A ball.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SphereMeshFile {
    /// Radius, above 0; default 1.
    pub radius_m: f32,
    /// Segments round it, 4..=1024; default 64.
    pub segments: u32,
    /// Height from the lowest valley to the highest hill, about; 0 to the radius; default 0. The
    /// radius is the mean.
    pub relief_m: f32,
    /// Distance between hills, about; above 0; default: the radius.
    pub hill_m: Option<f32>,
    /// Same seed, same hills; default 1.
    pub seed: u32,
}

impl Default for SphereMeshFile {
    fn default() -> Self {
        Self { radius_m: 1.0, segments: 64, relief_m: 0.0, hill_m: None, seed: 1 }
    }
}

/// A ring.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct TorusFile {
    /// Radius of the ring's middle line, above `tube_m`; default 2.
    pub radius_m: f32,
    /// Radius of the tube, above 0; default 0.7.
    pub tube_m: f32,
    /// Segments round the ring, 4..=1024, half as many round the tube; default 96.
    pub segments: u32,
}

impl Default for TorusFile {
    fn default() -> Self {
        Self { radius_m: 2.0, tube_m: 0.7, segments: 96 }
    }
}

/// A Mobius strip.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct MobiusFile {
    /// Radius of the middle line, above half of `width_m`; default 2.
    pub radius_m: f32,
    /// Width of the band, above 0; default 1.
    pub width_m: f32,
    /// Segments round it, 4..=1024; default 128.
    pub segments: u32,
}

impl Default for MobiusFile {
    fn default() -> Self {
        Self { radius_m: 2.0, width_m: 1.0, segments: 128 }
    }
}

/// A boulder.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RockFile {
    /// Radius, about; above 0; default 0.5.
    pub radius_m: f32,
    /// How far the surface strays from a ball, 0..=1 of the radius; default 0.35.
    pub rough: f32,
    /// Same seed, same rock; default 1. Each copy takes the next, of 64; then they come again.
    pub seed: u32,
}

impl Default for RockFile {
    fn default() -> Self {
        Self { radius_m: 0.5, rough: 0.35, seed: 1 }
    }
}

/// A tree.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct TreeFile {
    /// Height, above 0; default 7.
    pub height_m: f32,
    /// Radius of the crown, above 0; default 2.4.
    pub crown_m: f32,
    /// Colour of the leaves.
    pub leaf_color: Color,
    /// Colour of the bark.
    pub bark_color: Color,
    /// Same seed, same tree; default 1. Each copy takes the next, of 64; then they come again.
    pub seed: u32,
}

impl Default for TreeFile {
    fn default() -> Self {
        Self {
            height_m: 7.0,
            crown_m: 2.4,
            leaf_color: Color([0.07, 0.14, 0.025]),
            bark_color: Color([0.10, 0.07, 0.045]),
            seed: 1,
        }
    }
}
