//! The pictures of a field's clusters and plants, and the light that clusters stand for: what its
//! draw group holds beside its buffers.

use super::buffers::uniform;

/// Bytes of the clusters' surfels.
pub const SURFELS_BYTES: u64 = 1024;

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
    /// Trilinear.
    pub sampler: wgpu::Sampler,
    /// Representatives of the clusters' surface.
    pub surfels: wgpu::Buffer,
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

impl Pictures {
    /// One texel each: for fields that need none.
    pub fn none(device: &wgpu::Device) -> Self {
        let texture = blank(device);
        Self {
            cluster_color: texture.clone(),
            cluster_shape: texture.clone(),
            plant_color: texture.clone(),
            plant_normal: texture,
            sampler: device.create_sampler(&wgpu::SamplerDescriptor {
                label: Some("sward.pictures"),
                mag_filter: wgpu::FilterMode::Linear,
                min_filter: wgpu::FilterMode::Linear,
                mipmap_filter: wgpu::MipmapFilterMode::Linear,
                ..Default::default()
            }),
            surfels: uniform(device, "sward.surfels", SURFELS_BYTES),
        }
    }
}
