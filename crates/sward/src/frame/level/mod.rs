//! Levels of detail: how many segments a blade of a projected size gets, and how blades are thinned
//! where they are less than a pixel wide. WGSL functions that `update` and `draw` call.

#[cfg(test)]
pub(crate) mod twin;
