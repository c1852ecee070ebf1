//! Charts and pictures of a measurement.

use super::chart::{Chart, Line};
use super::{FrameFlip, Limits, PathFlip, Pictures, Quality, SceneFlip, ViewDrift};
use crate::picture::{Color, Sheet, ramp};
use glam::Vec2;
use image::{Rgb, RgbImage};

const BLUE: Color = [40, 110, 200];
const ORANGE: Color = [225, 120, 20];
const GREEN: Color = [40, 140, 70];

/// Every picture, with its file's name.
pub fn plots(quality: &Quality, pictures: &Pictures) -> Vec<(String, RgbImage)> {
    let limits = Limits::default();
    let mut all = Vec::new();
    if quality.flip.is_some() {
        all.push(("pictures.png".to_string(), sheet(quality, pictures)));
    }
    if quality.paths().next().is_some() {
        let flip = along_paths(quality, "mean FLIP", None, |f| Some(f.flip));
        all.push(("flip.png".into(), flip));
        let limit = Some(limits.jump);
        let jumps = along_paths(quality, "jump of mean FLIP", limit, |f| f.jump);
        all.push(("jumps.png".into(), jumps));
        let limit = Some(limits.tile_jump);
        let tiles = along_paths(quality, "jump of FLIP in tiles, 99.9 %", limit, |f| f.tile_jump);
        all.push(("tile_jumps.png".into(), tiles));
    }
    for view in quality.drift.iter().flat_map(|drift| &drift.views) {
        let name = |what: &str| format!("{what}_{}.png", view.camera);
        let coverage = both(view, |bin| bin.coverage);
        all.push((name("coverage"), against_distance(view, "share of the pixels", coverage)));
        let luminance = both(view, |bin| bin.luminance);
        all.push((name("luminance"), against_distance(view, "mean luminance", luminance)));
        all.push((name("ratio"), against_distance(view, "test over reference", ratios(view))));
    }
    all
}

fn sheet(quality: &Quality, pictures: &Pictures) -> RgbImage {
    let (width, height) = pictures.test.dimensions();
    let mut errors = RgbImage::new(width, height);
    for (pixel, error) in errors.pixels_mut().zip(&pictures.errors) {
        *pixel = Rgb(ramp(error.sqrt()));
    }
    let label = |flip: SceneFlip| format!("FLIP: mean {:.3}, 99 % {:.3}", flip.mean, flip.p99);
    Sheet::new(format!("{}: {}", quality.scene, quality.technique), 1)
        .picture("reference", pictures.reference.clone())
        .picture(format!("{} samples", quality.samples), pictures.test.clone())
        .picture(quality.flip.map(label).unwrap_or_default(), errors)
        .draw()
}

fn points(path: &PathFlip, value: fn(&FrameFlip) -> Option<f32>) -> Vec<Vec2> {
    let mut points: Vec<Vec2> = Vec::new();
    for frame in &path.frames {
        let x = frame.frame as f32;
        // Frames that are no neighbours are not joined
        if points.last().is_some_and(|last| last.x + 1.5 < x) {
            points.push(Vec2::NAN);
        }
        points.push(Vec2::new(x, value(frame).unwrap_or(f32::NAN)));
    }
    points
}

fn along_paths(
    quality: &Quality,
    title: &str,
    limit: Option<f32>,
    value: fn(&FrameFlip) -> Option<f32>,
) -> RgbImage {
    let colored = quality.paths().zip([BLUE, ORANGE, GREEN]);
    let line = |((name, path), color): ((&str, &PathFlip), Color)| Line {
        name: name.into(),
        color,
        points: points(path, value),
    };
    Chart {
        title: format!("{}, {}: {title}", quality.scene, quality.technique),
        along: "frame of the path".into(),
        log_x: false,
        lines: colored.map(line).collect(),
        limit,
        ranges: Vec::new(),
    }
    .draw()
}

fn both(view: &ViewDrift, pick: fn(&super::Bin) -> [f32; 2]) -> Vec<Line> {
    let line = |name: &str, color, which: usize| Line {
        name: name.into(),
        color,
        points: view.bins.iter().map(|bin| Vec2::new(middle(bin), pick(bin)[which])).collect(),
    };
    vec![line("reference", BLUE, 0), line("test", ORANGE, 1)]
}

fn ratios(view: &ViewDrift) -> Vec<Line> {
    let line = |name: &str, color, pick: fn(&super::Bin) -> [f32; 2]| Line {
        name: name.into(),
        color,
        points: view
            .bins
            .iter()
            .map(|bin| Vec2::new(middle(bin), pick(bin)[1] / pick(bin)[0].max(1e-9)))
            .collect(),
    };
    vec![
        line("coverage", GREEN, |bin| bin.coverage),
        line("luminance", ORANGE, |bin| bin.luminance),
    ]
}

fn middle(bin: &super::Bin) -> f32 {
    (bin.range_m[0] * bin.range_m[1]).sqrt()
}

fn against_distance(view: &ViewDrift, title: &str, lines: Vec<Line>) -> RgbImage {
    let ranges = view.changes.iter().map(|change| (change.range_m, change.name.clone()));
    Chart {
        title: format!("{}: {title}", view.camera),
        along: "distance, m".into(),
        log_x: true,
        lines,
        limit: None,
        ranges: ranges.collect(),
    }
    .draw()
}
