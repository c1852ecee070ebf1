//! Random fields and cameras from a seed.

use super::decoded::Decoded;
use crate::frame::collide::primitive::Primitive;
use crate::frame::physics::twin::{State, Surroundings};
use crate::gpu::state_twin::pack_state;
use crate::grow::Blade;
use crate::shared::curve_twin::project_tip;
use crate::shared::noise_twin::hash01;
use crate::{
    BladeOrder, Culling, Field, Gravity, Gusts, Metric, PhysicsModel, Range, Shape, Species,
    Technique, View, Waves, Wind, WindSource,
};
use glam::camera::rh::{
    proj::directx::{orthographic, perspective},
    view::look_at_mat4,
};
use glam::{DVec3, Mat4, Vec2, Vec3};
use std::f32::consts::TAU;

pub(super) const SIZE: [u32; 2] = [128, 96];

/// Numbers that depend on a seed alone.
pub(super) struct Draws {
    seed: u32,
    next: u32,
}

impl Draws {
    pub fn new(seed: u32) -> Self {
        Self { seed, next: 0 }
    }

    pub fn between(&mut self, min: f32, max: f32) -> f32 {
        self.next += 1;
        min + (max - min) * hash01(self.seed, self.next)
    }

    pub fn vector(&mut self, min: f32, max: f32) -> Vec3 {
        let x = self.between(min, max);
        let y = self.between(min, max);
        Vec3::new(x, y, self.between(min, max))
    }

    pub fn unit(&mut self) -> Vec3 {
        loop {
            let v = self.vector(-1.0, 1.0);
            if (0.01..1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }
}

/// A pointed species with a ridge and an arch, and a flat one.
pub(super) fn species() -> Vec<Species> {
    let pointed = Species { arch: 0.4, ..Species::default() };
    let flat = Species {
        shape: Shape::Quad,
        height_m: Range::new(0.1, 0.9),
        width_m: Range::new(0.004, 0.03),
        ridge: 0.0,
        arch: 0.0,
        ..Species::default()
    };
    vec![pointed, flat]
}

/// A blade of these species: values within the species' ranges, at any place and tilt.
pub(super) fn random_blade(draws: &mut Draws, species: &[Species], half_extent: f32) -> Blade {
    let kind = (draws.between(0.0, 0.999) * species.len() as f32) as usize;
    let own = &species[kind];
    let place = draws.vector(-half_extent, half_extent);
    Blade {
        root: Vec3::new(place.x, 0.05 * place.y, place.z),
        up: (Vec3::Y + draws.unit() * draws.between(0.0, 0.8)).normalize(),
        facing: draws.between(0.0, TAU),
        height: own.height_m.at(draws.between(0.0, 1.0)),
        width: own.width_m.at(draws.between(0.0, 1.0)),
        response: own.response.at(draws.between(0.0, 1.0)),
        species: kind as u8,
    }
}

pub(super) fn random_blades(seed: u32, count: u32, half_extent: f32) -> Vec<Blade> {
    let (mut draws, species) = (Draws::new(seed), species());
    (0..count).map(|_| random_blade(&mut draws, &species, half_extent)).collect()
}

pub(super) fn field_of(species: Vec<Species>, blades: &[Blade], patch_size: u32) -> Field {
    Field::from_blades(species, blades, patch_size, Metric::Euclidean, BladeOrder::Progressive)
        .expect("a valid field")
}

pub(super) fn random_field(seed: u32, count: u32, half_extent: f32, patch_size: u32) -> Field {
    field_of(species(), &random_blades(seed, count, half_extent), patch_size)
}

/// Any pose and any crush for each blade.
pub(super) fn random_states(seed: u32, blades: &[Decoded], model: PhysicsModel) -> Vec<[u32; 2]> {
    let mut draws = Draws::new(seed);
    let one = |decoded: &Decoded| {
        let b = &decoded.physics;
        let lean = draws.unit().as_dvec3() * f64::from(draws.between(0.0, 1.5));
        let tip = project_tip(b.up + lean, b.up, b.facing, b.arch);
        pack_state(b, State { tip, crush: draws.between(0.0, 2.0).into() }, model)
    };
    blades.iter().map(one).collect()
}

/// A camera with a vertical field of view of 60 degrees.
pub(super) fn look(eye: Vec3, target: Vec3) -> View<'static> {
    let aspect = SIZE[0] as f32 / SIZE[1] as f32;
    let clip = perspective(60_f32.to_radians(), aspect, 0.1, 200.0);
    // Single blades, whose stages most tests are of
    let view = View::new(look_at_mat4(eye, target, Vec3::Y), clip, SIZE);
    View { technique: Technique::Blades, ..view }
}

/// A level camera at the height of an upright one-metre blade's middle, 5 m in front of it.
pub(super) fn facing_origin() -> View<'static> {
    look(Vec3::new(0.0, 0.75, 5.0), Vec3::new(0.0, 0.75, 0.0))
}

/// A camera about the field, half of them orthographic.
pub(super) fn random_view(seed: u32, half_extent: f32) -> View<'static> {
    let mut draws = Draws::new(seed.wrapping_mul(77).wrapping_add(5));
    let mut eye = draws.vector(-half_extent, half_extent);
    eye.y = draws.between(0.3, 4.0);
    let mut target = draws.vector(-half_extent, half_extent);
    target.y = 0.3;
    let mut view = look(eye, target);
    if seed % 2 == 1 {
        let half = Vec2::new(draws.between(0.5, 4.0), draws.between(0.5, 4.0));
        view.clip_from_view = orthographic(-half.x, half.x, -half.y, half.y, 0.1, 30.0);
    }
    view.size = [320, 240];
    view
}

/// Every test off.
pub(super) fn no_culling() -> Culling {
    Culling {
        frustum: false,
        distance: false,
        orientation: false,
        occlusion: false,
        ..Culling::default()
    }
}

/// A view that keeps all.
pub(super) fn see_all() -> View<'static> {
    View { culling: no_culling(), ..facing_origin() }
}

/// A view straight up into the sky, away from every blade.
pub(super) fn see_none() -> View<'static> {
    let up = Mat4::from_rotation_x(-1.5) * Mat4::from_translation(Vec3::new(0.0, -500.0, 0.0));
    View { view_from_world: up, ..facing_origin() }
}

pub(super) fn breeze() -> Wind {
    let waves = WindSource::Waves(Waves::default());
    let gusts = WindSource::Gusts(Gusts { strength: 0.6, ..Gusts::default() });
    Wind::new(vec![waves, gusts]).expect("valid wind")
}

pub(super) fn surroundings<'a>(
    wind: &'a Wind,
    primitives: &'a [Primitive],
    dt_s: f32,
) -> Surroundings<'a> {
    let gravity = Gravity::default();
    Surroundings { wind, gravity, primitives, crush_decay: 0.25, dt_s: dt_s.into() }
}

pub(super) fn is_sound(state: &State) -> bool {
    state.tip.is_finite() && state.crush.is_finite() && state.tip != DVec3::ZERO
}
