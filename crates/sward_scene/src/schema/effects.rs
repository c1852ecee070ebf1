//! Keys for what is done to the finished picture.

use super::Color;
use serde::Deserialize;

/// Fog by distance (Olofsson and Silven), laid over the finished picture; the sky stays clear.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct FogFile {
    /// Its colour; default that of the sky's horizon, into which things then fade.
    pub color: Option<Color>,
    /// Share of the light that is lost a metre, 0..=10; default 0.02: half of it over 35 m.
    pub density_per_m: f32,
    /// Distance from the eye at which it starts, 0 or more; default 0.
    pub start_m: f32,
    /// Height (y) at which it has that density; default 0. Matters with `falloff_m` only.
    pub base_m: f32,
    /// Height over which it thins to 37 %, 0.01 or more; default `inf`: as dense at any height. Low
    /// values lie in the valleys and thicken without end below `base_m`.
    pub falloff_m: f32,
}

impl Default for FogFile {
    fn default() -> Self {
        Self {
            color: None,
            density_per_m: 0.02,
            start_m: 0.0,
            base_m: 0.0,
            falloff_m: f32::INFINITY,
        }
    }
}

/// Depth of field (Olofsson and Silven): what lies before or behind a plane is out of focus.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct DepthOfFieldFile {
    /// Distance of the plane in focus, along the line of sight, above 0; default 5.
    pub focus_m: f32,
    /// Diameter of the lens's opening in millimetres, 0..=10000; default 25, a 50 mm lens at f/2.
    /// Larger blurs more; 0 blurs nothing.
    pub aperture_mm: f32,
}

impl Default for DepthOfFieldFile {
    fn default() -> Self {
        Self { focus_m: 5.0, aperture_mm: 25.0 }
    }
}
