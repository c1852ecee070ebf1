//! A measurement as Markdown.

use super::{Drift, Limits, Quality};
use std::fmt::Write;

/// Tables of all numbers but those a frame and a slab.
pub fn markdown(quality: &Quality) -> String {
    let mut text = String::new();
    // Writing to a string does not fail.
    let _ = write(&mut text, quality);
    text
}

fn write(text: &mut String, quality: &Quality) -> std::fmt::Result {
    let [width, height] = quality.size;
    let limits = Limits::default();
    writeln!(
        text,
        "{}, {}: {} blades, {width} x {height}, {} samples, {} ({})\n",
        quality.scene,
        quality.technique,
        quality.blades_total,
        quality.samples,
        quality.adapter,
        quality.driver
    )?;
    writeln!(text, "| number | value | limit |\n|---|---|---|")?;
    if let Some(flip) = quality.flip {
        writeln!(text, "| FLIP, mean | {:.4} | |", flip.mean)?;
        writeln!(text, "| FLIP, 99th percentile | {:.4} | |", flip.p99)?;
        writeln!(text, "| FLIP, mean over grass | {:.4} | |", flip.grass_mean)?;
        writeln!(text, "| FLIP, 99th percentile over grass | {:.4} | |", flip.grass_p99)?;
    }
    for (name, path) in quality.paths() {
        let (count, mean) = (path.frames.len(), path.mean);
        writeln!(text, "| {name}: mean FLIP of {count} frames | {mean:.4} | |")?;
        writeln!(text, "| {name}: jump | {:.4} | {} |", path.jump, limits.jump)?;
        writeln!(text, "| {name}: jump of tiles | {:.4} | {} |", path.tile_jump, limits.tile_jump)?;
    }
    if let Some(drift) = &quality.drift {
        for (name, value) in
            [("coverage", drift.coverage), ("luminance", drift.luminance), ("colour", drift.colour)]
        {
            let limit = limits.drift * 1e2;
            writeln!(text, "| drift of {name} | {:.2} % | {limit} % |", value * 1e2)?;
        }
        writeln!(text, "| drift: standard error, up to | {:.2} % | |", drift.error * 1e2)?;
    }
    if let Some(still) = quality.still {
        let equal = if still.equal { "equal" } else { "not equal" };
        writeln!(text, "| {} frames of a still camera | {equal} | equal |", still.frames)?;
    }
    match &quality.drift {
        Some(drift) => changes(text, drift),
        None => Ok(()),
    }
}

fn changes(text: &mut String, drift: &Drift) -> std::fmt::Result {
    writeln!(
        text,
        "\n| view | change | from, m | to, m | coverage | luminance | colour | standard error |"
    )?;
    writeln!(text, "|---|---|---|---|---|---|---|---|")?;
    for view in &drift.views {
        for change in &view.changes {
            let [from, to] = change.range_m;
            writeln!(
                text,
                "| {} | {} | {from:.1} | {to:.1} | {:.2} % | {:.2} % | {:.2} % | {:.2} % |",
                view.camera,
                change.name,
                change.coverage * 1e2,
                change.luminance * 1e2,
                change.colour * 1e2,
                change.error * 1e2
            )?;
        }
    }
    Ok(())
}
