//! `sward paper`: the evaluation of Jahrmann and Wimmer (2017) with one command.

mod evaluate;
mod figures;
mod grid;
mod page;
mod published;
mod quantity;
mod tables;

use super::{load, tell_notes};
use crate::args::Size;
use crate::{output, progress};
use anyhow::{Context, Result, bail};
use evaluate::{Settings, evaluate};
use figures::{Folders, Outcome};
use page::Page;
use published::Published;
use quantity::SceneName;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;
use sward_app::gpu::Gpu;
use sward_scene::Scene;
use tables::Results;

const EXAMPLES: &str = "\
Examples:
  sward paper -o paper                   # then open paper/index.html
  sward paper -o paper --quick           # small pictures, few frames: to see that it works
  sward paper -o paper --size 1920x1080 --frames 120 --samples 4
  sward paper -o paper --published my-copy.ron";

/// Run the evaluation of Jahrmann and Wimmer 2017: tables, pictures and a page of them
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Folder to write to; its files of the same names are replaced
    #[arg(long, short, value_name = "DIR")]
    output: PathBuf,
    /// Folder of the scenes [default: ./scenes, else the one beside the program]
    #[arg(long, value_name = "DIR")]
    scenes: Option<PathBuf>,
    /// Size in pixels of what is measured; pictures are as wide, 16 to 9 [default: 1024x768; quick:
    /// 160x120]
    #[arg(long, value_name = "WxH")]
    size: Option<Size>,
    /// Frames to measure as a whole, and as many again by stage [default: 30; quick: 2]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    frames: Option<u32>,
    /// Samples a pixel of what is measured; pictures have what `render` gives them
    #[arg(long, value_name = "N", default_value_t = 1)]
    samples: u32,
    /// The paper's own numbers [default: those that come with the program]
    #[arg(long, value_name = "FILE")]
    published: Option<PathBuf>,
    /// The tables only: no picture is drawn
    #[arg(long)]
    no_pictures: bool,
    /// Small pictures and few frames; the times say little then
    #[arg(long)]
    quick: bool,
}

/// Writes the tables, the pictures and the page.
pub fn run(args: Args, quiet: bool) -> Result<()> {
    let start = Instant::now();
    let published = match &args.published {
        Some(path) => Published::read(path)?,
        None => Published::built_in()?,
    };
    let folder = scenes_folder(args.scenes.as_deref())?;
    let scenes = SceneName::ALL.map(|name| {
        load(&folder.join(name.key()).with_extension("ron")).map(|scene| (name, scene))
    });
    let scenes = scenes.into_iter().collect::<Result<Vec<_>>>()?;
    let (size, frames) = if args.quick { ([160, 120], 2) } else { ([1024, 768], 30) };
    let size = args.size.map_or(size, |Size(size)| size);
    let gpu = Gpu::headless()?;
    gpu.check_size(size)?;
    let samples = gpu.choose_samples(Some(args.samples))?;
    let settings = Settings { size, samples, frames: args.frames.unwrap_or(frames), quiet };
    if args.output.is_file() {
        bail!("-o {}: is a file; name a folder", args.output.display());
    }
    output::prepare_file("-o", &args.output.join("tables.json"))?;
    let results = measure(&gpu, &scenes, settings, published)?;
    drop(gpu);
    write_tables(&args.output, &results)?;
    let figures = if args.no_pictures { Vec::new() } else { figures::all()? };
    let bar = progress::bar(quiet, "pictures", figures::count(&figures) as u64);
    // The scenes' cameras are set up for this shape.
    let picture = [size[0], (size[0] * 9).div_ceil(16).max(1)];
    let folders = Folders { scenes: &folder, output: &args.output, size: picture };
    let outcomes = figures::draw(&figures, folders, &bar);
    drop(bar);
    write(&args.output, &Page { results: &results, figures: &figures, outcomes: &outcomes })?;
    scenes.iter().for_each(|(_, scene)| tell_notes(scene, quiet));
    if !quiet {
        summary(&args.output, &outcomes, start.elapsed().as_secs_f64())?;
    }
    Ok(())
}

fn measure(
    gpu: &Gpu,
    scenes: &[(SceneName, Scene)],
    settings: Settings,
    published: Published,
) -> Result<Results> {
    let mut runs = Vec::new();
    for (name, scene) in scenes {
        runs.extend(evaluate(gpu, *name, scene, settings)?);
    }
    Results::new(runs, published, settings)
}

/// The tables do not wait for the pictures, which take longer.
fn write_tables(folder: &Path, results: &Results) -> Result<()> {
    output::write_json(&folder.join("tables.json"), &results.json())?;
    output::write_text(&folder.join("tables.md"), &results.markdown())
}

/// The page comes last: where it is there, all that it links to is.
fn write(folder: &Path, page: &Page) -> Result<()> {
    output::write_text(&folder.join("index.md"), &page.markdown())?;
    output::write_text(&folder.join("index.html"), &page.html())
}

fn summary(folder: &Path, outcomes: &[Vec<Outcome>], seconds: f64) -> Result<()> {
    let drawn = |outcome: &&Outcome| matches!(outcome, Outcome::Drawn(_));
    let all = outcomes.iter().map(Vec::len).sum::<usize>();
    let drawn = outcomes.iter().flatten().filter(drawn).count();
    writeln!(
        std::io::stdout(),
        "{}: tables and {drawn} of {all} pictures in {seconds:.0} s",
        folder.join("index.html").display()
    )?;
    Ok(())
}

/// The folder of the scenes: the one named, else one here, else one above the program's own.
fn scenes_folder(named: Option<&Path>) -> Result<PathBuf> {
    if let Some(named) = named {
        if !named.is_dir() {
            bail!("--scenes {}: is not a folder", named.display());
        }
        return Ok(named.into());
    }
    let program = std::env::current_exe().context("the program's own place is not known")?;
    let around = program.ancestors().skip(1).map(|folder| folder.join("scenes"));
    let is_one = |folder: &PathBuf| folder.join("nature.ron").is_file();
    match std::iter::once(PathBuf::from("scenes")).chain(around).find(is_one) {
        Some(folder) => Ok(folder),
        None => bail!(
            "no folder 'scenes' with nature.ron here or beside the program; name it with \
                       --scenes DIR"
        ),
    }
}
