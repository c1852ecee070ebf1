//! Wind strength (beta) at a place and a time, the reference of `wind.wgsl`.

use super::WindMap;
use crate::shared::noise_twin::{NOISE_PERIOD, noise2, smoothstep};
use glam::{DVec2, DVec3, dvec2, dvec3};
use std::f64::consts::TAU;

/// Beyond this the wind is an error of its source: no blade can tell the difference.
const WIND_LIMIT: f64 = 100.0;

/// How far the noise of the waves drifts in a turn of the wave, cells: four crests fill a cell.
pub(super) const WAVE_CELLS: f64 = 0.25;

/// Of a moving source's past, so many seconds are told from its present velocity.
pub(super) const PAST_S: f64 = 4.0;

/// One source with its present phase; `frame.wgsl` says which kind uses what how.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Source<'a> {
    pub kind: Kind,
    pub seed: u32,
    /// Unit, xz. Fan: horizontal, across its axis.
    pub direction: DVec2,
    /// Waves: mean and amplitude; gusts: strength and turbulence; others: strength.
    pub strength: DVec2,
    /// Waves, cosine: radians a metre; texture: texels a metre; others: cells a metre.
    pub frequency: f64,
    /// Waves, cosine: radians a second; gusts, fan, texture: metres a second; rotor, vortex: how often a
    /// second their gusts are drawn anew.
    pub rate: f64,
    /// Waves: phase (radians) and drift of their noise (cells); gusts, fan: drift (cells); texture: drift
    /// (texels); cosine:
    /// phase; rotor, vortex: phase of the spokes and turns of their noise.
    pub phase: DVec2,
    pub radius: f64,
    pub range: f64,
    pub position: DVec3,
    pub turbulence: f64,
    pub velocity: DVec3,
    /// Fan: how much wider its cone is a metre.
    pub spread: f64,
    /// Rotor, vortex: outward, around (counter-clockwise from above) and upward; fan: its axis.
    pub flow: DVec3,
    /// Rotor, vortex: metres that gusts are carried before they are drawn anew.
    pub carried: f64,
    pub spokes: u32,
    /// Radians a second, and a metre outward.
    pub spoke_rate: f64,
    pub spoke_wind: f64,
    pub pulse: f64,
    /// Of a texture.
    pub map: Option<&'a WindMap>,
}

/// In the order of their numbers on the GPU.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Kind {
    #[default]
    Waves,
    Gusts,
    Cosine,
    Rotor,
    Vortex,
    Fan,
    Texture,
}

