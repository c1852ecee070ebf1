//! Wind: a sum of sources. Strength is the dimensionless `beta` of the scale-free species: a blade
//! of height h and response s feels `beta s h` metres a second (mean 0.4, gusts to 1.2).

mod twin;

use crate::Error;
use crate::gpu::layout::MAX_WIND_SOURCES;
use crate::shared::noise_twin::NOISE_PERIOD;
use glam::{DVec2, DVec3, Vec2, Vec3, dvec2};
use std::f64::consts::TAU;
use twin::{Kind, Source, WAVE_CELLS};

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
    /// Steady strength (beta), -100..=100. Higher bends the meadow more at all times.
    pub mean: f32,
    /// Strength of the waves (beta), 0..=100. Above the mean, blades swing against the wind
    /// between crests.
    pub amplitude: f32,
    /// Distance between crests, metres, 0.01..=10000. Longer waves read as gusts, shorter as ripples.
    pub wavelength_m: f32,
    /// How fast crests travel, metres a second, -1000..=1000; negative travels against the wind.
    pub speed_mps: f32,
}

/// Gust noise, longer across the wind than along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gusts {
    /// Where the gusts blow and drift to, in the xz plane; must not be zero.
    pub direction: Vec2,
    /// Peak strength (beta), 0..=100.
    pub strength: f32,
    /// Size of a gust along the wind, metres, 0.01..=10000; it is twice as long across. Larger
    /// gusts last longer over one place.
    pub size_m: f32,
    /// Drift speed, metres a second, -1000..=1000. Faster gusts pass a place in less time.
    pub speed_mps: f32,
    /// Turbulence, 0..=1: how much the direction veers inside a gust.
    pub turbulence: f32,
    /// Seed of the noise.
    pub seed: u32,
}

impl Default for Waves {
    /// A breeze with waves 14 m apart.
    fn default() -> Self {
        Self { direction: Vec2::X, mean: 0.25, amplitude: 0.35, wavelength_m: 14.0, speed_mps: 5.0 }
    }
}

impl Default for Gusts {
    /// Gusts of 12 m on a fresh day.
    fn default() -> Self {
        Self {
            direction: Vec2::X,
            strength: 0.8,
            size_m: 12.0,
            speed_mps: 5.0,
            turbulence: 0.3,
            seed: 1,
        }
    }
}

/// All sources, and the time that has passed for them.
///
/// Phases are kept in `f64`, so that a wind that has blown for days is as exact as a new one, and
/// a change of a source's speed, wavelength or strength goes on from where it is. A change of
/// direction turns the whole pattern about the world's origin: blend two sources instead.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Wind {
    /// The sources; their sum is the wind. May be changed at any time; values that
    /// [`Wind::new`] would refuse then count as no wind.
    pub sources: Vec<WindSource>,
    /// Progress of each source: waves in radians and noise cells, gusts in noise cells.
    phases: Vec<DVec2>,
}

/// What the GPU reads of one source: the mirror of the WGSL struct.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct GpuWindSource {
    pub kind: u32,
    pub seed: u32,
    pub direction: [f32; 2],
    pub strength: [f32; 2],
    pub frequency: f32,
    pub rate: f32,
    pub phase: [f32; 2],
    pub reserved: [f32; 2],
}

impl Wind {
    /// Most sources that the renderer takes at once.
    pub const MAX_SOURCES: usize = MAX_WIND_SOURCES;

    /// A wind of these sources, at time 0.
    ///
    /// # Errors
    /// [`Error::Setting`] names the first source whose direction is zero or whose values are not
    /// finite or out of the ranges that their fields state.
    pub fn new(sources: Vec<WindSource>) -> Result<Self, Error> {
        for (index, source) in sources.iter().enumerate() {
            source.check(&format!("wind[{index}]"))?;
        }
        let phases = vec![DVec2::ZERO; sources.len()];
        Ok(Self { sources, phases })
    }

