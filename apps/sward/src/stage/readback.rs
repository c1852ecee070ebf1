//! Pictures back from the GPU.

use crate::gpu::Gpu;
use anyhow::{Context, Result};
use glam::Vec4;
use image::RgbImage;

/// Copies an `Rgba8Unorm` texture into a picture without alpha.
pub(super) fn read(gpu: &Gpu, texture: &wgpu::Texture) -> Result<RgbImage> {
    let bytes = bytes(gpu, texture, 4)?;
    let pixels = bytes.chunks_exact(4).flat_map(|pixel| &pixel[..3]).copied().collect();
    RgbImage::from_raw(texture.width(), texture.height(), pixels)
        .context("the picture came back with a wrong size")
}

/// Copies an `Rgba32Float` texture, row by row.
pub(super) fn floats(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Vec<Vec4>> {
    let bytes = bytes(gpu, texture, 16)?;
    Ok(bytes.chunks_exact(16).map(bytemuck::pod_read_unaligned).collect())
}

/// The texture's rows, one after another.
pub(super) fn bytes(gpu: &Gpu, texture: &wgpu::Texture, bytes_a_pixel: u32) -> Result<Vec<u8>> {
    let line = texture.width() * bytes_a_pixel;
    let row = line.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("sward.stage.readback"),
        size: u64::from(row) * u64::from(texture.height()),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(row),
                rows_per_image: None,
            },
        },
        texture.size(),
    );
    gpu.queue.submit([encoder.finish()]);
    buffer.map_async(wgpu::MapMode::Read, .., |_| {});
    gpu.wait()?;
    let mapped = buffer.get_mapped_range(..).context("the picture cannot be read back")?;
    let rows = mapped.chunks_exact(row as usize);
    Ok(rows.flat_map(|bytes| &bytes[..line as usize]).copied().collect())
}
