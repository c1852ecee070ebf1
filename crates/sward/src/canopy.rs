//! Grass as a whole: what a field looks like from so far that no blade is told apart.
//!
//! Where the continuum of levels ends, nothing of the grass is drawn, and the host's ground shows its
//! look. For that a host asks a field for its [`Canopy`], gives [`Canopy::uniform`] to its ground's
//! shader, joins [`WGSL`] to that shader, and mixes what `canopy_radiance` gives into the ground's
//! colour by `canopy_on_ground`. The same text lights the last level that is drawn.
//!
//! ```wgsl
//! // What the text needs. `frame` may have more members; of these, `w` is not read
//! struct Frame { to_sun: vec4<f32>, sun: vec4<f32>, sky: vec4<f32>, ground: vec4<f32>, haze: vec4<f32> }
//! @group(0) @binding(0) var<uniform> frame: Frame;
//! @group(1) @binding(0) var<uniform> canopy: GpuCanopy;
//!
//! // In the ground's fragment: up the surface's normal, focal_px the pixels of a metre 1 m away, sway
//! // what `Canopy::sway` gives
//! let gone = canopy_gone(canopy.size.z * focal_px / distance);
//! let share = canopy_on_ground(canopy_coverage(up, to_eye, sway), gone);
//! color = mix(color, canopy_radiance(up, to_eye, sway, 0.0), share);
//! ```
//! `to_sun` is the unit direction to the sun; `sun`, `sky`, `ground` and `haze` are those of
//! [`crate::Light`], `haze.w` its share a metre.

use crate::Field;
use crate::bake::canopy::{canopy, met};
use crate::bake::cover::ROWS;
use crate::bake::stand::{Stands, WINDS};
use crate::changes::CANOPY_END_PX;
use crate::gpu::layout::{GpuCanopy, GpuCanopyRow, GpuLook};
use glam::Vec3;

/// The light on grass as a whole: struct `GpuCanopy`, and the functions
/// `canopy_radiance(up, to_eye, sway, shaded)`, `canopy_coverage(up, to_eye, sway)`,
/// `canopy_gone(height_px)`, `canopy_on_ground(coverage, gone)` and `canopy_tinted(radiance, own)`, with what
/// they call. It declares no binding; see the module's page for what it needs.
pub const WGSL: &str = concat!(
    include_str!("frame/light/light.wgsl"),
    include_str!("frame/light/canopy.wgsl"),
    include_str!("frame/light/canopy_light.wgsl"),
    include_str!("frame/light/end.wgsl")
);

/// Least share of the ground that is taken to show.
const LEAST_OPEN: f32 = 1e-4;

/// A field's look as a whole: colours, coverage and what shows, by elevation of view, at rest and in wind.
/// Found on the CPU, from some 2,000 of the field's blades (about 0.5 s on two cores), fitted to the means
/// of the field; the same for any number of threads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Canopy {
    gpu: GpuCanopy,
    ground_m2: f32,
}

impl Canopy {
    /// No grass: covers nothing.
    pub fn none() -> Self {
        Self { gpu: GpuCanopy::empty(), ground_m2: 0.0 }
    }

    /// Metres from the eye nearer than which ground never stands for the grass, in a view by which a metre
    /// at distance 1 covers `focal_px` pixels; infinite where there is no grass.
    pub fn stands_in_from_m(&self, focal_px: f32) -> f32 {
        let height_m = self.height_m();
        if height_m > 0.0 { height_m * focal_px / CANOPY_END_PX[0] } else { f32::INFINITY }
    }

    /// Mean length of a blade, metres.
    pub fn height_m(&self) -> f32 {
        self.gpu.size[2]
    }

    /// Share of the ground that the grass hides, 0..=1, from an elevation whose sine is `sine`: 1
    /// straight from above, 0 from the horizon.
    pub fn coverage(&self, sine: f32) -> f32 {
        1.0 - (-met(&self.gpu, sine)).exp()
    }

    /// Mean reflectance of what shows from straight above, linear RGB, each blade as dark as its
    /// depth between the others makes it.
    pub fn color(&self) -> [f32; 3] {
        let [r, g, b, _] = self.gpu.rows[ROWS - 1].shown;
        [r, g, b]
    }

    /// What a uniform buffer of type `GpuCanopy` holds.
    pub fn uniform(&self) -> &[u8] {
        bytemuck::bytes_of(&self.gpu)
    }

    /// Of fields that grow among each other on one surface: the lower is hidden by the taller, and one that
    /// stands on a part of the ground only, as far as the others go, counts by that part.
    pub fn together(canopies: &[Self]) -> Self {
        match canopies {
            [] => Self::none(),
            [one] => *one,
            several => {
                let ground_m2 = several.iter().map(|c| c.ground_m2).fold(0.0, f32::max);
                let spread: Vec<Self> = several.iter().map(|c| c.spread_over(ground_m2)).collect();
                Self { gpu: together(&spread), ground_m2 }
            }
        }
    }

