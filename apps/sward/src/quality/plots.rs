//! Charts and pictures of a measurement.

use super::chart::{Chart, Line};
use super::{Limits, PathFlip, Pictures, Quality, ViewDrift};
use crate::picture::{Color, Sheet, ramp};
use glam::Vec2;
use image::{Rgb, RgbImage};

const BLUE: Color = [40, 110, 200];
const ORANGE: Color = [225, 120, 20];
const GREEN: Color = [40, 140, 70];

/// Every picture, with its file's name.
pub fn plots(quality: &Quality, pictures: &Pictures) -> Vec<(String, RgbImage)> {
    let limits = Limits::default();
    let mut all = vec![
        ("pictures.png".into(), sheet(quality, pictures)),
        ("flip.png".into(), along_paths(quality, "mean FLIP", None, |p| points(p, |f| f.flip))),
        (
            "jumps.png".into(),
            along_paths(quality, "jump of mean FLIP", Some(limits.jump), |path| {
                points(path, |frame| frame.jump.unwrap_or(f32::NAN))
            }),
        ),
        (
            "tile_jumps.png".into(),
            along_paths(quality, "jump of FLIP in tiles, 99.9 %", Some(limits.tile_jump), |path| {
                points(path, |frame| frame.tile_jump.unwrap_or(f32::NAN))
            }),
        ),
    ];
    for view in &quality.drift.views {
        let name = |what: &str| format!("{what}_{}.png", view.camera);
        let coverage = both(view, |bin| bin.coverage);
        all.push((name("coverage"), against_distance(view, "share of the picture", coverage)));
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
    let flip = quality.flip;
    Sheet::new(format!("{}: {}", quality.scene, quality.technique), 1)
        .picture("reference", pictures.reference.clone())
        .picture(format!("{} samples", quality.samples), pictures.test.clone())
        .picture(format!("FLIP: mean {:.3}, 99 % {:.3}", flip.mean, flip.p99), errors)
        .draw()
}

fn points(path: &PathFlip, value: impl Fn(&super::FrameFlip) -> f32) -> Vec<Vec2> {
    let mut points: Vec<Vec2> = Vec::new();
    for frame in &path.frames {
        let x = frame.frame as f32;
        // Frames that are no neighbours are not joined
        if points.last().is_some_and(|last| last.x + 1.5 < x) {
            points.push(Vec2::NAN);
        }
        points.push(Vec2::new(x, value(frame)));
    }
    points
}

fn along_paths(
    quality: &Quality,
    title: &str,
    limit: Option<f32>,
    points: impl Fn(&PathFlip) -> Vec<Vec2>,
) -> RgbImage {
    let line = |name: &str, color, path| Line { name: name.into(), color, points: points(path) };
    Chart {
        title: format!("{}, {}: {title}", quality.scene, quality.technique),
        along: "frame of the path".into(),
        log_x: false,
        lines: vec![
            line("dolly", BLUE, &quality.dolly),
            line("orbit", ORANGE, &quality.orbit),
            line("fly-down", GREEN, &quality.flydown),
        ],
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
