//! Where pictures go. A picture is written beside its final name and renamed when it is whole, so
//! that nobody ever sees half of one.

use crate::video::Format;
use anyhow::{Context, Result, bail};
use image::{Rgb32FImage, RgbImage, RgbaImage};
use std::fs;
use std::path::{Path, PathBuf};

/// The names of one picture or of a sequence.
#[derive(Debug, Clone, PartialEq)]
pub enum Output {
    /// One file.
    Single(PathBuf),
    /// A film.
    Video(PathBuf, Format),
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
    /// Understands `FILE.png`, `f/%04d.png`, `FILE.mp4` and `FILE.gif`.
    ///
    /// # Errors
    /// Where the format is unknown or the pattern is broken.
    pub fn parse(path: &Path) -> Result<Self> {
        Self::parse_as(path, &["png"])
    }

    /// The same, and `.exr` for linear light.
    ///
    /// # Errors
    /// Where the format is unknown or the pattern is broken.
    pub fn parse_or_light(path: &Path) -> Result<Self> {
        Self::parse_as(path, &["png", "exr"])
    }

    fn parse_as(path: &Path, formats: &[&str]) -> Result<Self> {
        let known = formats.join(" or .");
        let shown = path.display();
        match path.extension().and_then(|e| e.to_str()).map(str::to_lowercase).as_deref() {
            Some(format) if formats.contains(&format) => {}
            Some("mp4") => return Ok(Self::Video(path.into(), Format::Mp4)),
            Some("gif") => return Ok(Self::Video(path.into(), Format::Gif)),
            Some(_) => bail!(
                "-o {shown}: unknown format; pictures are written as .{known}, films as .mp4 or .gif"
            ),
            None => {
                bail!("-o {shown}: the name has no extension; pictures are written as .{known}")
            }
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

    /// Checks that it can take as many frames as there are; none: a single picture.
    ///
    /// # Errors
    /// Where frames are missing, or would overwrite each other.
    pub fn check_frames(&self, frames: Option<usize>) -> Result<()> {
        let shown = self.file(0);
        let shown = shown.display();
        match (self, frames) {
            (Self::Single(_), Some(2..)) => {
                bail!("-o {shown}: several frames need a number in the name, such as f/%04d.png")
            }
            (Self::Sequence { .. }, None) => {
                bail!("-o {shown}: a name with a number needs --frames A..B")
            }
            (Self::Video(..), None) => bail!("-o {shown}: a film needs --frames A..B"),
            _ => Ok(()),
        }
    }

    /// The file of a frame.
    pub fn file(&self, frame: u32) -> PathBuf {
        match self {
            Self::Single(path) | Self::Video(path, _) => path.clone(),
            Self::Sequence { before, width, after } => {
                format!("{before}{frame:0width$}{after}", width = *width).into()
            }
        }
    }

    /// Whether it takes linear light, which no screen has to show.
    pub fn is_light(&self) -> bool {
        let file = self.file(0);
        file.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("exr"))
    }

    /// Makes the folder and tries it, so that a mistake shows before the work.
    ///
    /// # Errors
    /// Where nothing can be written there.
    pub fn prepare(&self) -> Result<()> {
        prepare_file("-o", &self.file(0))
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
    path: PathBuf,
    target: PathBuf,
}

impl Partial {
    /// Writes all bytes at once: the temporary file is there for as short a time as can be, so that
    /// hardly any end of the program leaves it behind.
    fn create(target: &Path, bytes: &[u8]) -> Result<Self> {
        let mut name = target.file_name().context("the name ends in no file")?.to_os_string();
        name.push(format!(".{}.partial", std::process::id()));
        let partial = Self { path: target.with_file_name(name), target: target.into() };
        fs::write(&partial.path, bytes).context("cannot write there")?;
        Ok(partial)
    }

    fn finish(self) -> Result<()> {
        fs::rename(&self.path, &self.target).context("cannot write there")
    }
}

impl Drop for Partial {
    fn drop(&mut self) {
        // Gone already where it was finished and renamed.
        let _ = fs::remove_file(&self.path);
    }
}

fn write_file(path: &Path, bytes: &[u8]) -> Result<()> {
    let partial = Partial::create(path, bytes);
    partial.and_then(Partial::finish).with_context(|| path.display().to_string())
}

/// Writes a picture as PNG.
///
/// # Errors
/// Where it cannot be written; then there is no new file.
pub fn write_picture(path: &Path, picture: &RgbImage) -> Result<()> {
    let mut bytes = Vec::new();
    picture.write_with_encoder(image::codecs::png::PngEncoder::new(&mut bytes))?;
    write_file(path, &bytes)
}

/// Writes linear light as OpenEXR, 32 bits a channel.
///
/// # Errors
/// Where it cannot be written; then there is no new file.
pub fn write_light(path: &Path, light: &Rgb32FImage) -> Result<()> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    light.write_with_encoder(image::codecs::openexr::OpenExrEncoder::new(&mut bytes))?;
    write_file(path, bytes.get_ref())
}

/// Writes a picture with alpha as PNG.
///
/// # Errors
/// Where it cannot be written; then there is no new file.
pub fn write_texture(path: &Path, picture: &RgbaImage) -> Result<()> {
    let mut bytes = Vec::new();
    picture.write_with_encoder(image::codecs::png::PngEncoder::new(&mut bytes))?;
    write_file(path, &bytes)
}

/// Writes JSON, with a line break at its end.
///
/// # Errors
/// Where it cannot be written; then there is no new file.
pub fn write_json(path: &Path, value: &impl serde::Serialize) -> Result<()> {
    let mut bytes = serde_json::to_vec_pretty(value)?;
    bytes.push(b'\n');
    write_file(path, &bytes)
}

/// Writes bytes.
///
/// # Errors
/// Where it cannot be written; then there is no new file.
pub fn write_bytes(path: &Path, bytes: &[u8]) -> Result<()> {
    write_file(path, bytes)
}

/// Writes text.
///
/// # Errors
/// Where it cannot be written; then there is no new file.
pub fn write_text(path: &Path, text: &str) -> Result<()> {
    write_file(path, text.as_bytes())
}

/// Makes the folder of a file that will be written later, and tries it. `option` names it in
/// messages.
///
/// # Errors
/// Where nothing can be written there.
pub fn prepare_file(option: &str, path: &Path) -> Result<()> {
    try_file(path).with_context(|| format!("{option} {}", path.display()))
}

fn try_file(path: &Path) -> Result<()> {
    // `Path` itself passes over a separator at the end.
    let is_folder = path.as_os_str().as_encoded_bytes().ends_with(b"/") || path.is_dir();
    if is_folder {
        bail!("is a folder; name a file");
    }
    // A rename would put a file in the place of a device or a pipe.
    if fs::metadata(path).is_ok_and(|about| !about.is_file()) {
        bail!("is not a file; name another");
    }
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        fs::create_dir_all(folder)
            .with_context(|| format!("cannot make the folder {}", folder.display()))?;
    }
    Partial::create(path, &[]).map(drop)
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
        let light = Output::parse_or_light(Path::new("light/%d.EXR"));
        assert!(light.is_ok_and(|output| output.is_light()));
        for bad in ["%s.png", "%d%d.png", "%4d.png", "%.png", "a", "a.jpg", "a.exr", "%099d.png"] {
            assert_eq!(file(bad, 0), None, "{bad}");
        }
    }
}
