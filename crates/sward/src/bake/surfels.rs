//! Few representatives of much that shows: groups of alike normal, height and brightness.

use super::cover::Shown;
use crate::gpu::layout::GpuSurfel;
use glam::Vec3;

/// Representatives of an elevation.
pub(crate) const SURFELS: usize = 8;
/// Rounds of grouping.
const ROUNDS: usize = 6;
/// How much a whole height counts beside a whole turn of the normal.
const HEIGHT: f32 = 1.5;

/// Share of the sky that the canopy lets through to a height in it: the twin of `canopy_open` in
/// light.wgsl.
pub(crate) fn canopy_open(height_share: f32, root_open: f32) -> f32 {
    let t = height_share.clamp(0.0, 1.0);
    root_open + (1.0 - root_open) * (t * (1.6 - 0.6 * t))
}

/// How much darker a place is for its depth in the canopy: between the sun's light, which goes by
/// the square of what is open, and the sky's, which goes by itself.
pub(crate) fn depth_shade(height_share: f32, root_open: f32) -> f32 {
    canopy_open(height_share, root_open).powf(1.6)
}

/// A place with what it counts.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Weighted {
    /// What shows.
    pub shown: Shown,
    /// How much of it.
    pub weight: f32,
}

#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    weight: f32,
    normal: Vec3,
    albedo: Vec3,
    height: f32,
    shaded: Vec3,
    shade: f32,
}

impl Sum {
    fn add(&mut self, place: &Weighted, root_open: f32) {
        let Weighted { shown, weight } = *place;
        let shade = depth_shade(shown.height_share, root_open);
        self.weight += weight;
        self.normal += shown.normal * weight;
        self.albedo += shown.albedo * weight;
        self.height += shown.height_share * weight;
        self.shaded += shown.albedo * (weight * shade);
        self.shade += weight * shade;
    }

    fn center(&self) -> (Vec3, f32) {
        (self.normal / self.weight, self.height / self.weight)
    }
}

fn distance(center: (Vec3, f32), shown: &Shown) -> f32 {
    let height = (center.1 - shown.height_share) * HEIGHT;
    center.0.distance_squared(shown.normal) + height * height
}

fn nearest(centers: &[(Vec3, f32)], shown: &Shown) -> usize {
    let of = |i: usize| distance(centers[i], shown);
    (1..centers.len()).fold(0, |best, i| if of(i) < of(best) { i } else { best })
}

/// The first place, then each time the one that is farthest from those taken.
fn seeds(places: &[Weighted]) -> Vec<(Vec3, f32)> {
    let mut far = vec![f32::INFINITY; places.len()];
    let mut centers: Vec<(Vec3, f32)> = Vec::new();
    let mut next = 0;
    while centers.len() < SURFELS.min(places.len()) {
        let center = (places[next].shown.normal, places[next].shown.height_share);
        centers.push(center);
        for (own, place) in far.iter_mut().zip(places) {
            *own = own.min(distance(center, &place.shown));
        }
        next = (0..far.len()).fold(0, |best, i| if far[i] > far[best] { i } else { best });
    }
    centers
}

/// Groups places; weights of what is returned sum to one, or are all 0 where there are no places.
pub(crate) fn group(places: &[Weighted], root_open: f32) -> [GpuSurfel; SURFELS] {
    let mut centers = seeds(places);
    let mut sums = [Sum::default(); SURFELS];
    for _ in 0..ROUNDS {
        sums = [Sum::default(); SURFELS];
        for place in places {
            sums[nearest(&centers, &place.shown)].add(place, root_open);
        }
        for (center, sum) in centers.iter_mut().zip(&sums) {
            if sum.weight > 0.0 {
                *center = sum.center();
            }
        }
    }
    let total: f32 = sums.iter().map(|sum| sum.weight).sum();
    sums.map(|sum| surfel(&sum, total, root_open))
}

/// The mean of a group. Normals are left shorter than one, so that a lit side's light is the mean of
/// the group's; the colour is that which, at the mean height, is as bright as the group.
fn surfel(sum: &Sum, total: f32, root_open: f32) -> GpuSurfel {
    if sum.weight <= 0.0 {
        return GpuSurfel {
            normal: [0.0, 1.0, 0.0],
            weight: 0.0,
            albedo: [0.0; 3],
            height_share: 1.0,
        };
    }
    let (normal, height_share) = sum.center();
    let albedo = sum.shaded / (sum.weight * depth_shade(height_share, root_open)).max(1e-12);
    GpuSurfel {
        normal: normal.to_array(),
        weight: sum.weight / total,
        albedo: albedo.to_array(),
        height_share,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(normal: Vec3, height_share: f32, shade: f32) -> Weighted {
        let albedo = Vec3::splat(shade);
        Weighted { shown: Shown { normal: normal.normalize(), albedo, height_share }, weight: 1.0 }
    }

    #[test]
    fn groups_keep_the_means() {
        let places: Vec<_> = (0..500)
            .map(|i| {
                let turn = i as f32 * 2.399;
                let h = (i % 37) as f32 / 36.0;
                place(Vec3::new(turn.sin(), h, turn.cos().abs() + 0.1), h, 0.2 + 0.5 * h)
            })
            .collect();
        let surfels = group(&places, 0.2);
        let weight: f32 = surfels.iter().map(|s| s.weight).sum();
        assert!((weight - 1.0).abs() < 1e-5);
        let mean = |of: &dyn Fn(&Weighted) -> Vec3| places.iter().map(of).sum::<Vec3>() / 500.0;
        let normal: Vec3 = surfels.iter().map(|s| Vec3::from(s.normal) * s.weight).sum();
        assert!(normal.distance(mean(&|p| p.shown.normal)) < 1e-4);
        let shaded = |h: f32, a: Vec3| a * depth_shade(h, 0.2);
        let bright: Vec3 =
            surfels.iter().map(|s| shaded(s.height_share, s.albedo.into()) * s.weight).sum();
        assert!(bright.distance(mean(&|p| shaded(p.shown.height_share, p.shown.albedo))) < 1e-4);
    }

    #[test]
    fn few_places_make_few_groups_and_none_makes_none() {
        assert!(group(&[], 0.2).iter().all(|s| s.weight == 0.0));
        let one = group(&[place(Vec3::Z, 0.5, 0.3); 3], 0.2);
        assert!((one.iter().map(|s| s.weight).sum::<f32>() - 1.0).abs() < 1e-6);
        assert!(one.iter().filter(|s| s.weight > 0.0).all(|s| s.normal[2] == 1.0));
    }
}
