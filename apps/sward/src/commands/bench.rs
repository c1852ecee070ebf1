//! `sward bench`: what a scene costs.

mod report;

use super::{grow_timed, load_lit, tell_notes};
use crate::args::Size;
use crate::light::LightChoice;
use crate::measure::{self, Measured, Report};
use crate::output;
use crate::progress;
use crate::technique::TechniqueChoice;
use anyhow::{Context, Result, bail};
use clap::ValueEnum;
use std::io::Write;
use std::path::PathBuf;
use sward_app::gpu::Gpu;
use sward_app::grow::{GrowOptions, blade_count};
use sward_app::stage::{Stage, StageOptions, no_culling};
use sward_scene::Scene;

const EXAMPLES: &str = "\
Examples:
  sward bench scenes/reference.ron --size 1024x768 --samples 1
  sward bench scenes/reference.ron --without collisions --json new.json --compare old.json
  sward bench scenes/meadow.ron --patch-sizes 64,128,256,512,1024";

/// Measure what a scene costs: time by stage, blades by what became of them, memory
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Scene file (RON)
    scene: PathBuf,
    /// Frames to measure, after as many again (at most 20) to warm up
    #[arg(long, value_name = "N", default_value_t = 60,
          value_parser = clap::value_parser!(u32).range(1..=100_000))]
    frames: u32,
    /// Size in pixels
    #[arg(long, value_name = "WxH", default_value = "1024x768")]
    size: Size,
    /// Samples a pixel [default: 4 where the adapter has it]
    #[arg(long, value_name = "N")]
    samples: Option<u32>,
    /// Camera of the scene [default: its first]
    #[arg(long, value_name = "NAME")]
    camera: Option<String>,
    /// Light it by this, in place of the scene's own light
    #[arg(long, value_enum, value_name = "PRESET")]
    light: Option<LightChoice>,
    /// Which forms plants are drawn in [default: the scene's]
    #[arg(long, value_enum, value_name = "NAME")]
    technique: Option<TechniqueChoice>,
    /// Scale the scene's densities and counts to about this many blades
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    blades: Option<u64>,
    /// Leave something out; may be given several times
    #[arg(long, value_enum, value_name = "WHAT")]
    without: Vec<Without>,
    /// Measure once for each of these patch sizes
    #[arg(long, value_name = "N,N,...", value_delimiter = ',')]
    patch_sizes: Vec<u32>,
    /// Write the numbers to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Show the change since the numbers in this file
    #[arg(long, value_name = "FILE")]
    compare: Option<PathBuf>,
}

/// What can be left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Without {
    /// Spheres push no blades
    Collisions,
    /// No test culls
    Culling,
    /// Blades hidden by things are drawn
    Occlusion,
    /// Blades out of view are drawn
    Frustum,
    /// Blades are not thinned with distance
    Distance,
    /// Blades seen edge-on are drawn
    Orientation,
    /// Time stands still
    Physics,
}

/// Measures and prints.
pub fn run(args: Args, quiet: bool) -> Result<()> {
    let baseline = args.compare.as_deref().map(report::read).transpose()?;
    let scene = load_lit(&args.scene, args.light)?;
    let gpu = Gpu::headless()?;
    gpu.check_size(args.size.0)?;
    let samples = gpu.choose_samples(args.samples)?;
    let options = options(&args, &scene, samples)?;
    if let Some(path) = &args.json {
        output::prepare_file("--json", path)?;
    }
    let density_scale = density_scale(&args, &scene, &gpu, quiet)?;
    let mut out = std::io::stdout();
    let mut reports = Vec::new();
    let sizes: Vec<_> = match args.patch_sizes.as_slice() {
        [] => vec![None],
        sizes => sizes.iter().copied().map(Some).collect(),
    };
    for patch_size in sizes {
        let grow = GrowOptions { density_scale, patch_size };
        reports.push(measure_once(&args, &gpu, &scene, &options, grow, quiet)?);
    }
    tell_notes(&scene, quiet);
    let Some(first) = reports.first() else { bail!("--patch-sizes: no sizes") };
    write!(out, "{}", report::tables(first, baseline.as_ref()))?;
    if !args.patch_sizes.is_empty() {
        write!(out, "\n{}", report::sweep_table(&reports))?;
    }
    if let Some(path) = &args.json {
        output::write_json(path, &report::json(&reports))?;
    }
    Ok(())
}

fn options(args: &Args, scene: &Scene, samples: u32) -> Result<StageOptions> {
    let mut options = StageOptions::new(scene, args.camera.as_deref(), args.size.0, samples)?;
    options.technique = args.technique.map_or(options.technique, Into::into);
    for without in &args.without {
        let culling = &mut options.culling;
        match without {
            Without::Collisions => options.collisions = false,
            Without::Culling => *culling = no_culling(*culling),
            Without::Occlusion => culling.occlusion = false,
            Without::Frustum => culling.frustum = false,
            Without::Distance => culling.distance = false,
            Without::Orientation => culling.orientation = false,
            // Read when the frames are measured.
            Without::Physics => {}
        }
    }
    Ok(options)
}

/// What to multiply the densities and counts by, found by growing once.
fn density_scale(args: &Args, scene: &Scene, gpu: &Gpu, quiet: bool) -> Result<Option<f64>> {
    let Some(wanted) = args.blades else { return Ok(None) };
    let (fields, _) = grow_timed(scene, gpu, GrowOptions::default(), quiet)?;
    match blade_count(&fields) {
        0 => bail!("--blades: nothing grows in this scene"),
        grown => Ok(Some(wanted as f64 / grown as f64)),
    }
}

fn measure_once(
    args: &Args,
    gpu: &Gpu,
    scene: &Scene,
    options: &StageOptions,
    grow: GrowOptions,
    quiet: bool,
) -> Result<Report> {
    let (fields, grow_s) = grow_timed(scene, gpu, grow, quiet)?;
    let patch_size = fields.first().map_or(0, sward::Field::patch_size);
    let mut stage = Stage::new(gpu, scene, &fields, options.clone())?;
    drop(fields);
    let steps = u64::from(measure::frames_run(args.frames));
    let bar = progress::bar(quiet, "measuring", steps);
    stage.warm_up()?;
    let still = args.without.contains(&Without::Physics);
    let times = measure::measure(gpu, &mut stage, args.frames, still, &|| bar.step())?;
    let statistics = measure::statistics(gpu, &mut stage, still)?
        .context("the device gave no statistics back")?;
    let (gpu_bytes, blade_bytes) = stage.gpu_bytes();
    let names = args.without.iter().filter_map(Without::to_possible_value);
    Ok(Report::new(
        gpu,
        scene,
        options,
        names.map(|name| name.get_name().to_string()).collect(),
        Measured { times, statistics, gpu_bytes, blade_bytes, patch_size, grow_s },
    ))
}
