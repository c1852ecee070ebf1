//! Textures back from the GPU.

use crate::gpu::Gpu;
use anyhow::{Context, Result};
use bytemuck::AnyBitPattern;
use image::RgbImage;

/// Copies an `Rgba8Unorm` texture into a picture without alpha.
pub(super) fn read(gpu: &Gpu, texture: &wgpu::Texture) -> Result<RgbImage> {
    let (width, height) = (texture.width(), texture.height());
    let texels = read_texels::<[u8; 4]>(gpu, texture)?;
    let pixels = texels.into_iter().flat_map(|[r, g, b, _]| [r, g, b]).collect();
    RgbImage::from_raw(width, height, pixels).context("the picture came back with a wrong size")
}

/// Copies a texture whose texels are each a `T`, by rows from the top.
pub(super) fn read_texels<T: AnyBitPattern>(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Vec<T>> {
    let (width, height) = (texture.width(), texture.height());
    let line = width * size_of::<T>() as u32;
    let row = line.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
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
    let mut texels = Vec::with_capacity((width * height) as usize);
    for padded in bytes.chunks_exact(row as usize) {
        let line = padded[..line as usize].chunks_exact(size_of::<T>());
        texels.extend(line.map(bytemuck::pod_read_unaligned::<T>));
    }
    Ok(texels)
}
