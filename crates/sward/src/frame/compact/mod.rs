//! Compaction: counts, prefix sums, places. No atomic append, so the same frame gives the same
//! list and the same picture, bit for bit.

#[cfg(test)]
pub(crate) mod twin;

use crate::gpu::bindings::compute;
use crate::gpu::lists::ViewLists;
use crate::gpu::page::Page;
use crate::gpu::shaders::Shader;
use crate::renderer::Layouts;

/// Bytes of the uniform with the indices that a plant takes in each bucket.
pub(crate) const SCAN_BLADE_INDICES_BYTES: u64 = 64;

/// The scan and the compaction.
#[derive(Debug)]
pub(crate) struct Compact {
    scan_blocks: wgpu::ComputePipeline,
    scan_totals: wgpu::ComputePipeline,
    /// Of bands, and of far patches.
    compact: [wgpu::ComputePipeline; 2],
}

impl Compact {
    pub(crate) fn new(device: &wgpu::Device, layouts: &Layouts) -> Self {
        let scan = [&layouts.frame, &layouts.field, &layouts.scan];
        let module = Shader::Scan.module(device);
        let groups = [&layouts.frame, &layouts.field, &layouts.compact];
        let places = Shader::Compact.module(device);
        let compact_of =
            |anchors: f64| compute(device, &places, "compact", &groups, &[("ANCHORS", anchors)]);
        Self {
            scan_blocks: compute(device, &module, "scan_blocks", &scan, &[]),
            scan_totals: compute(device, &module, "scan_totals", &scan, &[]),
            compact: [0.0, 1.0].map(compact_of),
        }
    }

    /// `far`: whether the view may have far patches. Groups 0 and 1 are set.
    pub(crate) fn encode(
        &self,
        pass: &mut wgpu::ComputePass,
        page: &Page,
        lists: &ViewLists,
        far: bool,
    ) {
        pass.set_bind_group(2, &lists.scan, &[]);
        pass.set_pipeline(&self.scan_blocks);
        pass.dispatch_workgroups(lists.seen.count, 1, 1);
        pass.set_pipeline(&self.scan_totals);
        pass.dispatch_workgroups(1, 1, 1);
        pass.set_bind_group(2, &lists.compact, &[]);
        for (pipeline, far_ones) in self.compact.iter().zip([false, true]) {
            if far || !far_ones {
                pass.set_pipeline(pipeline);
                page.dispatch_work(pass, far_ones);
            }
        }
    }
}
