//! Where pictures go. A picture is written beside its final name and renamed when it is whole, so
//! that nobody ever sees half of one.

use anyhow::{Context, Result, bail};
use image::RgbImage;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// The names of one picture or of a sequence.
#[derive(Debug, Clone, PartialEq)]
pub enum Output {
    /// One file.
    Single(PathBuf),
    /// A file a frame: text before the number, its least width, text after it.
    Sequence {
        /// Path up to the number.
        before: String,
        /// Digits at least, filled up with zeros.
        width: usize,
        /// Path after the number.
        after: String,
    },
}

impl Output {
    /// Understands `FILE.png` and `f/%04d.png`.
    ///
    /// # Errors
    /// Where the format is unknown or the pattern is broken.
    pub fn parse(path: &Path) -> Result<Self> {
        let shown = path.display();
        match path.extension().and_then(|e| e.to_str()).map(str::to_lowercase).as_deref() {
            Some("png") => {}
            Some(format @ ("mp4" | "gif")) => {
                bail!("-o {shown}: {format} is not written yet; use a sequence such as f/%04d.png")
            }
            Some(_) => bail!("-o {shown}: unknown format; pictures are written as .png"),
            None => bail!("-o {shown}: the name has no extension; pictures are written as .png"),
        }
        let Some(text) = path.to_str().filter(|text| text.contains('%')) else {
            return Ok(Self::Single(path.into()));
        };
        match pattern(text) {
            Some(sequence) => Ok(sequence),
            None => bail!(
                "-o {shown}: '%' stands for the frame's number, once, as %d or %04d; write %% for \
                 the sign itself"
            ),
        }
    }

    /// Whether each frame has a file of its own.
    pub fn is_sequence(&self) -> bool {
        matches!(self, Self::Sequence { .. })
    }

    /// The file of a frame.
    pub fn file(&self, frame: u32) -> PathBuf {
        match self {
            Self::Single(path) => path.clone(),
            Self::Sequence { before, width, after } => {
                format!("{before}{frame:0width$}{after}", width = *width).into()
            }
        }
    }

    /// Makes the folder and tries it, so that a mistake shows before the work.
    ///
    /// # Errors
    /// Where nothing can be written there.
    pub fn prepare(&self) -> Result<()> {
        let file = self.file(0);
        if let Some(folder) = file.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            fs::create_dir_all(folder)
                .with_context(|| format!("cannot make the folder {}", folder.display()))?;
        }
        if file.is_dir() {
            bail!("-o {}: is a folder; name a file", file.display());
        }
        Partial::create(&file).map(drop)
    }
}

/// Finds the one `%d` or `%0Nd`; `%%` is the sign itself.
fn pattern(text: &str) -> Option<Output> {
    let mut parts = vec![String::new()];
    let mut width = 0;
    let mut rest = text;
    while let Some((plain, after)) = rest.split_once('%') {
        parts.last_mut()?.push_str(plain);
        if let Some(after) = after.strip_prefix('%') {
            parts.last_mut()?.push('%');
            rest = after;
            continue;
        }
        let (digits, after) = after.split_once('d')?;
        width = match digits {
            "" => 0,
            _ => digits.strip_prefix('0')?.parse().ok().filter(|width| *width <= 20)?,
        };
        parts.push(String::new());
        rest = after;
    }
    parts.last_mut()?.push_str(rest);
    match <[String; 2]>::try_from(parts) {
        Ok([before, after]) => Some(Output::Sequence { before, width, after }),
        // Only doubled signs.
        Err(parts) if parts.len() == 1 => Some(Output::Single(parts.concat().into())),
        Err(_) => None,
    }
}

/// A file under a temporary name, removed unless it is finished.
#[derive(Debug)]
struct Partial {
    file: Option<File>,
    path: PathBuf,
    target: PathBuf,
}

impl Partial {
    fn create(target: &Path) -> Result<Self> {
        let mut name = target.file_name().context("the output has no file name")?.to_os_string();
        name.push(format!(".{}.partial", std::process::id()));
        let path = target.with_file_name(name);
        let file = File::create(&path)
            .with_context(|| format!("-o {}: cannot write there", target.display()))?;
        Ok(Self { file: Some(file), path, target: target.into() })
    }

    fn finish(mut self, write: impl FnOnce(&mut BufWriter<File>) -> Result<()>) -> Result<()> {
        let context = || format!("cannot write {}", self.target.display());
        if let Some(file) = self.file.take() {
            let mut writer = BufWriter::new(file);
            write(&mut writer).with_context(context)?;
            writer.flush().with_context(context)?;
        }
        fs::rename(&self.path, &self.target).with_context(context)
    }
}

impl Drop for Partial {
    fn drop(&mut self) {
        // Gone already where it was finished and renamed.
        let _ = fs::remove_file(&self.path);
    }
}

/// Writes a picture as PNG.
///
/// # Errors
/// Where it cannot be written; then there is no new file.
pub fn write_picture(path: &Path, picture: &RgbImage) -> Result<()> {
    Partial::create(path)?.finish(|writer| {
        let encoder = image::codecs::png::PngEncoder::new(writer);
        Ok(picture.write_with_encoder(encoder)?)
    })
}

/// Writes JSON, with a line break at its end.
///
/// # Errors
/// Where it cannot be written; then there is no new file.
pub fn write_json(path: &Path, value: &impl serde::Serialize) -> Result<()> {
    Partial::create(path)?.finish(|writer| {
        serde_json::to_writer_pretty(&mut *writer, value)?;
        Ok(writeln!(writer)?)
    })
}

/// Tries a file that will be written later.
///
/// # Errors
/// Where nothing can be written there.
pub fn prepare_file(path: &Path) -> Result<()> {
    Output::Single(path.into()).prepare()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(pattern: &str, frame: u32) -> Option<String> {
        Output::parse(Path::new(pattern)).ok().map(|o| o.file(frame).display().to_string())
    }

    #[test]
    fn patterns() {
        assert_eq!(file("a.png", 7).as_deref(), Some("a.png"));
        assert_eq!(file("f/%04d.png", 7).as_deref(), Some("f/0007.png"));
        assert_eq!(file("f/%04d.png", 12345).as_deref(), Some("f/12345.png"));
        assert_eq!(file("f-%d.png", 12).as_deref(), Some("f-12.png"));
        assert_eq!(file("50%%-%02d.png", 3).as_deref(), Some("50%-03.png"));
        assert_eq!(file("50%%.png", 3).as_deref(), Some("50%.png"));
        for bad in ["%s.png", "%d%d.png", "%4d.png", "%.png", "a", "a.jpg", "a.mp4", "%099d.png"] {
            assert_eq!(file(bad, 0), None, "{bad}");
        }
    }
}
