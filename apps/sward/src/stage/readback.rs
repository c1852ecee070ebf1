//! Pictures back from the GPU.

use crate::gpu::Gpu;
use anyhow::{Context, Result};
use image::RgbImage;

/// Copies an `Rgba8Unorm` texture into a picture without alpha.
pub(super) fn read(gpu: &Gpu, texture: &wgpu::Texture) -> Result<RgbImage> {
    let (width, height) = (texture.width(), texture.height());
    let row = (width * 4).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("sward.stage.readback"),
        size: u64::from(row) * u64::from(height),
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
    let bytes = buffer.get_mapped_range(..).context("the picture cannot be read back")?;
    let mut pixels = Vec::with_capacity((width * height * 3) as usize);
    for line in bytes.chunks_exact(row as usize) {
        for pixel in line[..width as usize * 4].chunks_exact(4) {
            pixels.extend_from_slice(&pixel[..3]);
        }
    }
    RgbImage::from_raw(width, height, pixels).context("the picture came back with a wrong size")
}
