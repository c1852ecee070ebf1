//! Blades of a field as they stand at rest, to be baked: some patches of it, fitted to the means of
//! the whole field.

use super::Triangle;
use super::color::{Tones, tone_at, tones};
use super::ribbon::Ribbon;
use crate::frame::physics::twin::{self, rest_tip};
use crate::gpu::quantize::{area_scale, field_openness, tangent_frame};
use crate::grow::{Blade, Patch};
use crate::shared::curve_twin::middle_point;
use crate::shared::noise_twin::hash01;
use crate::{Field, Gravity, Shape};
use glam::{DMat2, DVec2, Mat3, Vec2, Vec3};
use rayon::prelude::*;

/// Patches that are looked at.
pub(crate) const STANDS: usize = 4;
/// Most blades of each.
const MOST: usize = 256;
/// Patches that the density is measured on.
const MEASURED: usize = 64;
/// Most area of blades over an area of ground.
const DENSEST: f32 = 16.0;
/// Blades that the means are taken over.
const MEANS: usize = 4096;

/// A blade at rest, in metres about the middle of its stand: y is up.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Standing {
    /// Its form.
    pub ribbon: Ribbon,
    /// Colours at tones 0 and 1.
    pub colors: [Vec3; 2],
    /// How far it leans: 0 upright, 1 flat.
    pub lean: f32,
}

/// Blades near each other.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stand {
    /// The blades, the nearest to the middle first.
    pub blades: Vec<Standing>,
    /// Edges of the level rectangle that repeats, metres: it has the field's density.
    pub period: Vec2,
}

/// What is baked of a field.
#[derive(Debug, Clone)]
pub(crate) struct Stands {
    /// Some patches.
    pub stands: Vec<Stand>,
    /// Share of the sky that reaches the roots.
    pub root_open: f32,
    /// Means of the whole field.
    pub means: Means,
}

