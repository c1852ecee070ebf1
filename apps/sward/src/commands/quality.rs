//! `sward quality`: how near a scene's pictures come to its reference.

use super::{grow_timed, load_lit, tell_notes};
use crate::args::Size;
use crate::light::LightChoice;
use crate::technique::TechniqueChoice;
use crate::{output, progress};
use anyhow::{Result, bail};
use std::fmt;
use std::io::Write;
use std::path::PathBuf;
use sward::Field;
use sward_app::gpu::Gpu;
use sward_app::grow::{GrowOptions, blade_count};
use sward_app::quality::{Limits, PATH_STEPS, Part, Settings, markdown, measure, plots, steps};
use sward_app::stage::{StageOptions, no_culling};
use sward_scene::Scene;

const EXAMPLES: &str = "\
Examples:
  sward quality scenes/reference.ron --json quality.json
  sward quality scenes/plain.ron --technique blades --frames 120 --plots plots
  sward quality scenes/meadow.ron --size 320x180 --check";

/// Measure how near a scene's pictures come to its reference (all blades, 64 samples a pixel): from
/// its camera, along three paths, against distance, and standing still
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Scene file (RON)
    scene: PathBuf,
    /// Size in pixels
    #[arg(long, value_name = "WxH", default_value = "480x270")]
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
    /// Measure these parts only
    #[arg(long, value_enum, value_name = "PART,PART,...", value_delimiter = ',')]
    parts: Vec<PartChoice>,
    /// Leave a test out of the pictures that are measured; may be given several times
    #[arg(long, value_enum, value_name = "WHAT")]
    without: Vec<Without>,
    /// Frames of each path, of 120: fewer are runs of four neighbours, spread over the path
    #[arg(long, value_name = "N", default_value_t = Settings::default().path_frames,
          value_parser = clap::value_parser!(u32).range(2..=i64::from(PATH_STEPS)))]
    frames: u32,
    /// Write the numbers to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the tables to this file
    #[arg(long, value_name = "FILE")]
    markdown: Option<PathBuf>,
    /// Write charts and pictures to this folder
    #[arg(long, value_name = "FOLDER")]
    plots: Option<PathBuf>,
    /// Fail, with exit code 1, where drift, jumps or a still camera are beyond their limits
    #[arg(long)]
    check: bool,
}

/// Parts of the measurement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum PartChoice {
    /// The scene camera's picture
    Flip,
    /// Dolly, orbit and fly-down
    Paths,
    /// Coverage, luminance and colour against distance
    Drift,
    /// A camera that stands still
    Still,
}

/// What can be left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Without {
    /// No test culls
    Culling,
    /// Blades are not thinned with distance
    Distance,
    /// Blades seen edge-on are drawn
    Orientation,
}

/// Limits that were exceeded, a line each.
#[derive(Debug)]
pub struct Exceeded(pub Vec<String>);

impl fmt::Display for Exceeded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0.join("\n"))
    }
}

impl std::error::Error for Exceeded {}

/// Measures, prints and writes.
pub fn run(args: Args, quiet: bool) -> Result<()> {
    let scene = load_lit(&args.scene, args.light)?;
    let gpu = Gpu::headless()?;
    gpu.check_size(args.size.0)?;
    let samples = gpu.choose_samples(args.samples)?;
    let options = options(&args, &scene, samples)?;
    prepare(&args)?;
    let fields = grow(&args, &scene, &gpu, quiet)?;
    tell_notes(&scene, quiet);
    let settings = settings(&args);
    let (quality, pictures) = {
        let bar = progress::bar(quiet, "measuring", steps(&settings));
        measure(&gpu, &scene, &fields, &options, &settings, &|| bar.step())?
    };
    let page = markdown(&quality);
    write!(std::io::stdout(), "{page}")?;
    if let Some(path) = &args.json {
        output::write_json(path, &quality)?;
    }
    if let Some(path) = &args.markdown {
        output::write_text(path, &page)?;
    }
    if let Some(folder) = &args.plots {
        for (name, picture) in plots(&quality, &pictures) {
            output::write_picture(&folder.join(name), &picture)?;
        }
    }
    let exceeded = Limits::default().exceeded(&quality);
    if args.check && !exceeded.is_empty() {
        return Err(Exceeded(exceeded).into());
    }
    Ok(())
}

fn options(args: &Args, scene: &Scene, samples: u32) -> Result<StageOptions> {
    let mut options = StageOptions::new(scene, args.camera.as_deref(), args.size.0, samples)?;
    options.technique = args.technique.map_or(options.technique, Into::into);
    for without in &args.without {
        let culling = &mut options.culling;
        match without {
            Without::Culling => *culling = no_culling(*culling),
            Without::Distance => culling.distance = false,
            Without::Orientation => culling.orientation = false,
        }
    }
    Ok(options)
}

fn settings(args: &Args) -> Settings {
    let mut settings = Settings { path_frames: args.frames, ..Settings::default() };
    if !args.parts.is_empty() {
        let part = |choice: &PartChoice| match choice {
            PartChoice::Flip => Part::Flip,
            PartChoice::Paths => Part::Paths,
            PartChoice::Drift => Part::Drift,
            PartChoice::Still => Part::Still,
        };
        settings.parts = args.parts.iter().map(part).collect();
    }
    settings
}

/// Grows the scene, to about as many blades as were asked for.
fn grow(args: &Args, scene: &Scene, gpu: &Gpu, quiet: bool) -> Result<Vec<Field>> {
    let (fields, _) = grow_timed(scene, gpu, GrowOptions::default(), quiet)?;
    let Some(wanted) = args.blades else { return Ok(fields) };
    let grown = blade_count(&fields);
    if grown == 0 {
        bail!("--blades: nothing grows in this scene");
    }
    drop(fields);
    let density_scale = Some(wanted as f64 / grown as f64);
    let scaled = GrowOptions { density_scale, ..GrowOptions::default() };
    Ok(grow_timed(scene, gpu, scaled, quiet)?.0)
}

/// Tries the files before the work.
fn prepare(args: &Args) -> Result<()> {
    let plot = args.plots.as_ref().map(|folder| folder.join("pictures.png"));
    let files = [("--json", &args.json), ("--markdown", &args.markdown), ("--plots", &plot)];
    for (option, path) in files {
        if let Some(path) = path {
            output::prepare_file(option, path)?;
        }
    }
    Ok(())
}
