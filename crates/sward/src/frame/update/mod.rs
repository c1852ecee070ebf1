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

    fn constants(self, rare_wind: bool) -> [(&'static str, f64); 3] {
        let on = |x: bool| f64::from(u8::from(x));
        [
            ("SIMULATE", on(self != Self::Test)),
            ("TEST", on(self != Self::Simulate)),
            ("RARE_WIND", on(rare_wind)),
        ]
    }
}

/// A pipeline for each kind of work and of depth texture.
#[derive(Debug)]
struct Pipelines {
    single: [wgpu::ComputePipeline; 3],
    multisampled: [wgpu::ComputePipeline; 3],
}

/// The update stage. Most winds have no rotor, vortex, fan or map: they get pipelines that know none, as
/// a device may run what a wind does not need.
#[derive(Debug)]
pub(crate) struct Update {
    plain: Pipelines,
    /// Made when it is first needed.
    rare: Option<Pipelines>,
    rare_wind: bool,
}

impl Pipelines {
    fn new(device: &wgpu::Device, layouts: &Layouts, rare_wind: bool) -> Self {
        let set = |shader: Shader, depth| {
            let module = shader.module(device);
            let groups = [&layouts.frame, &layouts.field, &layouts.update, depth];
            let constants = |work: Work| work.constants(rare_wind);
            Work::ALL.map(|work| compute(device, &module, "update", &groups, &constants(work)))
        };
        Self {
            single: set(Shader::Update, &layouts.depth),
            multisampled: set(Shader::UpdateMultisampled, &layouts.depth_multisampled),
        }
    }
}

impl Update {
    pub(crate) fn new(device: &wgpu::Device, layouts: &Layouts) -> Self {
        let plain = Pipelines::new(device, layouts, false);
        Self { plain, rare: None, rare_wind: false }
    }

    /// Says whether some source of the wind has a place or a map.
    pub(crate) fn set_wind(&mut self, device: &wgpu::Device, layouts: &Layouts, rare: bool) {
        self.rare_wind = rare;
        if rare {
            self.rare.get_or_insert_with(|| Pipelines::new(device, layouts, true));
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
        let pipelines = self.rare.as_ref().filter(|_| self.rare_wind).unwrap_or(&self.plain);
        let set = if multisampled { &pipelines.multisampled } else { &pipelines.single };
        pass.set_pipeline(&set[work as usize]);
        pass.set_bind_group(2, &lists.update, &[]);
        pass.dispatch_workgroups_indirect(&page.work_size, 0);
    }
}
