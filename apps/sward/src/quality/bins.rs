//! Pixels of many pictures, sorted by how far the ground under them is.
//!
//! The ground's distance, not that of what shows: it is the same in the picture under test and in the
//! reference, so every pixel is compared with itself, and what is lost or won at one distance cannot
//! hide in another's sum. All of a picture that shows ground or plants is in one of the ranges.

use crate::stage::LightMap;
use glam::Vec3;
use serde::Serialize;
use sward_scene::Camera;
use sward_scene::atmosphere::LUMINANCE;

/// How many times as far as it begins a range ends.
const STEP: f32 = 1.35;
/// Pixels' worth of grass that a range must show in the reference to be counted.
const LEAST_PIXELS: f32 = 200.0;
/// Upright strips of a picture, whose differences tell how much is chance.
const STRIPS: usize = 10;

/// A range of distance.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Bin {
    /// Where it begins and ends, metres.
    pub range_m: [f32; 2],
    /// Share of its pixels that is grass: reference, test.
    pub coverage: [f32; 2],
    /// Mean luminance of its pixels, grass and what lies between; the sky is black.
    pub luminance: [f32; 2],
    /// Mean colour, as parts of its own luminance.
    pub colour: [[f32; 3]; 2],
    /// Standard error of test over reference, as a share: of coverage, of luminance.
    pub error: [f32; 2],
}

impl Bin {
    /// Test over reference.
    pub fn ratio(pair: [f32; 2]) -> f32 {
        pair[1] / pair[0].max(1e-9)
    }

    /// How far the colour is off.
    pub fn colour_off(&self) -> Vec3 {
        let [reference, test] = self.colour.map(Vec3::from);
        (test - reference) / reference.length().max(1e-9)
    }
}

/// Sums over a strip's pixels of one range: reference, test.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    pixels: f32,
    grass: [f32; 2],
    light: [Vec3; 2],
}

impl Sums {
    fn luminance(&self) -> [f32; 2] {
        self.light.map(|light| light.dot(LUMINANCE))
    }

    fn and(self, other: &Self) -> Self {
        Self {
            pixels: self.pixels + other.pixels,
            grass: [0, 1].map(|i| self.grass[i] + other.grass[i]),
            light: [0, 1].map(|i| self.light[i] + other.light[i]),
        }
    }
}

/// The pixels of all pictures of a view.
#[derive(Debug)]
pub(super) struct Bins {
    size: [u32; 2],
    tallest_m: f32,
    /// By power of `STEP`, each a strip of a picture
    ranges: std::collections::BTreeMap<i32, Vec<Sums>>,
    pictures: usize,
}

impl Bins {
    /// For pictures of this size, of plants at most so high.
    pub fn new(size: [u32; 2], tallest_m: f32) -> Self {
        Self { size, tallest_m, ranges: Default::default(), pictures: 0 }
    }

    /// Adds a picture and its reference; `places` as of [`crate::stage::Stage::opaque_places`].
    pub fn add(
        &mut self,
        camera: &Camera,
        places: &[Option<Vec3>],
        reference: &LightMap,
        test: &LightMap,
    ) {
        let distances = self.distances(camera, places);
        let width = self.size[0] as usize;
        let strip_px = width.div_ceil(STRIPS);
        let first = self.pictures * STRIPS;
        self.pictures += 1;
        let pixels = distances.iter().zip(reference.pixels().zip(test.pixels()));
        for (i, (distance, (one, two))) in pixels.enumerate() {
            let Some(distance) = distance else { continue };
            let range = distance.max(1e-6).log(STEP).floor() as i32;
            let strips = self.ranges.entry(range).or_default();
            strips.resize(self.pictures * STRIPS, Sums::default());
            let own = Sums { pixels: 1.0, grass: [one.1, two.1], light: [one.0, two.0] };
            if let Some(strip) = strips.get_mut(first + i % width / strip_px) {
                *strip = strip.and(&own);
            }
        }
    }

    /// How far what each pixel shows is: the ground, or, where plants may stand before the sky, the
    /// ground on which they stand.
    fn distances(&self, camera: &Camera, places: &[Option<Vec3>]) -> Vec<Option<f32>> {
        let [width, height] = self.size.map(|side| side as usize);
        let metre_px = 0.5 * height as f32 / (0.5 * camera.vertical_fov_deg.to_radians()).tan();
        let far = |place: &Option<Vec3>| place.map(|place| place.distance(camera.eye));
        let mut distances: Vec<_> = places.iter().map(far).collect();
        for column in 0..width {
            let mut below: Option<(usize, f32)> = None;
            for row in (0..height).rev() {
                let Some(distance) = distances.get_mut(row * width + column) else { continue };
                match (*distance, below) {
                    (Some(own), _) => below = Some((row, own)),
                    (None, Some((from, own))) => {
                        let tall_px = (self.tallest_m * metre_px / own).ceil() as usize;
                        *distance = (from - row <= tall_px).then_some(own);
                    }
                    (None, None) => {}
                }
            }
        }
        distances
    }

    /// The ranges in which enough grass shows, nearest first.
    pub fn sums(&self) -> Vec<Bin> {
        self.ranges.iter().filter_map(|(range, strips)| bin(*range, strips)).collect()
    }
}

fn bin(range: i32, strips: &[Sums]) -> Option<Bin> {
    let all = strips.iter().fold(Sums::default(), Sums::and);
    if all.grass[0] < LEAST_PIXELS {
        return None;
    }
    let luminance = all.luminance();
    Some(Bin {
        range_m: [range, range + 1].map(|power| STEP.powi(power)),
        coverage: all.grass.map(|sum| sum / all.pixels),
        luminance: luminance.map(|sum| sum / all.pixels),
        colour: all.light.map(|sum| (sum / sum.dot(LUMINANCE).max(1e-9)).to_array()),
        error: [error(strips, |strip| strip.grass), error(strips, Sums::luminance)],
    })
}

/// Standard error of a ratio of sums, as a share of it, from the parts that they are made of.
fn error(strips: &[Sums], pick: fn(&Sums) -> [f32; 2]) -> f32 {
    let parts: Vec<_> = strips.iter().filter(|strip| strip.pixels > 0.0).map(pick).collect();
    let [reference, test] =
        parts.iter().fold([0.0; 2], |sum, part| [0, 1].map(|i| sum[i] + part[i]));
    let ratio = test / reference.max(1e-9);
    let off = parts.iter().map(|part| (part[1] - ratio * part[0]).powi(2)).sum::<f32>();
    let count = parts.len() as f32;
    (off * count / (count - 1.0).max(1.0)).sqrt() / test.max(1e-9)
}
