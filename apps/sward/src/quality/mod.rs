//! How near a scene's pictures come to its reference, from one place and on the way.
//!
//! What each number means, and how it is measured, is told in `docs/quality.md`.

mod bins;
mod chart;
mod drift;
mod ground;
mod limits;
mod page;
mod pair;
mod paths;
mod plots;
mod series;

pub use bins::Bin;
pub use drift::{ChangeDrift, Drift, ViewDrift};
pub use limits::Limits;
pub use page::markdown;
pub use plots::plots;
pub use series::{FrameFlip, PathFlip};

use crate::compare::{Flip, flip_map, summary};
use crate::gpu::Gpu;
use crate::stage::StageOptions;
use anyhow::Result;
use image::RgbImage;
use pair::Pair;
use paths::{Paths, Which};
use serde::Serialize;
use sward::Field;
use sward_scene::Scene;

/// Steps of a path: its length is that of 120 frames.
pub const PATH_STEPS: u32 = 120;

/// A part of the measurement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The scene camera's picture.
    Flip,
    /// The three paths.
    Paths,
    /// Coverage, luminance and colour against distance.
    Drift,
    /// A camera that stands still.
    Still,
}

/// What is measured, and how finely.
#[derive(Debug, Clone)]
pub struct Settings {
    /// Which parts.
    pub parts: Vec<Part>,
    /// Frames drawn of each path, at most [`PATH_STEPS`]: fewer are runs of four neighbours, spread
    /// over the path.
    pub path_frames: u32,
    /// Frames of the still camera.
    pub still_frames: u32,
}

impl Default for Settings {
    /// A few minutes on a software adapter.
    fn default() -> Self {
        let parts = vec![Part::Flip, Part::Paths, Part::Drift, Part::Still];
        Self { parts, path_frames: 24, still_frames: 30 }
    }
}

/// All numbers of a scene; those of parts that were left out are not there.
#[derive(Debug, Clone, Serialize)]
pub struct Quality {
    /// The scene's name.
    pub scene: String,
    /// The graphics adapter.
    pub adapter: String,
    /// Its driver.
    pub driver: String,
    /// Size of the pictures, pixels.
    pub size: [u32; 2],
    /// Samples a pixel of the pictures under test.
    pub samples: u32,
    /// Which forms plants were drawn in.
    pub technique: String,
    /// Blades of the scene.
    pub blades_total: u64,
    /// Share of the paths' full length that fits the scene.
    pub path_scale: f32,
    /// FLIP of the scene's camera, haze included.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flip: Option<SceneFlip>,
    /// 20 m ahead.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dolly: Option<PathFlip>,
    /// A quarter turn about what is ahead.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orbit: Option<PathFlip>,
    /// From 60 to 2 m over the ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flydown: Option<PathFlip>,
    /// Against distance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub drift: Option<Drift>,
    /// A camera that stands still.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub still: Option<Still>,
}

impl Quality {
    /// The paths that were measured, with the names that they have in JSON.
    pub fn paths(&self) -> impl Iterator<Item = (&'static str, &PathFlip)> {
        let paths = [("dolly", &self.dolly), ("orbit", &self.orbit), ("flydown", &self.flydown)];
        paths.into_iter().filter_map(|(name, path)| Some((name, path.as_ref()?)))
    }
}

/// FLIP over all pixels, and over those of which grass covers most.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct SceneFlip {
    /// Mean of all pixels.
    pub mean: f32,
    /// 99th percentile of all pixels.
    pub p99: f32,
    /// Mean of the grass pixels.
    pub grass_mean: f32,
    /// 99th percentile of the grass pixels.
    pub grass_p99: f32,
    /// Share of the pixels that are grass pixels.
    pub grass_pixels: f32,
}

/// Frames of a camera that stands still.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Still {
    /// Whether all are equal to the bit.
    pub equal: bool,
    /// How many.
    pub frames: u32,
}

/// The scene camera's pictures.
#[derive(Debug, Clone)]
pub struct Pictures {
    /// All blades, 64 samples.
    pub reference: RgbImage,
    /// As the scene is drawn.
    pub test: RgbImage,
    /// Error of each pixel, row by row.
    pub errors: Vec<f32>,
}

/// Steps that [`measure`] tells of.
pub fn steps(settings: &Settings) -> u64 {
    let frames = 3 * paths::frames(settings.path_frames).len() as u32;
    let of = |part, steps| if settings.parts.contains(&part) { steps } else { 0 };
    u64::from(
        2 + of(Part::Paths, frames)
            + of(Part::Drift, 3 * paths::SIDES)
            + of(Part::Still, settings.still_frames),
    )
}

/// Measures a scene as `options` draw it; calls `step` after each of [`steps`].
///
/// # Errors
/// Where the fields do not fit the device, or it fails.
pub fn measure(
    gpu: &Gpu,
    scene: &Scene,
    fields: &[Field],
    options: &StageOptions,
    settings: &Settings,
    step: &dyn Fn(),
) -> Result<(Quality, Pictures)> {
    let has = |part| settings.parts.contains(&part);
    let mut pair = Pair::new(gpu, scene, fields, options)?;
    step();
    let (flip, pictures) = scene_flip(&mut pair)?;
    step();
    let still = || pair.still(settings.still_frames, step);
    let still = has(Part::Still).then(still).transpose()?;
    pair.clear_air()?;
    let camera = &options.camera;
    let paths = Paths::new(scene, camera);
    let mut path = |which: Which| {
        let camera = |t| paths.camera(which, t);
        let along = || series::along(&mut pair, camera, settings.path_frames, step);
        has(Part::Paths).then(along).transpose()
    };
    let dolly = path(Which::Dolly)?;
    let orbit = path(Which::Orbit)?;
    let flydown = path(Which::FlyDown)?;
    let views = paths.views();
    let drift = || drift::measure(&mut pair, scene, options, &views, step);
    let drift = has(Part::Drift).then(drift).transpose()?;
    let info = gpu.adapter.get_info();
    let quality = Quality {
        scene: scene.name.clone(),
        adapter: info.name,
        driver: format!("{} {}", info.driver, info.driver_info).trim().into(),
        size: options.size,
        samples: options.samples,
        technique: format!("{:?}", options.technique).to_lowercase(),
        blades_total: crate::grow::blade_count(fields),
        path_scale: paths.scale(),
        flip: has(Part::Flip).then_some(flip),
        dolly,
        orbit,
        flydown,
        drift,
        still,
    };
    Ok((quality, pictures))
}

fn scene_flip(pair: &mut Pair) -> Result<(SceneFlip, Pictures)> {
    let (reference, test) = pair.pictures()?;
    let errors = flip_map(&reference, &test)?;
    let grass = pair.reference_grass()?;
    let on_grass: Vec<f32> =
        errors.iter().zip(&grass).filter(|(_, share)| **share > 0.5).map(|(e, _)| *e).collect();
    let grass_pixels = on_grass.len() as f32 / errors.len().max(1) as f32;
    let (Flip { mean, p99, .. }, grass) = (summary(errors.clone()), summary(on_grass));
    let flip = SceneFlip { mean, p99, grass_mean: grass.mean, grass_p99: grass.p99, grass_pixels };
    Ok((flip, Pictures { reference, test, errors }))
}
