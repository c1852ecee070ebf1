//! `sward compare`: how different two pictures look.

use crate::{input, output};
use anyhow::{Context, Result, bail};
use image::{ImageFormat, ImageReader, RgbImage};
use std::io::{BufReader, Write};
use std::path::{Path, PathBuf};
use sward_app::compare::flip;

const EXAMPLES: &str = "\
Examples:
  sward compare truth.png meadow.png
  sward compare truth.png meadow.png --json flip.json";

/// Compare two pictures by FLIP (0 looks equal, 1 is as different as can be)
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Reference picture
    reference: PathBuf,
    /// Picture to test
    test: PathBuf,
    /// Write the numbers to this file too
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Prints the comparison.
pub fn run(args: Args) -> Result<()> {
    let (reference, test) = (open(&args.reference)?, open(&args.test)?);
    let result = flip(&reference, &test)
        .with_context(|| format!("{} and {}", args.reference.display(), args.test.display()))?;
    if let Some(path) = &args.json {
        output::prepare_file("--json", path)?;
        output::write_json(path, &serde_json::json!({ "flip": result }))?;
    }
    writeln!(
        std::io::stdout(),
        "FLIP mean {:.4}, 99th percentile {:.4}, largest {:.4}",
        result.mean,
        result.p99,
        result.max
    )?;
    Ok(())
}

fn open(path: &Path) -> Result<RgbImage> {
    let shown = || path.display().to_string();
    let file = input::open(path).with_context(shown)?;
    let reader =
        ImageReader::new(BufReader::new(file)).with_guessed_format().with_context(shown)?;
    if reader.format() != Some(ImageFormat::Png) {
        bail!("{}: is no PNG picture", shown());
    }
    Ok(reader.decode().with_context(shown)?.into_rgb8())
}
