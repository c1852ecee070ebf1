//! Baking on the CPU: plants made of ribbons become pictures of them, in texels that hold colour,
//! coverage, normal, height and thickness. `ribbon -> raster -> mips -> layers`.

mod bodies;
pub(crate) mod canopy;
pub(crate) mod cards;
pub(crate) mod cluster;
pub(crate) mod color;
pub(crate) mod cover;
pub(crate) mod harmonics;
pub(crate) mod layers;
pub(crate) mod means;
pub(crate) mod mips;
pub(crate) mod places;
pub(crate) mod raster;
#[cfg(test)]
mod raster_tests;
pub(crate) mod ribbon;
pub(crate) mod stand;
#[cfg(test)]
mod tests;

use glam::Vec3;

/// Alpha that a texel is drawn from.
pub(crate) const ALPHA_TEST: f32 = 0.5;

/// A corner of a plant's triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Corner {
    /// Metres.
    pub position: Vec3,
    /// Unit normal, of either side: it is turned to whoever looks.
    pub normal: Vec3,
    /// Added to the turned normal, so that a flat ribbon shades as a round one.
    pub round: Vec3,
    /// Linear reflectance.
    pub albedo: Vec3,
    /// 0 at the root of the plant, 1 at its tip.
    pub height_share: f32,
    /// What light has to pass here, relative to a blade of grass.
    pub thickness: f32,
}

/// Three corners.
pub(crate) type Triangle = [Corner; 3];
