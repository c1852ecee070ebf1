//! What the host says each frame, on the GPU: group 0.

use super::clock::Clock;
use super::layouts::Layouts;
use crate::frame::collide::expand::{Expanded, expand};
use crate::frame::collide::upload::{self, ChunkBuffer, ChunkCounts};
use crate::frame::wind::GpuWindSource;
use crate::frame::wind::atlas::{self, WindAtlas};
use crate::frame::wind::sway::sway;
use crate::gpu::layout::{GpuFrame, MAX_WIND_SOURCES, TICKS_PER_SECOND};
use crate::gpu::{bindings, buffers};
use crate::{Error, Frame, Gravity, Light, PhysicsModel};
use bytemuck::Zeroable;
use glam::Vec3;

/// Crush lost a second without contact: a crushed blade stands again after about 7 s.
const CRUSH_DECAY: f32 = 0.25;

/// The frame's uniform, with the wind sources, and colliders.
#[derive(Debug)]
pub(crate) struct Inputs {
    frame: wgpu::Buffer,
    wind_atlas: WindAtlas,
    chunks: ChunkBuffer,
    group: wgpu::BindGroup,
    draw_group: wgpu::BindGroup,
}

fn compute_group(
    device: &wgpu::Device,
    layouts: &Layouts,
    frame: &wgpu::Buffer,
    primitives: &wgpu::Buffer,
    wind_maps: &wgpu::TextureView,
) -> wgpu::BindGroup {
    let [frame, primitives] = [frame, primitives].map(|b| b.as_entire_binding());
    let maps = wgpu::BindingResource::TextureView(wind_maps);
    bindings::group(device, "sward.frame", &layouts.frame, &[frame, primitives, maps])
}

fn check_gravity(gravity: &Gravity) -> Result<(), Error> {
    let finite = gravity.direction.is_finite()
        && gravity.center.is_finite()
        && gravity.strength.is_finite()
        && gravity.center_strength.is_finite();
    if finite && (0.0..=1.0).contains(&gravity.blend) {
        return Ok(());
    }
    Err(Error::setting("gravity", "must be finite, and its blend within 0 to 1"))
}

fn check_light(light: &Light) -> Result<(), Error> {
    let colors = [light.to_sun, light.sun, light.sky, light.ground, light.haze];
    let haze = light.haze_per_m;
    if colors.iter().all(|c| c.is_finite()) && haze.is_finite() && haze >= 0.0 {
        return light.shade.check();
    }
    Err(Error::setting("light", "must be finite, and haze_per_m not below 0"))
}

impl Inputs {
    pub(crate) fn new(device: &wgpu::Device, layouts: &Layouts) -> Self {
        let frame = buffers::uniform(device, "sward.frame", size_of::<GpuFrame>() as u64);
        let chunks = ChunkBuffer::new(device);
        let wind_atlas = WindAtlas::new(device);
        let maps = wind_atlas.view();
        let group = compute_group(device, layouts, &frame, chunks.buffer(), maps);
        let draw_group =
            bindings::buffers(device, "sward.draw_frame", &layouts.draw_frame, &[&frame]);
        Self { frame, wind_atlas, chunks, group, draw_group }
    }

    /// Group 0 of the compute stages.
    pub(crate) fn group(&self) -> &wgpu::BindGroup {
        &self.group
    }

    /// The frame's uniform.
    pub(crate) fn frame(&self) -> &wgpu::Buffer {
        &self.frame
    }

    /// Group 0 of drawing.
    pub(crate) fn draw_group(&self) -> &wgpu::BindGroup {
        &self.draw_group
    }

    /// Some patches are new: all are listed anew in the next step.
    pub(crate) fn forget_lists(&mut self) {
        self.chunks.forget_lists();
    }

    /// The lists of the patches are of another time.
    pub(crate) fn make_lists_anew(&mut self) {
        self.chunks.make_lists_anew();
    }

    /// Writes a step's inputs, which [`check`] let pass; says what colliders there are.
    pub(crate) fn write(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        layouts: &Layouts,
        frame: &Frame,
        Lists { wind, expanded }: &Lists,
        clock: &Clock,
    ) -> ChunkCounts {
        let (counts, is_other) = self.chunks.write(device, encoder, expanded);
        let new_maps = self.wind_atlas.write(device, encoder, &frame.wind.sources);
        if is_other || new_maps {
            let (primitives, maps) = (self.chunks.buffer(), self.wind_atlas.view());
            self.group = compute_group(device, layouts, &self.frame, primitives, maps);
        }
        let uniform = gpu_frame(frame, clock, wind, counts);
        buffers::write(device, encoder, &self.frame, bytemuck::bytes_of(&uniform));
        counts
    }
}

/// What a step brings in lists.
pub(crate) struct Lists {
    wind: Vec<GpuWindSource>,
    expanded: Expanded,
}

/// Checks a step's inputs, before anything is changed.
pub(crate) fn check(device: &wgpu::Device, frame: &Frame) -> Result<Lists, Error> {
    check_gravity(&frame.gravity)?;
    check_light(&frame.light)?;
    let wind = frame.wind.gpu_sources();
    at_most("wind", "sward's 64 wind sources", wind.len(), MAX_WIND_SOURCES)?;
    atlas::check(&device.limits(), &frame.wind.sources)?;
    let expanded = expand(frame.colliders, frame.physics);
    upload::check(&device.limits(), &expanded)?;
    Ok(Lists { wind, expanded })
}

fn at_most(what: &str, limit: &'static str, asked: usize, available: usize) -> Result<(), Error> {
    if asked <= available {
        return Ok(());
    }
    Err(Error::Limit {
        what: what.into(),
        limit,
        needed: asked as u64,
        available: available as u64,
        remedy: "pass fewer".into(),
    })
}

fn gpu_frame(
    frame: &Frame,
    clock: &Clock,
    wind: &[GpuWindSource],
    chunks: ChunkCounts,
) -> GpuFrame {
    let with = |v: Vec3, w: f32| v.extend(w).to_array();
    let (gravity, light) = (&frame.gravity, &frame.light);
    let (shade, [shade_x, shade_y]) = light.shade.pattern();
    let mut wind_sources = [GpuWindSource::zeroed(); MAX_WIND_SOURCES];
    wind_sources[..wind.len()].copy_from_slice(wind);
    GpuFrame {
        wind_sources,
        gravity_direction: with(gravity.direction.normalize_or_zero(), gravity.strength),
        gravity_center: with(gravity.center, gravity.center_strength),
        to_sun: with(light.to_sun.normalize_or(Vec3::Y), 0.0),
        sun: with(light.sun, 0.0),
        sky: with(light.sky, 0.0),
        ground: with(light.ground, 0.0),
        haze: with(light.haze, light.haze_per_m),
        sway: sway(wind, f64::from(clock.ticks()) / TICKS_PER_SECOND),
        shade,
        dt_s: clock.dt_s(),
        gravity_blend: gravity.blend,
        crush_decay: CRUSH_DECAY,
        physics_model: match frame.physics {
            PhysicsModel::Sward => 0,
            PhysicsModel::Paper => 1,
        },
        wind_count: wind.len() as u32,
        chunk_count: chunks.all,
        step: clock.step(),
        ticks: clock.ticks(),
        resting_chunks: chunks.resting,
        keep_resting: chunks.keep_resting.into(),
        shade_x,
        shade_y,
    }
}
