//! One scene from grassland to garden, side by side.

use super::look::Look;
use super::{Args, options};
use crate::commands::{grow_timed, tell_notes};
use crate::output::{Output, write_picture};
use crate::progress;
use anyhow::{Result, bail};
use std::io::Write;
use sward_app::gpu::Gpu;
use sward_app::picture::Sheet;
use sward_app::stage::{Clock, Stage};
use sward_scene::Scene;

/// Pictures a row.
const COLUMNS: u32 = 3;

/// Draws the scene once for each place between grassland and garden; all else stays as it is.
pub(super) fn run(
    args: &Args,
    (scene, gpu): (&Scene, &Gpu),
    gardens: &[f32],
    quiet: bool,
) -> Result<()> {
    let output = Output::parse(&args.output)?;
    let Output::Single(file) = &output else {
        bail!("--garden: several places make one picture; name one .png");
    };
    output.prepare()?;
    let mut sheet = Sheet::new(format!("{}: from grassland to garden", scene.name), COLUMNS);
    for garden in gardens {
        let mut scene = scene.clone();
        scene.set_garden(*garden)?;
        let options = options(args, &scene, gpu)?;
        let (fields, _) = grow_timed(&scene, gpu, Default::default(), quiet)?;
        let _spinner = progress::spinner(quiet, "rendering");
        let look = Look::new(args.debug, args.labels, (&scene, &fields), &options);
        let mut stage = Stage::new(gpu, &scene, &fields, options)?;
        stage.warm_up()?;
        let clock = Clock::new(args.fps.unwrap_or_else(|| f64::from(scene.fps)));
        clock.until(args.time).try_for_each(|dt_s| stage.step(dt_s))?;
        sheet = sheet.picture(format!("garden: {garden}"), look.picture(&mut stage)?);
    }
    tell_notes(scene, quiet);
    let picture = sheet.draw();
    write_picture(file, &picture)?;
    if !quiet {
        let (width, height) = picture.dimensions();
        let shown = file.display();
        writeln!(std::io::stdout(), "{shown}: {width} x {height}, {} pictures", gardens.len())?;
    }
    Ok(())
}
