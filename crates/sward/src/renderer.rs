//! The renderer: the host's whole interface. `cull` reads as the list of stages.

use crate::frame::collide::Collide;
use crate::frame::compact::Compact;
use crate::frame::cull::Cull;
use crate::frame::debug::Debug;
use crate::frame::draw::Draw;
use crate::frame::draw::pipelines::{DRAWING_FLAGS, Variant};
use crate::frame::light::PatchLight;
use crate::frame::sweep::patches::SweepStage;
use crate::frame::update::{Look, Motion, Update, Work};
use crate::gpu::buffers;
use crate::gpu::limits;
use crate::gpu::page::Page;
use crate::gpu::quantize::species_table;
use crate::gpu::statistics::ReadBack;
use crate::gpu::uploads::Upload;
use crate::gpu::view::{Known, check_view, gpu_view};
use crate::plants::layers::PlantLayers;
use crate::{Error, Field, Frame, PhysicsModel, Statistics, View};

mod baked;
mod clock;
mod counting;
mod debugging;
mod inputs;
mod layouts;
mod saved;
mod sweeping;
mod targets;
#[cfg(test)]
mod testing;

use baked::Unbaked;
use clock::Clock;
use inputs::Inputs;
pub(crate) use layouts::Layouts;
pub use targets::Targets;

/// One stage of a frame, for hosts that time or interleave them; [`Renderer::cull`] runs
/// `PatchCull`, `Update`, `Light` and `Compact`, fused where that saves memory traffic.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// Patches that the view sees.
    PatchCull,
    /// Physics alone of the blades of those patches.
    Physics,
    /// Blade tests and level alone.
    Visibility,
    /// Physics, tests and level in one pass: the default.
    Update,
    /// The mean light of the patches, for [`Technique::Continuum`](crate::Technique::Continuum); others have none.
    Light,
    /// Prefix sums and the draw list.
    Compact,
}

const FUSED: [Stage; 4] = [Stage::PatchCull, Stage::Update, Stage::Light, Stage::Compact];

/// Draws grown fields into a host's passes.
#[derive(Debug)]
pub struct Renderer {
    layouts: Layouts,
    collide: Collide,
    cull: Cull,
    update: Update,
    patch_light: PatchLight,
    compact: Compact,
    draw: Draw,
    /// Made when a view first sweeps.
    sweep: Option<SweepStage>,
    /// Made when a view first asks for a debug view.
    debug: Option<Debug>,
    inputs: Inputs,
    clock: Clock,
    model: PhysicsModel,
    /// Whether shade moves over the fields.
    shaded: bool,
    pages: Vec<Page>,
    unbaked: Vec<Unbaked>,
    totals: Statistics,
    read_back: ReadBack,
    /// Content of pictures that the next frame sends.
    uploads: Vec<Upload>,
}

impl Renderer {
    /// Makes the pipelines.
    ///
    /// # Errors
    /// [`Error::Limit`] where the device lacks what they need, [`Error::Setting`] for targets that
    /// blades cannot be drawn to.
    pub fn new(device: &wgpu::Device, targets: Targets) -> Result<Self, Error> {
        targets.check()?;
        limits::check_device(&device.limits())?;
        let layouts = Layouts::new(device);
        Ok(Self {
            collide: Collide::new(device, &layouts),
            cull: Cull::new(device),
            update: Update::new(device),
            patch_light: PatchLight::new(device),
            compact: Compact::new(device, &layouts),
            draw: Draw::new(device, &layouts, targets),
            sweep: None,
            debug: None,
            inputs: Inputs::new(device, &layouts),
            clock: Clock::default(),
            model: PhysicsModel::default(),
            shaded: false,
            pages: Vec::new(),
            unbaked: Vec::new(),
            totals: Statistics::default(),
            read_back: ReadBack::default(),
            uploads: Vec::new(),
            layouts,
        })
    }

    /// Most blades that a field may have on a device: 16 pages of up to 4 million, fewer where
    /// `max_storage_buffer_binding_size` holds fewer.
    pub fn max_blades(limits: &wgpu::Limits, patch_size: u32) -> u64 {
        limits::max_blades(limits, patch_size)
    }

    /// Checks that a field of so many blades fits a device, such as those of
    /// [`FieldDesc::planned_blades`](crate::FieldDesc::planned_blades) before it grows.
    ///
    /// # Errors
    /// [`Error::Limit`] says how many fit and why.
    pub fn check_blades(limits: &wgpu::Limits, patch_size: u32, blades: u64) -> Result<(), Error> {
        limits::check_blades(limits, patch_size, blades)
    }

