//! The subcommands, one module each.

mod bench;
mod check;
mod compare;
mod info;
mod paper;
mod quality;
mod render;
mod sheet;
mod texture;
mod wind;

use crate::light::LightChoice;
use crate::progress;
use anyhow::Result;
use std::io::Write;
use std::path::Path;
use std::time::Instant;
use sward::Field;
use sward_app::gpu::Gpu;
use sward_app::grow::{GrowOptions, grow};
use sward_scene::Scene;

pub use quality::Exceeded;

/// What to do.
#[derive(Debug, clap::Subcommand)]
pub enum Command {
    Render(render::Args),
    Bench(bench::Args),
    Check(check::Args),
    Compare(compare::Args),
    Info(info::Args),
    Paper(paper::Args),
    Quality(quality::Args),
    Sheet(sheet::Args),
    Texture(texture::Args),
    Wind(wind::Args),
}

/// Runs a subcommand.
pub fn run(command: Command, quiet: bool) -> Result<()> {
    match command {
        Command::Render(args) => render::run(args, quiet),
        Command::Bench(args) => bench::run(args, quiet),
        Command::Check(args) => check::run(args, quiet),
        Command::Compare(args) => compare::run(args),
        Command::Info(args) => info::run(args),
        Command::Paper(args) => paper::run(args, quiet),
        Command::Quality(args) => quality::run(args, quiet),
        Command::Sheet(args) => sheet::run(args, quiet),
        Command::Texture(args) => texture::run(args, quiet),
        Command::Wind(args) => wind::run(args, quiet),
    }
}

fn load(path: &Path) -> Result<Scene> {
    Ok(sward_scene::load(path)?)
}

/// A scene in its own light, or in another one.
fn load_lit(path: &Path, light: Option<LightChoice>) -> Result<Scene> {
    let mut scene = load(path)?;
    if let Some(light) = light {
        scene.set_light(light.into());
    }
    Ok(scene)
}

/// Grows with a spinner; says how many seconds it took.
fn grow_timed(
    scene: &Scene,
    gpu: &Gpu,
    options: GrowOptions,
    quiet: bool,
) -> Result<(Vec<Field>, f64)> {
    let _spinner = progress::spinner(quiet, "growing");
    let start = Instant::now();
    let fields = grow(scene, &gpu.device.limits(), options)?;
    Ok((fields, start.elapsed().as_secs_f64()))
}

/// What is not wrong with a scene but worth telling, on standard error: once it is known to be
/// good, so that an error stands alone.
fn tell_notes(scene: &Scene, quiet: bool) {
    scene.notes.iter().filter(|_| !quiet).for_each(|note| tell(note));
}

/// One line that is worth telling, on standard error.
fn tell(note: &str) {
    // Nothing is left to do where standard error is closed.
    drop(writeln!(std::io::stderr(), "note: {note}"));
}
