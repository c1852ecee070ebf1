//! Films, through ffmpeg: frames go to it as they are drawn.

use anyhow::{Context, Result, bail};
use image::RgbImage;
use std::ffi::OsString;
use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::thread::JoinHandle;

/// Formats that ffmpeg writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// H.264, 4:2:0, so that every player shows it.
    Mp4,
    /// A palette for each frame: one for all would keep every frame in memory until the end.
    Gif,
}

/// A GIF's delays are hundredths of a second, and players slow down those of one.
const GIF_FPS: f64 = 50.0;

impl Format {
    /// What a size becomes, and why, where it is not written as it is.
    pub fn fitted(self, [width, height]: [u32; 2]) -> ([u32; 2], Option<String>) {
        let even = [width & !1, height & !1];
        if self == Self::Gif || even == [width, height] {
            return ([width, height], None);
        }
        let [w, h] = even;
        (even, Some(format!("{width} x {height} is cropped to {w} x {h}: H.264 needs even sides")))
    }

    /// What of a film is not written as it was asked for.
    fn note(self, size: [u32; 2], fps: f64) -> Option<String> {
        let faster = self == Self::Gif && fps > GIF_FPS;
        let rate = || format!("a GIF shows at most {GIF_FPS} of the {fps:.0} frames a second");
        self.fitted(size).1.or_else(|| faster.then(rate))
    }

    fn arguments(self, [width, height]: [u32; 2], fps: f64) -> Vec<String> {
        let filter = match self {
            // The matrix that the stream then is labelled with
            Self::Mp4 => format!("crop={width}:{height}:0:0,scale=out_color_matrix=bt709"),
            Self::Gif => {
                let rate = if fps > GIF_FPS { format!("fps={GIF_FPS},") } else { String::new() };
                format!(
                    "{rate}split[a][b];[a]palettegen=stats_mode=single[p];\
                     [b][p]paletteuse=new=1:dither=bayer:bayer_scale=4"
                )
            }
        };
        let own: &[&str] = match self {
            Self::Mp4 => &[
                "-c:v",
                "libx264",
                "-crf",
                "16",
                "-preset",
                "medium",
                "-pix_fmt",
                "yuv420p",
                "-colorspace",
                "bt709",
                "-color_primaries",
                "bt709",
                "-color_trc",
                "bt709",
                "-movflags",
                "+faststart",
                "-f",
                "mp4",
            ],
            Self::Gif => &["-f", "gif"],
        };
        ["-filter_complex", &filter].iter().chain(own).map(|part| (*part).into()).collect()
    }
}

/// A film on its way.
#[derive(Debug)]
pub struct Video {
    target: PathBuf,
    partial: PathBuf,
    note: Option<String>,
    ffmpeg: Child,
    frames: Option<ChildStdin>,
    said: Option<JoinHandle<String>>,
    finished: bool,
}

