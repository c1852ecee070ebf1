//! Saved states of a stage: those of its grass. Everything else follows from the time and is gone
//! through again: rigid bodies in all their steps, 20 ms a frame for 500 balls on one core.

use super::Stage;
use anyhow::Result;

impl Stage {
    /// What the grass is like now, as bytes for [`Stage::resume`].
    ///
    /// # Errors
    /// Where the device fails.
    pub fn save_state(&self) -> Result<Vec<u8>> {
        Ok(self.renderer.save_state(&self.gpu.device, &self.gpu.queue)?)
    }

    /// Goes on from a state of the same scene and options, saved after the warm-up and these steps;
    /// in place of them, on a stage that is new. The next is [`Stage::step`]. On refusal the stage
    /// is still new.
    ///
    /// # Errors
    /// Where the state is damaged, or of something else.
    pub fn resume(&mut self, state: &[u8], steps: impl Iterator<Item = f64>) -> Result<()> {
        self.renderer.restore_state(&self.gpu.queue, state)?;
        for dt_s in self.warm_up_steps() {
            self.follow(dt_s);
        }
        self.time_s = 0.0;
        self.follow(0.0);
        steps.for_each(|dt_s| self.follow(dt_s));
        Ok(())
    }

    /// The steps of the warm-up.
    pub(super) fn warm_up_steps(&self) -> impl Iterator<Item = f64> + use<> {
        let steps = (self.warm_up_s * 60.0).ceil() as usize;
        std::iter::repeat_n(self.warm_up_s / steps as f64, steps)
    }
}
