//! Fixed steps: the same times are stepped through whichever frames are drawn.

/// Steps a second that the simulation does not fall below.
const LEAST_RATE: f64 = 60.0;

/// Cuts frames into equal steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock {
    steps_per_frame: u32,
    step_s: f64,
}

impl Clock {
    /// For a frame rate above 0.
    pub fn new(fps: f64) -> Self {
        let steps_per_frame = (LEAST_RATE / fps - 1e-6).ceil().max(1.0) as u32;
        Self { steps_per_frame, step_s: 1.0 / (fps * f64::from(steps_per_frame)) }
    }

    /// Frames a second.
    pub fn fps(self) -> f64 {
        (self.step_s * f64::from(self.steps_per_frame)).recip()
    }

    /// Steps of one frame.
    pub fn frame(self) -> impl Iterator<Item = f64> {
        std::iter::repeat_n(self.step_s, self.steps_per_frame as usize)
    }

    /// Steps from 0 to a time: whole ones, then what is left. A frame's own time is reached by
    /// the same steps as by [`Clock::frame`].
    pub fn until(self, time_s: f64) -> impl Iterator<Item = f64> {
        let whole = (time_s / self.step_s + 1e-6).floor();
        let rest = time_s - whole * self.step_s;
        let last = (rest > 1e-6 * self.step_s).then_some(rest);
        std::iter::repeat_n(self.step_s, whole as usize).chain(last)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_short_enough_and_fill_the_frame() {
        for fps in [1.0, 7.0, 24.0, 25.0, 30.0, 60.0, 144.0, 1000.0] {
            let steps: Vec<_> = Clock::new(fps).frame().collect();
            assert!((steps.iter().sum::<f64>() - 1.0 / fps).abs() < 1e-12, "{fps}");
            assert!(steps.iter().all(|&s| s <= 1.0 / 60.0 + 1e-9), "{fps}");
        }
        assert_eq!(Clock::new(30.0).frame().count(), 2);
        assert_eq!(Clock::new(60.0).frame().count(), 1);
    }

    #[test]
    fn a_time_is_reached_as_its_frame_is() {
        let clock = Clock::new(30.0);
        let by_frames: Vec<_> = (0..45).flat_map(|_| clock.frame()).collect();
        assert_eq!(clock.until(1.5).collect::<Vec<_>>(), by_frames);
        assert_eq!(clock.until(0.0).count(), 0);
        let odd: Vec<_> = clock.until(0.04).collect();
        assert_eq!(odd.len(), 3);
        assert!((odd.iter().sum::<f64>() - 0.04).abs() < 1e-12);
    }
}
