//! A field: a surface, its species, density and seed, grown into blades and patches.

use crate::grow::surface::Surface;
use crate::grow::{Blade, Patch};
use crate::{Error, Species};
use glam::Vec3;

/// Tufts: blades seeded round Poisson-disk samples (Cline et al. 2009).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tufts {
    /// Share of all blades that grow in tufts, 0..=1; the rest are scattered singly.
    pub share: f32,
    /// Least distance between tufts, metres: larger gives fewer, fuller tufts.
    pub radius_m: f32,
    /// How far from its centre a tuft's blades stand, metres.
    pub spread_m: f32,
}

/// A map that thins the density: 0 is bare, 1 keeps all.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum DensityMap {
    /// Sampled through the mesh's UVs, wrapping, bilinear; row 0 is v = 0.
    Texture {
        /// Width, texels.
        width: u32,
        /// Height, texels.
        height: u32,
        /// Row-major values, 0..=1.
        values: Vec<f32>,
    },
    /// The red channel of the mesh's vertex colours.
    VertexColor,
}

/// Distance used when blades are grouped into patches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Metric {
    /// Straight-line distance: rounder patches.
    #[default]
    Euclidean,
    /// Sum of the axes' distances: boxier patches.
    Manhattan,
}

/// Order of the blades inside a patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BladeOrder {
    /// Every prefix is spread evenly over the patch, so that thinning is a prefix.
    #[default]
    Progressive,
    /// Morton order, as equation 20 of J needs it: neighbours are near each other.
    Morton,
    /// Sorted by x, then y, then z.
    Lexicographic,
}

/// What to grow.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldDesc {
    /// Blades a square metre, before thinning by map, slope and height. More costs memory (32
    /// bytes a blade) and frame time.
    pub density: f32,
    /// Blades in all, exactly, in place of `density`, which then is not used; map, slope and height
    /// still shape where they stand.
    pub count: Option<u64>,
    /// Same seed, same field, bit for bit.
    pub seed: u64,
    /// The mix; 1 to 256 kinds.
    pub species: Vec<Species>,
    /// Tufts, where some blades grow in them.
    pub tufts: Option<Tufts>,
    /// Map that thins the density.
    pub density_map: Option<DensityMap>,
    /// Steepest slope that bears grass, degrees from level (0..=180); 180 sets no limit.
    pub max_slope_deg: f32,
    /// World heights (y) that bear grass, metres.
    pub height_limits_m: (f32, f32),
    /// 0 grows along the surface's normal, 1 straight up (+y).
    pub upright: f32,
    /// Blades a patch: a multiple of 64, at most 1024. Smaller patches cull more exactly and cost
    /// more to test.
    pub patch_size: u32,
    /// Distance used to group blades.
    pub metric: Metric,
    /// Order inside a patch.
    pub order: BladeOrder,
    /// Most blades to grow; more is an error that says how many fit.
    pub max_blades: u64,
}

impl Default for FieldDesc {
    fn default() -> Self {
        Self {
            density: 400.0,
            count: None,
            seed: 1,
            species: vec![Species::default()],
            tufts: None,
            density_map: None,
            max_slope_deg: 180.0,
            height_limits_m: (f32::NEG_INFINITY, f32::INFINITY),
            upright: 0.0,
            patch_size: 256,
            metric: Metric::Euclidean,
            order: BladeOrder::Progressive,
            max_blades: u64::MAX,
        }
    }
}

/// A grown field.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    species: Vec<Species>,
    blades: Vec<Blade>,
    patches: Vec<Patch>,
    patch_size: u32,
    order: BladeOrder,
}

impl Field {
    /// Grows a field on a surface. Deterministic: the same input gives the same field, bit for
    /// bit, for any number of threads.
    ///
    /// # Errors
    /// [`Error::Setting`] for a value out of range, [`Error::Mesh`] where nothing can grow.
    pub fn grow(surface: &Surface, desc: &FieldDesc) -> Result<Self, Error> {
        let _ = (surface, desc, Vec3::ZERO);
        Err(Error::setting("field", "not grown yet"))
    }
    /// The species of the mix.
    pub fn species(&self) -> &[Species] {
        &self.species
    }
    /// All blades, patch by patch.
    pub fn blades(&self) -> &[Blade] {
        &self.blades
    }
    /// All patches.
    pub fn patches(&self) -> &[Patch] {
        &self.patches
    }
    /// Blades a patch (the last may have fewer).
    pub fn patch_size(&self) -> u32 {
        self.patch_size
    }
    /// Order of the blades inside a patch.
    pub fn order(&self) -> BladeOrder {
        self.order
    }
}
