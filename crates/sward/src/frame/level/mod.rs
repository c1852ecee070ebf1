//! Levels of detail: how many segments a blade of a projected size gets, and how blades are thinned
//! where they are less than a pixel wide. WGSL functions that `update` and `draw` call.

#[cfg(test)]
pub(crate) mod bands_twin;
#[cfg(test)]
pub(crate) mod continuum_twin;
#[cfg(test)]
pub(crate) mod strips_twin;
#[cfg(test)]
pub(crate) mod twin;

/// A quarter of this projected height, pixels, ends the first level; a quarter of that the next.
pub(crate) const FULL_DETAIL_PX: f32 = 480.0;

/// Levels of a blade.
pub(crate) const LEVELS: u32 = 4;

/// The last share of a level, by the logarithm of the height, over which it turns into the next.
pub(crate) const MORPH_SHARE: f32 = 0.3;
