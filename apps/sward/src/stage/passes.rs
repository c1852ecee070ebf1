//! The sky, and sums of pictures: full-screen passes that belong to no stage of their own.

use super::frame::FrameUniform;
use super::fullscreen::{Fullscreen, FullscreenDesc, Input};
use super::targets::texture;
use crate::gpu::COLOR_FORMAT;

const SUM_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;

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

/// How pictures are brought together.
#[derive(Debug, Clone, Copy)]
pub(super) enum Sum {
    /// Colours, by the frame's weight.
    Colors,
    /// World positions: the nearest.
    Positions,
}

/// What comes of several pictures of one place, 32 bits a channel.
#[derive(Debug)]
pub(super) struct Accumulator {
    pass: Fullscreen,
    sums: [wgpu::TextureView; 2],
    added: usize,
}

impl Accumulator {
    /// Starts at zero, as new textures are.
    pub fn new(device: &wgpu::Device, frame: &FrameUniform, size: [u32; 2], sum: Sum) -> Self {
        let (name, source) = match sum {
            Sum::Colors => ("accumulate", include_str!("accumulate.wgsl")),
            Sum::Positions => ("nearest", include_str!("post/nearest.wgsl")),
        };
        let desc = FullscreenDesc {
            name,
            source,
            formats: &[SUM_FORMAT],
            samples: 1,
            inputs: &[Input::Color; 2],
            constants: &[],
            background: false,
        };
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
        let sum = || {
            texture(device, "sward.stage.sum", size, SUM_FORMAT, 1, usage)
                .create_view(&Default::default())
        };
        let pass = Fullscreen::new(device, &frame.layout, &desc);
        Self { pass, sums: [sum(), sum()], added: 0 }
    }

    /// Adds the frame's picture.
    pub fn add(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameUniform,
        picture: &wgpu::TextureView,
    ) {
        let (from, to) = (self.added % 2, (self.added + 1) % 2);
        let inputs = self.pass.bind(device, &[picture, &self.sums[from]]);
        self.pass.run(encoder, &[&self.sums[to]], &frame.group, &inputs);
        self.added += 1;
    }

    /// The sum so far.
    pub fn sum(&self) -> &wgpu::TextureView {
        &self.sums[self.added % 2]
    }
}