impl Video {
    /// Starts ffmpeg, so that a mistake shows before the work.
    ///
    /// # Errors
    /// Where there is no ffmpeg, or the size is too small.
    pub fn start(target: &Path, format: Format, size: [u32; 2], fps: f64) -> Result<Self> {
        let shown = target.display();
        let (fitted, _) = format.fitted(size);
        if fitted.contains(&0) {
            bail!("-o {shown}: H.264 needs at least 2 pixels a side");
        }
        let mut name = target.file_name().context("the name ends in no file")?.to_os_string();
        name.push(format!(".{}.partial", std::process::id()));
        let partial = target.with_file_name(name);
        let [width, height] = size;
        let mut command = Command::new("ffmpeg");
        command
            .args(["-nostdin", "-hide_banner", "-loglevel", "error", "-bitexact"])
            .args(["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", &format!("{width}x{height}")])
            .args(["-r", &format!("{fps:.6}"), "-i", "pipe:0", "-an"])
            .args(format.arguments(fitted, fps))
            .args(["-bitexact", "-y"])
            .arg(as_file(&partial))
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped());
        let mut ffmpeg = match command.spawn() {
            Ok(child) => child,
            Err(error) if error.kind() == ErrorKind::NotFound => bail!(
                "-o {shown}: needs ffmpeg, which is not on the PATH: install it (Debian and Ubuntu: \
                 apt-get install ffmpeg), or write pictures, such as f/%04d.png"
            ),
            Err(error) => bail!("-o {shown}: ffmpeg cannot be started: {error}"),
        };
        let frames = ffmpeg.stdin.take();
        let said = ffmpeg.stderr.take().map(|mut stderr| {
            std::thread::spawn(move || {
                let mut said = Vec::new();
                // What was said before it broke off is all that can be told
                let _ = stderr.read_to_end(&mut said);
                String::from_utf8_lossy(&said).into_owned()
            })
        });
        let (target, note) = (target.into(), format.note(size, fps));
        Ok(Self { target, partial, note, ffmpeg, frames, said, finished: false })
    }

    /// What of the film is not as it was asked for.
    pub fn note(&self) -> Option<String> {
        self.note.as_ref().map(|note| format!("{}: {note}", self.target.display()))
    }

    /// Adds a frame.
    ///
    /// # Errors
    /// Where ffmpeg has failed; says how.
    pub fn add(&mut self, picture: &RgbImage) -> Result<()> {
        let frames = self.frames.as_mut().context("the film is finished")?;
        match frames.write_all(picture.as_raw()) {
            Ok(()) => Ok(()),
            // It ended early: it has said why
            Err(_) => self.end(),
        }
    }

    /// Ends the film and puts it in its place.
    ///
    /// # Errors
    /// Where ffmpeg has failed; then there is no new file.
    pub fn finish(mut self) -> Result<()> {
        self.end()?;
        std::fs::rename(&self.partial, &self.target)
            .with_context(|| format!("{}: cannot write there", self.target.display()))?;
        self.finished = true;
        Ok(())
    }

    /// Waits for ffmpeg to end.
    fn end(&mut self) -> Result<()> {
        drop(self.frames.take());
        let status = self.ffmpeg.wait().context("ffmpeg cannot be waited for")?;
        let said = self.said.take().and_then(|said| said.join().ok()).unwrap_or_default();
        if status.success() {
            return Ok(());
        }
        let last = said.lines().rev().map(str::trim).find(|line| !line.is_empty());
        let cause = last.map_or_else(|| status.to_string(), str::to_string);
        bail!("{}: ffmpeg failed: {cause}", self.target.display())
    }
}

/// A path that ffmpeg takes as one, whatever it starts with: it would read `12:30.mp4` as a protocol
/// and `-a.mp4` as an option.
fn as_file(path: &Path) -> OsString {
    let mut name = OsString::from("file:");
    name.push(path);
    name
}

impl Drop for Video {
    fn drop(&mut self) {
        if self.finished {
            return;
        }
        drop(self.frames.take());
        // It may have ended by itself, and left no file
        let _ = self.ffmpeg.kill();
        let _ = self.ffmpeg.wait();
        let _ = std::fs::remove_file(&self.partial);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_films_that_need_it_are_cropped() {
        assert_eq!(Format::Mp4.fitted([640, 360]), ([640, 360], None));
        assert_eq!(Format::Gif.fitted([641, 361]), ([641, 361], None));
        let (size, note) = Format::Mp4.fitted([641, 361]);
        assert_eq!(size, [640, 360]);
        assert!(note.unwrap().contains("641 x 361 is cropped to 640 x 360"));
    }

    #[test]
    fn a_gif_that_leaves_frames_out_says_so() {
        assert_eq!(Format::Gif.note([641, 361], 50.0), None);
        assert_eq!(Format::Mp4.note([640, 360], 60.0), None);
        let note = Format::Gif.note([640, 360], 60.0);
        assert_eq!(note.as_deref(), Some("a GIF shows at most 50 of the 60 frames a second"));
    }
}
