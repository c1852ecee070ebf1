//! Bind groups without ceremony: a list of kinds, a list of resources, numbered in order.

use wgpu::{BindingType, BufferBindingType, ShaderStages};

/// What a binding holds.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// Uniform buffer.
    Uniform,
    /// Read-only storage buffer.
    Read,
    /// Storage buffer that is written.
    Write,
    /// Texture that is read texel by texel.
    Texels,
    /// Depth texture.
    Depth {
        /// Whether it has several samples a pixel.
        multisampled: bool,
    },
    /// Colour pictures in layers, filtered.
    Pictures,
    /// Whole numbers in a texture, read texel by texel.
    Words,
    /// Filtering sampler.
    Sampler,
}

impl Kind {
    fn binding_type(self) -> BindingType {
        let buffer =
            |ty| BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
        match self {
            Self::Uniform => buffer(BufferBindingType::Uniform),
            Self::Read => buffer(BufferBindingType::Storage { read_only: true }),
            Self::Write => buffer(BufferBindingType::Storage { read_only: false }),
            Self::Texels => BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: false },
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            },
            Self::Depth { multisampled } => BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Depth,
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled,
            },
            Self::Pictures => BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: true },
                view_dimension: wgpu::TextureViewDimension::D2Array,
                multisampled: false,
            },
            Self::Words => BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Uint,
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            },
            Self::Sampler => BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
        }
    }
}

/// A layout of consecutive bindings.
pub fn layout(
    device: &wgpu::Device,
    label: &str,
    visibility: ShaderStages,
    kinds: &[Kind],
) -> wgpu::BindGroupLayout {
    let entries: Vec<_> = (0..)
        .zip(kinds)
        .map(|(binding, kind)| wgpu::BindGroupLayoutEntry {
            binding,
            visibility,
            ty: kind.binding_type(),
            count: None,
        })
        .collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some(label),
        entries: &entries,
    })
}

/// A group of consecutive bindings.
pub fn group(
    device: &wgpu::Device,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    resources: &[wgpu::BindingResource],
) -> wgpu::BindGroup {
    let entries: Vec<_> = (0..)
        .zip(resources)
        .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource: resource.clone() })
        .collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some(label),
        layout,
        entries: &entries,
    })
}

/// A group of whole buffers.
pub fn buffers(
    device: &wgpu::Device,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    list: &[&wgpu::Buffer],
) -> wgpu::BindGroup {
    let resources: Vec<_> = list.iter().map(|b| b.as_entire_binding()).collect();
    group(device, label, layout, &resources)
}

/// A compute pipeline of one entry point.
pub fn compute(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    entry: &str,
    layouts: &[&wgpu::BindGroupLayout],
    constants: &[(&str, f64)],
) -> wgpu::ComputePipeline {
    let label = format!("sward.{entry}");
    let groups: Vec<_> = layouts.iter().map(|l| Some(*l)).collect();
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(&label),
        bind_group_layouts: &groups,
        immediate_size: 0,
    });
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(&label),
        layout: Some(&layout),
        module,
        entry_point: Some(entry),
        compilation_options: wgpu::PipelineCompilationOptions { constants, ..Default::default() },
        cache: None,
    })
}
