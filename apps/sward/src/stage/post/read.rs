//! Positions back from the GPU, for debug views.

use super::Position;
use crate::stage::{Stage, readback};
use anyhow::Result;
use glam::{Vec3, Vec4};

/// Beyond this is only the sky, metres.
const SKY_M: f32 = 1e8;

impl Stage {
    /// What the last picture shows in each pixel, by rows from the top: its place in the world,
    /// metres, of what is nearest where a pixel shows several things; none where it is the sky.
    ///
    /// Of a reference, whose samples are gone, nothing is known.
    ///
    /// # Errors
    /// Where the device fails.
    pub fn positions(&mut self) -> Result<Vec<Option<Vec3>>> {
        let device = &self.gpu.device;
        let samples = if self.options.reference { 1 } else { self.options.samples };
        let made;
        let position = match self.post.position_target() {
            Some(position) => position,
            None => {
                made = Position::new(device, &self.uniform, self.options.size, samples);
                &made
            }
        };
        let mut encoder = device.create_command_encoder(&Default::default());
        position.run(device, &mut encoder, &self.uniform, &self.targets.depth);
        self.gpu.queue.submit([encoder.finish()]);
        let eye = self.options.camera.eye;
        let place = |texel: Vec4| {
            let at = texel.truncate();
            (at.distance(eye) < SKY_M).then_some(at)
        };
        let texels = readback::floats(&self.gpu, position.target())?;
        Ok(texels.into_iter().map(place).collect())
    }
}

impl super::Post {
    fn position_target(&self) -> Option<&Position> {
        self.position.as_ref()
    }
}
