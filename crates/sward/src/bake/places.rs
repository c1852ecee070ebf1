//! Places of a field that stand for all of it: squares of ground, evenly spread over it, however the
//! blades stand together on it.

use super::means::evenly;
use crate::Field;
use crate::gpu::quantize::tangent_frame;
use crate::grow::Blade;
use crate::shared::noise_twin::hash01;
use glam::{DMat2, DVec2, Mat3, Vec3};
use rayon::prelude::*;
use std::ops::Range;

/// Patches of a piece, at most: a piece is large beside a tuft.
const PATCHES: usize = 16;
/// Pieces that are measured.
const MEASURED: usize = 64;
/// Places that are tried for one with grass.
const TRIES: u32 = 8;
/// Most blades of a square, over those that it has in the mean.
const FULLEST: usize = 4;

/// Patches near each other, as recursive bisection left them: about a rectangle.
#[derive(Debug, Clone)]
struct Piece {
    blades: Range<usize>,
    /// Square metres of level ground.
    area: f64,
    up: Vec3,
}

/// A square of ground, and which blades stand on it.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    /// Its middle.
    pub origin: Vec3,
    /// World to a frame whose y is up.
    pub frame: Mat3,
    /// Indices in the field.
    pub blades: Vec<usize>,
}

/// How a field covers its ground.
#[derive(Debug, Clone)]
pub(crate) struct Ground {
    pieces: Vec<Piece>,
    /// Square metres of ground a blade.
    pub each: f32,
}

/// World to a frame whose y is `up`.
pub(crate) fn level_frame(up: Vec3) -> Mat3 {
    let (first, second) = tangent_frame(up);
    Mat3::from_cols(first, up, second).transpose()
}

fn mean_up(blades: &[Blade]) -> Vec3 {
    blades.iter().map(|b| b.up).sum::<Vec3>() / blades.len().max(1) as f32
}

/// Splits so many patches as the field was split.
fn split(patches: Range<usize>, out: &mut Vec<Range<usize>>) {
    if patches.len() <= PATCHES {
        out.push(patches);
        return;
    }
    let middle = patches.start + patches.len() / 2;
    split(patches.start..middle, out);
    split(middle..patches.end, out);
}

/// Level area: that of a rectangle whose points spread as these roots do.
fn area_of(blades: &[Blade], up: Vec3) -> f64 {
    let frame = level_frame(up.normalize_or(Vec3::Y));
    let origin = blades.first().map_or(Vec3::ZERO, |b| b.root);
    let places = || {
        let level = |b: &Blade| (frame * (b.root - origin)).as_dvec3();
        blades.iter().map(level).map(|p| DVec2::new(p.x, p.z))
    };
    let count = blades.len().max(2) as f64;
    let mean = places().sum::<DVec2>() / count;
    let spread = places().fold(DMat2::ZERO, |sum, p| {
        let d = p - mean;
        sum + DMat2::from_cols(d * d.x, d * d.y)
    });
    12.0 * spread.determinant().max(0.0).sqrt() / (count - 1.0)
}

impl Ground {
    /// Of a field whose blades have at least so much ground each.
    pub(crate) fn of(field: &Field, least: f32) -> Self {
        let patches = field.patches();
        let mut ranges = Vec::new();
        split(0..patches.len(), &mut ranges);
        let ranges: Vec<_> = evenly(ranges.len(), MEASURED).map(|i| ranges[i].clone()).collect();
        let piece = |range: &Range<usize>| {
            let own = &patches[range.clone()];
            let end = own.last().map_or(0, |p| (p.first + p.count) as usize);
            let blades = own.first().map_or(0, |p| p.first as usize)..end;
            let up = mean_up(&field.blades()[blades.clone()]);
            Piece { area: area_of(&field.blades()[blades.clone()], up), blades, up }
        };
        let pieces: Vec<Piece> = ranges.par_iter().map(piece).collect();
        let area: f64 = pieces.iter().map(|p| p.area).sum();
        let count: usize = pieces.iter().map(|p| p.blades.len()).sum();
        let each = ((area / count.max(1) as f64) as f32).clamp(0.0, 1e6).max(least);
        Self { pieces, each }
    }

    /// So many squares of this edge, evenly spread over the ground.
    pub(crate) fn places(&self, field: &Field, count: usize, edge: f32) -> Vec<Place> {
        let total: f64 = self.pieces.iter().map(|p| p.area).sum();
        let place = |index: usize| {
            let mut left = total * (index as f64 + 0.5) / count as f64;
            let after = |piece: &&Piece| {
                left -= piece.area;
                left <= 0.0
            };
            let piece = self.pieces.iter().find(after).or(self.pieces.last())?;
            Some(self.place(field, piece, index as u32, edge))
        };
        (0..count).into_par_iter().filter_map(place).collect()
    }

    /// A square somewhere in a piece: the first of some that is not bare.
    fn place(&self, field: &Field, piece: &Piece, index: u32, edge: f32) -> Place {
        let enough = (0.4 * edge * edge / self.each) as usize;
        let mut best = square(field, piece, index, 0, edge);
        for attempt in 1..TRIES {
            if best.blades.len() > enough {
                break;
            }
            let other = square(field, piece, index, attempt, edge);
            if other.blades.len() > best.blades.len() {
                best = other;
            }
        }
        let most = FULLEST * ((edge * edge / self.each) as usize).max(1);
        best.blades = evenly(best.blades.len(), most).map(|i| best.blades[i]).collect();
        best
    }
}

/// The square about a point that lies anywhere within some metres of a blade of the piece.
fn square(field: &Field, piece: &Piece, index: u32, attempt: u32, edge: f32) -> Place {
    let all = field.blades();
    let draw = |salt: u32| hash01(index, 60 + 3 * attempt + salt);
    let picked = piece.blades.start + (draw(0) * piece.blades.len() as f32) as usize;
    let blade = &all[picked.min(piece.blades.end.saturating_sub(1))];
    let up = if piece.up.length() > 0.5 { piece.up } else { blade.up };
    let frame = level_frame(up.normalize_or(Vec3::Y));
    // Were it at the blade, it would be in a tuft too often
    let reach = 0.5 * piece.area.sqrt() as f32;
    let aside = Vec3::new(draw(1) - 0.5, 0.0, draw(2) - 0.5) * reach;
    let origin = blade.root + frame.transpose() * aside;
    let mut blades = within(field, origin, &frame, edge);
    if blades.is_empty() {
        blades.push(picked);
    }
    Place { origin, frame, blades }
}

/// Blades that stand on a square.
fn within(field: &Field, origin: Vec3, frame: &Mat3, edge: f32) -> Vec<usize> {
    let reach = Vec3::splat(1.8 * edge);
    let near = |low: Vec3, high: Vec3| {
        (low - reach).cmple(origin).all() && (high + reach).cmpge(origin).all()
    };
    let patches = field.patches().iter().filter(|p| near(p.root_min, p.root_max));
    let inside = |index: &usize| {
        let at = (*frame * (field.blades()[*index].root - origin)).abs();
        at.x <= 0.5 * edge && at.z <= 0.5 * edge && at.y <= edge
    };
    patches.flat_map(|p| p.first as usize..(p.first + p.count) as usize).filter(inside).collect()
}
