//! Blades of a field as they stand, to be baked: squares of it, fitted to the means of the whole
//! field, at rest and bent by wind.

use super::Triangle;
use super::bodies::Bodies;
use super::color::tone_at;
use super::means::{Means, evenly};
use super::places::{Ground, Place};
use super::ribbon::Ribbon;
use crate::frame::physics::twin::{self, settled_tip};
use crate::gpu::quantize::{area_scale, field_openness, tangent_frame};
use crate::grow::Blade;
use crate::plants::body::{Body, Stance};
use crate::shared::curve_twin::middle_point;
use crate::shared::noise_twin::hash01;
use crate::{Field, Gravity, Shape};
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use std::f32::consts::TAU;
use std::sync::Arc;

/// Squares that are looked at.
pub(crate) const STANDS: usize = 8;
/// Blades of each, in the mean.
const BLADES: usize = 256;
/// The same where there are plants of quads, which have as many triangles as a dozen blades.
const PLANTS: usize = 64;
/// Most area of blades over an area of ground.
const DENSEST: f32 = 16.0;
/// Blades that the means are taken over.
const MEANS: usize = 4096;
/// Strengths of the winds that stands are bent by, beside none.
pub(crate) const WINDS: [f32; 3] = [0.35, 0.9, 2.0];
/// Poses of a stand: at rest, and in each wind.
pub(crate) const POSES: usize = 1 + WINDS.len();

/// How a blade's curve runs.
#[derive(Debug, Clone, Copy)]
struct Pose {
    /// v1 and v2 from the root, metres.
    curve: [Vec3; 2],
    /// v2 in heights.
    tip: Vec3,
    /// 0 upright, 1 flat.
    lean: f32,
}

/// A blade, in metres about the middle of its stand: y is up.
#[derive(Debug, Clone)]
pub(crate) struct Standing {
    /// Its form, at rest; of a plant of quads, its middle line and its width.
    pub ribbon: Ribbon,
    /// What a plant of quads looks like, and its up direction.
    planted: Option<(Arc<Body>, Vec3)>,
    /// Colours at tones 0 and 1.
    pub colors: [Vec3; 2],
    /// Length and width, metres, as means count them.
    size: [f32; 2],
    poses: [Pose; POSES],
}

/// Blades near each other.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stand {
    /// The blades, the nearest to the middle first.
    pub blades: Vec<Standing>,
    /// Edges of the level rectangle that repeats, metres: all stands together have the field's
    /// density.
    pub period: Vec2,
    /// Where the winds blow to: azimuth in radians, 0 along z.
    pub downwind: f32,
}

/// What is baked of a field.
#[derive(Debug, Clone)]
pub(crate) struct Stands {
    /// Some squares.
    pub stands: Vec<Stand>,
    /// Share of the sky that reaches the roots.
    pub root_open: f32,
    /// Means of the whole field.
    pub means: Means,
    /// Square metres of ground that it stands on.
    pub ground_m2: f32,
    /// The same for each blade.
    pub each_m2: f32,
}

/// A stand's triangles in a pose.
#[derive(Debug, Clone, Default)]
pub(crate) struct Posed {
    /// Blade by blade.
    pub triangles: Vec<Triangle>,
    /// How far each triangle's blade leans: 0 upright, 1 flat.
    pub leans: Vec<f32>,
}

fn facing_of(blade: &Blade) -> Vec3 {
    let (first, second) = tangent_frame(blade.up);
    first * blade.facing.cos() + second * blade.facing.sin()
}

/// A level direction of that azimuth.
pub(crate) fn level(azimuth: f32) -> Vec3 {
    Vec3::new(azimuth.sin(), 0.0, azimuth.cos())
}

