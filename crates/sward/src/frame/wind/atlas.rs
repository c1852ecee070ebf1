//! The maps of a wind as one texture: one below the other, each once.

use super::{WindMap, WindSource};
use crate::Error;
use std::sync::Arc;
use wgpu::util::DeviceExt;

/// Bytes of a texel: two `f32`.
const TEXEL: usize = 8;
/// Rows of a copy from a buffer start at multiples of this.
const ROW_ALIGNMENT: usize = wgpu::COPY_BYTES_PER_ROW_ALIGNMENT as usize;

/// Each map of the sources once, in their order, and its first row in the texture.
pub(super) fn rows(sources: &[WindSource]) -> Vec<(&Arc<WindMap>, u32)> {
    let mut rows: Vec<(&Arc<WindMap>, u32)> = Vec::new();
    let mut next = 0;
    for source in sources {
        let WindSource::Texture(texture) = source else { continue };
        if rows.iter().all(|(map, _)| !Arc::ptr_eq(map, &texture.map)) {
            rows.push((&texture.map, next));
            next += texture.map.height();
        }
    }
    rows
}

/// The texture on the GPU; a texel where there are no maps.
#[derive(Debug)]
pub(crate) struct WindAtlas {
    maps: Vec<Arc<WindMap>>,
    view: wgpu::TextureView,
}

impl WindAtlas {
    pub(crate) fn new(device: &wgpu::Device) -> Self {
        Self { maps: Vec::new(), view: texture(device, 1, 1).create_view(&Default::default()) }
    }

    pub(crate) fn view(&self) -> &wgpu::TextureView {
        &self.view
    }

    /// Holds the maps of these sources from this point of the encoder on; true where the texture is
    /// another.
    pub(crate) fn write(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        sources: &[WindSource],
    ) -> bool {
        let rows = rows(sources);
        let same = |(own, (map, _)): (&Arc<WindMap>, &(&Arc<WindMap>, u32))| Arc::ptr_eq(own, map);
        // A wind without maps reads none: those that are there may stay
        if rows.is_empty() || rows.len() == self.maps.len() && self.maps.iter().zip(&rows).all(same)
        {
            return false;
        }
        let width = rows.iter().map(|(map, _)| map.width()).max().unwrap_or(1);
        let height = rows.iter().map(|(map, _)| map.height()).sum();
        let texture = texture(device, width, height);
        for (map, row) in &rows {
            copy(device, encoder, &texture, map, *row);
        }
        self.view = texture.create_view(&Default::default());
        self.maps = rows.into_iter().map(|(map, _)| map.clone()).collect();
        true
    }
}

/// Whether the maps of all sources fit a texture of the device.
pub(crate) fn check(limits: &wgpu::Limits, sources: &[WindSource]) -> Result<(), Error> {
    let rows = rows(sources);
    let needed: u64 = rows.iter().map(|(map, _)| u64::from(map.height())).sum();
    let available = u64::from(limits.max_texture_dimension_2d);
    if needed <= available {
        return Ok(());
    }
    Err(Error::Limit {
        what: "wind: the rows of all maps".into(),
        limit: "max_texture_dimension_2d",
        needed,
        available,
        remedy: "use fewer or smaller maps, or one map for several sources".into(),
    })
}

fn texture(device: &wgpu::Device, width: u32, height: u32) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("sward.wind_maps"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rg32Float,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

fn copy(
    device: &wgpu::Device,
    encoder: &mut wgpu::CommandEncoder,
    texture: &wgpu::Texture,
    map: &WindMap,
    row: u32,
) {
    let stride = (map.width() as usize * TEXEL).next_multiple_of(ROW_ALIGNMENT);
    let mut bytes = Vec::with_capacity(stride * map.height() as usize);
    for winds in map.winds().chunks(map.width() as usize) {
        bytes.extend_from_slice(bytemuck::cast_slice(winds));
        bytes.resize(bytes.len().next_multiple_of(ROW_ALIGNMENT), 0);
    }
    let buffer = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("sward.wind_map"),
        contents: &bytes,
        usage: wgpu::BufferUsages::COPY_SRC,
    });
    encoder.copy_buffer_to_texture(
        wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(stride as u32),
                rows_per_image: None,
            },
        },
        wgpu::TexelCopyTextureInfo {
            texture,
            mip_level: 0,
            origin: wgpu::Origin3d { x: 0, y: row, z: 0 },
            aspect: wgpu::TextureAspect::All,
        },
        wgpu::Extent3d { width: map.width(), height: map.height(), depth_or_array_layers: 1 },
    );
}