/// Means over a field's blades.
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
fn part(field: &Field, index: usize) -> (f64, Means) {
    let blade = &field.blades()[index];
    let tones = own_tones(field, index);
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
    fn over(field: &Field, blades: &[usize]) -> Self {
        let zero = [0.0_f64; 15];
        let sum = blades.iter().fold(zero, |mut sum, &index| {
            let (area, own) = part(field, index);
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

fn own_tones(field: &Field, index: usize) -> Tones {
    let mix = if field.color(index).is_some() { field.tint_mix() } else { 0.0 };
    let species = &field.species()[usize::from(field.blades()[index].species)];
    tones(species, index as u32, mix)
}

fn facing_of(blade: &Blade) -> Vec3 {
    let (first, second) = tangent_frame(blade.up);
    first * blade.facing.cos() + second * blade.facing.sin()
}

/// World to a frame whose y is `up`.
fn level_frame(up: Vec3) -> Mat3 {
    let (first, second) = tangent_frame(up);
    Mat3::from_cols(first, up, second).transpose()
}

/// A blade at rest under plain gravity, in a frame about `origin`.
fn standing(field: &Field, index: usize, frame: &Mat3, origin: Vec3, wider: f32) -> Standing {
    let blade = &field.blades()[index];
    let species = &field.species()[usize::from(blade.species)];
    let up = (*frame * blade.up).normalize_or(Vec3::Y);
    let facing = (*frame * facing_of(blade)).normalize_or(Vec3::X);
    let own = twin::Blade {
        root: glam::DVec3::ZERO,
        up: up.as_dvec3(),
        facing: facing.as_dvec3(),
        height: f64::from(blade.height),
        response: f64::from(blade.response),
        droop: f64::from(species.droop.at(hash01(index as u32, 11))),
        gust: f64::from(species.gust),
        arch: f64::from(species.arch),
    };
    let tip = rest_tip(&own, &Gravity::default());
    let middle = middle_point(tip, own.up, own.arch).as_vec3() * blade.height;
    let root = *frame * (blade.root - origin);
    let tip = tip.as_vec3();
    let lobed = species.shape == Shape::Dandelion;
    let surface = field.color(index).map_or(Vec3::ONE, Vec3::from);
    Standing {
        ribbon: Ribbon {
            curve: [root, root + middle, root + tip * blade.height],
            side: up.cross(facing),
            width: blade.width * wider,
            shape: species.shape,
            ridge: species.ridge,
            segments: if lobed { 40 } else { 8 },
            height_share: [0.0, 1.0],
            thickness: 1.0,
        },
        colors: own_tones(field, index).on(surface),
        lean: tip.reject_from(up).length().min(1.0),
    }
}

/// Level area of a patch's ground: that of a rectangle whose points spread as its roots do.
fn ground_area(blades: &[Blade], patch: &Patch) -> f64 {
    let own = &blades[patch.first as usize..(patch.first + patch.count) as usize];
    let up = own.iter().map(|b| b.up).sum::<Vec3>().normalize_or(Vec3::Y);
    let frame = level_frame(up);
    let places: Vec<DVec2> = (own.iter())
        .map(|b| (frame * (b.root - patch.root_min)).as_dvec3())
        .map(|p| DVec2::new(p.x, p.z))
        .collect();
    let count = places.len().max(2) as f64;
    let mean = places.iter().sum::<DVec2>() / count;
    let spread = places.iter().fold(DMat2::ZERO, |sum, p| {
        let d = *p - mean;
        sum + DMat2::from_cols(d * d.x, d * d.y)
    });
    12.0 * (spread.determinant().max(0.0)).sqrt() / (count - 1.0)
}

/// Square metres of ground a blade.
fn area_a_blade(field: &Field) -> f32 {
    // A patch of few blades says little of the ground that it stands on
    let full = field.patches().iter().filter(|p| p.count == field.patch_size()).count();
    let patches = &field.patches()[..if full > 0 { full } else { field.patches().len() }];
    let picked: Vec<&Patch> = evenly(patches.len(), MEASURED).map(|i| &patches[i]).collect();
    let areas: Vec<f64> = picked.par_iter().map(|p| ground_area(field.blades(), p)).collect();
    let count: f64 = picked.iter().map(|p| f64::from(p.count)).sum();
    ((areas.iter().sum::<f64>() / count.max(1.0)) as f32).clamp(0.0, 1e6)
}

impl Stands {
    /// Some patches of a field, evenly spread over it.
    pub(crate) fn of(field: &Field) -> Self {
        let scales: Vec<f32> = field.species().iter().map(|s| area_scale(s, 0)).collect();
        let wider = |index: usize| {
            let species = usize::from(field.blades()[index].species);
            scales.get(species).copied().unwrap_or(1.0)
        };
        let patches = field.patches();
        // The last patch may have few blades
        let whole = if patches.len() > 1 { &patches[..patches.len() - 1] } else { patches };
        let all: Vec<usize> = evenly(field.blades().len(), MEANS).collect();
        let means = Means::over(field, &all);
        // Denser than this nothing shows of the ground, whether the blades stand on one point or not
        let each = area_a_blade(field).max(means.area / DENSEST);
        let picked: Vec<&Patch> = evenly(whole.len(), STANDS).map(|i| &whole[i]).collect();
        let stand = |patch: &&Patch| {
            let first = patch.first as usize;
            let own: Vec<usize> = (first..first + (patch.count as usize).min(MOST)).collect();
            Stand::of(field, &own, patch.count, &wider, each)
        };
        Self {
            stands: picked.par_iter().map(stand).collect(),
            root_open: field_openness(field),
            means,
        }
    }
}

impl Stand {
    /// `own` of the `count` blades of a patch; `each` is the ground of a blade.
    fn of(
        field: &Field,
        own: &[usize],
        count: u32,
        wider: &(dyn Fn(usize) -> f32 + Sync),
        each: f32,
    ) -> Self {
        let all = field.blades();
        let up = own.iter().map(|&i| all[i].up).sum::<Vec3>().normalize_or(Vec3::Y);
        let frame = level_frame(up);
        let middle = own.iter().map(|&i| all[i].root.as_dvec3()).sum::<glam::DVec3>()
            / own.len().max(1) as f64;
        let origin = middle.as_vec3();
        let mut blades: Vec<Standing> =
            own.iter().map(|&i| standing(field, i, &frame, origin, wider(i))).collect();
        // A thinned patch is drawn together, to the density of the whole
        let closer = (own.len() as f32 / count.max(1) as f32).sqrt();
        blades.iter_mut().for_each(|blade| blade.move_root(|p| Vec3::new(p.x, 0.0, p.z) * closer));
        let distance = |b: &Standing| b.ribbon.curve[0].length_squared();
        blades.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        let mut stand = Self { blades, period: Vec2::ONE };
        stand.repeat(each * own.len() as f32);
        stand
    }

    /// Finds the rectangle that repeats, of that area.
    fn repeat(&mut self, area: f32) {
        let places = || self.blades.iter().map(|b| b.ribbon.curve[0]);
        let low = places().fold(Vec3::INFINITY, Vec3::min);
        let high = places().fold(Vec3::NEG_INFINITY, Vec3::max);
        let size = high - low;
        let count = self.blades.len() as f32;
        // Points fill a rectangle but for about one of their distances
        let filled = size.x * size.z * ((count + 1.0) / (count - 1.0).max(1.0)).powi(2);
        if filled > 0.6 * area && filled < 1.25 * area {
            let scale = (area / (size.x * size.z)).sqrt();
            self.period = Vec2::new(size.x, size.z) * scale;
            return;
        }
        // Not a rectangle: the same blades anywhere on one
        self.period = Vec2::splat(area.sqrt());
        let period = self.period;
        for (i, blade) in self.blades.iter_mut().enumerate() {
            let at = [31, 32].map(|salt| hash01(i as u32, salt) - 0.5);
            blade.move_root(|_| Vec3::new(at[0] * period.x, 0.0, at[1] * period.y));
        }
    }

    /// Its triangles, of so many segments a blade, and lean by triangle.
    pub(crate) fn triangles(&self, blades: usize, coarse: bool) -> Vec<Triangle> {
        let mut list = Vec::new();
        for blade in self.blades.iter().take(blades) {
            blade.triangles(coarse, &mut list);
        }
        list
    }

    /// Scales heights, widths and colours so that the means of the first blades are the field's.
    pub(crate) fn fitted(mut self, blades: usize, means: &Means) -> Self {
        self.blades.truncate(blades);
        let count = self.blades.len().max(1) as f32;
        let (mut height, mut area, mut colors) = (0.0, 0.0, [Vec3::ZERO; 2]);
        for blade in &self.blades {
            let own = blade.ribbon.length() * blade.ribbon.width;
            height += blade.ribbon.length() / count;
            area += own / count;
            colors = [0, 1].map(|end| colors[end] + blade.colors[end] * (own / count));
        }
        let near = |ratio: f32| if ratio.is_finite() { ratio.clamp(0.5, 2.0) } else { 1.0 };
        let taller = near(means.height / height);
        let wider = near(means.area / area / taller);
        let shades = [0, 1].map(|end| {
            let ratio = means.colors[end] / (colors[end] / area);
            Vec3::from_array(ratio.to_array().map(near))
        });
        for blade in &mut self.blades {
            blade.ribbon.scale(taller, wider);
            blade.colors =
                [0, 1].map(|end| (blade.colors[end] * shades[end]).clamp(Vec3::ZERO, Vec3::ONE));
        }
        self
    }
}

impl Standing {
    fn move_root(&mut self, to: impl Fn(Vec3) -> Vec3) {
        let root = self.ribbon.curve[0];
        let by = to(root) - root;
        self.ribbon.curve = self.ribbon.curve.map(|p| p + by);
    }

    /// Adds its triangles; coarse ones for counting what shows.
    pub(crate) fn triangles(&self, coarse: bool, out: &mut Vec<Triangle>) {
        let mut ribbon = self.ribbon;
        if coarse {
            ribbon.segments = if ribbon.segments > 8 { 16 } else { 4 };
        }
        ribbon.triangles(|v| self.colors[0].lerp(self.colors[1], tone_at(v)), out);
    }
}
