//! Drawing: one indirect draw a bucket, vertices pulled from the blade buffers.

pub(crate) mod lobes_twin;
pub(crate) mod pipelines;
pub(crate) mod topology;

use crate::Targets;
use crate::gpu::buffers::filled;
use crate::gpu::layout::BUCKETS;
use crate::gpu::page::Page;
use crate::renderer::Layouts;
use pipelines::{Variant, variant_pipelines};
use topology::Topology;

/// The drawing stage.
#[derive(Debug)]
pub(crate) struct Draw {
    pub(crate) targets: Targets,
    layout: wgpu::PipelineLayout,
    /// By variant, the plain one first, then by bucket.
    pipelines: Vec<(Variant, Vec<wgpu::RenderPipeline>)>,
    indices: Vec<wgpu::Buffer>,
    /// Indices of one blade, by bucket: the scan makes the draws' arguments with them.
    pub(crate) blade_indices: wgpu::Buffer,
}

impl Draw {
    pub(crate) fn new(device: &wgpu::Device, layouts: &Layouts, targets: Targets) -> Self {
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
        let mut draw = Self {
            targets,
            layout,
            pipelines: Vec::new(),
            indices: (0..BUCKETS).map(index_buffer).collect(),
            blade_indices: filled(
                device,
                "sward.indices_per_blade",
                bytemuck::cast_slice(&per_blade),
                wgpu::BufferUsages::UNIFORM,
            ),
        };
        draw.ensure(device, Variant::default());
        draw
    }

    /// Makes the pipelines of a variant, unless they are there.
    pub(crate) fn ensure(&mut self, device: &wgpu::Device, variant: Variant) {
        if self.pipelines.iter().all(|(made, _)| *made != variant) {
            let own = variant_pipelines(device, &self.layout, self.targets, variant);
            self.pipelines.push((variant, own));
        }
    }

    /// Draws a page's blades of one view. Group 0 is set.
    pub(crate) fn encode(&self, pass: &mut wgpu::RenderPass, page: &Page, view: usize) {
        let Some(lists) = page.views.get(view) else { return };
        let own = |(made, _): &&(Variant, _)| *made == page.variant;
        let Some((_, pipelines)) = self.pipelines.iter().find(own) else { return };
        pass.set_bind_group(1, &page.draw_group, &[]);
        pass.set_bind_group(2, &lists.draw, &[]);
        for (bucket, pipeline) in pipelines.iter().enumerate() {
            if !page.topologies[bucket / 4] {
                continue;
            }
            pass.set_pipeline(pipeline);
            pass.set_index_buffer(self.indices[bucket].slice(..), wgpu::IndexFormat::Uint16);
            pass.draw_indexed_indirect(&lists.indirect, bucket as u64 * 20);
        }
    }
}
