//! WGSL functions of the light stage, which `draw` calls.

#[cfg(test)]
pub(crate) mod shade_twin;

/// WGSL of the pattern that [`crate::Shade`] moves over the field, for hosts whose ground is to lie in the
/// same shade: `shade_pattern(place, to_sun, pattern, offset)`, and the noise that it calls.
pub const SHADE_WGSL: &str =
    concat!(include_str!("../../shared/noise.wgsl"), include_str!("shade.wgsl"));
