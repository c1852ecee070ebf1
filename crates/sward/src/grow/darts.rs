//! Poisson-disk samples on a surface by dart throwing.
//!
//! After D. Cline, S. Jeschke, K. White, A. Razdan and P. Wonka, "Dart Throwing on Surfaces",
//! Computer Graphics Forum 28(4), 2009: darts are thrown at fragments of triangles, picked by
//! area; a fragment that one sample's disk covers is dropped, any other is cut into four. What is
//! left shrinks to nothing, so that the result is maximal but for slits too fine to matter.

use super::fragment::Fragment;
use super::random::{Draws, Purpose, Stream};
use super::surface::{Spot, Surface};
use glam::Vec3;
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// Fragments whose longest edge is less than this share of the radius are given up.
const FINEST: f32 = 0.02;

/// Samples at least `radius_m` (straight-line) from each other, as many as find room.
pub(crate) fn throw(surface: &Surface, radius_m: f32, seed: u64) -> Vec<Spot> {
    let mut draws = Stream::new(seed, Purpose::Dart).at(0);
    let mut active = Active::new(surface);
    let mut grid = Grid::new(radius_m);
    let mut samples: Vec<Spot> = Vec::new();
    while let Some(piece) = active.take(&mut draws) {
        let spot = surface.spot(piece.triangle, piece.fragment.point(&mut draws));
        if !grid.any_within(spot.position, |_| true) {
            grid.insert(spot.position);
            samples.push(spot);
        }
        let corners = surface.corners(piece.triangle);
        let [a, b, c] = corners;
        let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
        if grid.covers(place(piece.fragment, corners))
            || longest * piece.fragment.size() < FINEST * radius_m
        {
            continue;
        }
        for which in 0..4 {
            let fragment = piece.fragment.child(which);
            if !grid.covers(place(fragment, corners)) {
                active.push(Piece { fragment, ..piece });
            }
        }
    }
    samples
}

fn place(fragment: Fragment, [a, b, c]: [Vec3; 3]) -> [Vec3; 3] {
    fragment.corners().map(|w| a + (b - a) * w.x + (c - a) * w.y)
}

#[derive(Debug, Clone, Copy)]
struct Piece {
    fragment: Fragment,
    triangle: u32,
}

/// The fragments that may still take a dart, in buckets by area, each half the one before.
struct Active<'a> {
    surface: &'a Surface,
    largest_m2: f64,
    buckets: Vec<(f64, Vec<Piece>)>,
}

const BUCKETS: usize = 64;

impl<'a> Active<'a> {
    fn new(surface: &'a Surface) -> Self {
        let count = surface.triangle_count();
        let largest_m2 = (0..count).map(|t| surface.area_span_m2(t).1).fold(0.0, f64::max);
        let mut active = Self { surface, largest_m2, buckets: vec![(0.0, Vec::new()); BUCKETS] };
        for triangle in 0..count as u32 {
            active.push(Piece { fragment: Fragment::WHOLE, triangle });
        }
        active
    }

    fn area_m2(&self, piece: &Piece) -> f64 {
        let size = f64::from(piece.fragment.size());
        self.surface.area_span_m2(piece.triangle as usize).1 * size * size
    }

    fn push(&mut self, piece: Piece) {
        let area = self.area_m2(&piece);
        // A triangle far smaller than its neighbours can have a summed area of 0.
        let octave = (self.largest_m2 / area.max(f64::MIN_POSITIVE)).log2();
        let (sum, pieces) = &mut self.buckets[(octave.max(0.0) as usize).min(BUCKETS - 1)];
        *sum += area;
        pieces.push(piece);
    }

