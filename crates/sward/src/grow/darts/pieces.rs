//! Pieces of triangles that may still take a dart.

use crate::grow::random::Draws;
use crate::grow::surface::Surface;
use glam::{Vec2, Vec3};

/// A part of a triangle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub(super) triangle: u32,
    /// Barycentric weights of its corners.
    weights: [Vec2; 3],
}

impl Piece {
    pub(super) fn whole(triangle: u32) -> Self {
        Self { triangle, weights: [Vec2::ZERO, Vec2::X, Vec2::Y] }
    }

    pub(super) fn corners(&self, surface: &Surface) -> [Vec3; 3] {
        let [a, b, c] = surface.corners(self.triangle);
        self.weights.map(|w| a + (b - a) * w.x + (c - a) * w.y)
    }

    /// Barycentric weights of a uniform point.
    pub(super) fn point(&self, draws: &mut Draws) -> Vec2 {
        let [a, b, c] = self.weights;
        let (root, along) = (draws.unit().sqrt(), draws.unit());
        a + ((b - a) * (1.0 - along) + (c - a) * along) * root
    }

    /// Cuts the edge that starts at a corner in the middle: cutting the longest one keeps even
    /// slivers few.
    pub(super) fn halves(&self, side: usize) -> [Self; 2] {
        let (from, to) = (side, (side + 1) % 3);
        let middle = (self.weights[from] + self.weights[to]) * 0.5;
        let mut halves = [*self; 2];
        halves[0].weights[to] = middle;
        halves[1].weights[from] = middle;
        halves
    }

    fn area_m2(&self, surface: &Surface) -> f64 {
        let [a, b, c] = self.weights.map(|w| w.as_dvec2());
        (b - a).perp_dot(c - a).abs() * surface.area_span_m2(self.triangle as usize).1
    }
}

/// The longest edge: the corner that it starts at, and its length.
pub(super) fn longest([a, b, c]: [Vec3; 3]) -> (usize, f32) {
    let lengths = [a.distance(b), b.distance(c), c.distance(a)];
    let longest = Vec3::from(lengths).max_position();
    (longest, lengths[longest])
}

/// Enough for pieces of all sizes down to the finest, slivers but for the thinnest.
const BUCKETS: usize = 20;

/// Pieces in buckets by area, each bucket for half the area of the one before.
pub(super) struct Active<'a> {
    surface: &'a Surface,
    largest_m2: f64,
    buckets: [(f64, Vec<Piece>); BUCKETS],
}

impl<'a> Active<'a> {
    pub(super) fn new(surface: &'a Surface, pieces: &[Piece]) -> Self {
        let largest_m2 = pieces.iter().map(|p| p.area_m2(surface)).fold(0.0, f64::max);
        let buckets = std::array::from_fn(|_| (0.0, Vec::new()));
        let mut active = Self { surface, largest_m2, buckets };
        for &piece in pieces {
            active.push(piece);
        }
        active
    }

    pub(super) fn push(&mut self, piece: Piece) {
        let area = piece.area_m2(self.surface);
        // A triangle far smaller than its neighbours can have a summed area of 0.
        let octave = (self.largest_m2 / area.max(f64::MIN_POSITIVE)).log2();
        let (sum, pieces) = &mut self.buckets[(octave.max(0.0) as usize).min(BUCKETS - 1)];
        *sum += area;
        pieces.push(piece);
    }

    /// Takes a piece out, with a chance in proportion to its area.
    pub(super) fn take(&mut self, draws: &mut Draws) -> Option<Piece> {
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
        let octave = chosen?;
        let most = self.largest_m2 * 0.5f64.powi(octave as i32);
        let surface = self.surface;
        let (sum, pieces) = &mut self.buckets[octave];
        let mut which = 0;
        // Areas in a bucket differ by a factor of two, so a few tries do. The last bucket holds
        // all smaller ones: there the bound on tries ends it.
        for _ in 0..64 {
            which = draws.below(pieces.len());
            if draws.unit_f64() * most < pieces[which].area_m2(surface) {
                break;
            }
        }
        let piece = pieces.swap_remove(which);
        *sum = if pieces.is_empty() { 0.0 } else { (*sum - piece.area_m2(surface)).max(0.0) };
        Some(piece)
    }
}
