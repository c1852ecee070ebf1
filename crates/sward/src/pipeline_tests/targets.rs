//! What tests draw to.

use wgpu::{Texture, TextureFormat, TextureUsages};

/// A texture to draw to; with one sample it can be copied.
pub(super) fn texture(
    device: &wgpu::Device,
    size: [u32; 2],
    format: TextureFormat,
    samples: u32,
) -> Texture {
    let usage = TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING;
    let copied = if samples == 1 { TextureUsages::COPY_SRC } else { TextureUsages::empty() };
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("test.target"),
        size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: samples,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: usage | copied,
        view_formats: &[],
    })
}

/// A picture with its depth, and a buffer that takes it.
pub(super) struct Target {
    color: Texture,
    depth: Texture,
    pub out: wgpu::Buffer,
}

impl Target {
    /// Of a width of which a row's bytes are a multiple of 256.
    pub fn new(device: &wgpu::Device, size: [u32; 2], format: TextureFormat) -> Self {
        let texel = format.block_copy_size(None).expect("a colour");
        let bytes = u64::from(size[0] * size[1] * texel);
        let none = wgpu::BufferUsages::empty();
        Self {
            color: texture(device, size, format, 1),
            depth: texture(device, size, TextureFormat::Depth32Float, 1),
            out: crate::gpu::buffers::storage(device, "test", bytes, none),
        }
    }

    /// Records what is drawn on black, alpha 0, and its copy to the buffer.
    pub fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        draw: impl FnOnce(&mut wgpu::RenderPass),
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.color.create_view(&Default::default()),
                depth_slice: None,
                resolve_target: None,
                ops: cleared(wgpu::Color::TRANSPARENT),
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth.create_view(&Default::default()),
                depth_ops: Some(cleared(1.0)),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        draw(&mut pass);
        drop(pass);
        let texel = self.color.format().block_copy_size(None).unwrap_or(0);
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(self.color.width() * texel),
            rows_per_image: None,
        };
        encoder.copy_texture_to_buffer(
            self.color.as_image_copy(),
            wgpu::TexelCopyBufferInfo { buffer: &self.out, layout },
            self.color.size(),
        );
    }
}

/// Cleared to a value, and kept.
pub(super) fn cleared<V>(value: V) -> wgpu::Operations<V> {
    wgpu::Operations { load: wgpu::LoadOp::Clear(value), store: wgpu::StoreOp::Store }
}
