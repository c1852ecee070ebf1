//! The renderer: the host's whole interface. The frame function reads as the stage list.

use crate::frame::wind::Wind;
use crate::{Error, Field};
use glam::{Mat4, Vec3};

/// Formats of the host's targets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Targets {
    /// Colour target that blades are drawn to, in linear light.
    pub color: wgpu::TextureFormat,
    /// Depth target; reversed depth is not supported yet: near is 0, far is 1.
    pub depth: wgpu::TextureFormat,
    /// Samples a pixel of both.
    pub samples: u32,
}

/// A sphere that pushes blades aside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// Centre, metres.
    pub center: Vec3,
    /// Radius, metres, above 0.
    pub radius: f32,
}

/// Which physical model moves the blades.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PhysicsModel {
    /// Exact step, length by projection, scale-free species.
    #[default]
    Sward,
    /// Equations 1 to 16 of J as printed, with the errata.
    Paper,
}

/// Gravity (J equations 4 to 6): a direction, a centre, and the blend between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gravity {
    /// Unit direction of the uniform part.
    pub direction: Vec3,
    /// Its strength; 1 is what a species' droop means.
    pub strength: f32,
    /// Centre that the other part pulls to.
    pub center: Vec3,
    /// Strength of that part.
    pub center_strength: f32,
    /// Blend: 0 is the direction alone, 1 the centre alone.
    pub blend: f32,
}

impl Default for Gravity {
    fn default() -> Self {
        Self {
            direction: Vec3::NEG_Y,
            strength: 1.0,
            center: Vec3::ZERO,
            center_strength: 1.0,
            blend: 0.0,
        }
    }
}

/// Sun and sky for the built-in shading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// Unit direction from the ground to the sun.
    pub to_sun: Vec3,
    /// Sun's irradiance, linear RGB.
    pub sun: Vec3,
    /// Sky light from above.
    pub sky: Vec3,
    /// Light from the ground, below.
    pub ground: Vec3,
}

impl Default for Light {
    fn default() -> Self {
        Self {
            to_sun: Vec3::new(0.45, 0.55, -0.7).normalize(),
            sun: Vec3::new(3.1, 2.8, 2.3),
            sky: Vec3::new(0.55, 0.75, 1.05),
            ground: Vec3::new(0.16, 0.17, 0.10),
        }
    }
}

/// What happens in one step of the simulation.
#[derive(Debug, Clone)]
pub struct Frame<'a> {
    /// Seconds since the last step; clamped to 0..=10.
    pub dt_s: f32,
    /// The wind, already advanced by the host.
    pub wind: &'a Wind,
    /// Spheres that push blades.
    pub spheres: &'a [Sphere],
    /// Gravity.
    pub gravity: Gravity,
    /// Light for drawing.
    pub light: Light,
    /// Physical model.
    pub physics: PhysicsModel,
}

/// Which tests cull blades, and how.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Culling {
    /// Frustum test on patches and blades.
    pub frustum: bool,
    /// Thinning by projected size (or J equation 20).
    pub distance: bool,
    /// Blades seen edge-on.
    pub orientation: bool,
    /// Blades hidden by the opaque scene.
    pub occlusion: bool,
    /// The paper's own tests (J equations 17 to 20) instead of ours.
    pub paper: bool,
    /// Farthest distance that blades are drawn at, metres.
    pub max_distance_m: f32,
}

impl Default for Culling {
    fn default() -> Self {
        Self {
            frustum: true,
            distance: true,
            orientation: true,
            occlusion: true,
            paper: false,
            max_distance_m: f32::INFINITY,
        }
    }
}

/// A camera or a shadow cascade that blades are culled for and drawn to.
#[derive(Debug, Clone, Copy)]
pub struct View<'a> {
    /// World to view: right-handed, looking along -z.
    pub view_from_world: Mat4,
    /// View to clip, z in 0..w.
    pub clip_from_view: Mat4,
    /// Size of the target, pixels.
    pub size: [u32; 2],
    /// Depth of the opaque scene as seen from this view, for the occlusion test.
    pub opaque_depth: Option<&'a wgpu::TextureView>,
    /// Which tests.
    pub culling: Culling,
    /// Detail: 1 is the default; higher keeps more segments and thins later; infinity keeps all.
    pub detail: f32,
    /// Keep blades at least a pixel wide (J equation 24); off for supersampled references.
    pub width_correction: bool,
}

/// Counted work of one frame, read back a frame or more late.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Blades of the field.
    pub blades: u64,
    /// Patches of the field.
    pub patches: u64,
    /// Patches that passed the coarse tests.
    pub patches_visible: u64,
    /// Blades in those patches.
    pub blades_visible: u64,
    /// Blades drawn.
    pub blades_drawn: u64,
    /// Failed the orientation test (a blade that fails two tests counts in both).
    pub culled_orientation: u64,
    /// Failed the frustum test.
    pub culled_frustum: u64,
    /// Failed the distance test.
    pub culled_distance: u64,
    /// Failed the occlusion test.
    pub culled_occlusion: u64,
    /// Survivors that did not fit the list.
    pub dropped: u64,
    /// Sphere tests made by the blades.
    pub spheres_tested: u64,
    /// Spheres beyond a patch's list.
    pub spheres_dropped: u64,
    /// Vertices drawn.
    pub vertices: u64,
}

/// Draws grown fields into a host's passes.
#[derive(Debug)]
pub struct Renderer {}

impl Renderer {
    /// Makes the pipelines.
    ///
    /// # Errors
    /// [`Error::Limit`] where the device lacks what they need.
    pub fn new(_device: &wgpu::Device, _targets: Targets) -> Result<Self, Error> {
        Ok(Self {})
    }
    /// Uploads a field; it is simulated and drawn from then on.
    ///
    /// # Errors
    /// [`Error::Limit`] where it does not fit the device.
    pub fn add_field(
        &mut self,
        _device: &wgpu::Device,
        _queue: &wgpu::Queue,
        _field: &Field,
    ) -> Result<(), Error> {
        Ok(())
    }
    /// Advances time: wind, colliders, and the blades that colliders touch.
    pub fn simulate(
        &mut self,
        _device: &wgpu::Device,
        _queue: &wgpu::Queue,
        _encoder: &mut wgpu::CommandEncoder,
        _frame: &Frame,
    ) {
    }
    /// Brings the blades that the views see up to date, tests them and makes the draw lists.
    pub fn cull(
        &mut self,
        _device: &wgpu::Device,
        _queue: &wgpu::Queue,
        _encoder: &mut wgpu::CommandEncoder,
        _views: &[View],
    ) {
    }
    /// Draws the blades of a view into the host's pass.
    pub fn draw(&self, _pass: &mut wgpu::RenderPass, _view: usize) {}
    /// The newest statistics that have come back; never waits.
    pub fn statistics(&mut self, _device: &wgpu::Device) -> Option<Statistics> {
        None
    }
    /// Bytes of all GPU allocations, and those that grow with the blades.
    pub fn gpu_bytes(&self) -> u64 {
        0
    }
}
