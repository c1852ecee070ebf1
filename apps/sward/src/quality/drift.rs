//! Coverage, luminance and colour against distance, and how they drift where plants change form.
//!
//! Near and far plane of a camera cut out slabs of distance, so that what lies before and behind
//! does not count. A slab is drawn twice, as it is under test and as a reference.

use super::ground::Ground;
use super::pair::Pair;
use crate::stage::{LightMap, StageOptions};
use anyhow::Result;
use glam::{Quat, Vec3};
use serde::Serialize;
use sward::{Change, View};
use sward_scene::{Camera, Scene};

/// Pixels' worth of grass that a slab must show in the reference to be counted.
const LEAST_PIXELS: f32 = 200.0;

/// Drift, over all views and changes.
#[derive(Debug, Clone, Serialize)]
pub struct Drift {
    /// Of the share of the picture that is grass.
    pub coverage: f32,
    /// Of the light.
    pub luminance: f32,
    /// Of the colour, brightness left out.
    pub colour: f32,
    /// Each view.
    pub views: Vec<ViewDrift>,
}

/// What one camera sees.
#[derive(Debug, Clone, Serialize)]
pub struct ViewDrift {
    /// Which camera.
    pub camera: String,
    /// Slabs of distance, nearest first.
    pub bins: Vec<Bin>,
    /// Changes that the slabs reach across.
    pub changes: Vec<ChangeDrift>,
}

/// A slab of distance.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Bin {
    /// Its near and far plane, metres.
    pub range_m: [f32; 2],
    /// Share of the picture that is grass: reference, test.
    pub coverage: [f32; 2],
    /// Mean luminance of the whole picture, of which the slab is all that is not black.
    pub luminance: [f32; 2],
    /// Mean colour, as parts of its own luminance.
    pub colour: [[f32; 3]; 2],
}

/// How far test over reference moves across a change.
#[derive(Debug, Clone, Serialize)]
pub struct ChangeDrift {
    /// Which change.
    pub name: String,
    /// Where it begins and ends, metres.
    pub range_m: [f32; 2],
    /// Largest change of test over reference from before, as a share.
    pub coverage: f32,
    /// Likewise.
    pub luminance: f32,
    /// Largest change of the difference in colour.
    pub colour: f32,
}

/// Measures in `slabs` slabs altogether, as many a view.
pub(super) fn measure<const N: usize>(
    pair: &mut Pair,
    scene: &Scene,
    options: &StageOptions,
    views: [(&str, Camera); N],
    slabs: u32,
    step: &dyn Fn(),
) -> Result<Drift> {
    let ground = Ground::new(scene, Quat::IDENTITY);
    pair.show_sky(false);
    let mut drifts = Vec::new();
    for (name, camera) in views {
        let changes = changes(scene, options, &camera);
        let mut bins = Vec::new();
        for range_m in ranges(&ground, &camera, slabs) {
            let [near_m, far_m] = range_m;
            pair.look_from(&Camera { near_m, far_m, ..camera.clone() })?;
            let (reference, test) = pair.light_maps()?;
            bins.extend(Bin::new(range_m, &reference, &test));
            step();
        }
        let across = changes.iter().filter_map(|change| across(&bins, change)).collect();
        drifts.push(ViewDrift { camera: name.into(), bins, changes: across });
    }
    pair.show_sky(true);
    let largest = |pick: fn(&ChangeDrift) -> f32| {
        drifts.iter().flat_map(|view| &view.changes).map(pick).fold(0.0, f32::max)
    };
    let (coverage, luminance) = (largest(|c| c.coverage), largest(|c| c.luminance));
    Ok(Drift { coverage, luminance, colour: largest(|c| c.colour), views: drifts })
}

/// Slabs whose depths grow with the distance.
fn ranges(ground: &Ground, camera: &Camera, slabs: u32) -> Vec<[f32; 2]> {
    let far = ground.farthest(camera.eye).min(camera.far_m);
    let near = camera.near_m.max(far / 150.0).min(far * 0.5);
    let edge = |i: u32| near * (far / near).powf(i as f32 / slabs as f32);
    (0..slabs).map(|i| [edge(i), edge(i + 1)]).collect()
}

