//! `sward texture`: the pictures that the library paints of its plants.

mod sheets;

use crate::args;
use crate::output::{Output, prepare_file, write_picture, write_texture};
use anyhow::{Result, bail};
use image::RgbaImage;
use std::io::Write;
use std::path::{Path, PathBuf};
use sward::{Picture, Plant, plants::Angle};

const EXAMPLES: &str = "\
Examples:
  sward texture poppy -o poppy.png
  sward texture daisy -o daisy.png --normal daisy_normal.png --size 512 --seed 3
  sward texture clover -o clover_above.png --above
  sward texture strip -o blade.png
  sward texture atlas -o atlas.png
  sward texture fine-grass -o mips.png --mips";

/// Paint a plant: the texture of a billboard or of a strip, as the library makes it
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// A kind of plant, `strip` for the blade of strips, or `atlas` for all of them with their names
    what: String,
    /// Picture to write: FILE.png, with alpha but for atlas and --mips
    #[arg(long, short)]
    output: PathBuf,
    /// Texels a side, 2 to 4096
    #[arg(long, value_name = "N", default_value_t = 256)]
    size: u32,
    /// Which variant: the same seed gives the same picture
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Write the normals to this file too: red right, green up, blue towards the viewer
    #[arg(long, value_name = "FILE", conflicts_with = "mips")]
    normal: Option<PathBuf>,
    /// Seen from above
    #[arg(long, conflicts_with = "turned")]
    above: bool,
    /// How far to go round the plant, degrees
    #[arg(long, value_name = "DEG", value_parser = args::degrees, allow_hyphen_values = true)]
    turned: Option<f32>,
    /// Draw the mips as the alpha test cuts them, of plain means and with their coverage kept, with
    /// the share of each level that shows
    #[arg(long)]
    mips: bool,
}

/// What to paint.
#[derive(Debug, Clone, Copy, PartialEq)]
enum What {
    Plant(Plant),
    Strip,
    Atlas,
}

impl What {
    fn parse(name: &str) -> Result<Self> {
        match name {
            "atlas" => return Ok(Self::Atlas),
            "strip" => return Ok(Self::Strip),
            _ => {}
        }
        if let Some(plant) = Plant::from_name(name) {
            return Ok(Self::Plant(plant));
        }
        let known: Vec<_> = Plant::ALL.iter().map(|plant| plant.name()).collect();
        bail!("no plant '{name}'; there are: {}, strip, atlas", known.join(", "))
    }
}

impl Args {
    fn check(&self, what: What) -> Result<()> {
        let only_plants = |option: &str, given: bool| match what {
            What::Plant(_) => Ok(()),
            _ if !given => Ok(()),
            _ => bail!("{option}: {} has none; name a kind of plant", self.what),
        };
        only_plants("--above", self.above)?;
        only_plants("--turned", self.turned.is_some())?;
        only_plants("--seed", self.seed != 1 && what == What::Strip)?;
        if what == What::Atlas && self.normal.is_some() {
            bail!("--normal: an atlas has none; name a kind of plant");
        }
        if what == What::Atlas && self.mips {
            bail!("--mips: of one kind of plant, not of an atlas");
        }
        if what == What::Atlas && !(32..=1024).contains(&self.size) {
            bail!("--size {}: a picture of an atlas is 32 to 1024 texels a side", self.size);
        }
        if self.mips && !(16..=1024).contains(&self.size) {
            bail!("--size {}: mips are shown of 16 to 1024 texels a side", self.size);
        }
        Ok(())
    }

    fn angle(&self) -> Angle {
        if self.above {
            return Angle::Above;
        }
        Angle::Side { turned: self.turned.unwrap_or(0.0).to_radians() }
    }

    fn paint(&self, what: What) -> Result<Picture> {
        let picture = match what {
            What::Plant(plant) => Picture::paint(plant, self.seed, self.angle(), self.size),
            What::Strip | What::Atlas => Picture::strip(self.size),
        };
        picture.map_err(|error| anyhow::anyhow!("--size {}: {error}", self.size))
    }
}

/// Writes the picture.
pub fn run(args: Args, quiet: bool) -> Result<()> {
    let what = What::parse(&args.what)?;
    args.check(what)?;
    let output = Output::parse(&args.output)?;
    let Output::Single(file) = &output else {
        bail!("-o {}: a texture is one picture; name one .png", args.output.display());
    };
    let normal = args.normal.as_deref();
    if let Some(normal) = normal
        && !matches!(Output::parse(normal), Ok(Output::Single(_)))
    {
        bail!("--normal {}: normals are written as one .png", normal.display());
    }
    if what == What::Atlas {
        output.prepare()?;
        write_picture(file, &sheets::atlas(args.size, args.seed)?)?;
        return tell(quiet, file, &format!("{} plants and the blade of strips", Plant::ALL.len()));
    }
    let picture = args.paint(what)?;
    output.prepare()?;
    if args.mips {
        write_picture(file, &sheets::mips(&args.what, &picture))?;
        return tell(quiet, file, "mips");
    }
    if let Some(normal) = normal {
        prepare_file("--normal", normal)?;
        write_rgba(normal, args.size, picture.normals().unwrap_or_default())?;
    }
    write_rgba(file, args.size, picture.rgba())?;
    tell(quiet, file, &format!("{0} x {0}", args.size))
}

fn write_rgba(file: &Path, size: u32, bytes: &[u8]) -> Result<()> {
    let Some(image) = RgbaImage::from_raw(size, size, bytes.to_vec()) else {
        bail!("{}: a picture of {size} x {size} is not whole", file.display());
    };
    write_texture(file, &image)
}

fn tell(quiet: bool, file: &Path, what: &str) -> Result<()> {
    if !quiet {
        writeln!(std::io::stdout(), "{}: {what}", file.display())?;
    }
    Ok(())
}
