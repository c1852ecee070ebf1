//! What a frame holds before it becomes a picture: mean light of each pixel, and how much of the
//! pixel is grass.

use super::frame::FrameUniform;
use super::fullscreen::{Fullscreen, FullscreenDesc, Input};
use super::post::{Position, Post};
use super::targets::{Targets, texture};
use super::{Stage, readback};
use crate::gpu::Gpu;
use anyhow::{Context, Result};
use glam::{Vec3, Vec4, Vec4Swizzles};
use image::Rgb32FImage;

pub(super) const SUM_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;

/// Beyond a tenth of this lies the sky: see post/position.wgsl.
const SKY_M: f32 = 1e9;

/// A picture in linear light, row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct LightMap {
    /// Width and height, pixels.
    pub size: [u32; 2],
    pixels: Vec<Vec4>,
}

impl LightMap {
    /// Mean radiance of each pixel, linear RGB, and the share of it that is grass, or ground that
    /// stands for grass.
    pub fn pixels(&self) -> impl Iterator<Item = (Vec3, f32)> {
        self.pixels.iter().map(|pixel| (pixel.xyz(), pixel.w))
    }
}

/// A pass that averages the samples of each pixel.
pub(super) fn averaging(
    device: &wgpu::Device,
    frame: &FrameUniform,
    multisampled: bool,
) -> Fullscreen {
    const ONE: &str = concat!(include_str!("shown.wgsl"), include_str!("average.wgsl"));
    const MANY: &str = concat!(include_str!("shown.wgsl"), include_str!("average_samples.wgsl"));
    let desc = FullscreenDesc {
        name: "average",
        source: if multisampled { MANY } else { ONE },
        formats: &[SUM_FORMAT],
        samples: 1,
        inputs: &[if multisampled { Input::Samples } else { Input::Color }],
        constants: &[],
        background: false,
    };
    Fullscreen::new(device, &frame.layout, &desc)
}

/// Targets whose samples can be read, and the means.
#[derive(Debug)]
pub(super) struct Readable {
    samples: Targets,
    average: Fullscreen,
    inputs: wgpu::BindGroup,
    means: wgpu::Texture,
    means_view: wgpu::TextureView,
}

impl Readable {
    fn new(gpu: &Gpu, frame: &FrameUniform, size: [u32; 2], count: u32) -> Self {
        let device = &gpu.device;
        let samples = Targets::readable(device, size, count);
        let average = averaging(device, frame, count > 1);
        let inputs = average.bind(device, &[&samples.color]);
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let means = texture(device, "sward.stage.means", size, SUM_FORMAT, 1, usage);
        let means_view = means.create_view(&Default::default());
        Self { samples, average, inputs, means, means_view }
    }
}

impl Stage {
    /// What [`Stage::render`] would make a picture of.
    ///
    /// # Errors
    /// Where the device fails.
    pub fn light_map(&mut self) -> Result<LightMap> {
        let size = self.options.size;
        if self.options.reference {
            self.draw_reference()?;
            let target = self.supersampled.as_ref().context("no reference was drawn")?;
            return Ok(LightMap { size, pixels: readback::floats(&self.gpu, target.linear())? });
        }
        let mut target = match self.readable.take() {
            Some(target) => target,
            None => Readable::new(&self.gpu, &self.uniform, size, self.options.samples),
        };
        std::mem::swap(&mut self.targets, &mut target.samples);
        self.depth_is_opaque = false;
        let mut encoder = self.encoder();
        self.encode_draw(&mut encoder);
        std::mem::swap(&mut self.targets, &mut target.samples);
        let Readable { average, means_view, inputs, .. } = &target;
        average.run(&mut encoder, &[means_view], &self.uniform.group, inputs);
        self.submit(encoder);
        let pixels = readback::floats(&self.gpu, &target.means)?;
        self.readable = Some(target);
        Ok(LightMap { size, pixels })
    }

    /// The picture in linear light, neither exposed nor toned: with fog and depth of field.
    ///
    /// # Errors
    /// Where the device fails.
    pub fn linear_picture(&mut self) -> Result<Rgb32FImage> {
        let device = &self.gpu.device;
        let size = self.options.size;
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let mut target = texture(device, "sward.stage.hdr", size, SUM_FORMAT, 1, usage);
        let mut view = target.create_view(&Default::default());
        let mut post = Post::linear(device, &self.uniform, &self.options);
        let mut swap = |stage: &mut Self| {
            std::mem::swap(&mut stage.post, &mut post);
            std::mem::swap(&mut stage.targets.picture, &mut target);
            std::mem::swap(&mut stage.targets.picture_view, &mut view);
        };
        swap(self);
        let drawn = self.draw_picture();
        swap(self);
        drawn?;
        let texels = readback::floats(&self.gpu, &target)?;
        let light = texels.into_iter().flat_map(|texel| texel.xyz().to_array()).collect();
        Rgb32FImage::from_raw(size[0], size[1], light).context("the picture has a wrong size")
    }

    /// The place of the opaque thing that each pixel would show without grass, row by row; `None`
    /// where it would show the sky. Not of references, which are drawn in tiles.
    ///
    /// # Errors
    /// Where the device fails.
    pub fn opaque_places(&mut self) -> Result<Vec<Option<Vec3>>> {
        let (device, options) = (&self.gpu.device, &self.options);
        let position = Position::new(device, &self.uniform, options.size, options.samples);
        self.depth_is_opaque = false;
        let mut encoder = self.encoder();
        self.encode_opaque(&mut encoder);
        position.run(&self.gpu.device, &mut encoder, &self.uniform, &self.targets.depth);
        self.submit(encoder);
        let places = readback::floats(&self.gpu, position.target())?;
        let thing = |place: Vec4| (place.xyz().length() < 0.1 * SKY_M).then_some(place.xyz());
        Ok(places.into_iter().map(thing).collect())
    }

    /// Looks at the same moment from elsewhere.
    ///
    /// # Errors
    /// Where the camera is none, or the device fails.
    pub fn look_from(&mut self, camera: &sward_scene::Camera) -> Result<()> {
        self.options.camera = camera.clone();
        self.depth_is_opaque = false;
        self.write_camera();
        // A reference is culled tile by tile when it is drawn.
        if self.options.reference {
            return Ok(());
        }
        let mut encoder = self.encoder();
        self.encode_opaque(&mut encoder);
        self.encode_cull(&mut encoder)?;
        self.submit(encoder);
        self.gpu.wait()
    }

    /// Leaves out of references, from now on, what is out of view: the same pictures, sooner.
    pub fn draw_in_view_only(&mut self) {
        self.options.reference_in_view = true;
    }

    /// Takes haze, fog and depth of field away.
    ///
    /// # Errors
    /// Where the device fails.
    pub fn clear_air(&mut self) -> Result<()> {
        let options = &mut self.options;
        (options.haze, options.fog, options.depth_of_field) = (false, None, None);
        self.light.haze_per_m = 0.0;
        self.uniform.clear_air();
        let format = self.targets.picture.format();
        self.post = Post::new(&self.gpu.device, &self.uniform, format, &self.options);
        self.write_camera();
        // The renderer takes its light with a step.
        self.step(0.0)
    }

    /// Whether the sky is drawn; black, where it is not.
    pub fn show_sky(&mut self, shown: bool) {
        self.options.sky = shown;
    }
}
