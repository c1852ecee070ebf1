//! The textures that a frame is drawn to.

use crate::gpu::{COLOR_FORMAT, DEPTH_FORMAT};

/// Colour, depth and the final picture of one size and sample count.
#[derive(Debug)]
pub(super) struct Targets {
    /// Multisampled where `resolved` is there.
    pub color: wgpu::TextureView,
    pub resolved: Option<wgpu::TextureView>,
    pub depth: wgpu::TextureView,
    pub picture: wgpu::Texture,
    pub picture_view: wgpu::TextureView,
}

impl Targets {
    pub fn new(device: &wgpu::Device, size: [u32; 2], samples: u32) -> Self {
        Self::with_picture(device, size, samples, size)
    }

    /// The same, and the samples of its colour can be read.
    pub fn readable(device: &wgpu::Device, size: [u32; 2], samples: u32) -> Self {
        use wgpu::TextureUsages as U;
        let usage = U::RENDER_ATTACHMENT | U::TEXTURE_BINDING;
        let color = texture(device, "sward.stage.color", size, COLOR_FORMAT, samples, usage);
        Self { color: color.create_view(&Default::default()), ..Self::new(device, size, samples) }
    }

    /// One sample, and no picture to speak of: what is averaged before it becomes one.
    pub fn without_picture(device: &wgpu::Device, size: [u32; 2]) -> Self {
        Self::with_picture(device, size, 1, [1; 2])
    }

    fn with_picture(
        device: &wgpu::Device,
        size: [u32; 2],
        samples: u32,
        picture_size: [u32; 2],
    ) -> Self {
        use wgpu::TextureUsages as U;
        let (draw, read) = (U::RENDER_ATTACHMENT, U::TEXTURE_BINDING);
        let view = |label, format, samples, usage| {
            texture(device, label, size, format, samples, usage).create_view(&Default::default())
        };
        let color_usage = if samples > 1 { draw } else { draw | read };
        let picture_format = wgpu::TextureFormat::Rgba8Unorm;
        let picture_usage = draw | U::COPY_SRC;
        let name = "sward.stage.picture";
        let picture = texture(device, name, picture_size, picture_format, 1, picture_usage);
        Self {
            color: view("sward.stage.color", COLOR_FORMAT, samples, color_usage),
            resolved: (samples > 1)
                .then(|| view("sward.stage.resolved", COLOR_FORMAT, 1, draw | read)),
            depth: view("sward.stage.depth", DEPTH_FORMAT, samples, draw | read),
            picture_view: picture.create_view(&Default::default()),
            picture,
        }
    }

    /// Colour in linear light with one sample a pixel.
    pub fn linear(&self) -> &wgpu::TextureView {
        self.resolved.as_ref().unwrap_or(&self.color)
    }
}

/// A 2D texture without mipmaps.
pub(super) fn texture(
    device: &wgpu::Device,
    label: &str,
    [width, height]: [u32; 2],
    format: wgpu::TextureFormat,
    samples: u32,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: samples,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}
