//! Few representatives of much that shows: groups of alike normal and height, all of equal weight.

use super::cover::Shown;
use crate::gpu::layout::GpuSurfel;
use glam::Vec3;

/// Representatives of an elevation.
pub(crate) const SURFELS: usize = 1 << HALVINGS;
/// Halvings that lead to them.
const HALVINGS: usize = 5;
/// How much a whole height counts beside a whole turn of the normal.
const HEIGHT: f32 = 1.0;

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

/// What places are told apart by.
fn features(place: &Weighted) -> [f32; 4] {
    let [x, y, z] = place.shown.normal.to_array();
    [x, y, z, place.shown.height_share * HEIGHT]
}

/// The feature that varies most.
fn widest(places: &[Weighted]) -> usize {
    let weight: f32 = places.iter().map(|p| p.weight).sum();
    let variance = |axis: usize| {
        let mean = places.iter().map(|p| features(p)[axis] * p.weight).sum::<f32>() / weight;
        places.iter().map(|p| (features(p)[axis] - mean).powi(2) * p.weight).sum::<f32>()
    };
    let all: [f32; 4] = std::array::from_fn(variance);
    (1..4).fold(0, |best, axis| if all[axis] > all[best] { axis } else { best })
}

/// Halves the weight across the widest feature; a place in the middle goes to both halves in part.
fn halves(mut places: Vec<Weighted>) -> [Vec<Weighted>; 2] {
    let axis = widest(&places);
    places.sort_by(|a, b| features(a)[axis].total_cmp(&features(b)[axis]));
    let half = 0.5 * places.iter().map(|p| p.weight).sum::<f32>();
    let mut low = Vec::with_capacity(places.len() / 2 + 1);
    let mut weight = 0.0;
    while let Some(place) = places.get(low.len())
        && weight + place.weight < half
    {
        weight += place.weight;
        low.push(*place);
    }
    let mut high = places.split_off(low.len());
    if let Some(middle) = high.first_mut() {
        let own = (half - weight).clamp(0.0, middle.weight);
        low.push(Weighted { weight: own, ..*middle });
        middle.weight -= own;
    }
    high.retain(|place| place.weight > 0.0);
    low.retain(|place| place.weight > 0.0);
    [low, high]
}

/// Groups places. Each group has as much weight as another, and those of numbers that differ by a
/// multiple of four lie far from each other; where there are no places all weights are 0.
pub(crate) fn group(places: &[Weighted], root_open: f32) -> [GpuSurfel; SURFELS] {
    let mut groups = vec![places.to_vec()];
    for _ in 0..HALVINGS {
        groups = groups.into_iter().flat_map(halves).collect();
    }
    let sum = |list: &Vec<Weighted>| {
        list.iter().fold(Sum::default(), |mut sum, place| {
            sum.add(place, root_open);
            sum
        })
    };
    std::array::from_fn(|i| surfel(&groups.get(i).map(sum).unwrap_or_default(), root_open))
}

/// The mean of a group; the colour is that which, at the mean height, is as bright as the group.
fn surfel(sum: &Sum, root_open: f32) -> GpuSurfel {
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
        normal: normal.normalize_or(Vec3::Y).to_array(),
        weight: 1.0 / SURFELS as f32,
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
        assert!(surfels.iter().all(|s| (Vec3::from(s.normal).length() - 1.0).abs() < 1e-5));
        let mean = |of: &dyn Fn(&Weighted) -> Vec3| places.iter().map(of).sum::<Vec3>() / 500.0;
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