    /// Uploads a field; it is simulated and drawn from then on.
    ///
    /// # Errors
    /// [`Error::Limit`] where it does not fit the device.
    pub fn add_field(&mut self, device: &wgpu::Device, field: &Field) -> Result<(), Error> {
        let available = device.limits();
        let count = field.blades().len() as u64;
        limits::check_blades(&available, field.patch_size(), count)?;
        let patches_a_page = (limits::page_blades(&available, field.patch_size())
            / u64::from(field.patch_size())) as usize;
        let patch_count = field.patches().len();
        let first_page = self.pages.len();
        let looks: Vec<_> = field.species().iter().filter_map(|s| s.form.look()).collect();
        let plants = PlantLayers::new(looks.iter());
        plants.check(&available)?;
        let species = species_table(field, &plants);
        let (pictures, uploads) = self.layouts.no_pictures.of_plants(device, &plants);
        self.uploads.extend(uploads);
        for first in (0..patch_count).step_by(patches_a_page.max(1)) {
            let range = first..(first + patches_a_page).min(patch_count);
            let ticks = self.clock.ticks();
            let page = Page::new(
                device,
                &self.layouts,
                (field, &pictures),
                &species,
                range,
                self.model,
                ticks,
            );
            self.pages.push(page);
        }
        if count > 0 {
            let pages = first_page..self.pages.len();
            self.unbaked.push(Unbaked::new(field, pictures, pages));
        }
        self.inputs.forget_lists();
        self.totals.blades += count;
        self.totals.patches += patch_count as u64;
        Ok(())
    }

    /// Advances time. Blades that moving colliders touch move now, the others when a view next sees
    /// them.
    ///
    /// # Errors
    /// [`Error::Setting`] for values that are not finite, [`Error::Limit`] for more wind sources
    /// or colliders than fit.
    pub fn simulate(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        frame: &Frame,
    ) -> Result<(), Error> {
        let lists = inputs::check(device, frame)?;
        self.send_pictures(encoder);
        self.shaded = frame.light.shade.depth > 0.0;
        if frame.physics != self.model {
            self.model = frame.physics;
            for page in &self.pages {
                page.reset(device, encoder, self.model, self.clock.ticks());
            }
        }
        self.clock.advance(frame.dt_s);
        let chunks = self.inputs.write(device, encoder, &self.layouts, frame, &lists, &self.clock);
        self.update.set_motion(Motion {
            paper: self.model == PhysicsModel::Paper,
            colliders: chunks.all > 0,
            wind_kinds: frame.wind.kinds(),
        });
        if !chunks.listed {
            self.wake_touched(device, encoder);
        }
        Ok(())
    }

    fn send_pictures(&mut self, encoder: &mut wgpu::CommandEncoder) {
        self.uploads.drain(..).for_each(|upload| upload.record(encoder));
    }

    /// Lists the colliders near each patch and moves the blades of the patches that moving ones touch.
    fn wake_touched(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder) {
        for index in 0..self.pages.len() {
            self.ensure_view(device, index, 0, None);
            let page = &self.pages[index];
            page.reset_all_work(encoder);
            let mut pass = begin(encoder, "sward.collide");
            pass.set_bind_group(0, self.inputs.group(), &[]);
            pass.set_bind_group(1, &page.group, &[]);
            pass.set_bind_group(3, &self.layouts.no_depth, &[]);
            self.collide.encode(&mut pass, page);
            let (gpu, of) = ((device, &self.layouts), (page, &page.views[0]));
            self.update.encode(gpu, &mut pass, of, Work::Simulate, Look::default());
        }
    }

    fn ensure_view(&mut self, device: &wgpu::Device, page: usize, view: usize, cap: Option<u32>) {
        let page = &mut self.pages[page];
        let all = page.field.blade_count;
        let kept = page.views.get(view).map_or(all, |v| v.capacity);
        // A view keeps its size until it is asked for another
        let capacity = cap.map_or(kept, |c| c.min(all));
        page.ensure_view(device, &self.layouts, view, capacity, &self.draw.blade_indices);
    }

    /// Brings the blades that the views see up to date, tests them and makes the draw lists.
    ///
    /// # Errors
    /// [`Error::Setting`] for a view that is no camera.
    pub fn cull(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        views: &[View],
    ) -> Result<(), Error> {
        for (index, view) in views.iter().enumerate() {
            self.prepare_view(device, encoder, index, view)?;
            for stage in FUSED {
                self.encode_stage(device, encoder, stage, index, view);
            }
            if index == 0 {
                self.record_statistics(device, encoder);
            }
            self.finish_view(device, encoder, index, view);
        }
        Ok(())
    }

