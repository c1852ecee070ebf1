//! The background.

use super::frame::FrameUniform;
use super::fullscreen::{Fullscreen, FullscreenDesc};
use crate::gpu::COLOR_FORMAT;

/// What is seen where nothing is.
#[derive(Debug)]
pub(super) struct Sky {
    pass: Fullscreen,
    inputs: wgpu::BindGroup,
}

impl Sky {
    pub fn new(device: &wgpu::Device, frame: &FrameUniform, samples: u32) -> Self {
        let desc = FullscreenDesc {
            name: "sky",
            source: concat!(include_str!("sky_model.wgsl"), include_str!("sky.wgsl")),
            formats: &[COLOR_FORMAT],
            samples,
            inputs: &[],
            constants: &[],
            background: true,
        };
        let pass = Fullscreen::new(device, &frame.layout, &desc);
        Self { inputs: pass.bind(device, &[]), pass }
    }

    /// Fills the background of an open pass.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, frame: &FrameUniform) {
        self.pass.draw(pass, &frame.group, &self.inputs);
    }
}
