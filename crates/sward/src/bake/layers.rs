//! Layers of a texture array: pictures of equal size, in 8 bits a channel, with their mips.

use super::mips::Chain;
use super::raster::Texel;
use crate::gpu::uploads::Upload;

/// Pictures of one size, as a texture array takes them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Layers {
    /// Texels of the first level.
    pub size: [u32; 2],
    /// How many.
    pub count: u32,
    /// By level: all its layers one after the other, row by row.
    pub levels: Vec<Vec<[u8; 4]>>,
}

/// Colour as its square root, which is finer in the dark, and alpha.
pub(crate) fn color_of(texel: &Texel) -> [f32; 4] {
    let [r, g, b] = texel.albedo.to_array().map(|c| c.max(0.0).sqrt());
    [r, g, b, texel.alpha]
}

/// Normal from -1..=1, and height share.
pub(crate) fn shape_of(texel: &Texel) -> [f32; 4] {
    let [x, y, z] = (texel.normal * 0.5 + 0.5).to_array();
    [x, y, z, texel.height_share]
}

/// Normal from -1..=1, and how much light a texel lets through: 1 over 1 + thickness.
pub(crate) fn thin_of(texel: &Texel) -> [f32; 4] {
    let [x, y, z, _] = shape_of(texel);
    [x, y, z, 1.0 / (1.0 + texel.thickness.max(0.0))]
}

#[cfg(test)]
fn level_size(size: [u32; 2], level: usize) -> [u32; 2] {
    size.map(|n| (n >> level).max(1))
}

impl Layers {
    /// Layers of chains that are all of the first one's size; others are left out. `encode` gives
    /// each texel's channels, 0..=1.
    pub(crate) fn new(chains: &[Chain], encode: impl Fn(&Texel) -> [f32; 4]) -> Self {
        let first = chains.first().map_or(&[][..], |chain| &chain[..]);
        let size = first.first().map_or([0, 0], |tile| tile.size);
        let fits = |chain: &&Chain| {
            chain.len() == first.len() && chain.first().is_some_and(|tile| tile.size == size)
        };
        let chains: Vec<&Chain> = chains.iter().filter(fits).collect();
        let byte = |x: f32| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
        let level = |i: usize| {
            let texels = chains.iter().flat_map(|chain| &chain[i].texels);
            texels.map(|texel| encode(texel).map(byte)).collect()
        };
        Self { size, count: chains.len() as u32, levels: (0..first.len()).map(level).collect() }
    }

    /// Texels of a layer of a level, row by row; for tests and pictures.
    #[cfg(test)]
    pub(crate) fn layer(&self, level: usize, layer: u32) -> &[[u8; 4]] {
        let [width, height] = level_size(self.size, level);
        let texels = (width * height) as usize;
        &self.levels[level][layer as usize * texels..][..texels]
    }

    /// Makes the texture, and what fills it.
    pub(crate) fn texture(
        &self,
        device: &wgpu::Device,
        label: &str,
    ) -> (wgpu::TextureView, Vec<Upload>) {
        use wgpu::TextureUsages as U;
        let [width, height] = self.size;
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some(label),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: self.count },
            mip_level_count: self.levels.len() as u32,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba8Unorm,
            usage: U::TEXTURE_BINDING | U::COPY_DST | U::COPY_SRC,
            view_formats: &[],
        });
        let upload = |(level, texels): (u32, &Vec<[u8; 4]>)| {
            Upload::new(device, &texture, level, (bytemuck::cast_slice(texels), 4))
        };
        let uploads = (0..).zip(&self.levels).map(upload).collect();
        let view = texture.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::D2Array),
            ..Default::default()
        });
        (view, uploads)
    }
}

#[cfg(test)]
mod tests {
    use super::super::mips::chain;
    use super::super::raster::Tile;
    use super::*;
    use crate::gpu::test_device;
    use glam::Vec3;

    fn tile(size: [u32; 2], shade: f32) -> Tile {
        let texel = Texel {
            albedo: Vec3::new(shade, 0.25, 1.0),
            alpha: 1.0,
            normal: Vec3::NEG_X,
            height_share: 0.5,
            thickness: 1.0,
        };
        Tile { size, texels: vec![texel; (size[0] * size[1]) as usize] }
    }

    #[test]
    fn channels_are_as_documented() {
        let chains = [chain(tile([16, 16], 0.0), 1.0), chain(tile([16, 16], 1.0), 1.0)];
        let color = Layers::new(&chains, color_of);
        assert_eq!((color.count, color.levels.len()), (2, 3));
        assert!(color.layer(1, 0).iter().all(|t| *t == [0, 128, 255, 255]));
        assert!(color.layer(2, 1).iter().all(|t| *t == [255, 128, 255, 255]));
        let shape = Layers::new(&chains, shape_of);
        assert!(shape.layer(0, 1).iter().all(|t| *t == [0, 128, 128, 128]));
    }

    #[test]
    fn layers_of_another_size_are_left_out() {
        let chains = [chain(tile([8, 8], 0.0), 1.0), chain(tile([16, 8], 0.0), 1.0)];
        assert_eq!(Layers::new(&chains, color_of).count, 1);
        assert_eq!(Layers::new(&[], color_of).count, 0);
    }

    /// Every level and layer arrives at its place, rows narrower than the copy's alignment too.
    #[test]
    fn what_is_uploaded_is_read_back() {
        let (device, queue) = test_device::device();
        let shades = [0.0, 0.3, 1.0];
        let chains = shades.map(|shade| chain(tile([32, 16], shade), 1.0));
        let layers = Layers::new(&chains, color_of);
        let mut encoder = device.create_command_encoder(&Default::default());
        let (view, uploads) = layers.texture(&device, "test");
        uploads.iter().for_each(|upload| upload.record(&mut encoder));
        let row = 256_u64;
        for level in 0..layers.levels.len() {
            let [width, height] = level_size(layers.size, level);
            let bytes = row * u64::from(height * layers.count);
            let usage = wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC;
            let buffer = device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size: bytes,
                usage,
                mapped_at_creation: false,
            });
            let texture = view.texture();
            let mip_level = level as u32;
            encoder.copy_texture_to_buffer(
                wgpu::TexelCopyTextureInfo { mip_level, ..texture.as_image_copy() },
                wgpu::TexelCopyBufferInfo {
                    buffer: &buffer,
                    layout: wgpu::TexelCopyBufferLayout {
                        offset: 0,
                        bytes_per_row: Some(row as u32),
                        rows_per_image: Some(height),
                    },
                },
                wgpu::Extent3d { width, height, depth_or_array_layers: layers.count },
            );
            queue.submit([std::mem::replace(
                &mut encoder,
                device.create_command_encoder(&Default::default()),
            )
            .finish()]);
            let words: Vec<[u8; 4]> = test_device::read(&device, &queue, &buffer);
            for layer in 0..layers.count {
                let rows = words.chunks_exact(64).skip((layer * height) as usize);
                let found: Vec<_> =
                    rows.take(height as usize).flat_map(|r| &r[..width as usize]).collect();
                let sent: Vec<_> = layers.layer(level, layer).iter().collect();
                assert_eq!(found, sent, "level {level}, layer {layer}");
            }
        }
    }
}
