//! Base colour textures with mipmaps, and the look of the grass beside them.

use super::grass_look::GrassLook;
use sward_scene::TextureImage;
use wgpu::util::{DeviceExt, TextureDataOrder};

/// Bind group layout of a texture, its sampler and the grass's look, group 1 of the opaque pass.
pub(super) fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty,
        count: None,
    };
    let texture = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable: true },
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    let uniform = wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Uniform,
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("sward.stage.texture"),
        entries: &[entry(0, texture), entry(1, sampler), entry(2, uniform), entry(3, uniform)],
    })
}

/// Uploads textures with one sampler.
pub(super) struct Uploader<'a> {
    pub device: &'a wgpu::Device,
    pub queue: &'a wgpu::Queue,
    pub layout: &'a wgpu::BindGroupLayout,
    pub sampler: wgpu::Sampler,
}

impl<'a> Uploader<'a> {
    pub fn new(
        device: &'a wgpu::Device,
        queue: &'a wgpu::Queue,
        layout: &'a wgpu::BindGroupLayout,
    ) -> Self {
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("sward.stage.texture"),
            address_mode_u: wgpu::AddressMode::Repeat,
            address_mode_v: wgpu::AddressMode::Repeat,
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            mipmap_filter: wgpu::MipmapFilterMode::Linear,
            ..Default::default()
        });
        Self { device, queue, layout, sampler }
    }

    /// Without an image: white, which changes nothing that it multiplies.
    pub fn upload(&self, image: Option<&TextureImage>, grass: &GrassLook) -> wgpu::BindGroup {
        let [canopy, stance] = grass.buffers(self.device);
        let (width, height, data, levels) = match image {
            None => (1, 1, vec![255; 4], 1),
            Some(image) => {
                let (data, levels) = mip_chain(image);
                (image.width, image.height, data, levels)
            }
        };
        let texture = self.device.create_texture_with_data(
            self.queue,
            &wgpu::TextureDescriptor {
                label: Some("sward.stage.texture"),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: levels,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: wgpu::TextureFormat::Rgba8UnormSrgb,
                usage: wgpu::TextureUsages::TEXTURE_BINDING,
                view_formats: &[],
            },
            TextureDataOrder::MipMajor,
            &data,
        );
        let view = texture.create_view(&Default::default());
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("sward.stage.texture"),
            layout: self.layout,
            entries: &[
                wgpu::BindGroupEntry {
                    binding: 0,
                    resource: wgpu::BindingResource::TextureView(&view),
                },
                wgpu::BindGroupEntry {
                    binding: 1,
                    resource: wgpu::BindingResource::Sampler(&self.sampler),
                },
                wgpu::BindGroupEntry { binding: 2, resource: canopy.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 3, resource: stance.as_entire_binding() },
            ],
        })
    }
}

/// All levels one after another, each the mean of 2 x 2 of the one before, in linear light.
fn mip_chain(image: &TextureImage) -> (Vec<u8>, u32) {
    let (mut width, mut height) = (image.width as usize, image.height as usize);
    // Both transfer functions of each value once: a large image has many millions.
    let [color, alpha] = [0, 3].map(|i| (0..=255).map(|v| decode(i, v)).collect::<Vec<_>>());
    let table = |i: usize| if i % 4 == 3 { &alpha } else { &color };
    let pixels = image.pixels.iter().enumerate();
    let mut level: Vec<f32> = pixels.map(|(i, &v)| table(i)[usize::from(v)]).collect();
    let mut data = image.pixels.clone();
    let mut levels = 1;
    while width > 1 || height > 1 {
        let (next_width, next_height) = ((width / 2).max(1), (height / 2).max(1));
        let mut next = Vec::with_capacity(next_width * next_height * 4);
        for y in 0..next_height {
            for x in 0..next_width {
                for channel in 0..4 {
                    let at = |dx: usize, dy: usize| {
                        let (sx, sy) = ((x * 2 + dx).min(width - 1), (y * 2 + dy).min(height - 1));
                        level[(sy * width + sx) * 4 + channel]
                    };
                    next.push((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) * 0.25);
                }
            }
        }
        data.extend(next.iter().enumerate().map(|(i, &v)| encode(i, v)));
        (level, width, height) = (next, next_width, next_height);
        levels += 1;
    }
    (data, levels)
}

/// Channels 0 to 2 of 4 are sRGB, alpha is linear.
fn decode(index: usize, value: u8) -> f32 {
    let v = f32::from(value) / 255.0;
    match index % 4 {
        3 => v,
        _ if v <= 0.04045 => v / 12.92,
        _ => ((v + 0.055) / 1.055).powf(2.4),
    }
}

fn encode(index: usize, value: f32) -> u8 {
    let v = match index % 4 {
        3 => value,
        _ if value <= 0.003_130_8 => value * 12.92,
        _ => 1.055 * value.powf(1.0 / 2.4) - 0.055,
    };
    (v * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mipmaps_average_linear_light_down_to_one_texel() {
        let row = [[0, 0, 0, 255], [255, 255, 255, 0], [0, 0, 0, 255]];
        let image = TextureImage { width: 3, height: 1, pixels: row.concat() };
        let (data, levels) = mip_chain(&image);
        assert_eq!(levels, 2);
        // Half the light is 188 in sRGB, not 128; alpha is a plain mean.
        assert_eq!(&data[12..], &[188, 188, 188, 128]);
    }

    #[test]
    fn encoding_undoes_decoding() {
        for value in 0..=255 {
            assert_eq!(encode(0, decode(0, value)), value);
            assert_eq!(encode(3, decode(3, value)), value);
        }
    }
}
