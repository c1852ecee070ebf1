//! Blade update: physics, the blade tests and the level in one pass over the patches at work, so
//! that a blade is read once.

use crate::gpu::bindings::compute;
use crate::gpu::page::{Page, ViewLists};
use crate::gpu::shaders::Shader;
use crate::renderer::Layouts;

/// What a pass does with the blades.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Work {
    /// Physics only.
    Simulate,
    /// Tests only, of blades that are up to date.
    Test,
    /// Both.
    Both,
}

impl Work {
    const ALL: [Self; 3] = [Self::Simulate, Self::Test, Self::Both];

    fn constants(self) -> [(&'static str, f64); 2] {
        let on = |x: bool| f64::from(u8::from(x));
        [("SIMULATE", on(self != Self::Test)), ("TEST", on(self != Self::Simulate))]
    }
}

/// The update stage: a pipeline for each kind of work and of depth texture.
#[derive(Debug)]
pub(crate) struct Update {
    single: [wgpu::ComputePipeline; 3],
    multisampled: [wgpu::ComputePipeline; 3],
}

fn pipelines(
    device: &wgpu::Device,
    layouts: &Layouts,
    shader: Shader,
    depth: &wgpu::BindGroupLayout,
) -> [wgpu::ComputePipeline; 3] {
    let module = shader.module(device);
    let groups = [&layouts.frame, &layouts.field, &layouts.update, depth];
    Work::ALL.map(|work| compute(device, &module, "update", &groups, &work.constants()))
}

impl Update {
    pub(crate) fn new(device: &wgpu::Device, layouts: &Layouts) -> Self {
        let multisampled = Shader::UpdateMultisampled;
        Self {
            single: pipelines(device, layouts, Shader::Update, &layouts.depth),
            multisampled: pipelines(device, layouts, multisampled, &layouts.depth_multisampled),
        }
    }

    /// One workgroup a band of the patches at work. Groups 0, 1 and 3 are set.
    pub(crate) fn encode(
        &self,
        pass: &mut wgpu::ComputePass,
        page: &Page,
        lists: &ViewLists,
        work: Work,
        multisampled: bool,
    ) {
        let set = if multisampled { &self.multisampled } else { &self.single };
        pass.set_pipeline(&set[work as usize]);
        pass.set_bind_group(2, &lists.update, &[]);
        pass.dispatch_workgroups_indirect(&page.work_size, 0);
    }
}
