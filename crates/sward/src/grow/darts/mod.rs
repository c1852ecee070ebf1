//! Poisson-disk samples on a surface by dart throwing.
//!
//! After D. Cline, S. Jeschke, K. White, A. Razdan and P. Wonka, "Dart Throwing on Surfaces",
//! Computer Graphics Forum 28(4), 2009: darts are thrown at pieces of triangles, picked by area; a
//! piece that one sample's disk covers is dropped, any other is cut. What is left shrinks to
//! nothing, so that the result is maximal but for slits too fine to matter.
//!
//! In parallel and yet always the same: pieces are grouped by cells of space, and the cells are
//! filled in eight turns, so that cells of one turn lie too far apart to see each other.

mod near;
mod pieces;

use super::random::{Purpose, Stream, mix};
use super::surface::{Spot, Surface};
use glam::{I64Vec3, Vec3};
use near::Near;
use pieces::{Active, Piece, longest};
use rayon::prelude::*;

/// Pieces whose longest edge is less than this share of the radius are given up.
const FINEST: f32 = 0.02;
/// Longest edge of the first pieces, in radii: what is longer, no disk covers.
const LONGEST: f32 = 2.0;
/// Side of a cell, in radii. Two cells of one turn are a side apart, less the length of a piece at
/// either end: that must leave a radius, so 5 is the least.
const CELL: f64 = 8.0;

/// Samples at least `radius_m` (straight-line) from each other, as many as find room.
pub(crate) fn throw(surface: &Surface, radius_m: f32, seed: u64) -> Vec<Spot> {
    let pieces = pieces_by_cell(surface, radius_m);
    let groups: Vec<&[(Cell, Piece)]> = pieces.chunk_by(|a, b| a.0 == b.0).collect();
    let mut filled: Vec<Vec<Spot>> = vec![Vec::new(); groups.len()];
    let stream = Stream::new(seed, Purpose::Dart);
    for turn in 0..8 {
        let new: Vec<(usize, Vec<Spot>)> = (groups.par_iter().enumerate())
            .filter(|(_, group)| turn_of(group[0].0) == turn)
            .map(|(i, group)| (i, fill(surface, group, &groups, &filled, radius_m, stream)))
            .collect();
        for (i, samples) in new {
            filled[i] = samples;
        }
    }
    filled.concat()
}

type Cell = [i64; 3];

fn turn_of(cell: Cell) -> i64 {
    (cell[0] & 1) | (cell[1] & 1) << 1 | (cell[2] & 1) << 2
}

/// The surface in pieces that a disk may cover, sorted by the cell of their middle.
fn pieces_by_cell(surface: &Surface, radius_m: f32) -> Vec<(Cell, Piece)> {
    let side_m = CELL * f64::from(radius_m);
    let mut pieces: Vec<(Cell, Piece)> = (0..surface.triangle_count() as u32)
        .into_par_iter()
        .flat_map_iter(|triangle| {
            let mut done = Vec::new();
            let mut open = vec![Piece::whole(triangle)];
            while let Some(piece) = open.pop() {
                let corners = piece.corners(surface);
                let (side, length) = longest(corners);
                // The weights' precision bounds the depth: 2^-40 of the area.
                if length > LONGEST * radius_m && open.len() < 40 {
                    open.extend(piece.halves(side));
                } else {
                    let middle = (corners[0] + corners[1] + corners[2]).as_dvec3() / 3.0;
                    let cell: I64Vec3 = (middle / side_m).floor().as_i64vec3();
                    done.push((cell.to_array(), piece));
                }
            }
            done
        })
        .collect();
    // Stable: pieces of one cell keep the order of the triangles.
    pieces.par_sort_by_key(|&(cell, _)| cell);
    pieces
}

/// Throws darts at one cell's pieces, with the samples of the cells about it in place.
fn fill(
    surface: &Surface,
    group: &[(Cell, Piece)],
    groups: &[&[(Cell, Piece)]],
    filled: &[Vec<Spot>],
    radius_m: f32,
    stream: Stream,
) -> Vec<Spot> {
    let cell = group[0].0;
    let pieces: Vec<Piece> = group.iter().map(|&(_, piece)| piece).collect();
    let corners = || pieces.iter().flat_map(|piece| piece.corners(surface));
    let low = corners().fold(Vec3::INFINITY, Vec3::min);
    let high = corners().fold(Vec3::NEG_INFINITY, Vec3::max);
    let mut near = Near::new(low, high, radius_m);
    for offset in 0..27 {
        let other = [offset % 3 - 1, offset / 3 % 3 - 1, offset / 9 - 1];
        let other: Cell = std::array::from_fn(|axis| cell[axis].saturating_add(other[axis]));
        let Ok(index) = groups.binary_search_by_key(&other, |g| g[0].0) else {
            continue;
        };
        for sample in &filled[index] {
            let p = sample.position;
            if p.cmpge(low - radius_m).all() && p.cmple(high + radius_m).all() {
                near.insert(p);
            }
        }
    }
    let mut draws = stream.at(cell.iter().fold(0, |key, &c| mix(key ^ c as u64)));
    let mut active = Active::new(surface, &pieces);
    let mut samples = Vec::new();
    while let Some(piece) = active.take(&mut draws) {
        let corners = piece.corners(surface);
        if near.covers(corners) {
            continue;
        }
        let spot = surface.spot(piece.triangle, piece.point(&mut draws));
        if !near.any_within(spot.position, |_| true) {
            near.insert(spot.position);
            samples.push(spot);
        }
        let (side, length) = longest(corners);
        if length > FINEST * radius_m {
            for half in piece.halves(side) {
                active.push(half);
            }
        }
    }
    samples
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Mesh;
    use crate::grow::fragment::Fragment;
    use glam::{UVec2, Vec2};

    fn check(mesh: Mesh, radius_m: f32) -> usize {
        let surface = Surface::new(mesh).unwrap();
        let samples = throw(&surface, radius_m, 7);
        for (i, a) in samples.iter().enumerate() {
            for b in &samples[..i] {
                let apart = a.position.distance(b.position);
                assert!(apart >= radius_m, "{} and {}: {apart}", a.position, b.position);
            }
        }
        // As full as it can be: random places have a sample nearby.
        let stream = Stream::new(1, Purpose::Single);
        for i in 0..2000 {
            let mut draws = stream.at(i);
            let triangle = draws.below(surface.triangle_count()) as u32;
            let spot = surface.spot(triangle, Fragment::WHOLE.point(&mut draws));
            let near = samples.iter().any(|s| s.position.distance(spot.position) < 1.05 * radius_m);
            assert!(near, "{} is bare", spot.position);
        }
        samples.len()
    }

    #[test]
    fn samples_keep_the_radius_and_leave_no_gap() {
        let flat = check(Mesh::plane(Vec2::splat(10.0), UVec2::splat(3)).unwrap(), 0.4);
        // Dart throwing ends at about 0.7 samples for each square radius.
        let packing = flat as f32 * 0.16 / 100.0;
        assert!((0.62..0.82).contains(&packing), "{packing}");
        check(Mesh::plane(Vec2::splat(10.0), UVec2::splat(60)).unwrap(), 0.4);
        check(Mesh::sphere(1.0, 9).unwrap(), 0.2);
        check(Mesh::mobius(2.0, 1.0, UVec2::new(20, 2)).unwrap(), 0.3);
        assert_eq!(check(Mesh::sphere(1.0, 9).unwrap(), 5.0), 1);
    }
}