/// The changes of all species, those of one name joined.
fn changes(scene: &Scene, options: &StageOptions, camera: &Camera) -> Vec<Change> {
    let aspect = options.size[0] as f32 / options.size[1] as f32;
    let clip_from_view = camera.clip_from_view(aspect);
    let mut view = View::new(camera.view_from_world(), clip_from_view, options.size);
    view.technique = options.technique;
    view.level = options.level;
    let mut joined: Vec<Change> = Vec::new();
    let species = scene.fields.iter().flat_map(|field| &field.desc.species);
    for change in species.flat_map(|species| view.changes(species)) {
        match joined.iter_mut().find(|known| known.name == change.name) {
            Some(known) => {
                known.nearest_m = known.nearest_m.min(change.nearest_m);
                known.farthest_m = known.farthest_m.max(change.farthest_m);
            }
            None => joined.push(change),
        }
    }
    joined
}

const LUMINANCE: Vec3 = Vec3::new(0.2126, 0.7152, 0.0722);

impl Bin {
    /// `None` where hardly any grass shows.
    fn new(range_m: [f32; 2], reference: &LightMap, test: &LightMap) -> Option<Self> {
        let sums = |map: &LightMap| {
            let start = (Vec3::ZERO, 0.0_f32);
            map.pixels().fold(start, |(light, grass), (l, g)| (light + l, grass + g))
        };
        let pixels = (reference.size[0] * reference.size[1]) as f32;
        let both = [sums(reference), sums(test)];
        if both[0].1 < LEAST_PIXELS {
            return None;
        }
        let luminance = both.map(|(light, _)| light.dot(LUMINANCE) / pixels);
        Some(Self {
            range_m,
            coverage: both.map(|(_, grass)| grass / pixels),
            luminance,
            colour: both.map(|(light, _)| (light / light.dot(LUMINANCE).max(1e-9)).to_array()),
        })
    }

    fn ratio(pair: [f32; 2]) -> f32 {
        pair[1] / pair[0].max(1e-9)
    }

    fn colour_off(&self) -> Vec3 {
        let [reference, test] = self.colour.map(Vec3::from);
        (test - reference) / reference.length().max(1e-9)
    }
}

/// From the last slab before a change to the first after it; `None` where the slabs do not reach so
/// far.
fn across(bins: &[Bin], change: &Change) -> Option<ChangeDrift> {
    let before = bins.iter().rposition(|bin| bin.range_m[1] <= change.nearest_m).unwrap_or(0);
    let reached = bins.get(before)?.range_m[0] < change.farthest_m;
    let after = bins.iter().position(|bin| bin.range_m[0] >= change.farthest_m);
    let after = after.unwrap_or(bins.len().saturating_sub(1));
    if !reached || after <= before || change.nearest_m > bins.last()?.range_m[0] {
        return None;
    }
    let span = bins.get(before..=after)?;
    let first = span.first()?;
    let largest = |off: &dyn Fn(&Bin) -> f32| span.iter().map(off).fold(0.0, f32::max);
    let share = |pick: fn(&Bin) -> [f32; 2]| {
        let start = Bin::ratio(pick(first));
        largest(&move |bin| (Bin::ratio(pick(bin)) / start.max(1e-9) - 1.0).abs())
    };
    Some(ChangeDrift {
        name: change.name.into(),
        range_m: [change.nearest_m, change.farthest_m],
        coverage: share(|bin| bin.coverage),
        luminance: share(|bin| bin.luminance),
        colour: largest(&|bin| (bin.colour_off() - first.colour_off()).length()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bin(range_m: [f32; 2], ratio: f32) -> Bin {
        let gray = [1.0; 3];
        Bin { range_m, coverage: [0.2, 0.2 * ratio], luminance: [0.3; 2], colour: [gray; 2] }
    }

    #[test]
    fn drift_is_that_of_the_ratio_across_the_change() {
        let bins: Vec<_> = [1.1, 1.1, 1.1 * 1.05, 1.1, 1.3]
            .into_iter()
            .zip(1..)
            .map(|(ratio, i)| bin([i as f32, i as f32 + 1.0], ratio))
            .collect();
        let change = |nearest_m, farthest_m| Change { name: "c", nearest_m, farthest_m };
        let drift = across(&bins, &change(3.0, 4.0)).unwrap();
        assert!((drift.coverage - 0.05).abs() < 1e-4, "{drift:?}");
        assert!(drift.luminance < 1e-6 && drift.colour < 1e-6);
        assert!(across(&bins, &change(20.0, 30.0)).is_none());
        let all = across(&bins, &change(0.1, 40.0)).unwrap();
        assert!((all.coverage - (1.3 / 1.1 - 1.0)).abs() < 1e-4, "{all:?}");
    }
}
