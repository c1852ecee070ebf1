//! Culling: patches here, one thread each; the tests of single blades run in `update`.

pub(crate) mod blocks;
#[cfg(test)]
pub(crate) mod twin;

use crate::gpu::bindings::compute;
use crate::gpu::layout::BAND;
use crate::gpu::lists::ViewLists;
use crate::gpu::page::Page;
use crate::gpu::shaders::Shader;
use crate::renderer::Layouts;

/// The patch culling stage.
#[derive(Debug)]
pub(crate) struct Cull {
    pipeline: wgpu::ComputePipeline,
}

impl Cull {
    pub(crate) fn new(device: &wgpu::Device, layouts: &Layouts) -> Self {
        let groups = [&layouts.frame, &layouts.field, &layouts.cull];
        let module = Shader::Cull.module(device);
        Self { pipeline: compute(device, &module, "cull", &groups, &[]) }
    }

    /// One thread a patch of the blocks that the view may see. Groups 0 and 1 are set.
    pub(crate) fn encode(&self, pass: &mut wgpu::ComputePass, page: &Page, lists: &ViewLists) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(2, &lists.cull, &[]);
        let threads = lists.seen.count * page.patches_a_block();
        pass.dispatch_workgroups(threads.div_ceil(BAND), 1, 1);
    }
}