/// A blade under plain gravity and each wind, in a frame about `origin`.
fn standing(
    (field, bodies): (&Field, &Bodies),
    index: usize,
    place: &Place,
    wind: Vec3,
    wider: f32,
) -> Standing {
    let blade = &field.blades()[index];
    let species = &field.species()[usize::from(blade.species)];
    let up = (place.frame * blade.up).normalize_or(Vec3::Y);
    let facing = (place.frame * facing_of(blade)).normalize_or(Vec3::X);
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
    let pose = |strength: f32| {
        let tip = settled_tip(&own, &Gravity::default(), (wind * strength).as_dvec3());
        let middle = middle_point(tip, own.up, own.arch).as_vec3() * blade.height;
        let tip = tip.as_vec3();
        let lean = tip.reject_from(up).length().min(1.0);
        Pose { curve: [middle, tip * blade.height], tip, lean }
    };
    let poses = std::array::from_fn(|i| pose(if i == 0 { 0.0 } else { WINDS[i - 1] }));
    let root = place.frame * (blade.root - place.origin);
    let root = Vec3::new(root.x, 0.0, root.z);
    let lobed = species.shape == Shape::Dandelion;
    let surface = field.color(index).map_or(Vec3::ONE, Vec3::from);
    let body = bodies.body(field, index);
    // The width of a plant of quads is that of its box
    let wider = if body.is_some() { 1.0 } else { wider };
    Standing {
        planted: body.map(|body| (body.clone(), up)),
        ribbon: Ribbon {
            curve: [root, root + poses[0].curve[0], root + poses[0].curve[1]],
            side: up.cross(facing),
            width: blade.width * wider,
            shape: species.shape,
            ridge: species.ridge,
            segments: if lobed { 40 } else { 8 },
            height_share: [0.0, 1.0],
            thickness: 1.0,
        },
        colors: bodies.tones(field, index).on(surface),
        size: [blade.height, blade.width],
        poses,
    }
}

impl Stands {
    /// Some squares of a field, evenly spread over its ground.
    pub(crate) fn of(field: &Field) -> Self {
        let scales: Vec<f32> = field.species().iter().map(|s| area_scale(s, 0)).collect();
        let wider = |index: usize| {
            let species = usize::from(field.blades()[index].species);
            scales.get(species).copied().unwrap_or(1.0)
        };
        let all: Vec<usize> = evenly(field.blades().len(), MEANS).collect();
        let bodies = Bodies::of(field);
        let most = if bodies.any() { PLANTS } else { BLADES };
        let means = Means::over(field, &bodies, &all);
        // Denser than this nothing shows of the ground, whether the blades stand on one point or not
        let ground = Ground::of(field, means.area / DENSEST);
        let count = field.blades().len().clamp(1, most);
        let edge = (count as f32 * ground.each).sqrt();
        let places = ground.places(field, STANDS, edge);
        let stands = places.par_iter().enumerate().map(|(i, place)| {
            // No two from the same side
            let downwind = TAU * (i as f32 * 0.618_034).fract();
            let wind = level(downwind);
            let own =
                place.blades.iter().map(|&b| standing((field, &bodies), b, place, wind, wider(b)));
            let mut blades: Vec<Standing> = own.collect();
            let distance = |b: &Standing| b.ribbon.curve[0].length_squared();
            blades.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
            Stand { blades, period: Vec2::splat(edge), downwind }
        });
        let mut stands: Vec<Stand> = stands.collect();
        // Squares that happen to be full or bare must not make the field denser or thinner
        let blades: usize = stands.iter().map(|s| s.blades.len()).sum();
        let area = stands.len() as f32 * edge * edge;
        let scale = (blades as f32 * ground.each / area).sqrt();
        for stand in &mut stands {
            stand.period *= scale;
            stand.blades.iter_mut().for_each(|blade| blade.move_root(scale));
        }
        let ground_m2 = ground.each * field.blades().len() as f32;
        Self { stands, root_open: field_openness(field), means, ground_m2, each_m2: ground.each }
    }

    /// All of them, fitted together to the means of the field.
    pub(crate) fn fitted(&self) -> Vec<Stand> {
        let blades = || self.stands.iter().flat_map(|s| &s.blades);
        let fit = Fit::of(blades(), &self.means);
        let mut stands = self.stands.clone();
        stands.iter_mut().flat_map(|s| &mut s.blades).for_each(|blade| fit.apply(blade));
        stands
    }
}

