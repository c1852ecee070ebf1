//! Roots and species become blades.

use super::Blade;
use super::noise;
use super::random::{Draws, Purpose, Stream};
use super::scatter::Root;
use super::tufts::RIM_LEAN;
use crate::gpu::quantize::tangent_frame;
use crate::{Billboard, FieldDesc, Form, Species};
use glam::Vec3;
use rayon::prelude::*;
use std::f32::consts::TAU;

/// Width of the meadow's patches of taller and shorter grass, in blade heights.
const MEADOW_PATCH: f32 = 12.0;

/// How far the blades of a tuft turn from facing straight outward, radians either way.
const TUFT_TURN: f32 = 1.3;

/// Grows one blade on each root. Every value lies in its species' range.
pub(crate) fn blades(roots: &[Root], desc: &FieldDesc) -> Vec<Blade> {
    let gardener = Gardener::new(desc);
    roots.par_iter().with_min_len(1024).map(|root| gardener.blade(root)).collect()
}

struct Gardener<'a> {
    species: &'a [Species],
    /// Sum of the shares up to and with each species, over the sum of all.
    shares: Vec<f64>,
    upright: f32,
    single: Stream,
    tuft_blade: Stream,
    tuft: Stream,
    meadow: u64,
}

impl<'a> Gardener<'a> {
    fn new(desc: &'a FieldDesc) -> Self {
        let total: f64 = desc.species.iter().map(|s| f64::from(s.share)).sum();
        let mut sum = 0.0;
        let shares = desc.species.iter().map(|s| {
            sum += f64::from(s.share) / total;
            sum
        });
        Self {
            species: &desc.species,
            shares: shares.collect(),
            upright: desc.upright,
            single: Stream::new(desc.seed, Purpose::SingleShape),
            tuft_blade: Stream::new(desc.seed, Purpose::BladeShape),
            tuft: Stream::new(desc.seed, Purpose::TuftShape),
            meadow: Stream::new(desc.seed, Purpose::Meadow).at(0).bits(),
        }
    }

    fn blade(&self, root: &Root) -> Blade {
        let blades = if root.tuft.is_some() { self.tuft_blade } else { self.single };
        let mut draws = blades.at(u64::from(root.key));
        let mut tuft_draws = root.tuft.map(|tuft| self.tuft.at(u64::from(tuft)));
        // A tuft is one plant: of one kind.
        let kind = self.pick(tuft_draws.as_mut().unwrap_or(&mut draws));
        let species = &self.species[kind];
        let up = self.up(root);
        let facing = facing(up, root.lean, draws.unit());
        let own = draws.unit();
        if let Form::Billboard(billboard) = &species.form {
            return plant(root, up, (kind, species, billboard), own, &mut draws);
        }
        let tall = match &mut tuft_draws {
            Some(tuft) => {
                // Tufts differ in size, and are lower towards their rim.
                let rim = root.lean.length_squared() / (RIM_LEAN * RIM_LEAN);
                (0.5 * own + 0.5 * tuft.unit()) * (1.0 - 0.3 * rim.min(1.0))
            }
            None => self.meadow(root.position, species, own),
        };
        Blade {
            root: root.position,
            up,
            facing,
            height: species.height_m.at(tall),
            width: species.width_m.at(draws.unit()),
            response: species.response.at(draws.unit()),
            species: kind as u8,
        }
    }

    fn pick(&self, draws: &mut Draws) -> usize {
        let at = draws.unit_f64();
        self.shares.partition_point(|&s| s <= at).min(self.species.len() - 1)
    }

    /// Single blades follow broad waves of height, as a meadow does; flat chance looks like a mat.
    fn meadow(&self, position: Vec3, species: &Species, own: f32) -> f32 {
        let wave = noise::value(self.meadow, position / (MEADOW_PATCH * species.height_m.max));
        0.65 * own + 0.35 * wave
    }

    fn up(&self, root: &Root) -> Vec3 {
        let up = root.normal.lerp(Vec3::Y, self.upright) + root.lean;
        // Halfway between straight down and straight up there is no direction: keep the normal.
        if up.length_squared() > 1e-6 { up.normalize() } else { root.normal }
    }
}

/// A plant of quads: turned by Wang and Yao's equation 2, as large as by 3; its width goes with its height,
/// stretched a little.
fn plant(
    root: &Root,
    up: Vec3,
    (kind, species, billboard): (usize, &Species, &Billboard),
    class: f32,
    draws: &mut Draws,
) -> Blade {
    let tall = billboard.sizes.place(class, draws.unit());
    let wide = (tall + 0.3 * (draws.unit() - 0.5)).clamp(0.0, 1.0);
    let response = species.response.at(draws.unit());
    let turn = billboard.turn_deg.at(draws.unit()).to_radians().rem_euclid(TAU);
    Blade {
        root: root.position,
        up,
        facing: if turn < TAU { turn } else { 0.0 },
        height: species.height_m.at(tall),
        width: species.width_m.at(wide),
        response,
        species: kind as u8,
    }
}

/// Single blades face anywhere, those of a tuft about outward; `chance` is uniform in 0..1.
fn facing(up: Vec3, lean: Vec3, chance: f32) -> f32 {
    if lean == Vec3::ZERO {
        return chance * TAU;
    }
    let (first, second) = tangent_frame(up);
    let outward = lean.dot(second).atan2(lean.dot(first));
    let facing = (outward + (2.0 * chance - 1.0) * TUFT_TURN).rem_euclid(TAU);
    // The remainder of a tiny negative angle rounds up to the divisor.
    if facing < TAU { facing } else { 0.0 }
}
