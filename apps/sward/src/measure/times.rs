//! Times of whole frames, and of their stages.
//!
//! A whole frame is recorded as a program would: all stages in one submission. Stages are timed in
//! frames of their own, each submitted and waited for, with physics and visibility apart: their
//! sum is above the whole frame's time. No timestamp queries: some drivers' are wrong.

use anyhow::Result;
use std::time::Instant;
use sward::Statistics;
use sward_app::gpu::Gpu;
use sward_app::stage::Stage;

const DT_S: f64 = 1.0 / 60.0;

/// Milliseconds, one value a frame.
#[derive(Debug, Default)]
pub struct Times {
    /// Whole frames.
    pub frame: Vec<f32>,
    /// Wind, contact, blade physics.
    pub physics: Vec<f32>,
    /// Tests, levels, draw lists.
    pub visibility: Vec<f32>,
    /// Opaque things, grass, sky.
    pub draw: Vec<f32>,
    /// Fog and depth of field where the scene has them, tone mapping.
    pub post: Vec<f32>,
}

/// Frames that run unmeasured before `frames` that are measured as a whole; one more runs before
/// those that are measured by stage.
pub fn warm_up_frames(frames: u32) -> u32 {
    frames.min(20)
}

/// Frames that [`statistics`] runs; the counts are of the last one.
pub const COUNTED_FRAMES: u32 = 4;

/// Frames that [`measure`] runs.
pub fn frames_run(frames: u32) -> u32 {
    warm_up_frames(frames) + frames + 1 + frames
}

/// Measures `frames` whole frames and as many by stage, after a warm-up.
pub fn measure(
    gpu: &Gpu,
    stage: &mut Stage,
    frames: u32,
    still: bool,
    progress: &dyn Fn(),
) -> Result<Times> {
    let mut measuring = [Measuring { still, ..Measuring::new(stage) }];
    measure_in_turns(gpu, &mut measuring, frames, progress)?;
    let [Measuring { times, .. }] = measuring;
    Ok(times)
}

/// A scene that is being measured.
#[derive(Debug)]
pub struct Measuring<'a> {
    stage: &'a mut Stage,
    /// Whether its time stands still.
    still: bool,
    /// What was measured.
    pub times: Times,
}

impl<'a> Measuring<'a> {
    /// Nothing yet.
    pub fn new(stage: &'a mut Stage) -> Self {
        Self { stage, still: false, times: Times::default() }
    }

    /// Runs a frame, as a whole or stage by stage.
    fn run(&mut self, gpu: &Gpu, whole: bool, keep: bool) -> Result<()> {
        let dt_s = if self.still { 0.0 } else { DT_S };
        let mut unwanted = Times::default();
        let times = if keep { &mut self.times } else { &mut unwanted };
        if whole {
            times.frame.push(whole_frame(gpu, self.stage, dt_s)?);
            Ok(())
        } else {
            by_stage(gpu, self.stage, dt_s, times)
        }
    }
}

/// Frames that one scene runs before the next has its turn.
const TURN: u32 = 5;

/// Measures several scenes, each as [`measure`] does, in turns of a few frames: what slows the
/// machine for a while slows all of them.
pub fn measure_in_turns(
    gpu: &Gpu,
    scenes: &mut [Measuring],
    frames: u32,
    progress: &dyn Fn(),
) -> Result<()> {
    let phases = [
        (true, false, warm_up_frames(frames)),
        (true, true, frames),
        // The first use of a stage by itself may compile it.
        (false, false, 1),
        (false, true, frames),
    ];
    for (whole, keep, count) in phases {
        for first in (0..count).step_by(TURN as usize) {
            for scene in scenes.iter_mut() {
                for _ in first..count.min(first + TURN) {
                    scene.run(gpu, whole, keep)?;
                    progress();
                }
            }
        }
    }
    Ok(())
}

fn whole_frame(gpu: &Gpu, stage: &mut Stage, dt_s: f64) -> Result<f32> {
    time_stage(gpu, stage, |stage, encoder| {
        stage.encode_simulate(encoder, dt_s)?;
        stage.encode_opaque(encoder);
        stage.encode_cull(encoder)?;
        stage.encode_draw(encoder);
        stage.encode_post(encoder);
        Ok(())
    })
}

fn by_stage(gpu: &Gpu, stage: &mut Stage, dt_s: f64, times: &mut Times) -> Result<()> {
    use sward::Stage::{Compact, Light, PatchCull, Physics, Visibility};
    let one = |stage: &mut Stage, which| {
        time_stage(gpu, stage, |stage, encoder| {
            stage.encode_stage(encoder, which);
            Ok(())
        })
    };
    let simulate = time_stage(gpu, stage, |stage, encoder| stage.encode_simulate(encoder, dt_s))?;
    let opaque = time_stage(gpu, stage, |stage, encoder| {
        stage.encode_opaque(encoder);
        Ok(())
    })?;
    // Writes settings only; part of no stage.
    time_stage(gpu, stage, Stage::encode_prepare)?;
    let patch_cull = one(stage, PatchCull)?;
    let physics = one(stage, Physics)?;
    let visibility = one(stage, Visibility)?;
    let light = one(stage, Light)?;
    let compact = one(stage, Compact)?;
    let draw = time_stage(gpu, stage, |stage, encoder| {
        stage.encode_draw(encoder);
        Ok(())
    })?;
    let post = time_stage(gpu, stage, |stage, encoder| {
        stage.encode_post(encoder);
        Ok(())
    })?;
    times.physics.push(simulate + physics);
    times.visibility.push(patch_cull + visibility + light + compact);
    times.draw.push(opaque + draw);
    times.post.push(post);
    Ok(())
}

/// Milliseconds from recording to the end of the work on the device.
fn time_stage(
    gpu: &Gpu,
    stage: &mut Stage,
    record: impl FnOnce(&mut Stage, &mut wgpu::CommandEncoder) -> Result<()>,
) -> Result<f32> {
    let start = Instant::now();
    let mut encoder = stage.encoder();
    record(stage, &mut encoder)?;
    stage.submit(encoder);
    gpu.wait()?;
    Ok(start.elapsed().as_secs_f32() * 1e3)
}

/// Counts of a frame, which come back a few frames late.
pub fn statistics(gpu: &Gpu, stage: &mut Stage, still: bool) -> Result<Option<Statistics>> {
    let mut newest = stage.statistics();
    for _ in 0..COUNTED_FRAMES {
        whole_frame(gpu, stage, if still { 0.0 } else { DT_S })?;
        newest = stage.statistics().or(newest);
    }
    Ok(newest)
}
