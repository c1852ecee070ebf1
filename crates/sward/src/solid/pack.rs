//! Filling a solid with spheres that may overlap: few, large, and hardly beyond its surface.
//!
//! The spheres are chosen from those that the distance field allows: round each point inside, the
//! largest that fits. Each next one covers the most of the volume that is still bare. Inner sphere
//! packing on the distance field is R. Weller and G. Zachmann's ("Inner Sphere Trees for Proximity
//! and Penetration Queries", RSS 2009), whose spheres must not overlap and so leave a third bare;
//! overlapping spheres with their centres near the medial axis are P. Hubbard's ("Approximating
//! Polyhedra with Spheres for Time-Critical Collision Detection", 1996). Choosing by the volume
//! won is the greedy cover of a set, and no method that is fast does better than it by more than a
//! share of 1/e (G. Nemhauser, L. Wolsey and M. Fisher, 1978).
//!
//! The bare volume only shrinks, so what a sphere won when it was last counted bounds what it wins
//! now: only the few on top of the heap are counted anew (M. Minoux, 1978).

use super::Solid;
use super::samples::Samples;
use crate::error::within;
use crate::{Error, Sphere};
use glam::{IVec3, UVec3, Vec3};
use rayon::prelude::*;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// How to fill a solid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PackDesc {
    /// Spheres at most, 1..=65536: more follow the shape more closely, and cost more each frame.
    pub spheres: u32,
    /// How far a sphere may bulge over the surface, as a share of the bounding box's diagonal,
    /// 0..=0.1: more covers thin parts and corners with fewer spheres, less keeps to the shape.
    pub bulge: f32,
}

impl Default for PackDesc {
    fn default() -> Self {
        Self { spheres: 1000, bulge: 0.001 }
    }
}

/// A solid as spheres.
#[derive(Debug, Clone, PartialEq)]
pub struct Packing {
    /// The spheres, in the space of the solid's mesh. Each covers no more new volume than the one
    /// before it, so that the first few are a coarser packing.
    pub spheres: Vec<Sphere>,
    /// Share of the solid's volume that they cover, 0..=1, by points that the packer did not use.
    pub coverage: f32,
    /// Farthest that a sphere bulges over the surface, metres: a bound, which may be a little high.
    pub bulge_m: f32,
}

/// Most spheres of a packing.
const MOST_SPHERES: u32 = 65_536;
/// Grid points inside, for each sphere: below about 100 the shapes of the smallest are left to
/// chance. And their least and most in all.
const POINTS_A_SPHERE: u32 = 300;
const POINTS: std::ops::RangeInclusive<u32> = 4_000..=400_000;
/// Points of the box that coverage is counted with, a round; rounds at most; points inside that
/// are enough.
const COUNTED: u32 = 5_000;
const ROUNDS: u32 = 60;
const ENOUGH: u32 = 2000;
/// Powers of the inverse of the root of x^4 = x + 1.
const R3: [f64; 3] = [0.819_172_513_396_164_4, 0.671_043_606_703_789_2, 0.549_700_477_901_970_4];
/// A point is near the medial axis where the distance field rises less than this towards each of
/// its 26 neighbours; away from the axis one of them lies within 28 degrees of straight up the
/// slope, where it rises by 0.88 a step.
const RISE: f32 = 0.85;

