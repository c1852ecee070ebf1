//! `sward wind`: a map of the wind.

use super::{load, tell_notes};
use crate::args::{self, Size};
use crate::output::{Output, write_picture};
use crate::progress;
use anyhow::{Result, bail};
use std::io::Write;
use std::path::PathBuf;
use sward_app::wind_map::{self, MapOptions};

const EXAMPLES: &str = "\
Examples:
  sward wind scenes/helicopter.ron -o wind.png
  sward wind scenes/tornado.ron -o wind.png --time 6 --size 1920x1080
  sward wind scenes/meadow.ron -o high.png --height 10";

/// Draw the wind over a scene's fields, seen from above: strength by colour, direction by arrows
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Scene file (RON)
    scene: PathBuf,
    /// Picture to write: FILE.png
    #[arg(long, short)]
    output: PathBuf,
    /// Size in pixels, up to 16384 a side
    #[arg(long, value_name = "WxH", default_value = "1280x720")]
    size: Size,
    /// Seconds from the scene's start
    #[arg(long, value_name = "S", default_value = "0", value_parser = args::time_s)]
    time: f64,
    /// Height over the fields' ground, metres
    #[arg(long, value_name = "M", default_value = "0.3", value_parser = height_m)]
    height: f32,
}

/// Widest and highest picture: its pixels are kept in memory several times.
const MOST_PIXELS: u32 = 16_384;

fn height_m(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(height) if (0.0..=10_000.0).contains(&height) => Ok(height),
        _ => Err("the height is a number of metres from 0 to 10000".into()),
    }
}

/// Writes the map.
pub fn run(args: Args, quiet: bool) -> Result<()> {
    let output = Output::parse(&args.output)?;
    let Output::Single(file) = &output else {
        bail!("-o {}: a map is one picture; name one .png", args.output.display());
    };
    let Size(size) = args.size;
    if size.iter().any(|side| *side > MOST_PIXELS) {
        bail!("--size {}x{}: at most {MOST_PIXELS} pixels a side", size[0], size[1]);
    }
    let scene = load(&args.scene)?;
    output.prepare()?;
    let options = MapOptions { size, time_s: args.time, height_m: args.height };
    let picture = {
        let _spinner = progress::spinner(quiet, "wind");
        wind_map::draw(&scene, options)?
    };
    tell_notes(&scene, quiet);
    write_picture(file, &picture)?;
    if !quiet {
        let [width, height] = size;
        let count = scene.wind.len();
        let shown = file.display();
        writeln!(std::io::stdout(), "{shown}: {width} x {height}, {count} wind sources")?;
    }
    Ok(())
}
