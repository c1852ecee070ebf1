//! Saved states of a run, so that a later one need not start from the beginning.
//!
//! A file is one line of JSON, which says what it is of, and then the state itself. It is used only
//! where all of that is as in the run at hand; else the pictures would be others.

use crate::output::write_bytes;
use anyhow::{Result, bail};
use serde::{Deserialize, Serialize};
use std::cell::OnceCell;
use std::fmt::{self, Write};
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use sward_app::gpu::Gpu;
use sward_app::stage::{Clock, StageOptions};
use sward_scene::Scene;

/// The rules by which the command comes from a state to the frame after it: the order and length of
/// steps, how time is added up, where things on paths and bodies are at a time. Releases and shaders
/// are compared by themselves, but between two releases such a rule may change; whoever changes
/// one raises this number, since a state that was made by another rule goes on as no whole run does.
const STATE_VERSION: u32 = 2;
/// Longest first line of a file, bytes.
const MOST_HEAD: u64 = 1 << 16;
/// Longest state, bytes: of some 500 million blades.
const MOST_STATE: u64 = 1 << 32;

/// What a state is of.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Head {
    /// The release that wrote it.
    sward: String,
    /// [`STATE_VERSION`].
    version: u32,
    adapter: String,
    /// Stands for the scene and all that it refers to.
    scene: String,
    /// Camera, size, samples, rates and the rest, in words.
    settings: String,
    /// The frame that comes next.
    frame: u32,
    /// Bytes that follow the line.
    bytes: usize,
    /// Stands for the frame and those bytes.
    content: String,
}

/// The states of one scene in one folder.
#[derive(Debug)]
pub struct States<'a> {
    folder: PathBuf,
    stem: String,
    scene: &'a Scene,
    adapter: String,
    settings: String,
    /// Made when it is first asked for: large meshes take their time.
    of: OnceCell<Head>,
}

/// A state that was found.
#[derive(Debug)]
pub struct Found {
    /// The frame that comes next.
    pub frame: u32,
    /// The stage's own bytes.
    pub state: Vec<u8>,
    path: PathBuf,
}

impl<'a> States<'a> {
    /// Those in a folder, for a run.
    pub fn new(
        folder: PathBuf,
        scene: &'a Scene,
        gpu: &Gpu,
        options: &StageOptions,
        clock: Clock,
    ) -> Self {
        let stem = scene.path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let about = gpu.adapter.get_info();
        let adapter = format!("{} {} {}", about.name, about.driver, about.driver_info);
        let settings = format!("{options:?} {clock:?}");
        Self { folder, stem, scene, adapter, settings, of: OnceCell::new() }
    }

    fn of(&self) -> &Head {
        self.of.get_or_init(|| Head {
            sward: env!("CARGO_PKG_VERSION").into(),
            version: STATE_VERSION,
            adapter: self.adapter.clone(),
            scene: scene_print(self.scene),
            settings: self.settings.clone(),
            frame: 0,
            bytes: 0,
            content: String::new(),
        })
    }

    fn file(&self, frame: u32) -> PathBuf {
        self.folder.join(format!("{}.{frame:06}.state", self.stem))
    }

    /// Saves the state in which a frame is the next.
    ///
    /// # Errors
    /// Where it cannot be written; then there is no new file.
    pub fn save(&self, frame: u32, state: &[u8]) -> Result<()> {
        let content = content_print(frame, state);
        let head = Head { frame, bytes: state.len(), content, ..self.of().clone() };
        let mut bytes = serde_json::to_vec(&head)?;
        bytes.push(b'\n');
        bytes.extend_from_slice(state);
        write_bytes(&self.file(frame), &bytes)
    }

