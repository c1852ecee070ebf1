//! Light: functions that `draw` calls, and the mean light of the patches that a view sees.

#[cfg(test)]
pub(crate) mod shade_twin;

use crate::gpu::bindings::compute;
use crate::gpu::layout::BAND;
use crate::gpu::lists::ViewLists;
use crate::gpu::page::Page;
use crate::gpu::shaders::Shader;
use crate::gpu::variants::Variants;
use crate::gpu::view::{DISTANCE, FRUSTUM, Known, PAPER};
use crate::renderer::Layouts;

/// WGSL of the pattern that [`crate::Shade`] moves over the field, for hosts whose ground is to lie in the
/// same shade: `shade_pattern(place, to_sun, pattern, offset)`, and the noise that it calls.
pub const SHADE_WGSL: &str =
    concat!(include_str!("../../shared/noise.wgsl"), include_str!("shade.wgsl"));

/// The stage of the patches' mean light.
#[derive(Debug)]
pub(crate) struct PatchLight {
    module: wgpu::ShaderModule,
    made: Variants<Known>,
}

impl PatchLight {
    pub(crate) fn new(device: &wgpu::Device) -> Self {
        Self { module: Shader::PatchLight.module(device), made: Variants::default() }
    }

    /// One thread a patch of the blocks that the view may see. Groups 0 and 1 are set.
    pub(crate) fn encode(
        &self,
        (device, layouts): (&wgpu::Device, &Layouts),
        pass: &mut wgpu::ComputePass,
        (page, lists): (&Page, &ViewLists),
    ) {
        let known = lists.known.only(FRUSTUM | DISTANCE | PAPER);
        let groups = [&layouts.frame, &layouts.field, &layouts.patch_light];
        let constants = known.constants();
        let make = || compute(device, &self.module, "patch_lights", &groups, &constants);
        pass.set_pipeline(&self.made.get(known, make));
        pass.set_bind_group(2, &lists.lit.patch_light, &[]);
        let threads = lists.seen.count * page.patches_a_block();
        pass.dispatch_workgroups(threads.div_ceil(BAND), 1, 1);
    }
}