    /// Lets `dt_s` seconds pass; negative and non-finite times count as 0.
    pub fn advance(&mut self, dt_s: f64) {
        let dt_s = if dt_s.is_finite() { dt_s.max(0.0) } else { 0.0 };
        self.phases.resize(self.sources.len(), DVec2::ZERO);
        let period = f64::from(NOISE_PERIOD);
        for (source, phase) in self.sources.iter().zip(&mut self.phases) {
            let Some(state) = source.state(*phase) else { continue };
            *phase = match state.kind {
                Kind::Waves => {
                    let turned = state.rate * dt_s;
                    let drifted = turned / TAU * WAVE_CELLS;
                    dvec2(
                        (phase.x + turned).rem_euclid(TAU),
                        (phase.y + drifted).rem_euclid(period),
                    )
                }
                Kind::Gusts => {
                    let drifted = state.rate * state.frequency * dt_s;
                    dvec2((phase.x + drifted).rem_euclid(period), 0.0)
                }
            };
        }
    }

    /// The wind at `position` (metres) as it was `seconds_ago`, in units of beta; its y is 0.
    pub fn strength_at(&self, position: Vec3, seconds_ago: f32) -> Vec3 {
        self.strength_at_f64(position.as_dvec3(), f64::from(seconds_ago)).as_vec3()
    }

    /// [`Wind::strength_at`] in full precision, for the references of the stages.
    pub(crate) fn strength_at_f64(&self, position: DVec3, seconds_ago: f64) -> DVec3 {
        twin::wind_at(self.states(), position, seconds_ago)
    }

    /// The sources for the GPU; those without effect are left out.
    #[doc(hidden)]
    pub fn gpu_sources(&self) -> Vec<GpuWindSource> {
        self.states().map(GpuWindSource::from).collect()
    }

    fn states(&self) -> impl Iterator<Item = Source> {
        let phases = self.phases.iter().copied().chain(std::iter::repeat(DVec2::ZERO));
        self.sources.iter().zip(phases).filter_map(|(source, phase)| source.state(phase))
    }
}

impl WindSource {
    fn check(&self, path: &str) -> Result<(), Error> {
        let (direction, values) = match self {
            Self::Waves(w) => (
                w.direction,
                vec![
                    ("mean", w.mean, -100.0, 100.0),
                    ("amplitude", w.amplitude, 0.0, 100.0),
                    ("wavelength_m", w.wavelength_m, 0.01, 1e4),
                    ("speed_mps", w.speed_mps, -1e3, 1e3),
                ],
            ),
            Self::Gusts(g) => (
                g.direction,
                vec![
                    ("strength", g.strength, 0.0, 100.0),
                    ("size_m", g.size_m, 0.01, 1e4),
                    ("speed_mps", g.speed_mps, -1e3, 1e3),
                    ("turbulence", g.turbulence, 0.0, 1.0),
                ],
            ),
        };
        if direction.try_normalize().is_none() {
            let cause = format!("{direction} is no direction; give two finite numbers, not both 0");
            return Err(Error::setting(format!("{path}.direction"), cause));
        }
        for (name, value, min, max) in values {
            if !(min..=max).contains(&value) {
                let cause = format!("{value} is not in {min} to {max}");
                return Err(Error::setting(format!("{path}.{name}"), cause));
            }
        }
        Ok(())
    }

    /// The source with its phase, in the numbers that wind is worked out from; none where its
    /// settings make no sense.
    fn state(&self, phase: DVec2) -> Option<Source> {
        self.check("").ok()?;
        Some(match *self {
            Self::Waves(w) => {
                let frequency = TAU / f64::from(w.wavelength_m);
                Source {
                    kind: Kind::Waves,
                    seed: 0x5eed,
                    direction: w.direction.as_dvec2().normalize(),
                    strength: dvec2(f64::from(w.mean), f64::from(w.amplitude)),
                    frequency,
                    rate: frequency * f64::from(w.speed_mps),
                    phase,
                }
            }
            Self::Gusts(g) => Source {
                kind: Kind::Gusts,
                seed: g.seed,
                direction: g.direction.as_dvec2().normalize(),
                strength: dvec2(f64::from(g.strength), f64::from(g.turbulence)),
                frequency: 1.0 / f64::from(g.size_m),
                rate: f64::from(g.speed_mps),
                phase,
            },
        })
    }
}

impl From<Source> for GpuWindSource {
    fn from(source: Source) -> Self {
        Self {
            kind: match source.kind {
                Kind::Waves => 0,
                Kind::Gusts => 1,
            },
            seed: source.seed,
            direction: source.direction.as_vec2().to_array(),
            strength: source.strength.as_vec2().to_array(),
            frequency: source.frequency as f32,
            rate: source.rate as f32,
            phase: source.phase.as_vec2().to_array(),
            reserved: [0.0; 2],
        }
    }
}
