//! `sward render`: pictures and sequences.

use super::{grow_timed, load, tell_notes};
use crate::args::{self, Frames, Size};
use crate::output::{Output, write_picture};
use crate::progress;
use crate::table::thousands;
use anyhow::{Result, bail};
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;
use sward::PhysicsModel;
use sward_app::gpu::Gpu;
use sward_app::grow::blade_count;
use sward_app::stage::{Clock, Stage, StageOptions};
use sward_scene::Scene;

const EXAMPLES: &str = "\
Examples:
  sward render scenes/meadow.ron -o meadow.png
  sward render scenes/meadow.ron -o big.png --size 3840x2160 --time 2.5
  sward render scenes/meadow.ron -o f/%04d.png --frames 0..120 --fps 30
  sward render scenes/meadow.ron -o truth.png --reference";

/// Render a scene to a picture, or to a sequence of them
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Scene file (RON)
    scene: PathBuf,
    /// Picture to write: FILE.png, or f/%04d.png, where %04d is the frame's own number
    #[arg(long, short)]
    output: PathBuf,
    /// Size in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720")]
    size: Size,
    /// Samples a pixel [default: 4 where the adapter has it]
    #[arg(long, value_name = "N")]
    samples: Option<u32>,
    /// Frames A to B - 1; each shows what a run from frame 0 would
    #[arg(long, value_name = "A..B", conflicts_with = "time")]
    frames: Option<Frames>,
    /// Frames a second [default: the scene's, else 30]
    #[arg(long, value_parser = args::fps)]
    fps: Option<f64>,
    /// Time of a single picture, seconds from the scene's start
    #[arg(long, value_name = "S", default_value = "0", value_parser = args::time_s)]
    time: f64,
    /// Camera of the scene [default: its first]
    #[arg(long, value_name = "NAME")]
    camera: Option<String>,
    /// How blades move [default: the scene's]
    #[arg(long, value_enum)]
    physics: Option<Physics>,
    /// How blades are culled [default: the scene's]
    #[arg(long, value_enum)]
    culling: Option<CullingChoice>,
    /// Draw every blade at one level of detail: 0 to 3 for 8, 4, 2 or 1 segments
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(0..=3))]
    level: Option<u8>,
    /// All blades at full detail, 64 samples a pixel, averaged in linear light; slow
    #[arg(long, conflicts_with_all = ["samples", "culling"])]
    reference: bool,
}

/// Physical models.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
pub enum Physics {
    /// Exact step, constant length, any size of plant
    Sward,
    /// As in the paper of Jahrmann and Wimmer
    Paper,
}

/// Ways to cull.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
pub enum CullingChoice {
    /// By what shows
    Sward,
    /// As in the paper of Jahrmann and Wimmer
    Paper,
    /// Draw every blade
    Off,
}

/// Writes the pictures.
pub fn run(args: Args, quiet: bool) -> Result<()> {
    let output = Output::parse(&args.output)?;
    if args.frames.as_ref().is_some_and(|f| f.0.len() > 1) && !output.is_sequence() {
        let shown = args.output.display();
        bail!("-o {shown}: several frames need a number in the name, such as f/%04d.png");
    }
    if args.frames.is_none() && output.is_sequence() {
        bail!("-o {}: a name with a number needs --frames A..B", args.output.display());
    }
    let scene = load(&args.scene)?;
    let gpu = Gpu::headless()?;
    let options = options(&args, &scene, &gpu)?;
    output.prepare()?;
    let (fields, grow_s) = grow_timed(&scene, &gpu, Default::default(), quiet)?;
    let blades = blade_count(&fields);
    let samples = if options.reference { 64 } else { options.samples };
    let start = Instant::now();
    let mut stage = Stage::new(&gpu, &scene, &fields, options)?;
    drop(fields);
    tell_notes(&scene, quiet);
    let clock = Clock::new(args.fps.unwrap_or_else(|| f64::from(scene.fps)));
    match &args.frames {
        None => {
            render_single(&mut stage, clock, args.time, &output, quiet)?;
        }
        Some(frames) => render_frames(&mut stage, clock, &frames.0, &output, quiet)?,
    }
    if !quiet {
        let render_s = start.elapsed().as_secs_f64();
        let Size([width, height]) = args.size;
        writeln!(
            std::io::stdout(),
            "{}: {width} x {height}, {samples} samples, {} blades; grown in {grow_s:.1} s, \
             rendered in {render_s:.1} s",
            what(&args),
            thousands(blades),
        )?;
    }
    Ok(())
}

fn what(args: &Args) -> String {
    let path = args.output.display();
    match &args.frames {
        Some(Frames(frames)) if frames.len() > 1 => {
            format!("{path} ({} frames, {} to {})", frames.len(), frames.start, frames.end - 1)
        }
        _ => path.to_string(),
    }
}

fn options(args: &Args, scene: &Scene, gpu: &Gpu) -> Result<StageOptions> {
    gpu.check_size(args.size.0)?;
    let samples = gpu.choose_samples(args.samples)?;
    let mut options = StageOptions::new(scene, args.camera.as_deref(), args.size.0, samples)?;
    options.reference = args.reference;
    options.level = args.level;
    match args.physics {
        Some(Physics::Sward) => options.physics = PhysicsModel::Sward,
        Some(Physics::Paper) => options.physics = PhysicsModel::Paper,
        None => {}
    }
    let culling = &mut options.culling;
    match args.culling {
        Some(CullingChoice::Sward) => culling.paper = false,
        Some(CullingChoice::Paper) => culling.paper = true,
        Some(CullingChoice::Off) => *culling = sward_app::stage::no_culling(*culling),
        None => {}
    }
    Ok(options)
}

fn render_single(
    stage: &mut Stage,
    clock: Clock,
    time_s: f64,
    output: &Output,
    quiet: bool,
) -> Result<()> {
    let bar = progress::bar(quiet, "rendering", clock.until(time_s).count() as u64 + 1);
    stage.warm_up()?;
    for dt_s in clock.until(time_s) {
        stage.step(dt_s)?;
        bar.step();
    }
    write_picture(&output.file(0), &stage.render()?)
}

fn render_frames(
    stage: &mut Stage,
    clock: Clock,
    frames: &std::ops::Range<u32>,
    output: &Output,
    quiet: bool,
) -> Result<()> {
    let bar = progress::bar(quiet, "frames", u64::from(frames.end));
    stage.warm_up()?;
    for frame in 0..frames.end {
        if frame > 0 {
            clock.frame().try_for_each(|dt_s| stage.step(dt_s))?;
        }
        if frames.contains(&frame) {
            write_picture(&output.file(frame), &stage.render()?)?;
        }
        bar.step();
    }
    Ok(())
}