impl Solid {
    /// Fills the solid with spheres. The same input gives the same spheres for any number of
    /// threads. Fewer than asked for come back where fewer cover all.
    ///
    /// # Errors
    /// [`Error::Setting`] for a value out of range; [`Error::Mesh`] where the solid is too thin for
    /// a point of the grid to lie inside.
    pub fn pack(&self, desc: &PackDesc) -> Result<Packing, Error> {
        if !(1..=MOST_SPHERES).contains(&desc.spheres) {
            let cause = format!("{} is out of range; use 1 to {MOST_SPHERES}", desc.spheres);
            return Err(Error::setting("spheres", cause));
        }
        within("bulge", desc.bulge, 0.0, 0.1)?;
        let points = desc.spheres.saturating_mul(POINTS_A_SPHERE);
        let points = points.clamp(*POINTS.start(), *POINTS.end());
        let samples = Samples::inside(self, points).ok_or_else(|| {
            Error::mesh("too thin to pack: no point of a fine grid lies inside; thicken it")
        })?;
        // The solid's unit is half of the diagonal.
        let bulge = 2.0 * desc.bulge / samples.step;
        let candidates = candidates(&samples, bulge);
        let mut bare = Cells::inside(&samples);
        let all = bare.count();
        let chosen = choose(&candidates, &mut bare, desc.spheres as usize);
        let mut packing = Packing { spheres: Vec::new(), coverage: 0.0, bulge_m: 0.0 };
        for ball in chosen {
            let center = self.world_from_unit(samples.at(ball.center));
            let radius = (f64::from(ball.radius * samples.step) * self.unit_m) as f32;
            packing.bulge_m = packing.bulge_m.max(radius + self.distance(center));
            packing.spheres.push(Sphere { center, radius });
        }
        // Of a thin shell too few points may lie inside: then the packer's own count stands.
        let own = 1.0 - bare.count() as f32 / all.max(1) as f32;
        packing.coverage = self.coverage(&packing.spheres).unwrap_or(own);
        Ok(packing)
    }

    /// Share of the volume that spheres cover, by points spread evenly over the box: the R3
    /// sequence (M. Roberts, 2018), whose first point lies in its middle. Of a thin shell few of
    /// them lie inside, so there are more then. `None` where still too few do.
    fn coverage(&self, spheres: &[Sphere]) -> Option<f32> {
        let (mut inside, mut covered) = (0, 0);
        for round in 0..ROUNDS {
            let points = round * COUNTED..(round + 1) * COUNTED;
            let counted = points.into_par_iter().map(|i| self.counted(i, spheres));
            let [more, of_them] = counted.reduce(|| [0, 0], |a, b| [a[0] + b[0], a[1] + b[1]]);
            (inside, covered) = (inside + more, covered + of_them);
            if inside >= ENOUGH {
                break;
            }
        }
        (inside >= 100).then(|| covered as f32 / inside as f32)
    }

    /// Whether a point of the sequence lies inside, and whether spheres cover it, as counts.
    fn counted(&self, i: u32, spheres: &[Sphere]) -> [u32; 2] {
        let (low, high) = self.bounds();
        let at = R3.map(|step| ((0.5 + f64::from(i) * step).fract()) as f32);
        let point = low + (high - low) * Vec3::from(at);
        if !self.contains(point) {
            return [0, 0];
        }
        let within = |s: &Sphere| s.center.distance_squared(point) <= s.radius * s.radius;
        [1, u32::from(spheres.iter().any(within))]
    }
}

/// A sphere about a point of the grid, in steps.
#[derive(Debug, Clone, Copy)]
struct Ball {
    center: UVec3,
    radius: f32,
}

/// The largest spheres about the points near the medial axis. All others lie in one of these, but
/// for a fraction of a step.
fn candidates(samples: &Samples, bulge: f32) -> Vec<Ball> {
    let size = samples.size.as_ivec3();
    let steps: Vec<(IVec3, f32)> = (0..27)
        .map(|i| IVec3::new(i % 3, i / 3 % 3, i / 9) - 1)
        .filter(|&step| step != IVec3::ZERO)
        .map(|step| (step, RISE * step.as_vec3().length()))
        .collect();
    (0..samples.depths.len())
        .into_par_iter()
        .filter_map(|i| {
            let depth = samples.depths[i];
            if depth <= 0.0 {
                return None;
            }
            let cell = samples.cell(i);
            let rises = steps.iter().any(|&(step, rise)| {
                let next = cell.as_ivec3() + step;
                next.cmpge(IVec3::ZERO).all()
                    && next.cmplt(size).all()
                    && samples.depths[samples.index(next.as_uvec3())] > depth + rise
            });
            (!rises).then_some(Ball { center: cell, radius: depth + bulge })
        })
        .collect()
}

