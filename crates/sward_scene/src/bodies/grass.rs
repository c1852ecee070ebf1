//! How grass slows what moves through it.

use crate::Scene;
use crate::objects::ground::Ground;
use glam::{Vec3, Vec3Swizzles};

/// Loss of speed deep in grass, whatever the speed, metres a second each second: what makes a ball
/// stop, and stay on a slope.
const ROLLING: f32 = 1.0;
/// Loss of speed deep in grass as a share of it, 1/s.
const VISCOUS: f32 = 0.6;

/// Where there is grass, and how high.
#[derive(Debug, Default)]
pub(super) struct Grass {
    /// The object of each field, its ground, and the mean height of the blades, metres.
    fields: Vec<(usize, Ground, f32)>,
}

impl Grass {
    pub(super) fn new(scene: &Scene) -> Self {
        let mut grass = Self::default();
        for field in &scene.fields {
            let kinds = &field.desc.species;
            let shares: f32 = kinds.iter().map(|kind| kind.share).sum();
            let sum: f32 = kinds.iter().map(|kind| kind.share * kind.height_m.at(0.5)).sum();
            let height = sum / shares.max(f32::MIN_POSITIVE);
            match grass.fields.iter_mut().find(|(object, ..)| *object == field.object) {
                Some((_, _, known)) => *known = known.max(height),
                None => {
                    let ground = Ground::new(field.surface.mesh());
                    grass.fields.push((field.object, ground, height));
                }
            }
        }
        grass
    }

    /// Share of a body that is in grass, 0 to 1, by its middle and the radius round it.
    pub(super) fn share(&self, middle: Vec3, reach: f32) -> f32 {
        let in_field = |(_, ground, height): &(usize, Ground, f32)| {
            let floor = ground.height(middle.xz())?;
            Some(((floor + height - (middle.y - reach)) / height).clamp(0.0, 1.0))
        };
        self.fields.iter().filter_map(in_field).fold(0.0, f32::max)
    }

    /// What is left of a speed after `dt_s` in grass, as a share of it.
    pub(super) fn kept(speed: f32, drag: f32, dt_s: f32) -> f32 {
        let lost = drag * (ROLLING + VISCOUS * speed) * dt_s;
        if speed > 0.0 { ((speed - lost) / speed).max(0.0) } else { 1.0 }
    }
}