    /// Frames of which there are files, the newest first, up to one.
    fn frames(&self, last: u32) -> Vec<u32> {
        let frame = |entry: std::io::Result<std::fs::DirEntry>| {
            let name = entry.ok()?.file_name().into_string().ok()?;
            let number = name.strip_prefix(&self.stem)?.strip_prefix('.')?;
            number.strip_suffix(".state")?.parse().ok()
        };
        let here = self.folder.as_os_str().is_empty();
        let folder = if here { Path::new(".") } else { &self.folder };
        // A folder that cannot be read holds none
        let entries = std::fs::read_dir(folder).into_iter().flatten();
        let mut frames: Vec<u32> = entries.filter_map(frame).filter(|&f| f <= last).collect();
        frames.sort_unstable_by(|a, b| b.cmp(a));
        frames
    }

    /// The newest state from which `frame` can be reached and that `resume` takes, and why the
    /// newest file is not it.
    pub fn newest(
        &self,
        frame: u32,
        mut resume: impl FnMut(&Found) -> Result<()>,
    ) -> (Option<u32>, Option<String>) {
        let mut refusal = None;
        for candidate in self.frames(frame) {
            let path = self.file(candidate);
            let found = self.read(&path, candidate);
            match found.and_then(|found| resume(&found).map(|()| found)) {
                Ok(found) => return (Some(found.frame), refusal.map(|r| told(r, found.frame))),
                Err(error) => {
                    let shown = path.display();
                    refusal.get_or_insert_with(|| format!("{shown} is not used: {error:#}"));
                }
            }
        }
        (None, refusal.map(|refusal| told(refusal, 0)))
    }

    fn read(&self, path: &Path, frame: u32) -> Result<Found> {
        let mut file = BufReader::new(File::open(path)?);
        let mut line = Vec::new();
        file.by_ref().take(MOST_HEAD).read_until(b'\n', &mut line)?;
        let Ok(head) = serde_json::from_slice::<Head>(&line) else {
            bail!("it is no saved state, or its first line is damaged or of another release");
        };
        self.check(&head)?;
        if head.bytes as u64 > MOST_STATE {
            bail!("it is damaged");
        }
        // One byte more shows what is too long
        let mut state = Vec::new();
        file.take(head.bytes as u64 + 1).read_to_end(&mut state)?;
        if state.len() < head.bytes {
            bail!("it is cut short");
        }
        let sound = state.len() == head.bytes && head.content == content_print(frame, &state);
        if head.frame != frame || !sound {
            bail!("it is damaged");
        }
        Ok(Found { frame, state, path: path.into() })
    }

    /// That a state is of this run.
    fn check(&self, head: &Head) -> Result<()> {
        let of = self.of();
        if head.sward != of.sward {
            bail!("it is of release {}, this is {}", head.sward, of.sward);
        }
        if head.version != of.version {
            bail!("it was made by another version of the simulation");
        }
        if head.adapter != of.adapter {
            bail!("it is of another adapter, {}", head.adapter);
        }
        if head.scene != of.scene {
            bail!("it is of another scene, or the scene has changed");
        }
        if head.settings != of.settings {
            bail!("it is of another camera, size, rate or other setting");
        }
        Ok(())
    }
}

impl fmt::Display for Found {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.path.display().fmt(f)
    }
}

fn told(refusal: String, frame: u32) -> String {
    format!("{refusal}; the run is simulated from frame {frame} on")
}

/// FNV-1a: of all that a value prints.
struct Print(u64);

impl Print {
    fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
}

impl Write for Print {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.add(text.as_bytes());
        Ok(())
    }
}

/// Stands for what the scene's file says and for the meshes that it refers to, but not for where it
/// lies. Of a texture there is the size alone: colours move nothing. Maps that say where blades grow
/// show in the blades, which the state itself is compared by.
fn scene_print(scene: &Scene) -> String {
    let mut print = Print::new();
    let placeless = Scene { path: PathBuf::new(), notes: Vec::new(), ..scene.clone() };
    // Formatting into a number does not fail
    let _ = write!(print, "{placeless:?}");
    format!("{:016x}", print.0)
}

fn content_print(frame: u32, state: &[u8]) -> String {
    let mut print = Print::new();
    print.add(&frame.to_le_bytes());
    print.add(state);
    format!("{:016x}", print.0)
}
