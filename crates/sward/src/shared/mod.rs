//! What several stages share: pure functions, each in WGSL and as its CPU twin.

pub mod curve_twin;
#[cfg(test)]
pub(crate) mod leaf_twin;
pub mod noise_twin;
