//! `sward render`: pictures and sequences.

mod frustum;
mod garden;
mod look;
mod places;

use super::{grow_timed, load_lit, tell, tell_notes};
use crate::args::{self, Frames, Gardens, Size};
use crate::light::LightChoice;
use crate::output::{Output, write_light, write_picture};
use crate::progress;
use crate::states::States;
use crate::table::thousands;
use crate::technique::TechniqueChoice;
use crate::video::Video;
use anyhow::{Context, Result, bail};
use look::{DebugChoice, Look};
use std::io::Write;
use std::ops::Range;
use std::path::PathBuf;
use std::time::Instant;
use sward::PhysicsModel;
use sward_app::gpu::Gpu;
use sward_app::grow::blade_count;
use sward_app::stage::{Clock, Stage, StageOptions};
use sward_scene::Scene;

const EXAMPLES: &str = "\
Examples:
  sward render scenes/meadow.ron -o meadow.png
  sward render scenes/meadow.ron -o big.png --size 3840x2160 --time 2.5
  sward render scenes/meadow.ron -o f/%04d.png --frames 0..120 --fps 30
  sward render scenes/balls.ron -o balls.mp4 --frames 0..240
  sward render scenes/balls.ron -o f/%04d.png --frames 0..240 --state-every 60
  sward render scenes/nature.ron -o levels.png --debug level
  sward render scenes/garden.ron -o garden.png --garden 0,0.25,0.5,0.75,1
  sward render scenes/meadow.ron -o evening.png --light golden-hour
  sward render scenes/meadow.ron -o truth.png --reference";

/// Render a scene to a picture, or to a sequence of them
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Scene file (RON)
    scene: PathBuf,
    /// Picture to write: FILE.png, FILE.exr for linear light, or f/%04d.png, where %04d is the frame's own
    /// number; or a film, FILE.mp4 or FILE.gif, by the ffmpeg on the PATH
    #[arg(long, short)]
    output: PathBuf,
    /// Size in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720")]
    size: Size,
    /// Samples a pixel [default: 4 where the adapter has it]
    #[arg(long, value_name = "N")]
    samples: Option<u32>,
    /// Frames A to B - 1; each shows, to the bit, what a run from frame 0 would
    #[arg(long, value_name = "A..B", conflicts_with = "time")]
    frames: Option<Frames>,
    /// Saves the simulation's state every N frames; a later run starts from the newest that fits,
    /// in place of frame 0
    #[arg(long, value_name = "N", requires = "frames", value_parser = clap::value_parser!(u32).range(1..))]
    state_every: Option<u32>,
    /// Folder of the saved states [default: the output's]
    #[arg(long, value_name = "FOLDER", requires = "frames")]
    states: Option<PathBuf>,
    /// Frames a second [default: the scene's, else 30]
    #[arg(long, value_parser = args::fps)]
    fps: Option<f64>,
    /// Time of a single picture, seconds from the scene's start
    #[arg(long, value_name = "S", default_value = "0", value_parser = args::time_s)]
    time: f64,
    /// Camera of the scene [default: its first]
    #[arg(long, value_name = "NAME")]
    camera: Option<String>,
    /// How blades move [default: the scene's]
    #[arg(long, value_enum)]
    physics: Option<Physics>,
    /// Light it by this, in place of the scene's own light
    #[arg(long, value_enum, value_name = "PRESET")]
    light: Option<LightChoice>,
    /// Which forms plants are drawn in [default: the scene's]
    #[arg(long, value_enum, value_name = "NAME")]
    technique: Option<TechniqueChoice>,
    /// How blades are culled [default: the scene's]
    #[arg(long, value_enum)]
    culling: Option<CullingChoice>,
    /// How far plants given by probability go from grassland, 0, to garden, 1; several with commas between
    /// are drawn side by side [default: the scene's]
    #[arg(long, value_name = "0..1", conflicts_with_all = ["frames"])]
    garden: Option<Gardens>,
    /// Draw every blade at one level of detail: 0 to 3 for 8, 4, 2 or 1 segments
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(0..=3))]
    level: Option<u8>,
    /// Show something else in place of the blades' look, with a legend
    #[arg(long, value_enum, value_name = "NAME", conflicts_with = "reference")]
    debug: Option<DebugChoice>,
    /// Cull for this camera of the scene while another one looks on; its frustum is drawn
    #[arg(long, value_name = "NAME", conflicts_with = "reference")]
    culling_camera: Option<String>,
    /// Write the fields' names under them
    #[arg(long)]
    labels: bool,
    /// All blades at full detail, 64 samples a pixel, averaged in linear light; slow
    #[arg(long, conflicts_with_all = ["samples", "culling"])]
    reference: bool,
}

