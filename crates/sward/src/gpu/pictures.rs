//! The pictures of a field's clusters and plants, and the light that clusters stand for: what its
//! draw group holds beside its buffers.

use super::buffers::filled;
use super::layout::GpuCanopy;
use super::uploads::Upload;
use crate::plants::layers::{MODEL_POINTS, PlantLayers};

/// Group 1 of drawing from binding 6 on, but for the bands.
#[derive(Debug, Clone)]
pub struct Pictures {
    /// Square root of the albedo, and alpha: a layer for each variant, elevation and azimuth.
    pub cluster_color: wgpu::TextureView,
    /// Normal, and share of the height.
    pub cluster_shape: wgpu::TextureView,
    /// Square root of the albedo, and alpha: a layer a picture of a plant.
    pub plant_color: wgpu::TextureView,
    /// Normal, and how much light passes.
    pub plant_normal: wgpu::TextureView,
    /// Points of modelled plants, a row a variant.
    pub plant_models: wgpu::TextureView,
    /// Trilinear.
    pub sampler: wgpu::Sampler,
    /// `GpuCanopy`: what clusters and ground are lit as.
    pub canopy: wgpu::Buffer,
}

fn blank(device: &wgpu::Device) -> wgpu::TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("sward.blank"),
        size: wgpu::Extent3d::default(),
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8Unorm,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2Array),
        ..Default::default()
    })
}

/// A table of so many variants' points.
fn models(device: &wgpu::Device, rows: u32) -> (wgpu::Texture, wgpu::TextureView) {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("sward.plant_models"),
        size: wgpu::Extent3d { width: MODEL_POINTS, height: rows, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba32Uint,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
    (texture, view)
}

/// Bytes of a texture's texels, all its mips and layers.
fn texel_bytes(texture: &wgpu::Texture) -> u64 {
    let texel = texture.format().block_copy_size(None).unwrap_or(0);
    let level = |mip: u32| {
        let side = |size: u32| u64::from((size >> mip).max(1));
        side(texture.width()) * side(texture.height())
    };
    let texels: u64 = (0..texture.mip_level_count()).map(level).sum();
    texels * u64::from(texture.depth_or_array_layers()) * u64::from(texel)
}

/// Bytes of all textures and canopies in these pictures, each counted once.
pub fn bytes<'a>(pictures: impl Iterator<Item = &'a Pictures>) -> u64 {
    let (mut textures, mut canopies) = (Vec::new(), Vec::new());
    for own in pictures {
        let views = [
            &own.cluster_color,
            &own.cluster_shape,
            &own.plant_color,
            &own.plant_normal,
            &own.plant_models,
        ];
        textures.extend(views.map(wgpu::TextureView::texture));
        canopies.push(&own.canopy);
    }
    textures.sort_unstable();
    textures.dedup();
    canopies.sort_unstable();
    canopies.dedup();
    let texels = textures.into_iter().map(texel_bytes).sum::<u64>();
    texels + canopies.into_iter().map(wgpu::Buffer::size).sum::<u64>()
}

impl Pictures {
    /// The uniform of a canopy.
    pub fn canopy_buffer(device: &wgpu::Device, canopy: &GpuCanopy) -> wgpu::Buffer {
        let content = bytemuck::bytes_of(canopy);
        filled(device, "sward.canopy", content, wgpu::BufferUsages::UNIFORM)
    }

    /// Those of a field's plants, and what fills them.
    pub fn of_plants(&self, device: &wgpu::Device, plants: &PlantLayers) -> (Self, Vec<Upload>) {
        let (plant_color, mut uploads) = plants.color.texture(device, "sward.plant_color");
        let (plant_normal, more) = plants.normal.texture(device, "sward.plant_normal");
        uploads.extend(more);
        let mut pictures = Self { plant_color, plant_normal, ..self.clone() };
        let rows = plants.models.len() as u32 / MODEL_POINTS;
        if rows > 0 {
            let (texture, view) = models(device, rows);
            let points = bytemuck::cast_slice(&plants.models);
            uploads.push(Upload::new(device, &texture, 0, (points, 16)));
            pictures.plant_models = view;
        }
        (pictures, uploads)
    }

    /// One texel each: for fields that need none.
    pub fn none(device: &wgpu::Device) -> Self {
        let texture = blank(device);
        Self {
            cluster_color: texture.clone(),
            cluster_shape: texture.clone(),
            plant_color: texture.clone(),
            plant_normal: texture,
            plant_models: models(device, 1).1,
            sampler: device.create_sampler(&wgpu::SamplerDescriptor {
                label: Some("sward.pictures"),
                mag_filter: wgpu::FilterMode::Linear,
                min_filter: wgpu::FilterMode::Linear,
                mipmap_filter: wgpu::MipmapFilterMode::Linear,
                ..Default::default()
            }),
            canopy: Self::canopy_buffer(device, &GpuCanopy::empty()),
        }
    }
}