/// Takes up to `count` balls, each time the one that covers the most bare points; clears them.
fn choose(candidates: &[Ball], bare: &mut Cells, count: usize) -> Vec<Ball> {
    let most = |ball: &Ball| (4.2 * (ball.radius + 1.0).powi(3)) as u32;
    // The first of equals wins: the order is the grid's.
    let mut heap: BinaryHeap<(u32, Reverse<usize>)> =
        candidates.iter().enumerate().map(|(i, ball)| (most(ball), Reverse(i))).collect();
    let mut chosen = Vec::new();
    while let Some((_, Reverse(i))) = heap.pop() {
        let ball = &candidates[i];
        let wins = (bare.covered(ball), Reverse(i));
        if wins.0 == 0 {
            continue;
        }
        if heap.peek().is_some_and(|next| *next > wins) {
            heap.push(wins);
            continue;
        }
        bare.clear(ball);
        chosen.push(*ball);
        if chosen.len() == count {
            break;
        }
    }
    chosen
}

/// A set of points of the grid: one bit each, rows along x in whole words.
struct Cells {
    size: UVec3,
    words_a_row: usize,
    words: Vec<u64>,
}

impl Cells {
    fn inside(samples: &Samples) -> Self {
        let size = samples.size;
        let words_a_row = size.x.div_ceil(64) as usize;
        let mut words = vec![0; words_a_row * (size.y * size.z) as usize];
        for (row, depths) in samples.depths.chunks(size.x as usize).enumerate() {
            for (x, _) in depths.iter().enumerate().filter(|(_, depth)| **depth > 0.0) {
                words[row * words_a_row + x / 64] |= 1 << (x % 64);
            }
        }
        Self { size, words_a_row, words }
    }

    fn count(&self) -> u32 {
        self.words.iter().map(|word| word.count_ones()).sum()
    }

    /// Points of the set within a ball.
    fn covered(&self, ball: &Ball) -> u32 {
        let mut covered = 0;
        self.each_word(ball, |at, mask| covered += (self.words[at] & mask).count_ones());
        covered
    }

    fn clear(&mut self, ball: &Ball) {
        let mut words = std::mem::take(&mut self.words);
        self.each_word(ball, |at, mask| words[at] &= !mask);
        self.words = words;
    }

    /// Calls `visit` with each word that a ball meets, and the ball's bits in it.
    fn each_word(&self, ball: &Ball, mut visit: impl FnMut(usize, u64)) {
        let squared = ball.radius * ball.radius;
        let center = ball.center.as_ivec3();
        let reach = ball.radius as i32;
        let last = self.size.as_ivec3() - 1;
        for z in (center.z - reach).max(0)..=(center.z + reach).min(last.z) {
            for y in (center.y - reach).max(0)..=(center.y + reach).min(last.y) {
                let (dy, dz) = ((y - center.y) as f32, (z - center.z) as f32);
                let left = squared - dy * dy - dz * dz;
                if left < 0.0 {
                    continue;
                }
                let half = left.sqrt() as i32;
                let from = (center.x - half).max(0) as usize;
                let to = (center.x + half).min(last.x) as usize;
                let row = (z * self.size.y as i32 + y) as usize * self.words_a_row;
                for word in from / 64..=to / 64 {
                    let low = from.saturating_sub(word * 64);
                    let high = (to - word * 64).min(63);
                    visit(row + word, (u64::MAX << low) & (u64::MAX >> (63 - high)));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_hold_exactly_the_points_of_a_ball() {
        let size = UVec3::new(150, 20, 20);
        let full = vec![u64::MAX; 3 * 400];
        let cells = Cells { size, words_a_row: 3, words: full };
        for (x, radius) in [(0, 3.0), (63, 7.9), (64, 0.5), (100, 40.0), (149, 9.99), (70, 0.0)] {
            let ball = Ball { center: UVec3::new(x, 9, 10), radius };
            let within = (0..size.element_product()).filter(|i| {
                let cell = UVec3::new(i % 150, i / 150 % 20, i / 3000);
                cell.as_vec3().distance_squared(ball.center.as_vec3()) <= radius * radius
            });
            assert_eq!(cells.covered(&ball) as usize, within.count(), "{x}, {radius}");
        }
    }
}
