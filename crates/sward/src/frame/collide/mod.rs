//! Colliders: taken apart into spheres, capsules and boxes, swept, ordered and cut into chunks on the
//! CPU; on the GPU which of them are near each patch, and which patches they wake.

pub(crate) mod chunks;
pub(crate) mod cuboid_twin;
pub(crate) mod expand;
pub mod primitive;
pub mod twin;
pub(crate) mod upload;

use crate::gpu::bindings::compute;
use crate::gpu::layout::BAND;
use crate::gpu::page::Page;
use crate::gpu::shaders::Shader;
use crate::renderer::Layouts;

/// The collider stage.
#[derive(Debug)]
pub(crate) struct Collide {
    pipeline: wgpu::ComputePipeline,
}

impl Collide {
    pub(crate) fn new(device: &wgpu::Device, layouts: &Layouts) -> Self {
        let groups = [&layouts.frame, &layouts.field, &layouts.collide];
        let module = Shader::Collide.module(device);
        Self { pipeline: compute(device, &module, "collide", &groups, &[]) }
    }

    /// One thread a patch. Groups 0 and 1 are set.
    pub(crate) fn encode(&self, pass: &mut wgpu::ComputePass, page: &Page) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(2, &page.collide, &[]);
        pass.dispatch_workgroups(page.field.patch_count.div_ceil(BAND), 1, 1);
    }
}
