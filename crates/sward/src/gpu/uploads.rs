//! Content of textures on its way to the GPU: made with the field, copied in the next frame, as only
//! then there is an encoder.

use wgpu::COPY_BYTES_PER_ROW_ALIGNMENT;
use wgpu::util::DeviceExt;

/// The content of one level of a texture, all its layers.
#[derive(Debug)]
pub struct Upload {
    texture: wgpu::Texture,
    mip_level: u32,
    size: wgpu::Extent3d,
    row: u32,
    buffer: wgpu::Buffer,
}

impl Upload {
    /// Texels row by row, layer by layer, each of `texel_bytes`; fewer rows than the level has leave
    /// the rest as it is.
    pub fn new(
        device: &wgpu::Device,
        texture: &wgpu::Texture,
        mip_level: u32,
        (texels, texel_bytes): (&[u8], u32),
    ) -> Self {
        let width = (texture.width() >> mip_level).max(1);
        let height = (texture.height() >> mip_level).max(1);
        let line = width * texel_bytes;
        // Rows of a copy begin at multiples of 256 bytes
        let row = line.next_multiple_of(COPY_BYTES_PER_ROW_ALIGNMENT);
        let rows = texels.len() / line as usize;
        let mut bytes = Vec::with_capacity(rows * row as usize);
        for texels in texels.chunks_exact(line as usize) {
            bytes.extend_from_slice(texels);
            bytes.resize(bytes.len().next_multiple_of(row as usize), 0);
        }
        let buffer = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("sward.upload"),
            contents: &bytes,
            usage: wgpu::BufferUsages::COPY_SRC,
        });
        let depth_or_array_layers = rows as u32 / height;
        let size = wgpu::Extent3d { width, height, depth_or_array_layers };
        Self { texture: texture.clone(), mip_level, size, row, buffer }
    }

    /// Records the copy.
    pub fn record(&self, encoder: &mut wgpu::CommandEncoder) {
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(self.row),
            rows_per_image: Some(self.size.height),
        };
        encoder.copy_buffer_to_texture(
            wgpu::TexelCopyBufferInfo { buffer: &self.buffer, layout },
            wgpu::TexelCopyTextureInfo {
                texture: &self.texture,
                mip_level: self.mip_level,
                origin: wgpu::Origin3d::ZERO,
                aspect: wgpu::TextureAspect::All,
            },
            self.size,
        );
    }
}