    /// Takes a fragment out, with a chance in proportion to its area.
    fn take(&mut self, draws: &mut Draws) -> Option<Piece> {
        let total: f64 = self.buckets.iter().map(|(sum, _)| sum).sum();
        let mut at = draws.unit_f64() * total;
        let mut chosen = None;
        for (i, (sum, pieces)) in self.buckets.iter().enumerate() {
            if pieces.is_empty() {
                continue;
            }
            chosen = Some(i);
            at -= sum;
            if at < 0.0 {
                break;
            }
        }
        let bucket = chosen?;
        let most = self.largest_m2 * 0.5f64.powi(bucket as i32);
        let mut which = 0;
        // Areas in a bucket differ by a factor of two, so a few tries do. The last bucket holds
        // all smaller ones: there the bound on tries ends it.
        for _ in 0..64 {
            which = draws.below(self.buckets[bucket].1.len());
            let area = self.area_m2(&self.buckets[bucket].1[which]);
            if draws.unit_f64() * most < area {
                break;
            }
        }
        let piece = self.buckets[bucket].1.swap_remove(which);
        let area = self.area_m2(&piece);
        let (sum, pieces) = &mut self.buckets[bucket];
        *sum = if pieces.is_empty() { 0.0 } else { (*sum - area).max(0.0) };
        Some(piece)
    }
}

/// Samples by cell; cells are as wide as a disk, so that eight hold all that lies within a radius.
struct Grid {
    radius_m: f32,
    heads: HashMap<u64, u32, BuildHasherDefault<CellHasher>>,
    /// Each sample, and the one before it in its cell.
    samples: Vec<(Vec3, u32)>,
}

const END: u32 = u32::MAX;

impl Grid {
    fn new(radius_m: f32) -> Self {
        Self { radius_m, heads: HashMap::default(), samples: Vec::new() }
    }

    /// Two cells may share a key: they then share a list, which costs a test and changes nothing.
    fn key(x: i64, y: i64, z: i64) -> u64 {
        (x as u64).wrapping_mul(0x8da6_b343_9e37_79b1)
            ^ (y as u64).wrapping_mul(0xd816_3841_85eb_ca77)
            ^ (z as u64).wrapping_mul(0xcb1a_b31f_c2b2_ae3d)
    }

    fn insert(&mut self, position: Vec3) {
        let cell = (position / (2.0 * self.radius_m)).floor();
        let key = Self::key(cell.x as i64, cell.y as i64, cell.z as i64);
        let index = self.samples.len() as u32;
        let before = self.heads.insert(key, index).unwrap_or(END);
        self.samples.push((position, before));
    }

    /// Whether a sample that passes the test lies within the radius.
    fn any_within(&self, position: Vec3, test: impl Fn(Vec3) -> bool) -> bool {
        let at = position / (2.0 * self.radius_m);
        let low = (at - 0.5).floor();
        let (x, y, z) = (low.x as i64, low.y as i64, low.z as i64);
        let reach = self.radius_m * self.radius_m;
        (0..8).any(|corner: i64| {
            let key = Self::key(
                x.wrapping_add(corner & 1),
                y.wrapping_add(corner >> 1 & 1),
                z.wrapping_add(corner >> 2),
            );
            let mut next = self.heads.get(&key).copied().unwrap_or(END);
            while let Some(&(sample, before)) = self.samples.get(next as usize) {
                if sample.distance_squared(position) < reach && test(sample) {
                    return true;
                }
                next = before;
            }
            false
        })
    }

    /// Whether one sample's disk covers a triangle.
    fn covers(&self, [a, b, c]: [Vec3; 3]) -> bool {
        let reach = self.radius_m * self.radius_m;
        self.any_within(a, |sample| {
            sample.distance_squared(b) < reach && sample.distance_squared(c) < reach
        })
    }
}

/// Keys are well mixed in their high bits only; the table uses low and high.
#[derive(Default)]
struct CellHasher(u64);

impl Hasher for CellHasher {
    fn finish(&self) -> u64 {
        self.0
    }
    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.write_u64(u64::from(byte));
        }
    }
    fn write_u64(&mut self, key: u64) {
        self.0 = super::random::mix(self.0 ^ key);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Mesh;
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