/// What makes the means of some blades the field's.
struct Fit {
    taller: f32,
    wider: f32,
    shades: [Vec3; 2],
}

impl Fit {
    fn of<'a>(blades: impl Iterator<Item = &'a Standing> + Clone, means: &Means) -> Self {
        let count = blades.clone().count().max(1) as f32;
        let (mut height, mut area, mut colors) = (0.0, 0.0, [Vec3::ZERO; 2]);
        for blade in blades {
            let [own_height, own_width] = blade.size;
            let own = own_height * own_width;
            height += own_height / count;
            area += own / count;
            colors = [0, 1].map(|end| colors[end] + blade.colors[end] * (own / count));
        }
        let near = |ratio: f32| if ratio.is_finite() { ratio.clamp(0.5, 2.0) } else { 1.0 };
        let taller = near(means.height / height);
        let shades = [0, 1].map(|end| {
            let ratio = means.colors[end] / (colors[end] / area);
            Vec3::from_array(ratio.to_array().map(near))
        });
        Self { taller, wider: near(means.area / area / taller), shades }
    }

    fn apply(&self, blade: &mut Standing) {
        blade.ribbon.scale(self.taller, self.wider);
        for pose in &mut blade.poses {
            pose.curve = pose.curve.map(|p| p * self.taller);
        }
        blade.colors =
            [0, 1].map(|end| (blade.colors[end] * self.shades[end]).clamp(Vec3::ZERO, Vec3::ONE));
    }
}

impl Stand {
    /// Its triangles in a pose.
    pub(crate) fn posed(&self, pose: usize) -> Posed {
        let mut posed = Posed::default();
        for blade in &self.blades {
            blade.triangles(pose, true, &mut posed.triangles);
            posed.leans.resize(posed.triangles.len(), blade.poses[pose].lean);
        }
        posed
    }

    /// Mean tip in a pose, in heights.
    pub(crate) fn mean_tip(&self, pose: usize) -> Vec3 {
        let tips = self.blades.iter().map(|blade| blade.poses[pose].tip);
        tips.sum::<Vec3>() / self.blades.len().max(1) as f32
    }

    /// The triangles of the first blades at rest, with their heights, widths and colours scaled so
    /// that their means are the field's.
    pub(crate) fn nearest(&self, blades: usize, means: &Means) -> Vec<Triangle> {
        let own = &self.blades[..self.blades.len().min(blades)];
        let fit = Fit::of(own.iter(), means);
        let mut list = Vec::new();
        for mut blade in own.iter().cloned() {
            fit.apply(&mut blade);
            blade.triangles(0, false, &mut list);
        }
        list
    }
}

impl Standing {
    fn move_root(&mut self, scale: f32) {
        let root = self.ribbon.curve[0];
        self.ribbon.curve = self.ribbon.curve.map(|p| p + root * (scale - 1.0));
    }

    /// Adds its triangles; coarse ones for counting what shows.
    fn triangles(&self, pose: usize, coarse: bool, out: &mut Vec<Triangle>) {
        let root = self.ribbon.curve[0];
        let [middle, tip] = self.poses[pose].curve;
        let mut ribbon = Ribbon { curve: [root, root + middle, root + tip], ..self.ribbon };
        if let Some((body, up)) = &self.planted {
            let Ribbon { curve, side: right, width, .. } = ribbon;
            // Its own tone, and what it was fitted to the field by
            let tone = self.colors[0] / body.mean.max(Vec3::splat(1e-4));
            return body.add(&Stance { curve, up: *up, right, width }, tone, coarse, out);
        }
        if coarse {
            ribbon.segments = if ribbon.segments > 8 { 16 } else { 8 };
        }
        ribbon.triangles(|v| self.colors[0].lerp(self.colors[1], tone_at(v)), out);
    }
}
