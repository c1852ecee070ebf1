//! Drawing: one indirect draw a bucket, vertices pulled from the blade buffers.

pub(crate) mod topology;

use crate::Targets;
use crate::gpu::buffers::filled;
use crate::gpu::layout::BUCKETS;
use crate::gpu::page::Page;
use crate::gpu::shaders::Shader;
use crate::renderer::Layouts;
use topology::Topology;

/// The drawing stage.
#[derive(Debug)]
pub(crate) struct Draw {
    pipelines: Vec<wgpu::RenderPipeline>,
    indices: Vec<wgpu::Buffer>,
    /// Indices of one blade, by bucket: the scan makes the draws' arguments with them.
    pub(crate) blade_indices: wgpu::Buffer,
}

fn pipeline(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    layout: &wgpu::PipelineLayout,
    targets: Targets,
    bucket: usize,
) -> wgpu::RenderPipeline {
    let topology = Topology::of(bucket);
    let constants = [
        ("BUCKET", bucket as f64),
        ("SEGMENTS", f64::from(topology.segments)),
        ("RING", f64::from(topology.ring)),
        ("FLAT_TIP", f64::from(u8::from(topology.flat_tip))),
        ("VERTICES", f64::from(topology.vertices())),
    ];
    // The first level is near, the others far
    let (vertex, fragment) =
        if bucket.is_multiple_of(4) { ("vs_near", "fs_near") } else { ("vs_far", "fs_far") };
    let options = wgpu::PipelineCompilationOptions { constants: &constants, ..Default::default() };
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("sward.draw"),
        layout: Some(layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(vertex),
            compilation_options: options.clone(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: targets.depth,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Less),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState { count: targets.samples, ..Default::default() },
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(fragment),
            compilation_options: options,
            targets: &[Some(targets.color.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

impl Draw {
    pub(crate) fn new(device: &wgpu::Device, layouts: &Layouts, targets: Targets) -> Self {
        let module = Shader::Draw.module(device);
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("sward.draw"),
            bind_group_layouts: &[
                Some(&layouts.draw_frame),
                Some(&layouts.draw_field),
                Some(&layouts.draw),
            ],
            immediate_size: 0,
        });
        let per_blade: [u32; BUCKETS] =
            std::array::from_fn(|b| Topology::of(b).indices().len() as u32);
        let index_buffer = |bucket| {
            let list = Topology::of(bucket).instance_indices();
            let content = bytemuck::cast_slice(&list);
            filled(device, "sward.blade_indices", content, wgpu::BufferUsages::INDEX)
        };
        Self {
            pipelines: (0..BUCKETS)
                .map(|bucket| pipeline(device, &module, &layout, targets, bucket))
                .collect(),
            indices: (0..BUCKETS).map(index_buffer).collect(),
            blade_indices: filled(
                device,
                "sward.indices_per_blade",
                bytemuck::cast_slice(&per_blade),
                wgpu::BufferUsages::UNIFORM,
            ),
        }
    }

    /// Draws a page's blades of one view. Group 0 is set.
    pub(crate) fn encode(&self, pass: &mut wgpu::RenderPass, page: &Page, view: usize) {
        let Some(lists) = page.views.get(view) else { return };
        pass.set_bind_group(1, &page.draw_group, &[]);
        pass.set_bind_group(2, &lists.draw, &[]);
        for bucket in 0..BUCKETS {
            if !page.topologies[bucket / 4] {
                continue;
            }
            pass.set_pipeline(&self.pipelines[bucket]);
            pass.set_index_buffer(self.indices[bucket].slice(..), wgpu::IndexFormat::Uint16);
            pass.draw_indexed_indirect(&lists.indirect, bucket as u64 * 20);
        }
    }
}
