//! Wind: a sum of sources. Strength is the dimensionless `beta` of the scale-free species: a blade
//! of height h and response s feels `beta s h` metres a second (mean 0.4, gusts to 1.2).

use glam::Vec2;

/// One term of the wind field.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum WindSource {
    /// A steady breeze with travelling waves on it.
    Waves(Waves),
    /// Gusts: noise that drifts with the wind.
    Gusts(Gusts),
}

/// Travelling waves: `direction * (mean + amplitude * wave(phase))`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waves {
    /// Where the wind blows to, in the xz plane; need not be unit length, must not be zero.
    pub direction: Vec2,
    /// Steady strength (beta).
    pub mean: f32,
    /// Strength of the waves (beta).
    pub amplitude: f32,
    /// Distance between crests, metres.
    pub wavelength_m: f32,
    /// How fast crests travel, metres a second.
    pub speed_mps: f32,
}

/// Gust noise, longer across the wind than along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gusts {
    /// Where the gusts drift to, in the xz plane.
    pub direction: Vec2,
    /// Peak strength (beta).
    pub strength: f32,
    /// Size of a gust, metres.
    pub size_m: f32,
    /// Drift speed, metres a second.
    pub speed_mps: f32,
    /// Turbulence, 0..=1: how much the direction veers inside a gust.
    pub turbulence: f32,
    /// Seed of the noise.
    pub seed: u32,
}

/// All sources, and the time that has passed for them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Wind {
    /// The sources; their sum is the wind.
    pub sources: Vec<WindSource>,
}
