//! Blades as the shaders see them: through their quantised form.

use crate::frame::cull::twin::Pose;
use crate::frame::physics::twin::{Blade as PhysicsBlade, State};
use crate::gpu::quantize::{pack_blade, tangent_frame, unpack_blade};
use crate::gpu::state_twin::unpack_state;
use crate::grow::Blade;
use crate::shared::curve_twin::middle_point;
use crate::shared::noise_twin::hash01;
use crate::{Field, PhysicsModel, Species};
use glam::Vec3;

#[derive(Debug, Clone)]
pub(super) struct Decoded {
    pub blade: Blade,
    pub physics: PhysicsBlade,
    pub ridge: f32,
    pub flat_tip: bool,
    pub patch: usize,
    /// Index in its patch, and the patch's count.
    pub local: (u32, u32),
}

pub(super) fn facing_of(blade: &Blade) -> Vec3 {
    let (first, second) = tangent_frame(blade.up);
    first * blade.facing.cos() + second * blade.facing.sin()
}

/// What physics knows of a blade with this index in the field.
pub(super) fn physics_blade(blade: &Blade, species: &Species, id: u32) -> PhysicsBlade {
    PhysicsBlade {
        root: blade.root.as_dvec3(),
        up: blade.up.as_dvec3(),
        facing: facing_of(blade).as_dvec3(),
        height: blade.height.into(),
        response: blade.response.into(),
        droop: species.droop.at(hash01(id, 11)).into(),
        gust: species.gust.into(),
        arch: species.arch.into(),
    }
}

pub(super) fn decode(field: &Field) -> Vec<Decoded> {
    let one = |(index, blade): (usize, &Blade)| {
        let patch = index / field.patch_size() as usize;
        let home = &field.patches()[patch];
        let species = &field.species()[usize::from(blade.species)];
        let blade = unpack_blade(pack_blade(blade, home, species), home, field.species());
        Decoded {
            physics: physics_blade(&blade, species, index as u32),
            ridge: species.ridge,
            flat_tip: crate::gpu::quantize::has_flat_tip(species),
            patch,
            local: (index as u32 - home.first, home.count),
            blade,
        }
    };
    field.blades().iter().enumerate().map(one).collect()
}

pub(super) fn states(blades: &[Decoded], bits: &[[u32; 2]], model: PhysicsModel) -> Vec<State> {
    blades.iter().zip(bits).map(|(b, bits)| unpack_state(&b.physics, *bits, model)).collect()
}

/// The points of a blade's curve.
pub(super) fn pose(blade: &PhysicsBlade, state: &State) -> Pose {
    let knee = middle_point(state.tip, blade.up, blade.arch);
    Pose {
        root: blade.root.as_vec3(),
        knee: (blade.root + knee * blade.height).as_vec3(),
        tip: (blade.root + state.tip * blade.height).as_vec3(),
    }
}
