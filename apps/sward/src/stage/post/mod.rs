//! What is done to the picture once it is drawn, after Olofsson and Silven: a target of world
//! positions, fog and depth of field by it, and tone mapping at the end.
//!
//! Positions come from the depth in a pass of their own: exact to what a depth in f32 resolves, for
//! every sample, and neither grass nor things need a second target for them. Passes that a scene
//! does not ask for are not made, and cost nothing.

mod depth_of_field;
mod position;
mod read;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod tone_tests;
#[cfg(test)]
mod twin;

pub(super) use depth_of_field::lens;
pub(super) use position::Position;

use super::StageOptions;
use super::frame::FrameUniform;
use super::fullscreen::{Fullscreen, FullscreenDesc, Input};
use super::light::SUM_FORMAT;
use super::targets::texture;
use crate::gpu::COLOR_FORMAT;
use depth_of_field::DepthOfField;
use sward_scene::Tone;

/// The passes after drawing.
#[derive(Debug)]
pub(super) struct Post {
    position: Option<Position>,
    fogged: Option<Filter>,
    depth_of_field: Option<DepthOfField>,
    /// Tone mapping, or nothing.
    end: Fullscreen,
}

/// Colour and positions that are worked on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Drawn<'a> {
    /// In linear light, one sample a pixel.
    pub color: &'a wgpu::TextureView,
    /// As [`Position`] makes it; may be left out where no pass needs it.
    pub position: Option<&'a wgpu::TextureView>,
}

/// A pass with the textures that it fills.
#[derive(Debug)]
struct Filter {
    pass: Fullscreen,
    to: Vec<wgpu::TextureView>,
}

impl Post {
    /// Only the passes that the options ask for, and a picture in the end.
    pub fn new(
        device: &wgpu::Device,
        frame: &FrameUniform,
        picture: wgpu::TextureFormat,
        options: &StageOptions,
    ) -> Self {
        let agx = f64::from(u8::from(options.tone == Tone::Agx));
        let tone_map = FullscreenDesc {
            name: "tone_map",
            source: concat!(include_str!("agx.wgsl"), include_str!("tone_map.wgsl")),
            formats: &[picture],
            samples: 1,
            inputs: &[Input::Color],
            constants: &[("AGX", agx)],
            background: false,
        };
        Self::ending(device, frame, options, &tone_map)
    }

    /// The same, but what comes out is linear light, in [`SUM_FORMAT`].
    pub fn linear(device: &wgpu::Device, frame: &FrameUniform, options: &StageOptions) -> Self {
        let linear = FullscreenDesc {
            name: "linear",
            source: include_str!("linear.wgsl"),
            formats: &[SUM_FORMAT],
            samples: 1,
            inputs: &[Input::Color],
            constants: &[],
            background: false,
        };
        Self::ending(device, frame, options, &linear)
    }

    fn ending(
        device: &wgpu::Device,
        frame: &FrameUniform,
        options: &StageOptions,
        end: &FullscreenDesc,
    ) -> Self {
        let size = options.size;
        let samples = if options.reference { 1 } else { options.samples };
        let (fog, lens) = (options.fog.is_some(), options.depth_of_field.is_some());
        Self {
            position: (fog || lens).then(|| Position::new(device, frame, size, samples)),
            fogged: fog.then(|| fogged(device, frame, size)),
            depth_of_field: lens.then(|| DepthOfField::new(device, frame, size)),
            end: Fullscreen::new(device, &frame.layout, end),
        }
    }

    /// Whether any pass reads positions.
    pub fn needs_positions(&self) -> bool {
        self.position.is_some()
    }

    /// Makes the positions that the passes need; none where none does.
    pub fn position(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameUniform,
        depth: &wgpu::TextureView,
    ) -> Option<&wgpu::TextureView> {
        let position = self.position.as_ref()?;
        position.run(device, encoder, frame, depth);
        Some(position.view())
    }

    /// From what was drawn to the picture.
    pub fn run(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameUniform,
        drawn: Drawn,
        picture: &wgpu::TextureView,
    ) {
        let mut color = drawn.color;
        if let (Some(fogged), Some(position)) = (&self.fogged, drawn.position) {
            color = fogged.run(device, encoder, frame, &[color, position]);
        }
        if let (Some(lens), Some(position)) = (&self.depth_of_field, drawn.position) {
            color = lens.run(device, encoder, frame, [color, position]);
        }
        let inputs = self.end.bind(device, &[color]);
        self.end.run(encoder, &[picture], &frame.group, &inputs);
    }
}

fn fogged(device: &wgpu::Device, frame: &FrameUniform, size: [u32; 2]) -> Filter {
    Filter::new(
        device,
        frame,
        size,
        &FullscreenDesc {
            name: "fogged",
            source: include_str!("fogged.wgsl"),
            formats: &[COLOR_FORMAT],
            samples: 1,
            inputs: &[Input::Color; 2],
            constants: &[],
            background: false,
        },
    )
}

impl Filter {
    /// With textures of a size for all that it writes.
    fn new(
        device: &wgpu::Device,
        frame: &FrameUniform,
        size: [u32; 2],
        desc: &FullscreenDesc,
    ) -> Self {
        use wgpu::TextureUsages as U;
        let label = format!("sward.stage.{}", desc.name);
        // What a pass left can be read back
        let usage = U::RENDER_ATTACHMENT | U::TEXTURE_BINDING | U::COPY_SRC;
        let made = desc.formats.iter().map(|&format| {
            texture(device, &label, size, format, 1, usage).create_view(&Default::default())
        });
        Self { to: made.collect(), pass: Fullscreen::new(device, &frame.layout, desc) }
    }

    /// Runs from these textures; gives the first that it fills.
    fn run(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameUniform,
        from: &[&wgpu::TextureView],
    ) -> &wgpu::TextureView {
        let inputs = self.pass.bind(device, from);
        let to: Vec<_> = self.to.iter().collect();
        self.pass.run(encoder, &to, &frame.group, &inputs);
        &self.to[0]
    }
}
