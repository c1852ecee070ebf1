//! `sward sheet`: scenes in every light, side by side.

use super::{grow_timed, load, tell_notes};
use crate::args::Size;
use crate::output::{Output, write_picture};
use crate::progress;
use anyhow::{Result, bail};
use std::io::Write;
use std::path::PathBuf;
use sward_app::gpu::Gpu;
use sward_app::picture::Sheet;
use sward_app::stage::{Stage, StageOptions};
use sward_scene::{LightPreset, Scene};

const EXAMPLES: &str = "\
Examples:
  sward sheet -o lights.png
  sward sheet scenes/nature.ron scenes/plain.ron -o two.png --size 256x192";

/// Most scenes of one sheet: its picture must fit a file that viewers open.
const MOST_SCENES: usize = 32;

/// Draw scenes in all lights that `--light` knows, a row a scene
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Scene files (RON)
    #[arg(default_values = ["scenes/meadow.ron", "scenes/reference.ron", "scenes/garden.ron"])]
    scenes: Vec<PathBuf>,
    /// Picture to write, FILE.png
    #[arg(long, short)]
    output: PathBuf,
    /// Size of each picture in pixels
    #[arg(long, value_name = "WxH", default_value = "384x216")]
    size: Size,
    /// Samples a pixel [default: 4 where the adapter has it]
    #[arg(long, value_name = "N")]
    samples: Option<u32>,
}

/// Draws and writes.
pub fn run(args: Args, quiet: bool) -> Result<()> {
    let output = Output::parse(&args.output)?;
    let Output::Single(file) = &output else {
        bail!("-o {}: a sheet is one picture; name one .png", args.output.display());
    };
    if args.scenes.len() > MOST_SCENES {
        bail!("{} scenes: at most {MOST_SCENES} fit a sheet", args.scenes.len());
    }
    let scenes: Vec<Scene> = args.scenes.iter().map(|path| load(path)).collect::<Result<_>>()?;
    let gpu = Gpu::headless()?;
    gpu.check_size(args.size.0)?;
    let samples = gpu.choose_samples(args.samples)?;
    output.prepare()?;
    let mut sheet = Sheet::new("", LightPreset::ALL.len() as u32);
    for scene in &scenes {
        sheet = row(sheet, scene, &gpu, (args.size.0, samples), quiet)?;
        tell_notes(scene, quiet);
    }
    let picture = sheet.draw();
    write_picture(file, &picture)?;
    if !quiet {
        let (width, height) = picture.dimensions();
        let (shown, count) = (file.display(), sheet.pictures.len());
        writeln!(std::io::stdout(), "{shown}: {width} x {height}, {count} pictures")?;
    }
    Ok(())
}

/// Adds one scene in every light. It is grown and warmed up once.
fn row(
    mut sheet: Sheet,
    scene: &Scene,
    gpu: &Gpu,
    (size, samples): ([u32; 2], u32),
    quiet: bool,
) -> Result<Sheet> {
    let (fields, _) = grow_timed(scene, gpu, Default::default(), quiet)?;
    let options = StageOptions::new(scene, None, size, samples)?;
    let mut stage = Stage::new(gpu, scene, &fields, options)?;
    drop(fields);
    let bar = progress::bar(quiet, "lighting", LightPreset::ALL.len() as u64);
    stage.warm_up()?;
    for preset in LightPreset::ALL {
        let mut lit = scene.clone();
        lit.set_light(preset);
        stage.relight(&lit)?;
        sheet = sheet.picture(format!("{}: {}", scene.name, preset.name()), stage.render()?);
        bar.step();
    }
    Ok(sheet)
}
