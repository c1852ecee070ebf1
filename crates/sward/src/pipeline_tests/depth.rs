//! Depth textures with known content.

use super::rig::Gpu;
use super::scenes::SIZE;
use super::targets::{cleared, texture};
use crate::View;
use glam::Vec3;

/// Depth value of a point straight ahead at this distance.
pub(super) fn depth_of(view: &View, distance_m: f32) -> f32 {
    view.clip_from_view.project_point3(Vec3::new(0.0, 0.0, -distance_m)).z
}

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Writes the depth that `fs` gives over the whole target.
fn depth_pipeline(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    samples: u32,
) -> wgpu::RenderPipeline {
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("test.depth"),
        layout: None,
        vertex: wgpu::VertexState {
            module,
            entry_point: Some("vs"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: FORMAT,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Always),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some("fs"),
            compilation_options: Default::default(),
            targets: &[],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// A texture whose depth is this WGSL expression of pixel `p` and `sample`.
pub(super) fn depth_texture(
    (device, queue): &Gpu,
    samples: u32,
    expression: &str,
) -> wgpu::TextureView {
    let source = format!(
        "@vertex fn vs(@builtin(vertex_index) i: u32) -> @builtin(position) vec4<f32> {{
            return vec4<f32>(f32(i & 1u) * 4.0 - 1.0, f32(i >> 1u) * 4.0 - 1.0, 0.5, 1.0);
        }}
        @fragment fn fs(@builtin(position) p: vec4<f32>{}) -> @builtin(frag_depth) f32 {{
            return {expression};
        }}",
        if samples > 1 { ", @builtin(sample_index) sample: u32" } else { "" }
    );
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("test.depth"),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    });
    let pipeline = depth_pipeline(device, &module, samples);
    let view = texture(device, SIZE, FORMAT, samples).create_view(&Default::default());
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: &view,
            depth_ops: Some(cleared(0.0)),
            stencil_ops: None,
        }),
        ..Default::default()
    });
    pass.set_pipeline(&pipeline);
    pass.draw(0..3, 0..1);
    drop(pass);
    queue.submit([encoder.finish()]);
    view
}
