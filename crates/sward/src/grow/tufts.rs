//! Tufts: blades that stand together round a Poisson-disk sample.

use super::darts;
use super::mask::Mask;
use super::random::{Draws, Purpose, Stream};
use super::scatter::Root;
use super::surface::{Spot, Surface};
use super::tint::Tint;
use super::walk::{self, End};
use super::weld::Adjacency;
use crate::FieldDesc;
use rayon::prelude::*;
use std::f32::consts::TAU;

/// How far the outermost blades of a tuft lean outward, as the tangent of the angle.
pub(crate) const RIM_LEAN: f32 = 0.35;
/// Samples that fit a square of one radius: 0.7 is what dart throwing reaches.
const PACKING: f64 = 0.7;
/// Turn from one blade of a tuft to the next: the golden angle never repeats a direction.
const TURN: f32 = 0.381_966 * TAU;

/// Roots of all blades that grow in tufts, `count` before thinning.
pub(crate) fn roots(
    surface: &Surface,
    count: u64,
    desc: &FieldDesc,
    mask: &Mask,
    tint: &Tint,
) -> Vec<Root> {
    let Some(tufts) = desc.tufts.filter(|_| count > 0) else {
        return Vec::new();
    };
    // More tufts than blades would be work for nothing.
    let least_m = (PACKING * surface.area_m2() / count as f64).sqrt() as f32;
    let radius_m = tufts.radius_m.max(least_m);
    let (centers, adjacency) =
        rayon::join(|| darts::throw(surface, radius_m, desc.seed), || Adjacency::new(surface));
    let stream = Stream::new(desc.seed, Purpose::Tuft);
    let firsts = firsts(count, centers.len(), stream);
    let tuft = Tuft { surface, adjacency: &adjacency, spread_m: tufts.spread_m };
    (centers.par_iter().enumerate())
        .flat_map_iter(|(i, center)| {
            let angle = stream.at(i as u64).unit() * TAU;
            let run = firsts[i]..firsts[i + 1];
            let size = (run.end - run.start) as f32;
            let blades = Stream::new(desc.seed, Purpose::TuftBlade);
            let tuft = &tuft;
            run.enumerate().filter_map(move |(n, key)| {
                let mut draws = blades.at(key);
                // A jittered spiral: fuller than fully random places, yet no pattern shows.
                let t = (n as f32 + draws.unit()) / size;
                let angle = angle + n as f32 * TURN + draws.unit();
                let end = tuft.place(center, angle, t, &mut draws);
                let lean = end.direction.as_vec3() * tuft.lean(&end);
                let Spot { position, normal, .. } = end.spot;
                mask.keeps(&end.spot, draws.unit()).then_some(Root {
                    position,
                    normal,
                    lean,
                    key: key as u32,
                    tuft: Some(i as u32),
                    tint: tint.at(&end.spot),
                })
            })
        })
        .collect()
}

/// The first blade of each tuft, and the end: tufts differ in size by up to 0.5 to 1.5 times.
fn firsts(count: u64, tufts: usize, stream: Stream) -> Vec<u64> {
    let mut sum = 0.0;
    let ends: Vec<f64> = (0..tufts as u64)
        .map(|i| {
            let mut draws = stream.at(i);
            draws.bits();
            sum += 0.5 + draws.unit_f64();
            sum
        })
        .collect();
    let last = ends.last().copied().unwrap_or(1.0);
    std::iter::once(0)
        .chain(ends.iter().map(|end| ((end / last) * count as f64).round() as u64))
        .collect()
}

struct Tuft<'a> {
    surface: &'a Surface,
    adjacency: &'a Adjacency,
    spread_m: f32,
}

impl Tuft<'_> {
    /// Places a blade at the share `t` of the tuft, counted from its centre.
    fn place(&self, center: &Spot, angle: f32, t: f32, draws: &mut Draws) -> End {
        // Denser towards the centre: an even disk would take the square root.
        let reach = f64::from(self.spread_m * t.powf(0.8));
        let toward = walk::direction(self.surface, center, angle);
        let end = walk::walk(self.surface, self.adjacency, center, toward, reach);
        if end.walked_m >= reach {
            return end;
        }
        // The surface ends here. Spread over the way to its edge, or blades would line it.
        let nearer = end.walked_m * draws.unit_f64();
        walk::walk(self.surface, self.adjacency, center, toward, nearer)
    }

    fn lean(&self, end: &End) -> f32 {
        RIM_LEAN * (end.walked_m as f32 / self.spread_m.max(f32::MIN_POSITIVE)).min(1.0)
    }
}
