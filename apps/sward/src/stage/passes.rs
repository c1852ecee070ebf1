//! The full-screen passes of a frame, bound to its targets.

use super::frame::FrameUniform;
use super::fullscreen::{Fullscreen, FullscreenDesc};
use super::targets::Targets;
use crate::gpu::COLOR_FORMAT;

/// A full-screen pass with its inputs.
#[derive(Debug)]
struct Bound {
    pass: Fullscreen,
    inputs: wgpu::BindGroup,
}

/// Sky and post.
#[derive(Debug)]
pub(super) struct Passes {
    sky: Bound,
    post: Bound,
}

impl Passes {
    pub fn new(
        device: &wgpu::Device,
        frame: &FrameUniform,
        targets: &Targets,
        samples: u32,
    ) -> Self {
        let make = |desc: FullscreenDesc, views: &[&wgpu::TextureView]| {
            let pass = Fullscreen::new(device, &frame.layout, &desc);
            let inputs = pass.bind(device, views);
            Bound { pass, inputs }
        };
        let sky = FullscreenDesc {
            name: "sky",
            source: concat!(include_str!("sky_model.wgsl"), include_str!("sky.wgsl")),
            format: COLOR_FORMAT,
            samples,
            inputs: 0,
            multisampled: false,
            background: true,
        };
        let post = FullscreenDesc {
            name: "post",
            source: include_str!("post.wgsl"),
            format: targets.picture.format(),
            samples: 1,
            inputs: 1,
            multisampled: false,
            background: false,
        };
        Self { sky: make(sky, &[]), post: make(post, &[targets.linear()]) }
    }

    /// Fills the background of an open pass.
    pub fn draw_sky(&self, pass: &mut wgpu::RenderPass, frame: &FrameUniform) {
        self.sky.pass.draw(pass, &frame.group, &self.sky.inputs);
    }

    /// From linear light to the picture.
    pub fn run_post(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameUniform,
        targets: &Targets,
    ) {
        self.post.pass.run(encoder, &targets.picture_view, &frame.group, &self.post.inputs);
    }

    /// The same from another colour, such as a sum.
    pub fn run_post_from(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameUniform,
        targets: &Targets,
        color: &wgpu::TextureView,
    ) {
        let inputs = self.post.pass.bind(device, &[color]);
        self.post.pass.run(encoder, &targets.picture_view, &frame.group, &inputs);
    }
}