impl Source<'_> {
    fn at(&self, position: DVec3, seconds_ago: f64) -> DVec3 {
        let place = dvec2(position.x, position.z);
        let along_across = dvec2(place.dot(self.direction), place.dot(self.direction.perp()));
        let level = |wind: DVec2| dvec3(wind.x, 0.0, wind.y);
        let from = position - self.position + self.velocity * seconds_ago.min(PAST_S);
        match self.kind {
            Kind::Waves => level(self.wave(along_across, seconds_ago)),
            Kind::Gusts => level(self.gust(along_across, seconds_ago)),
            Kind::Cosine => level(self.cosine(along_across, seconds_ago)),
            Kind::Rotor | Kind::Vortex => self.whirl(from, seconds_ago),
            Kind::Fan => self.fan(from, seconds_ago),
            Kind::Texture => level(self.mapped(along_across, seconds_ago)),
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

    /// Wang and Yao's equation 4, with a phase by position.
    fn cosine(&self, at: DVec2, seconds_ago: f64) -> DVec2 {
        let phase = self.phase.x - self.rate * seconds_ago - self.frequency * at.x;
        self.direction * (self.strength.x * phase.cos())
    }

    /// The map, as it has drifted.
    fn mapped(&self, at: DVec2, seconds_ago: f64) -> DVec2 {
        let Some(map) = self.map else { return DVec2::ZERO };
        let drift = self.phase.x - self.rate * self.frequency * seconds_ago;
        let wind = map.at(at * self.frequency - dvec2(drift, 0.0)) * self.strength.x;
        self.direction * wind.x + self.direction.perp() * wind.y
    }

    /// A rotor's wash or a vortex, at `from` its hub.
    fn whirl(&self, from: DVec3, seconds_ago: f64) -> DVec3 {
        let at = dvec2(from.x, from.z);
        let reach = at.length_squared() / (self.range * self.range);
        if reach >= 1.0 {
            return DVec3::ZERO;
        }
        let mut strength = self.strength.x * (1.0 - reach) * (1.0 - reach);
        let mut radius = self.radius;
        if self.kind == Kind::Rotor {
            // Deeper below, the wash is wider and weaker.
            let depth = (-from.y / self.radius).max(0.0);
            strength *= smoothstep(0.0, 0.3, depth) / (1.0 + depth * depth / 16.0);
            radius *= 1.0 + 0.15 * depth;
        }
        let s = at / radius;
        let core = 1.0 / (1.0 + s.length_squared());
        // As long as 0 in the middle, 1 at one radius, and falling as 1/s.
        let radial = s * (2.0 * core);
        let around = dvec2(radial.y, -radial.x);
        let flow = radial * self.flow.x + around * self.flow.y;
        let speed = radial.length();
        let gusts = if self.turbulence == 0.0 {
            DVec2::ZERO
        } else {
            self.carried_noise(at, flow * self.carried, seconds_ago)
        };
        let spokes = if self.pulse == 0.0 {
            0.0
        } else {
            self.pulse * speed * self.spoke_wave(at, seconds_ago, 3.0 * gusts.x)
        };
        // Where air comes down or goes up, it is the most irregular.
        let shaken =
            gusts * (2.0 * self.turbulence * (speed + core * (1.0 + 2.0 * self.flow.z.abs())));
        let level = flow * (1.0 + spokes) + shaken;
        let upward = self.flow.z * core * core * (1.0 + spokes + 2.0 * self.turbulence * gusts.y);
        dvec3(level.x, upward, level.y) * strength
    }

    /// Noise that the flow carries along by `carried` metres, then draws anew: two layers by turns.
    fn carried_noise(&self, at: DVec2, carried: DVec2, seconds_ago: f64) -> DVec2 {
        let (mut sum, mut squares) = (DVec2::ZERO, 0.0);
        for layer in 0..2_u32 {
            let turn = self.phase.y - self.rate * seconds_ago + 0.5 * f64::from(layer);
            let whole = turn.floor();
            let share = turn - whole;
            let drawn = (whole as i64).rem_euclid(i64::from(NOISE_PERIOD)) as u32;
            let seed = self.seed.wrapping_add(4 * drawn + 2 * layer);
            let cell = (at - carried * (share - 0.5)) * self.frequency;
            let weight = 1.0 - (2.0 * share - 1.0).abs();
            sum += weight * dvec2(noise2(cell, seed), noise2(cell, seed.wrapping_add(1)));
            squares += weight * weight;
        }
        sum / squares.sqrt()
    }

    /// `cos(spokes * angle - phase)`, without an angle: there is none in the middle.
    fn spoke_wave(&self, at: DVec2, seconds_ago: f64, wander: f64) -> f64 {
        let distance = at.length();
        let unit = dvec2(at.x, -at.y) / distance.max(1e-4);
        let power = (0..self.spokes).fold(DVec2::X, |power, _| unit.rotate(power));
        let turned = self.phase.x - self.spoke_rate * seconds_ago;
        let phase = turned - self.spoke_wind * distance + wander;
        power.dot(DVec2::from_angle(phase))
    }

    /// A jet that widens, at `from` the fan's middle.
    fn fan(&self, from: DVec3, seconds_ago: f64) -> DVec3 {
        let axis = self.flow;
        let along = from.dot(axis);
        let reach = along / self.range;
        let across = from - axis * along;
        let width = self.radius + along * self.spread;
        let off = across.length_squared() / (width * width);
        if along <= 0.0 || reach >= 1.0 || off >= 1.0 {
            return DVec3::ZERO;
        }
        let ends = (1.0 - reach * reach) * (1.0 - off);
        let start = smoothstep(0.0, 0.5 * self.radius, along);
        let mut strength = self.strength.x * start * ends * ends * self.radius / width;
        // Away from the tip of the cone.
        let mut direction = (axis * width + across * self.spread).normalize();
        if self.turbulence != 0.0 {
            let side = self.direction;
            let drift = self.phase.x - self.rate * self.frequency * seconds_ago;
            let lateral = dvec2(from.x, from.z).dot(side) * self.frequency;
            let cell = dvec2(along * self.frequency - drift, lateral);
            strength *= 1.0 + 1.5 * self.turbulence * noise2(cell, self.seed);
            let veer = self.turbulence * noise2(cell, self.seed.wrapping_add(1));
            direction += dvec3(side.x, 0.0, side.y) * veer;
        }
        direction * strength
    }
}

/// The sum of `sources` at `position` (metres) as it was `seconds_ago`.
pub(super) fn wind_at<'a>(
    sources: impl Iterator<Item = Source<'a>>,
    position: DVec3,
    seconds_ago: f64,
) -> DVec3 {
    let sum: DVec3 = sources.map(|source| source.at(position, seconds_ago)).sum();
    if !sum.is_finite() {
        return DVec3::ZERO;
    }
    sum.clamp(DVec3::splat(-WIND_LIMIT), DVec3::splat(WIND_LIMIT))
}