/// Physical models.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
pub enum Physics {
    /// Exact step, constant length, any size of plant
    Sward,
    /// As in the paper of Jahrmann and Wimmer
    Paper,
}

/// Ways to cull.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
pub enum CullingChoice {
    /// By what shows
    Sward,
    /// As in the paper of Jahrmann and Wimmer
    Paper,
    /// Draw every blade
    Off,
}

/// Writes the pictures.
pub fn run(args: Args, quiet: bool) -> Result<()> {
    let output = Output::parse_or_light(&args.output)?;
    if output.is_light() && (args.debug.is_some() || args.labels) {
        bail!("-o {}: linear light has no debug view and no labels", args.output.display());
    }
    output.check_frames(args.frames.as_ref().map(|frames| frames.0.len()))?;
    let mut scene = load_lit(&args.scene, args.light)?;
    let gpu = Gpu::headless()?;
    match args.garden.as_ref().map(|gardens| &gardens.0[..]) {
        None => {}
        Some([garden]) => scene.set_garden(*garden)?,
        Some(gardens) => return garden::run(&args, (&scene, &gpu), gardens, quiet),
    }
    let options = options(&args, &scene, &gpu)?;
    output.prepare()?;
    if args.debug == Some(DebugChoice::Frustum) {
        return map_frustum(&args, &output, (&scene, &gpu, &options), quiet);
    }
    let clock = Clock::new(args.fps.unwrap_or_else(|| f64::from(scene.fps)));
    let mut sink = Sink::open(output, args.size.0, clock.fps())?;
    let states = run_states(&args, &scene, &gpu, &options, clock)?;
    let (fields, grow_s) = grow_timed(&scene, &gpu, Default::default(), quiet)?;
    let blades = blade_count(&fields);
    let samples = if options.reference { 64 } else { options.samples };
    let start = Instant::now();
    let look = Look::new(args.debug, args.labels, (&scene, &fields), &options);
    let mut stage = Stage::new(&gpu, &scene, &fields, options)?;
    drop(fields);
    tell_notes(&scene, quiet);
    if let Some(note) = sink.note().filter(|_| !quiet) {
        tell(&note);
    }
    let mut from = String::new();
    match &args.frames {
        None => render_single((&mut stage, &look), clock, args.time, &mut sink, quiet)?,
        Some(frames) => {
            let mut run =
                FrameRun { stage: &mut stage, look: &look, clock, states: states.as_ref(), quiet };
            let first = run.render(&frames.0, args.state_every, &mut sink)?;
            if first > 0 {
                from = format!("; started from the state of frame {first}");
            }
        }
    }
    sink.finish()?;
    if !quiet {
        let render_s = start.elapsed().as_secs_f64();
        let Size([width, height]) = args.size;
        writeln!(
            std::io::stdout(),
            "{}: {width} x {height}, {samples} samples, {} blades; grown in {grow_s:.1} s, \
             rendered in {render_s:.1} s{from}",
            what(&args),
            thousands(blades),
        )?;
    }
    Ok(())
}

/// `--debug frustum`: a map, for which nothing has to grow.
fn map_frustum(
    args: &Args,
    output: &Output,
    (scene, gpu, options): (&Scene, &Gpu, &StageOptions),
    quiet: bool,
) -> Result<()> {
    if args.frames.is_some() {
        bail!("--debug frustum is one picture, of no time: leave --frames out");
    }
    let (picture, found) = frustum::picture(scene, gpu, options)?;
    write_picture(&output.file(0), &picture)?;
    if !quiet {
        writeln!(std::io::stdout(), "{}: {found}", what(args))?;
    }
    Ok(())
}

fn what(args: &Args) -> String {
    let path = args.output.display();
    match &args.frames {
        Some(Frames(frames)) if frames.len() > 1 => {
            format!("{path} ({} frames, {} to {})", frames.len(), frames.start, frames.end - 1)
        }
        _ => path.to_string(),
    }
}

fn options(args: &Args, scene: &Scene, gpu: &Gpu) -> Result<StageOptions> {
    gpu.check_size(args.size.0)?;
    let samples = gpu.choose_samples(args.samples)?;
    let mut options = StageOptions::new(scene, args.camera.as_deref(), args.size.0, samples)?;
    options.reference = args.reference;
    options.level = args.level;
    Look::prepare(args.debug, &mut options);
    let culls = args.culling_camera.as_deref();
    options.culling_camera = culls.map(|name| scene.camera(Some(name)).cloned()).transpose()?;
    match args.physics {
        Some(Physics::Sward) => options.physics = PhysicsModel::Sward,
        Some(Physics::Paper) => options.physics = PhysicsModel::Paper,
        None => {}
    }
    options.technique = args.technique.map_or(options.technique, Into::into);
    let culling = &mut options.culling;
    match args.culling {
        Some(CullingChoice::Sward) => culling.paper = false,
        Some(CullingChoice::Paper) => culling.paper = true,
        Some(CullingChoice::Off) => *culling = sward_app::stage::no_culling(*culling),
        None => {}
    }
    Ok(options)
}

