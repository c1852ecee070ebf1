//! The look of the grass on an object, which its ground shows where the grass itself ends.

use super::StageOptions;
use sward::{Canopy, Field, Technique};
use sward_scene::Scene;
use wgpu::util::DeviceExt;

/// What a ground's shader knows of its grass.
#[derive(Debug, Clone, Copy)]
pub(super) struct GrassLook {
    canopy: Canopy,
    /// Mean of `FieldDesc::upright`: 0 where grass stands along the surface's normal, 1 straight up.
    upright: f32,
}

impl GrassLook {
    /// Of a thing that carries none, or whose grass never ends.
    pub fn none() -> Self {
        Self { canopy: Canopy::none(), upright: 0.0 }
    }

    /// Of each object, from the fields on it.
    pub fn of_objects(scene: &Scene, fields: &[Field], options: &StageOptions) -> Vec<Self> {
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
            Self { canopy: Canopy::together(&canopies), upright }
        };
        (0..scene.objects.len()).map(of).collect()
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
        let stance = [self.upright, 0.0, 0.0, 0.0];
        [buffer(self.canopy.uniform()), buffer(bytemuck::cast_slice(&stance))]
    }
}
