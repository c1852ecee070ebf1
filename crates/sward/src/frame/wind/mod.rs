//! Wind: a sum of sources. Strength is the dimensionless `beta` of the scale-free species: a blade
//! of height h and response s feels `beta s h` metres a second (mean 0.4, gusts to 1.2).
//!
//! Wind is a vector in space. Its upward or downward part acts on blades that lean: by J's equation
//! 7 wind along a blade finds nothing to push.

pub(crate) mod atlas;
mod check;
mod map;
mod source;
mod state;
pub(crate) mod sway;
mod twin;

pub use map::WindMap;
pub use source::{Cosine, Fan, Gusts, Rotor, Vortex, Waves, WindSource, WindTexture};
pub use state::GpuWindSource;

use crate::Error;
use crate::gpu::layout::MAX_WIND_SOURCES;
use glam::{DVec2, DVec3, Vec3};
use std::sync::Arc;
use twin::Source;

/// All sources, and the time that has passed for them.
///
/// Phases are kept in `f64`, so that a wind that has blown for days is as exact as a new one, and
/// a change of a source's speed, wavelength or strength goes on from where it is. A change of
/// direction of waves, gusts or a cosine turns the whole pattern about the world's origin: blend two
/// sources instead.
///
/// Sources with a place are moved by the host, with [`WindSource::place`], before
/// [`Wind::advance`]; their patterns move with them. The first step with such a source makes the
/// pipelines for it; a wind that has none costs nothing for them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Wind {
    /// The sources; their sum is the wind. May be changed at any time; values that
    /// [`Wind::new`] would refuse then count as no wind.
    pub sources: Vec<WindSource>,
    /// Progress of each source: angles in radians, drift of noise in cells; see
    /// [`Source::phase_after`].
    phases: Vec<DVec2>,
}

impl Wind {
    /// Most sources that the renderer takes at once.
    pub const MAX_SOURCES: usize = MAX_WIND_SOURCES;

    /// For the wind of the past, a moving source is taken to have moved straight, with its present
    /// velocity, for so many seconds at most; before that, to have stood. What is longer past no
    /// blade remembers well.
    pub const PAST_S: f32 = twin::PAST_S as f32;

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

    /// Lets `dt_s` seconds pass; negative and non-finite times count as 0. It moves no source.
    pub fn advance(&mut self, dt_s: f64) {
        let dt_s = if dt_s.is_finite() { dt_s.max(0.0) } else { 0.0 };
        self.phases.resize(self.sources.len(), DVec2::ZERO);
        for (source, phase) in self.sources.iter().zip(&mut self.phases) {
            if let Some(state) = source.state(*phase) {
                *phase = state.phase_after(dt_s);
            }
        }
    }

    /// The wind at `position` (metres) as it was `seconds_ago`, in units of beta, each axis limited
    /// to -100..=100. The past of a source that moves is a guess: see [`Wind::PAST_S`].
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
        let rows = atlas::rows(&self.sources);
        let row = |source: &Source| {
            let own = |(map, _): &&(&Arc<WindMap>, u32)| {
                source.map.is_some_and(|used| std::ptr::eq(used, Arc::as_ptr(map)))
            };
            rows.iter().find(own).map_or(0, |(_, row)| *row)
        };
        let gpu = |source: Source| GpuWindSource { map_row: row(&source), ..source.into() };
        self.states().map(gpu).collect()
    }

    /// Bits of the kinds of its sources, as wind.wgsl numbers them.
    pub(crate) fn kinds(&self) -> u32 {
        let bits = |source: &WindSource| match source {
            WindSource::Waves(waves) => u32::from(waves.amplitude != 0.0),
            WindSource::Gusts(_) => 2,
            WindSource::Cosine(_) => 4,
            _ => 8,
        };
        self.sources.iter().map(bits).fold(0, |all, own| all | own)
    }

    fn states(&self) -> impl Iterator<Item = Source<'_>> {
        let phases = self.phases.iter().copied().chain(std::iter::repeat(DVec2::ZERO));
        self.sources.iter().zip(phases).filter_map(|(source, phase)| source.state(phase))
    }
}
