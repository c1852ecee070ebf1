//! What the host says each frame, on the GPU: group 0.

use super::clock::Clock;
use super::layouts::Layouts;
use crate::frame::wind::GpuWindSource;
use crate::gpu::layout::{GpuFrame, MAX_WIND_SOURCES};
use crate::gpu::{bindings, buffers};
use crate::{Collider, Error, Frame, Gravity, Light, PhysicsModel};
use glam::Vec3;
use wgpu::BufferUsages;

/// Crush lost a second without contact: a crushed blade stands again after about 7 s.
const CRUSH_DECAY: f32 = 0.25;
const FIRST_SPHERES: usize = 64;

/// The frame's uniform, wind sources and spheres.
#[derive(Debug)]
pub(crate) struct Inputs {
    frame: wgpu::Buffer,
    wind: wgpu::Buffer,
    spheres: wgpu::Buffer,
    group: wgpu::BindGroup,
    draw_group: wgpu::BindGroup,
}

fn sphere_buffer(device: &wgpu::Device, count: usize) -> wgpu::Buffer {
    buffers::storage(device, "sward.spheres", count as u64 * 16, BufferUsages::empty())
}

fn compute_group(
    device: &wgpu::Device,
    layouts: &Layouts,
    frame: &wgpu::Buffer,
    wind: &wgpu::Buffer,
    spheres: &wgpu::Buffer,
) -> wgpu::BindGroup {
    bindings::buffers(device, "sward.frame", &layouts.frame, &[frame, wind, spheres])
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
        return Ok(());
    }
    Err(Error::setting("light", "must be finite, and haze_per_m not below 0"))
}

/// Colliders that can touch anything, as the shaders read them.
fn gpu_spheres(colliders: &[Collider]) -> Vec<[f32; 4]> {
    colliders
        .iter()
        .flat_map(crate::frame::collide::spheres::inside)
        .filter(|s| s.center.is_finite() && s.radius.is_finite() && s.radius > 0.0)
        .map(|s| s.center.extend(s.radius).to_array())
        .collect()
}

impl Inputs {
    pub(crate) fn new(device: &wgpu::Device, layouts: &Layouts) -> Self {
        let frame = buffers::uniform(device, "sward.frame", size_of::<GpuFrame>() as u64);
        let wind_bytes = (MAX_WIND_SOURCES * size_of::<GpuWindSource>()) as u64;
        let wind = buffers::uniform(device, "sward.wind", wind_bytes);
        let spheres = sphere_buffer(device, FIRST_SPHERES);
        let group = compute_group(device, layouts, &frame, &wind, &spheres);
        let draw_group =
            bindings::buffers(device, "sward.draw_frame", &layouts.draw_frame, &[&frame]);
        Self { frame, wind, spheres, group, draw_group }
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

    /// Writes a step's inputs, which [`check`] let pass.
    pub(crate) fn write(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        layouts: &Layouts,
        frame: &Frame,
        Lists { wind, spheres }: &Lists,
        clock: &Clock,
    ) {
        if spheres.len() as u64 * 16 > self.spheres.size() {
            self.spheres =
                sphere_buffer(device, spheres.len().next_power_of_two().min(sphere_room(device)));
            self.group = compute_group(device, layouts, &self.frame, &self.wind, &self.spheres);
        }
        let uniform = gpu_frame(frame, clock, wind.len(), spheres.len());
        buffers::write(device, encoder, &self.frame, bytemuck::bytes_of(&uniform));
        buffers::write(device, encoder, &self.wind, bytemuck::cast_slice(wind));
        buffers::write(device, encoder, &self.spheres, bytemuck::cast_slice(spheres));
    }
}

/// Most spheres that one binding holds.
fn sphere_room(device: &wgpu::Device) -> usize {
    (device.limits().max_storage_buffer_binding_size / 16) as usize
}

/// What a step brings in lists.
pub(crate) struct Lists {
    wind: Vec<GpuWindSource>,
    /// Centre and radius.
    pub(crate) spheres: Vec<[f32; 4]>,
}

/// Checks a step's inputs, before anything is changed.
pub(crate) fn check(device: &wgpu::Device, frame: &Frame) -> Result<Lists, Error> {
    check_gravity(&frame.gravity)?;
    check_light(&frame.light)?;
    let (wind, spheres) = (frame.wind.gpu_sources(), gpu_spheres(frame.colliders));
    at_most("wind", "sward's 64 wind sources", wind.len(), MAX_WIND_SOURCES)?;
    let room = sphere_room(device);
    at_most("spheres", "max_storage_buffer_binding_size / 16", spheres.len(), room)?;
    Ok(Lists { wind, spheres })
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

fn gpu_frame(frame: &Frame, clock: &Clock, wind: usize, spheres: usize) -> GpuFrame {
    let with = |v: Vec3, w: f32| v.extend(w).to_array();
    let (gravity, light) = (&frame.gravity, &frame.light);
    GpuFrame {
        gravity_direction: with(gravity.direction.normalize_or_zero(), gravity.strength),
        gravity_center: with(gravity.center, gravity.center_strength),
        to_sun: with(light.to_sun.normalize_or(Vec3::Y), 0.0),
        sun: with(light.sun, 0.0),
        sky: with(light.sky, 0.0),
        ground: with(light.ground, 0.0),
        haze: with(light.haze, light.haze_per_m),
        dt_s: clock.dt_s(),
        gravity_blend: gravity.blend,
        crush_decay: CRUSH_DECAY,
        physics_model: match frame.physics {
            PhysicsModel::Sward => 0,
            PhysicsModel::Paper => 1,
        },
        wind_count: wind as u32,
        sphere_count: spheres as u32,
        step: clock.step(),
        ticks: clock.ticks(),
    }
}
