//! Wind strength (beta) at a place and a time, the reference of `wind.wgsl`.

use crate::shared::noise_twin::{noise2, smoothstep};
use glam::{DVec2, DVec3, dvec2, dvec3};
use std::f64::consts::TAU;

/// Beyond this the wind is an error of its source: no blade can tell the difference.
const WIND_LIMIT: f64 = 100.0;

/// How far the noise of the waves drifts in a turn of the wave, cells: four crests fill a cell.
pub(super) const WAVE_CELLS: f64 = 0.25;

/// One source with its present phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Source {
    pub kind: Kind,
    pub seed: u32,
    /// Unit, xz.
    pub direction: DVec2,
    /// Waves: mean and amplitude; gusts: strength and turbulence.
    pub strength: DVec2,
    /// Waves: radians a metre; gusts: cells a metre.
    pub frequency: f64,
    /// Waves: radians a second; gusts: metres a second.
    pub rate: f64,
    /// Waves: phase (radians) and drift of their noise (cells); gusts: drift (cells).
    pub phase: DVec2,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Waves,
    Gusts,
}

impl Source {
    fn at(&self, position: DVec3, seconds_ago: f64) -> DVec2 {
        let place = dvec2(position.x, position.z);
        let along_across = dvec2(place.dot(self.direction), place.dot(self.direction.perp()));
        match self.kind {
            Kind::Waves => self.wave(along_across, seconds_ago),
            Kind::Gusts => self.gust(along_across, seconds_ago),
        }
    }

    /// Crests that wander and break: noise that travels with them shifts their phase and fades
    /// them, so that they are no parallel stripes.
    fn wave(&self, at: DVec2, seconds_ago: f64) -> DVec2 {
        let travelled = self.phase.x - self.rate * seconds_ago;
        let cells = self.frequency / TAU;
        let drift = self.phase.y - self.rate / TAU * WAVE_CELLS * seconds_ago;
        let noise_at = dvec2(at.x * cells * WAVE_CELLS - drift, at.y * cells * WAVE_CELLS);
        let noise = |octave: f64, seed| noise2(noise_at * octave, self.seed.wrapping_add(seed));
        let wander = 9.0 * noise(1.0, 0) + 4.0 * noise(2.0, 1);
        let envelope = 1.2 * smoothstep(-0.5, 0.4, noise(2.0, 2));
        let phase = travelled - self.frequency * at.x + wander;
        // Rises three times as fast as it falls: the front of a gust is sharp, its tail is not.
        let profile = (phase + 0.5 * phase.sin()).sin();
        self.direction * (self.strength.x + self.strength.y * envelope * profile)
    }

    /// Two octaves of noise that drift with the wind, twice as long across it.
    fn gust(&self, at: DVec2, seconds_ago: f64) -> DVec2 {
        let drift = self.phase.x - self.rate * self.frequency * seconds_ago;
        let cell = dvec2(at.x * self.frequency - drift, at.y * self.frequency * 0.5);
        let sum = noise2(cell, self.seed) + 0.5 * noise2(cell * 2.0, self.seed.wrapping_add(1));
        let strength = smoothstep(-0.4, 0.8, sum) * self.strength.x;
        let veer = self.strength.y * 1.6 * noise2(cell, self.seed.wrapping_add(2));
        DVec2::from_angle(veer).rotate(self.direction) * strength
    }
}

/// The sum of `sources` at `position` (metres) as it was `seconds_ago`.
pub(super) fn wind_at(
    sources: impl Iterator<Item = Source>,
    position: DVec3,
    seconds_ago: f64,
) -> DVec3 {
    let sum: DVec2 = sources.map(|source| source.at(position, seconds_ago)).sum();
    if !sum.is_finite() {
        return DVec3::ZERO;
    }
    let limited = sum.clamp(DVec2::splat(-WIND_LIMIT), DVec2::splat(WIND_LIMIT));
    dvec3(limited.x, 0.0, limited.y)
}
