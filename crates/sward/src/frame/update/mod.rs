//! Blade update: physics, the blade tests and the level in one pass over the patches at work, so
//! that a blade is read once.

use crate::gpu::bindings::compute;
use crate::gpu::page::{Page, ViewLists};
use crate::gpu::shaders::Shader;
use crate::renderer::Layouts;
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

/// What a pass does with the blades.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Work {
    /// Physics only.
    Simulate,
    /// Tests only, of blades that are up to date.
    Test,
    /// Both.
    Both,
}

/// What a pipeline knows beforehand. Some devices run what a branch leaves out: what is known is not in
/// the pipeline at all.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Variant {
    work: Work,
    /// Anchors of far patches, in place of bands.
    far: bool,
    multisampled: bool,
    /// Most winds have no rotor, vortex, fan or map.
    rare_wind: bool,
}

impl Variant {
    fn constants(self) -> [(&'static str, f64); 4] {
        let on = |x: bool| f64::from(u8::from(x));
        [
            ("SIMULATE", on(self.work != Work::Test)),
            ("TEST", on(self.work != Work::Simulate)),
            ("ANCHORS", on(self.far)),
            ("RARE_WIND", on(self.rare_wind)),
        ]
    }
}

/// What the update must know of a view.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Seen {
    /// Whether it may have far patches.
    pub(crate) far: bool,
    /// Whether its depth is multisampled.
    pub(crate) multisampled: bool,
}

/// The update stage. Its pipelines are made when they are first needed.
#[derive(Debug)]
pub(crate) struct Update {
    single: wgpu::ShaderModule,
    multisampled: wgpu::ShaderModule,
    made: Mutex<BTreeMap<Variant, wgpu::ComputePipeline>>,
    rare_wind: bool,
}

impl Update {
    pub(crate) fn new(device: &wgpu::Device) -> Self {
        Self {
            single: Shader::Update.module(device),
            multisampled: Shader::UpdateMultisampled.module(device),
            made: Mutex::default(),
            rare_wind: false,
        }
    }

    /// Says whether some source of the wind has a place or a map.
    pub(crate) fn set_wind(&mut self, rare: bool) {
        self.rare_wind = rare;
    }

    fn pipeline(
        &self,
        device: &wgpu::Device,
        layouts: &Layouts,
        variant: Variant,
    ) -> wgpu::ComputePipeline {
        let make = || {
            let (module, depth) = if variant.multisampled {
                (&self.multisampled, &layouts.depth_multisampled)
            } else {
                (&self.single, &layouts.depth)
            };
            let groups = [&layouts.frame, &layouts.field, &layouts.update, depth];
            compute(device, module, "update", &groups, &variant.constants())
        };
        let mut made = self.made.lock().unwrap_or_else(PoisonError::into_inner);
        made.entry(variant).or_insert_with(make).clone()
    }

    /// Runs the blades at work. Groups 0, 1 and 3 are set.
    pub(crate) fn encode(
        &self,
        (device, layouts): (&wgpu::Device, &Layouts),
        pass: &mut wgpu::ComputePass,
        (page, lists): (&Page, &ViewLists),
        work: Work,
        seen: Seen,
    ) {
        pass.set_bind_group(2, &lists.update, &[]);
        for far in [false, true] {
            if far && !seen.far {
                continue;
            }
            let Seen { multisampled, .. } = seen;
            let rare_wind = self.rare_wind && work != Work::Test;
            let variant = Variant { work, far, multisampled, rare_wind };
            pass.set_pipeline(&self.pipeline(device, layouts, variant));
            page.dispatch_work(pass, far);
        }
    }
}
