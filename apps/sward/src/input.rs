//! Files that are read as a whole.

use anyhow::{Result, bail};
use std::fs::File;
use std::path::Path;

/// Opens a regular file; a folder, a device or a pipe could be read for ever.
///
/// # Errors
/// Where it is none or cannot be read.
pub fn open(path: &Path) -> Result<File> {
    // Asked before it is opened: opening a pipe waits for its writer.
    if !std::fs::metadata(path)?.is_file() {
        bail!("is not a file");
    }
    Ok(File::open(path)?)
}
