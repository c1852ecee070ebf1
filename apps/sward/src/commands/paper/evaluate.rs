//! Runs a scene under each condition.

use super::quantity::{Condition, SceneName};
use crate::commands::grow_timed;
use crate::measure::{self, COUNTED_FRAMES, Measured, Measuring, Report, frames_run};
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
        frames_run(self.frames) + COUNTED_FRAMES
    }
}

/// A scene under one condition.
#[derive(Debug)]
pub struct Run {
    pub scene: SceneName,
    pub condition: Condition,
    pub report: Report,
    /// Spheres that colliders are made of; a capsule or a box counts as one.
    pub spheres: u64,
    /// The frame that was counted.
    pub picture: RgbImage,
}

/// All conditions of a scene, grown once and measured in turns.
pub fn evaluate(gpu: &Gpu, name: SceneName, scene: &Scene, settings: Settings) -> Result<Vec<Run>> {
    let (fields, grow_s) = grow_timed(scene, gpu, GrowOptions::default(), settings.quiet)?;
    let patch_size = fields.first().map_or(0, sward::Field::patch_size);
    let bar = progress::bar(
        settings.quiet,
        &format!("measuring {}", name.key()),
        u64::from(frames_run(settings.frames)) * Condition::ALL.len() as u64,
    );
    let options = Condition::ALL.map(|condition| options(scene, condition, settings));
    let options = options.into_iter().collect::<Result<Vec<_>>>()?;
    let stages = options.iter().map(|options| {
        let mut stage = Stage::new(gpu, scene, &fields, options.clone())?;
        stage.warm_up()?;
        Ok(stage)
    });
    let mut stages = stages.collect::<Result<Vec<_>>>()?;
    let mut measuring: Vec<_> = stages.iter_mut().map(Measuring::new).collect();
    measure::measure_in_turns(gpu, &mut measuring, settings.frames, &|| bar.step())?;
    let times: Vec<_> = measuring.into_iter().map(|measuring| measuring.times).collect();
    let runs = Condition::ALL.into_iter().zip(options).zip(stages.into_iter().zip(times));
    runs.map(|((condition, options), (mut stage, times))| {
        let statistics = measure::statistics(gpu, &mut stage, false)?
            .context("the device gave no statistics back")?;
        let picture = stage.render()?;
        let (gpu_bytes, blade_bytes) = stage.gpu_bytes();
        let measured = Measured { times, statistics, gpu_bytes, blade_bytes, patch_size, grow_s };
        let report = Report::new(gpu, scene, &options, without(condition), measured);
        let spheres = stage.collider_parts();
        Ok(Run { scene: name, condition, report, spheres, picture })
    })
    .collect()
}

fn options(scene: &Scene, condition: Condition, settings: Settings) -> Result<StageOptions> {
    let mut options = StageOptions::new(scene, None, settings.size, settings.samples)?;
    // As the paper draws: every blade a blade
    options.technique = sward::Technique::Blades;
    match condition {
        Condition::All => {}
        Condition::NoCollisions => options.collisions = false,
        Condition::NoCulling => options.culling = no_culling(options.culling),
    }
    Ok(options)
}

/// As `bench` names it.
fn without(condition: Condition) -> Vec<String> {
    match condition {
        Condition::All => Vec::new(),
        Condition::NoCollisions => vec!["collisions".into()],
        Condition::NoCulling => vec!["culling".into()],
    }
}
