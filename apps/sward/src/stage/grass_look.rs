//! The look of the grass on an object, which its ground shows where the grass itself ends.

use super::StageOptions;
use glam::Vec3;
use sward::{Canopy, Field, Technique, Wind};
use sward_scene::Scene;
use wgpu::util::DeviceExt;

/// What a ground's shader knows of its grass.
#[derive(Debug, Clone, Copy)]
pub(super) struct GrassLook {
    canopy: Canopy,
    /// Mean of `FieldDesc::upright`: 0 where grass stands along the surface's normal, 1 straight up.
    upright: f32,
    /// How far the wind moves the mean tip, in heights.
    sway: Vec3,
}

/// Plants of a field that the wind is measured at.
const MEASURED: usize = 256;

impl GrassLook {
    /// Of a thing that carries none, or whose grass never ends.
    pub fn none() -> Self {
        Self { canopy: Canopy::none(), upright: 0.0, sway: Vec3::ZERO }
    }

    /// Of each object, from the fields on it, in the wind as it is now.
    pub fn of_objects(
        scene: &Scene,
        fields: &[Field],
        options: &StageOptions,
        wind: &Wind,
    ) -> Vec<Self> {
        let culling = options.culling;
        let ends = options.technique == Technique::Continuum
            && !options.reference
            && options.level.is_none()
            && options.debug.is_none()
            && culling.distance
            && !culling.paper;
        let of = |object: usize| {
            let own: Vec<_> =
                scene.fields.iter().zip(fields).filter(|(f, _)| f.object == object).collect();
            if !ends || own.is_empty() {
                return Self::none();
            }
            let canopies: Vec<Canopy> = own.iter().map(|(_, field)| field.canopy()).collect();
            let upright = own.iter().map(|(f, _)| f.desc.upright).sum::<f32>() / own.len() as f32;
            let canopy = Canopy::together(&canopies);
            let roots = own.iter().flat_map(|(_, field)| {
                let blades = field.blades();
                blades.iter().step_by(blades.len().div_ceil(MEASURED).max(1)).map(|b| b.root)
            });
            let sways: Vec<Vec3> =
                roots.map(|root| canopy.sway(wind.strength_at(root, 0.0))).collect();
            let sway = sways.iter().sum::<Vec3>() / sways.len().max(1) as f32;
            Self { canopy, upright, sway }
        };
        (0..scene.objects.len()).map(of).collect()
    }

    /// Metres nearer than which the ground shows none of it.
    pub fn shows_from_m(&self, focal_px: f32) -> f32 {
        self.canopy.stands_in_from_m(focal_px)
    }

    /// Its uniforms: the canopy, and how the grass stands.
    pub fn buffers(&self, device: &wgpu::Device) -> [wgpu::Buffer; 2] {
        let buffer = |contents: &[u8]| {
            device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some("sward.stage.grass_look"),
                contents,
                usage: wgpu::BufferUsages::UNIFORM,
            })
        };
        let stance = [self.upright, self.sway.x, self.sway.y, self.sway.z];
        [buffer(self.canopy.uniform()), buffer(bytemuck::cast_slice(&stance))]
    }
}
