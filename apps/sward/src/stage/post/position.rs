//! The target of world positions.

use super::super::frame::FrameUniform;
use super::super::fullscreen::{Fullscreen, FullscreenDesc, Input};
use super::super::targets::texture;

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;

/// World positions of a picture: xyz in metres of what is nearest in a pixel (the sky lies 1e9 m
/// off), and the share of the pixel's light that fog lets through.
#[derive(Debug)]
pub(in crate::stage) struct Position {
    pass: Fullscreen,
    target: wgpu::Texture,
    view: wgpu::TextureView,
}

impl Position {
    /// For a picture of `size`, and a depth of so many samples, or one so much larger as the frame
    /// says.
    pub fn new(device: &wgpu::Device, frame: &FrameUniform, size: [u32; 2], samples: u32) -> Self {
        let multisampled = samples > 1;
        let source = match multisampled {
            true => concat!(
                include_str!("depth_multisampled.wgsl"),
                include_str!("fog.wgsl"),
                include_str!("position.wgsl")
            ),
            false => concat!(
                include_str!("depth_single.wgsl"),
                include_str!("fog.wgsl"),
                include_str!("position.wgsl")
            ),
        };
        let desc = FullscreenDesc {
            name: "position",
            source,
            formats: &[FORMAT],
            samples: 1,
            inputs: &[Input::Depth { multisampled }],
            constants: &[("SAMPLES", f64::from(samples))],
            background: false,
        };
        use wgpu::TextureUsages as U;
        let usage = U::RENDER_ATTACHMENT | U::TEXTURE_BINDING | U::COPY_SRC;
        let target = texture(device, "sward.stage.position", size, FORMAT, 1, usage);
        Self {
            pass: Fullscreen::new(device, &frame.layout, &desc),
            view: target.create_view(&Default::default()),
            target,
        }
    }

    /// Fills the target from a depth, as the frame's camera sees it.
    pub fn run(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameUniform,
        depth: &wgpu::TextureView,
    ) {
        let inputs = self.pass.bind(device, &[depth]);
        self.pass.run(encoder, &[&self.view], &frame.group, &inputs);
    }

    pub fn view(&self) -> &wgpu::TextureView {
        &self.view
    }

    pub fn target(&self) -> &wgpu::Texture {
        &self.target
    }
}
