//! Culling: patches here, one thread each; the tests of single blades run in `update`.

pub(crate) mod blocks;
#[cfg(test)]
pub(crate) mod twin;

use crate::gpu::bindings::compute;
use crate::gpu::layout::BAND;
use crate::gpu::lists::ViewLists;
use crate::gpu::page::Page;
use crate::gpu::shaders::Shader;
use crate::gpu::variants::Variants;
use crate::gpu::view::Known;
use crate::renderer::Layouts;

/// The patch culling stage.
#[derive(Debug)]
pub(crate) struct Cull {
    module: wgpu::ShaderModule,
    made: Variants<Known>,
}

impl Cull {
    pub(crate) fn new(device: &wgpu::Device) -> Self {
        Self { module: Shader::Cull.module(device), made: Variants::default() }
    }

    /// One thread a patch of the blocks that the view may see. Groups 0 and 1 are set.
    pub(crate) fn encode(
        &self,
        (device, layouts): (&wgpu::Device, &Layouts),
        pass: &mut wgpu::ComputePass,
        (page, lists): (&Page, &ViewLists),
    ) {
        let groups = [&layouts.frame, &layouts.field, &layouts.cull];
        let constants = lists.known.constants();
        let make = || compute(device, &self.module, "cull", &groups, &constants);
        pass.set_pipeline(&self.made.get(lists.known, make));
        pass.set_bind_group(2, &lists.cull, &[]);
        let threads = lists.seen.count * page.patches_a_block();
        pass.dispatch_workgroups(threads.div_ceil(BAND), 1, 1);
    }
}
