//! Light: functions that `draw` calls, and the mean light of the patches that a view sees.

#[cfg(test)]
pub(crate) mod shade_twin;

use crate::gpu::bindings::compute;
use crate::gpu::layout::BAND;
use crate::gpu::lists::ViewLists;
use crate::gpu::page::Page;
use crate::gpu::shaders::Shader;
use crate::renderer::Layouts;

/// WGSL of the pattern that [`crate::Shade`] moves over the field, for hosts whose ground is to lie in the
/// same shade: `shade_pattern(place, to_sun, pattern, offset)`, and the noise that it calls.
pub const SHADE_WGSL: &str =
    concat!(include_str!("../../shared/noise.wgsl"), include_str!("shade.wgsl"));

/// The stage of the patches' mean light.
#[derive(Debug)]
pub(crate) struct PatchLight {
    pipeline: wgpu::ComputePipeline,
}

impl PatchLight {
    pub(crate) fn new(device: &wgpu::Device, layouts: &Layouts) -> Self {
        let groups = [&layouts.frame, &layouts.field, &layouts.patch_light];
        let module = Shader::PatchLight.module(device);
        Self { pipeline: compute(device, &module, "patch_lights", &groups, &[]) }
    }

    /// One thread a patch of the blocks that the view may see. Groups 0 and 1 are set.
    pub(crate) fn encode(&self, pass: &mut wgpu::ComputePass, page: &Page, lists: &ViewLists) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(2, &lists.patch_light, &[]);
        let threads = lists.seen.count * page.patches_a_block();
        pass.dispatch_workgroups(threads.div_ceil(BAND), 1, 1);
    }
}
