//! Simulated time.

use crate::gpu::layout::TICKS_PER_SECOND;
use bytemuck::{Pod, Zeroable};

/// Longest step; a longer one is cut, as after a breakpoint or a closed lid.
const LONGEST_STEP_S: f32 = 10.0;

/// Counts steps and time; kept in f64 so that days pass without loss.
#[derive(Debug)]
pub(crate) struct Clock {
    time_s: f64,
    step: u32,
    dt_s: f32,
}

/// A clock in a saved state.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct SavedClock {
    time_s: f64,
    step: u32,
    dt_s: f32,
}

impl SavedClock {
    /// Whether a clock can have been so.
    pub(crate) fn is_sound(&self) -> bool {
        let step_s = f64::from(self.dt_s);
        self.time_s.is_finite()
            && self.time_s >= 0.0
            && (0.0..=f64::from(LONGEST_STEP_S)).contains(&step_s)
    }
}

impl Default for Clock {
    fn default() -> Self {
        // Step 0 is every new band's: 2 apart, so that it counts as asleep
        Self { time_s: 0.0, step: 1, dt_s: 0.0 }
    }
}

impl Clock {
    /// One step on. A step of no number takes no time.
    pub(crate) fn advance(&mut self, dt_s: f32) {
        let dt_s = if dt_s.is_finite() { dt_s.clamp(0.0, LONGEST_STEP_S) } else { 0.0 };
        self.time_s += f64::from(dt_s);
        self.step = self.step.wrapping_add(1);
        self.dt_s = dt_s;
    }

    /// For a saved state.
    pub(crate) fn saved(&self) -> SavedClock {
        SavedClock { time_s: self.time_s, step: self.step, dt_s: self.dt_s }
    }

    /// From a saved state that is sound.
    pub(crate) fn restore(&mut self, SavedClock { time_s, step, dt_s }: SavedClock) {
        *self = Self { time_s, step, dt_s };
    }

    /// Seconds that the step takes.
    pub(crate) fn dt_s(&self) -> f32 {
        self.dt_s
    }

    /// Number of the step.
    pub(crate) fn step(&self) -> u32 {
        self.step
    }

    /// Time in 1/16384 s, wrapping after three days.
    pub(crate) fn ticks(&self) -> u32 {
        (self.time_s * TICKS_PER_SECOND) as u64 as u32
    }
}
