//! `sward check`: what a scene holds, and whether it fits.

use super::{grow_timed, load, tell_notes};
use crate::table::{Table, thousands};
use anyhow::Result;
use std::io::Write;
use std::path::PathBuf;
use sward_app::gpu::Gpu;
use sward_app::stage::{Stage, StageOptions};

const EXAMPLES: &str = "\
Examples:
  sward check scenes/meadow.ron";

/// Load a scene, grow it, put it on the graphics adapter, and say what it holds
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Scene file (RON)
    scene: PathBuf,
}

/// Prints the summary.
pub fn run(args: Args, quiet: bool) -> Result<()> {
    let scene = load(&args.scene)?;
    let gpu = Gpu::headless()?;
    let (fields, grow_s) = grow_timed(&scene, &gpu, Default::default(), quiet)?;
    let head = ["object", "triangles", "degenerate, dropped", "vertices", "area, m2", "grass"];
    let mut objects = Table::new(head);
    for object in &scene.objects {
        objects.row([
            object.name.clone(),
            thousands(object.mesh.triangles.len() as u64),
            thousands(object.dropped_triangles as u64),
            thousands(object.mesh.positions.len() as u64),
            area(object.area_m2),
            if object.carries_grass { "yes" } else { "no" }.into(),
        ]);
    }
    let mut table = Table::new(["field", "on", "species", "blades", "patches", "blades a patch"]);
    for (field, grown) in scene.fields.iter().zip(&fields) {
        table.row([
            field.name.clone(),
            scene.objects[field.object].name.clone(),
            grown.species().len().to_string(),
            thousands(grown.blades().len() as u64),
            thousands(grown.patches().len() as u64),
            grown.patch_size().to_string(),
        ]);
    }
    let options = StageOptions::new(&scene, None, [64, 64], gpu.choose_samples(None)?)?;
    let stage = Stage::new(&gpu, &scene, &fields, options)?;
    tell_notes(&scene, quiet);
    let cameras: Vec<_> = scene.cameras.iter().map(|camera| camera.name.as_str()).collect();
    let limits = gpu.device.limits();
    let mut out = std::io::stdout();
    write!(out, "{objects}\n{table}\n")?;
    let mut facts = Table::default();
    facts.row(["cameras", &cameras.join(", ")]);
    facts.row(["wind sources", &scene.wind.len().to_string()]);
    facts.row(["spheres", &scene.spheres.len().to_string()]);
    let bodies: usize = scene.bodies.iter().map(sward_scene::BodyGroup::count).sum();
    facts.row(["bodies", &bodies.to_string()]);
    facts.row(["grown in", &format!("{grow_s:.2} s")]);
    facts.row(["GPU memory of the grass", &format!("{} bytes", thousands(stage.gpu_bytes().0))]);
    facts.row(["max_buffer_size", &thousands(limits.max_buffer_size)]);
    facts.row([
        "max_storage_buffer_binding_size",
        &thousands(limits.max_storage_buffer_binding_size),
    ]);
    write!(out, "{facts}")?;
    Ok(())
}

/// Whole square metres of fields, four digits of a pebble.
fn area(m2: f64) -> String {
    if m2 >= 1000.0 {
        return thousands(m2.round() as u64);
    }
    let decimals = (3.0 - m2.log10().floor()).clamp(1.0, 12.0) as usize;
    format!("{m2:.decimals$}")
}