    /// Writes a view's settings; the first thing to do for a view whose stages are encoded singly.
    ///
    /// # Errors
    /// [`Error::Setting`] for a view that is no camera.
    pub fn prepare_view(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        index: usize,
        view: &View,
    ) -> Result<(), Error> {
        check_view(view)?;
        self.send_pictures(encoder);
        self.bake(device, encoder, view.technique);
        for page in 0..self.pages.len() {
            // Views are numbered without gaps
            for earlier in self.pages[page].views.len()..index {
                self.ensure_view(device, page, earlier, Some(0));
            }
            let all = self.pages[page].field.blade_count;
            self.ensure_view(device, page, index, Some(view.max_blades.unwrap_or(all)));
            self.ensure_pipelines(device, page, index, view);
            let mut uniform = gpu_view(view, self.pages[page].views[index].capacity);
            self.prepare_sweep(device, encoder, (page, index), view, &mut uniform);
            let all = view.debug.is_some_and(|debug| debug.shows_all());
            self.pages[page].see_blocks(device, encoder, index, (&uniform, all));
            let lists = &mut self.pages[page].views[index];
            lists.known = Known { flags: uniform.flags, ..Known::of(view) };
            buffers::write(device, encoder, &lists.view, bytemuck::bytes_of(&uniform));
        }
        Ok(())
    }

    fn ensure_pipelines(&mut self, device: &wgpu::Device, page: usize, index: usize, view: &View) {
        let page = &mut self.pages[page];
        let buckets = page.buckets(view.technique);
        let known = Some(Known::of(view).only(DRAWING_FLAGS));
        let paper = self.model == PhysicsModel::Paper;
        let variant = Variant { shaded: self.shaded, paper, known, ..page.variant };
        (page.views[index].buckets, page.views[index].variant) = (buckets, variant);
        self.draw.ensure(device, variant, buckets);
    }

    /// Encodes one stage of one view over all pages. Stages of a view go in the order of
    /// [`Stage`], and those of one view before those of the next.
    pub fn encode_stage(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        stage: Stage,
        index: usize,
        view: &View,
    ) {
        let (depth, multisampled) = self.layouts.depth_group(device, view.opaque_depth);
        let look = Look::of(view, multisampled);
        for page in &self.pages {
            let Some(lists) = page.views.get(index) else { continue };
            if stage == Stage::PatchCull {
                page.reset_view_work(encoder);
            }
            if lists.seen.count == 0 {
                lists.count_nothing(encoder);
                continue;
            }
            let mut pass = begin(encoder, "sward.frame");
            pass.set_bind_group(0, self.inputs.group(), &[]);
            pass.set_bind_group(1, &page.group, &[]);
            pass.set_bind_group(3, depth.as_ref().unwrap_or(&self.layouts.no_depth), &[]);
            if stage == Stage::PatchCull {
                self.encode_sweep(&mut pass, page, lists, view);
            }
            let gpu = (device, &self.layouts);
            let mut update = |work| self.update.encode(gpu, &mut pass, (page, lists), work, look);
            match stage {
                Stage::PatchCull => self.cull.encode(gpu, &mut pass, (page, lists)),
                Stage::Physics => update(Work::Simulate),
                Stage::Visibility => update(Work::Test),
                Stage::Update => update(Work::Both),
                Stage::Light if look.has_far_patches() => {
                    self.patch_light.encode(gpu, &mut pass, (page, lists))
                }
                Stage::Light => {}
                Stage::Compact => {
                    self.compact.encode(&mut pass, page, lists, look.has_far_patches())
                }
            }
        }
    }

    /// Draws the blades of a view into the host's pass, whose targets are those of
    /// [`Renderer::new`].
    pub fn draw(&self, pass: &mut wgpu::RenderPass, view: usize) {
        pass.set_bind_group(0, self.inputs.draw_group(), &[]);
        let seen = |page: &Page| page.views.get(view).is_some_and(|lists| lists.seen.count > 0);
        for page in self.pages.iter().enumerate().filter(|(_, page)| seen(page)) {
            if !self.debug.as_ref().is_some_and(|debug| debug.encode(pass, page, view)) {
                self.draw.encode(pass, page.1, view);
            }
        }
    }
}

fn begin<'e>(encoder: &'e mut wgpu::CommandEncoder, label: &str) -> wgpu::ComputePass<'e> {
    encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
        label: Some(label),
        timestamp_writes: None,
    })
}
