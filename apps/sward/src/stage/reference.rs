//! References: many pictures of one moment, each shifted by a part of a pixel. What is done to a
//! drawn picture is done once, at the end, to their mean.

use super::Stage;
use super::passes::{Accumulator, Sum};
use super::post::Drawn;
use anyhow::Result;
use glam::Vec2;

/// Renders a side that a reference adds up: 8 x 8 places inside a pixel, one sample each.
const REFERENCE_GRID: u32 = 8;

impl Stage {
    pub(super) fn render_reference(&mut self) -> Result<()> {
        let [mut sum, mut nearest] = [Sum::Colors, Sum::Positions].map(|sum| {
            Accumulator::new(&self.gpu.device, &self.uniform, self.targets.size, sum)
        });
        let mut positioned = false;
        let step = 1.0 / REFERENCE_GRID as f32;
        for i in 0..REFERENCE_GRID * REFERENCE_GRID {
            let cell = Vec2::new((i % REFERENCE_GRID) as f32, (i / REFERENCE_GRID) as f32);
            self.jitter_px = (cell + 0.5) * step - 0.5;
            self.depth_is_opaque = false;
            self.write_camera(step * step);
            let mut encoder = self.encoder();
            self.encode_opaque(&mut encoder);
            self.encode_cull(&mut encoder)?;
            self.encode_draw(&mut encoder);
            let (device, uniform) = (&self.gpu.device, &self.uniform);
            sum.add(device, &mut encoder, uniform, self.targets.linear());
            if let Some(positions) =
                self.post.position(device, &mut encoder, uniform, &self.targets.depth)
            {
                nearest.add(device, &mut encoder, uniform, positions);
                positioned = true;
            }
            self.submit(encoder);
            self.gpu.wait()?;
        }
        self.jitter_px = Vec2::ZERO;
        self.depth_is_opaque = false;
        self.write_camera(1.0);
        let mut encoder = self.encoder();
        let position = positioned.then(|| nearest.sum());
        let drawn = Drawn { color: sum.sum(), position };
        let (device, picture) = (&self.gpu.device, &self.targets.picture_view);
        self.post.run(device, &mut encoder, &self.uniform, drawn, picture);
        self.submit(encoder);
        Ok(())
    }
}
