//! Blade update: physics, the blade tests and the level in one pass over the patches at work, so
//! that a blade is read once.

use crate::gpu::bindings::compute;
use crate::gpu::lists::ViewLists;
use crate::gpu::page::Page;
use crate::gpu::shaders::Shader;
use crate::gpu::variants::Variants;
use crate::gpu::view::Known;
use crate::renderer::Layouts;
use crate::{Technique, View};

/// What a pass does with the blades.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Work {
    /// Physics only.
    Simulate,
    /// Tests only, of blades that are up to date.
    Test,
    /// Both.
    Both,
}

/// What acts on blades in a step.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub(crate) struct Motion {
    /// J's model.
    pub(crate) paper: bool,
    pub(crate) colliders: bool,
    /// Bits of [`Wind::kinds`](crate::Wind::kinds).
    pub(crate) wind_kinds: u32,
}

/// How a view tests blades.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub(crate) struct Look {
    pub(crate) known: Known,
    /// Its depth is.
    pub(crate) multisampled: bool,
}

impl Look {
    /// Of a view by that technique.
    pub(crate) fn of(view: &View, multisampled: bool) -> Self {
        Self { known: Known::of(view), multisampled }
    }

    /// Whether some patches may be far: clusters are all that is left of them.
    pub(crate) fn has_far_patches(self) -> bool {
        self.known.technique == Technique::Continuum
    }
}

/// What a pipeline is made for. Some devices run what a branch leaves out, all of them keep registers
/// for it: what is known beforehand is not in the pipeline at all.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Variant {
    work: Work,
    /// Anchors of far patches, in place of bands.
    far: bool,
    /// Strips or billboards among the plants.
    other_forms: bool,
    motion: Motion,
    look: Look,
}

impl Variant {
    /// Without what the work has no use for.
    fn new(work: Work, far: bool, other_forms: bool, motion: Motion, look: Look) -> Self {
        // The group of the depth is bound all the same
        let blind = Look { multisampled: look.multisampled, ..Look::default() };
        let still = Motion { paper: motion.paper, ..Motion::default() };
        Self {
            work,
            far,
            other_forms: other_forms && work != Work::Simulate,
            motion: if work == Work::Test { still } else { motion },
            look: if work == Work::Simulate { blind } else { look },
        }
    }

    fn constants(self) -> [(&'static str, f64); 9] {
        let on = |x: bool| f64::from(u8::from(x));
        let [technique, flags] = self.look.known.constants();
        [
            ("SIMULATE", on(self.work != Work::Test)),
            ("TEST", on(self.work != Work::Simulate)),
            ("ANCHORS", on(self.far)),
            ("OTHER_FORMS", on(self.other_forms)),
            ("MODEL", on(self.motion.paper)),
            ("COLLIDERS", on(self.motion.colliders)),
            ("WIND_KINDS", self.motion.wind_kinds.into()),
            technique,
            flags,
        ]
    }
}

/// The update stage. Its pipelines are made when they are first needed.
#[derive(Debug)]
pub(crate) struct Update {
    single: wgpu::ShaderModule,
    multisampled: wgpu::ShaderModule,
    made: Variants<Variant>,
    motion: Motion,
}

impl Update {
    pub(crate) fn new(device: &wgpu::Device) -> Self {
        Self {
            single: Shader::Update.module(device),
            multisampled: Shader::UpdateMultisampled.module(device),
            made: Variants::default(),
            motion: Motion::default(),
        }
    }

    /// What acts in the present step.
    pub(crate) fn set_motion(&mut self, motion: Motion) {
        self.motion = motion;
    }

    fn pipeline(
        &self,
        device: &wgpu::Device,
        layouts: &Layouts,
        variant: Variant,
    ) -> wgpu::ComputePipeline {
        let make = || {
            let (module, depth) = if variant.look.multisampled {
                (&self.multisampled, &layouts.depth_multisampled)
            } else {
                (&self.single, &layouts.depth)
            };
            let groups = [&layouts.frame, &layouts.field, &layouts.update, depth];
            compute(device, module, "update", &groups, &variant.constants())
        };
        self.made.get(variant, make)
    }

    /// Runs the blades at work. Groups 0, 1 and 3 are set.
    pub(crate) fn encode(
        &self,
        (device, layouts): (&wgpu::Device, &Layouts),
        pass: &mut wgpu::ComputePass,
        (page, lists): (&Page, &ViewLists),
        work: Work,
        look: Look,
    ) {
        pass.set_bind_group(2, &lists.update, &[]);
        for far in [false, true] {
            if far && !look.has_far_patches() {
                continue;
            }
            let variant = Variant::new(work, far, page.other_forms, self.motion, look);
            pass.set_pipeline(&self.pipeline(device, layouts, variant));
            page.dispatch_work(pass, far);
        }
    }
}