/// Where frames go.
enum Sink {
    Pictures(Output),
    Film(Box<Video>),
}

impl Sink {
    fn open(output: Output, size: [u32; 2], fps: f64) -> Result<Self> {
        match &output {
            Output::Video(path, format) => {
                Ok(Self::Film(Box::new(Video::start(path, *format, size, fps)?)))
            }
            _ => Ok(Self::Pictures(output)),
        }
    }

    fn note(&self) -> Option<String> {
        match self {
            Self::Pictures(_) => None,
            Self::Film(film) => film.note(),
        }
    }

    /// Takes what the stage shows.
    fn add(&mut self, frame: u32, look: &Look, stage: &mut Stage) -> Result<()> {
        match self {
            Self::Pictures(output) if output.is_light() => {
                write_light(&output.file(frame), &stage.linear_picture()?)
            }
            Self::Pictures(output) => write_picture(&output.file(frame), &look.picture(stage)?),
            Self::Film(film) => film.add(&look.picture(stage)?),
        }
    }

    fn finish(self) -> Result<()> {
        match self {
            Self::Pictures(_) => Ok(()),
            Self::Film(film) => film.finish(),
        }
    }
}

/// The saved states of a run of frames; its folder is made where there will be some.
fn run_states<'a>(
    args: &Args,
    scene: &'a Scene,
    gpu: &Gpu,
    options: &StageOptions,
    clock: Clock,
) -> Result<Option<States<'a>>> {
    if args.frames.is_none() {
        return Ok(None);
    }
    let beside = args.output.parent().map(Into::into).unwrap_or_default();
    let folder: PathBuf = args.states.clone().unwrap_or(beside);
    if args.state_every.is_some() {
        let shown = folder.display();
        std::fs::create_dir_all(&folder)
            .with_context(|| format!("--states {shown}: cannot make the folder"))?;
    }
    Ok(Some(States::new(folder, scene, gpu, options, clock)))
}

fn render_single(
    (stage, look): (&mut Stage, &Look),
    clock: Clock,
    time_s: f64,
    sink: &mut Sink,
    quiet: bool,
) -> Result<()> {
    let bar = progress::bar(quiet, "rendering", clock.until(time_s).count() as u64 + 1);
    stage.warm_up()?;
    for dt_s in clock.until(time_s) {
        stage.step(dt_s)?;
        bar.step();
    }
    sink.add(0, look, stage)
}

/// A run of frames.
struct FrameRun<'a> {
    stage: &'a mut Stage,
    look: &'a Look,
    clock: Clock,
    states: Option<&'a States<'a>>,
    quiet: bool,
}

impl FrameRun<'_> {
    /// Draws; says from which frame on was simulated.
    fn render(&mut self, frames: &Range<u32>, every: Option<u32>, sink: &mut Sink) -> Result<u32> {
        let first = self.start(frames.start)?;
        let bar = progress::bar(self.quiet, "frames", u64::from(frames.end - first));
        for frame in first..frames.end {
            if frame > 0 {
                // The one that it started from is there
                let due = every.is_some_and(|n| frame.is_multiple_of(n)) && frame > first;
                if let Some(states) = self.states.filter(|_| due) {
                    states.save(frame, &self.stage.save_state()?)?;
                }
                self.clock.frame().try_for_each(|dt_s| self.stage.step(dt_s))?;
            }
            if frames.contains(&frame) {
                sink.add(frame, self.look, self.stage)?;
            }
            bar.step();
        }
        Ok(first)
    }

    /// Makes ready for the steps of a frame at or before the one that is wanted; says which.
    fn start(&mut self, wanted: u32) -> Result<u32> {
        if let Some(states) = self.states.filter(|_| wanted > 0) {
            let (clock, stage) = (self.clock, &mut *self.stage);
            let (first, refusal) = states.newest(wanted, |found| {
                let steps = (1..found.frame).flat_map(|_| clock.frame());
                stage.resume(&found.state, steps)
            });
            if let Some(refusal) = refusal.filter(|_| !self.quiet) {
                tell(&refusal);
            }
            if let Some(first) = first {
                return Ok(first);
            }
        }
        self.stage.warm_up()?;
        Ok(0)
    }
}
