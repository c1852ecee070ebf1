//! Runs a scene under each condition.

use super::quantity::{Condition, SceneName};
use crate::commands::grow_timed;
use crate::measure::{self, Measured, Report, frames_run};
use crate::progress;
use anyhow::{Context, Result};
use image::RgbImage;
use sward_app::gpu::Gpu;
use sward_app::grow::GrowOptions;
use sward_app::stage::{Stage, StageOptions, no_culling};
use sward_scene::Scene;

/// How to measure.
#[derive(Debug, Clone, Copy)]
pub struct Settings {
    pub size: [u32; 2],
    pub samples: u32,
    /// Measured as whole frames, and as many again by stage.
    pub frames: u32,
    pub quiet: bool,
}

impl Settings {
    /// Number of the frame, at 60 a second from the scene's time 0, that was counted and drawn.
    pub fn counted_frame(&self) -> u32 {
        frames_run(self.frames)
    }
}

/// A scene under one condition.
#[derive(Debug)]
pub struct Run {
    pub scene: SceneName,
    pub condition: Condition,
    pub report: Report,
    /// Spheres that colliders are made of.
    pub spheres: u64,
    /// The frame that was counted.
    pub picture: RgbImage,
}

/// All conditions of a scene, grown once.
pub fn evaluate(gpu: &Gpu, name: SceneName, scene: &Scene, settings: Settings) -> Result<Vec<Run>> {
    let (fields, grow_s) = grow_timed(scene, gpu, GrowOptions::default(), settings.quiet)?;
    let patch_size = fields.first().map_or(0, sward::Field::patch_size);
    let one = |condition: Condition| {
        let mut options = StageOptions::new(scene, None, settings.size, settings.samples)?;
        match condition {
            Condition::All => {}
            Condition::NoCollisions => options.collisions = false,
            Condition::NoCulling => options.culling = no_culling(options.culling),
        }
        let what = format!("{}, {}", name.key(), condition.name());
        let steps = u64::from(settings.counted_frame());
        let bar = progress::bar(settings.quiet, &what, steps);
        let mut stage = Stage::new(gpu, scene, &fields, options.clone())?;
        stage.warm_up()?;
        let times = measure::measure(gpu, &mut stage, settings.frames, false, &|| bar.step())?;
        // Time stands still from here on: what is counted is the frame that is drawn.
        let statistics = measure::statistics(gpu, &mut stage, true)?
            .context("the device gave no statistics back")?;
        stage.step(0.0)?;
        let picture = stage.render()?;
        let gpu_bytes = stage.gpu_bytes();
        let without = match condition {
            Condition::All => Vec::new(),
            Condition::NoCollisions => vec!["collisions".into()],
            Condition::NoCulling => vec!["culling".into()],
        };
        let measured = Measured { times, statistics, gpu_bytes, patch_size, grow_s };
        let report = Report::new(gpu, scene, &options, without, measured);
        let spheres = match condition {
            Condition::NoCollisions => 0,
            _ => spheres(scene),
        };
        Ok(Run { scene: name, condition, report, spheres, picture })
    };
    Condition::ALL.into_iter().map(one).collect()
}

fn spheres(scene: &Scene) -> u64 {
    scene.spheres.len() as u64
}
