//! Drawing: one indirect draw a bucket, vertices pulled from the blade buffers.

pub(crate) mod lobes_twin;
pub(crate) mod mesh;
pub(crate) mod pipelines;
#[cfg(test)]
pub(crate) mod quads_twin;
pub(crate) mod topology;

use crate::Targets;
use crate::gpu::buckets::Buckets;
use crate::gpu::buffers::filled;
use crate::gpu::layout::BUCKETS;
use crate::gpu::page::Page;
use crate::renderer::Layouts;
use mesh::Mesh;
use pipelines::{Modules, Variant, bucket_pipeline};

/// Pipelines by bucket, each made when it is first needed.
type ByBucket = [Option<wgpu::RenderPipeline>; BUCKETS];

/// The drawing stage.
#[derive(Debug)]
pub(crate) struct Draw {
    pub(crate) targets: Targets,
    layout: wgpu::PipelineLayout,
    modules: Modules,
    /// By variant.
    pipelines: Vec<(Variant, ByBucket)>,
    indices: Vec<wgpu::Buffer>,
    /// Indices of one plant, by bucket: the scan makes the draws' arguments with them.
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
        let per_plant: [u32; BUCKETS] = std::array::from_fn(|b| Mesh::of(b).indices.len() as u32);
        let index_buffer = |bucket| {
            let list = Mesh::of(bucket).instance_indices();
            let content = bytemuck::cast_slice(&list);
            filled(device, "sward.indices", content, wgpu::BufferUsages::INDEX)
        };
        Self {
            targets,
            layout,
            modules: Modules::default(),
            pipelines: Vec::new(),
            indices: (0..BUCKETS).map(index_buffer).collect(),
            blade_indices: filled(
                device,
                "sward.indices_per_plant",
                bytemuck::cast_slice(&per_plant),
                wgpu::BufferUsages::UNIFORM,
            ),
        }
    }

    /// Makes the pipelines of a variant for these buckets, unless they are there.
    pub(crate) fn ensure(&mut self, device: &wgpu::Device, variant: Variant, buckets: Buckets) {
        let known = self.pipelines.iter().position(|(made, _)| *made == variant);
        let slot = known.unwrap_or_else(|| {
            self.pipelines.push((variant, Default::default()));
            self.pipelines.len() - 1
        });
        let own = &mut self.pipelines[slot].1;
        for bucket in buckets.iter().filter(|bucket| own[*bucket].is_none()).collect::<Vec<_>>() {
            let modules = &mut self.modules;
            let all = (&self.layout, self.targets);
            own[bucket] = bucket_pipeline(device, modules, all, variant, bucket);
        }
    }

    /// Draws a page's plants of one view. Group 0 is set.
    pub(crate) fn encode(&self, pass: &mut wgpu::RenderPass, page: &Page, view: usize) {
        let Some(lists) = page.views.get(view) else { return };
        let own = |(made, _): &&(Variant, _)| *made == lists.variant;
        let Some((_, pipelines)) = self.pipelines.iter().find(own) else { return };
        pass.set_bind_group(1, &page.draw_group, &[]);
        pass.set_bind_group(2, &lists.lit.draw, &[]);
        for bucket in lists.buckets.iter() {
            let Some(pipeline) = &pipelines[bucket] else { continue };
            pass.set_pipeline(pipeline);
            pass.set_index_buffer(self.indices[bucket].slice(..), wgpu::IndexFormat::Uint16);
            pass.draw_indexed_indirect(&lists.indirect, bucket as u64 * 20);
        }
    }
}
