//! `sward compare`: how different two pictures look.

use crate::output;
use anyhow::{Context, Result};
use image::RgbImage;
use std::io::Write;
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
    let result = flip(&reference, &test)?;
    if let Some(path) = &args.json {
        output::prepare_file(path)?;
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
    let picture = image::open(path).with_context(|| path.display().to_string())?;
    Ok(picture.into_rgb8())
}