    /// How far a steady wind of that strength moves the mean tip, in heights: what `canopy_radiance` and
    /// `canopy_coverage` take as `sway`. Zero is grass at rest.
    pub fn sway(&self, wind: Vec3) -> Vec3 {
        let strength = wind.length().min(WINDS[2]);
        // What it moves levels off, as this does
        let bent = |strength: f32| strength / (strength + 0.5);
        let [_, first, second, third] = shares(WINDS.map(bent), bent(strength));
        let [a, b, c, _] = self.gpu.pose;
        let moved = first * a + second * b + third * c;
        wind.normalize_or_zero() * moved
    }

    /// The same grass on so much ground, on parts of it as densely as it stands.
    fn spread_over(mut self, ground_m2: f32) -> Self {
        let share = (self.ground_m2 / ground_m2.max(1e-6)).clamp(0.0, 1.0);
        for row in &mut self.gpu.rows {
            let whole = |look: &mut GpuLook| {
                look.around[3] = 1.0 - share * (1.0 - look.around[3]);
            };
            whole(&mut row.rest);
            for bent in &mut row.winds {
                whole(&mut bent.mean);
                for part in [&mut bent.first, &mut bent.second, &mut bent.third] {
                    part.around[3] *= share;
                }
            }
        }
        self.ground_m2 = ground_m2;
        self
    }

    fn depth(&self, row: usize) -> f32 {
        -self.gpu.rows[row].rest.around[3].max(LEAST_OPEN).ln()
    }
}

impl Field {
    /// What the field looks like as a whole. Takes about 0.5 s: ask once.
    pub fn canopy(&self) -> Canopy {
        let stands = Stands::of(self);
        Canopy { gpu: canopy(&stands, None), ground_m2: stands.ground_m2 }
    }
}

/// How much each of 0 and three places counts at `x`, for a cubic through all four: the twin of
/// `canopy_shares`.
fn shares([a, b, c]: [f32; 3], x: f32) -> [f32; 4] {
    [
        (x - a) * (x - b) * (x - c) / (-a * b * c),
        x * (x - b) * (x - c) / (a * (a - b) * (a - c)),
        x * (x - a) * (x - c) / (b * (b - a) * (b - c)),
        x * (x - a) * (x - b) / (c * (c - a) * (c - b)),
    ]
}

fn together(canopies: &[Canopy]) -> GpuCanopy {
    let mut sum = GpuCanopy::empty();
    // Lengths and the light at the roots by how much of each field there is, seen from above
    let total: f32 = canopies.iter().map(|c| c.depth(ROWS - 1)).sum::<f32>().max(1e-12);
    let part = |c: &Canopy| c.depth(ROWS - 1) / total;
    let mean = |of: &dyn Fn(&GpuCanopy) -> [f32; 4]| {
        canopies.iter().fold([0.0; 4], |sum, c| {
            let own = of(&c.gpu);
            std::array::from_fn(|i| sum[i] + own[i] * part(c))
        })
    };
    sum.size = mean(&|c| c.size);
    sum.pose = mean(&|c| c.pose);
    sum.tint = mean(&|c| c.tint);
    sum.tint_mean = mean(&|c| c.tint_mean);
    for row in 0..ROWS {
        sum.rows[row] = row_of_all(canopies, row);
    }
    sum
}

/// A row of all fields together: each counts by how much of it shows.
fn row_of_all(canopies: &[Canopy], row: usize) -> GpuCanopyRow {
    let shares = shown_of_all(canopies, row);
    let mut mixed = GpuCanopy::empty().rows[row];
    let floats = |canopy: &Canopy| -> Vec<f32> {
        bytemuck::cast_slice(bytemuck::bytes_of(&canopy.gpu.rows[row])).to_vec()
    };
    let all: Vec<Vec<f32>> = canopies.iter().map(floats).collect();
    let own: &mut [f32] = bytemuck::cast_slice_mut(bytemuck::bytes_of_mut(&mut mixed));
    for (i, value) in own.iter_mut().enumerate() {
        *value = all.iter().zip(&shares).map(|(values, share)| values[i] * share).sum();
    }
    // Gaps of one are filled by another
    let open = |of: &dyn Fn(&GpuCanopyRow) -> f32| -> f32 {
        canopies.iter().map(|c| of(&c.gpu.rows[row]).max(0.0)).product()
    };
    mixed.rest.around[3] = open(&|r| r.rest.around[3]);
    for (wind, bent) in mixed.winds.iter_mut().enumerate() {
        bent.mean.around[3] = open(&|r| r.winds[wind].mean.around[3]);
    }
    mixed
}

/// Which share of all that shows from an elevation is each field's; each is hidden by the parts of the
/// others that are above what shows of it.
fn shown_of_all(canopies: &[Canopy], row: usize) -> Vec<f32> {
    let weight = |(own, canopy): (usize, &Canopy)| {
        let at = canopy.gpu.rows[row].shown[3] * canopy.height_m();
        let above = |other: &Canopy| (1.0 - at / other.height_m().max(1e-6)).max(0.0);
        let hidden: f32 = (canopies.iter().enumerate())
            .filter(|(i, _)| *i != own)
            .map(|(_, other)| other.depth(row) * above(other))
            .sum();
        (1.0 - (-canopy.depth(row)).exp()) * (-hidden).exp()
    };
    let weights: Vec<f32> = canopies.iter().enumerate().map(weight).collect();
    let total = weights.iter().sum::<f32>().max(1e-12);
    weights.iter().map(|weight| weight / total).collect()
}
