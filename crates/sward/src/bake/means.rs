//! Means over a field's blades.

use super::bodies::Bodies;
use crate::Field;
use crate::grow::Blade;
use glam::Vec3;

/// Means of the whole field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Means {
    /// Length, metres.
    pub height: f32,
    /// Length times width, square metres.
    pub area: f32,
    /// Colours at tones 0 and 1, by area.
    pub colors: [Vec3; 2],
    /// The part of the middle colour that no surface gives, what the surface's is multiplied by,
    /// and the surface's mean; by area.
    pub plain: Vec3,
    /// See `plain`.
    pub tint: f32,
    /// See `plain`.
    pub surface: Vec3,
}

/// One blade's part in the means.
fn part(field: &Field, bodies: &Bodies, index: usize) -> (f64, Means) {
    let blade: &Blade = &field.blades()[index];
    let tones = bodies.tones(field, index);
    let surface = field.color(index).map_or(Vec3::ONE, Vec3::from);
    let means = Means {
        height: blade.height,
        area: blade.height * blade.width,
        colors: tones.on(surface),
        plain: (tones.plain[0] + tones.plain[1]) * 0.5,
        tint: (tones.tint[0] + tones.tint[1]) * 0.5,
        surface,
    };
    (f64::from(means.area), means)
}

impl Means {
    /// Metres.
    pub(crate) fn width(&self) -> f32 {
        self.area / self.height.max(1e-6)
    }

    /// Over some blades.
    pub(super) fn over(field: &Field, bodies: &Bodies, blades: &[usize]) -> Self {
        let zero = [0.0_f64; 15];
        let sum = blades.iter().fold(zero, |mut sum, &index| {
            let (area, own) = part(field, bodies, index);
            let [low, high] = own.colors;
            let vectors = [low, high, own.plain, own.surface].map(Vec3::as_dvec3);
            let weighted = vectors.into_iter().flat_map(|v| (v * area).to_array());
            let all = [f64::from(own.height), area, f64::from(own.tint) * area];
            for (total, value) in sum.iter_mut().zip(all.into_iter().chain(weighted)) {
                *total += value;
            }
            sum
        });
        let (count, area) = (blades.len().max(1) as f64, sum[1].max(1e-30));
        let vector =
            |i: usize| Vec3::from_array([0, 1, 2].map(|k| (sum[3 + 3 * i + k] / area) as f32));
        Self {
            height: (sum[0] / count) as f32,
            area: (sum[1] / count) as f32,
            colors: [vector(0), vector(1)],
            plain: vector(2),
            tint: (sum[2] / area) as f32,
            surface: vector(3),
        }
    }
}

/// So many indices below `count`, evenly spread.
pub(crate) fn evenly(count: usize, most: usize) -> impl Iterator<Item = usize> {
    let taken = count.min(most);
    (0..taken).map(move |i| (2 * i + 1) * count / (2 * taken))
}
