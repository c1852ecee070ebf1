//! Coverage, luminance and colour against distance, and how they drift where plants change form.
//!
//! Pixels are sorted by how far the ground under them is, whatever covers it, and summed by distance,
//! as they are under test and in the reference. So each sum is over the same pixels in both.

use super::bins::{Bin, Bins};
use super::pair::Pair;
use crate::stage::StageOptions;
use anyhow::Result;
use serde::Serialize;
use sward::{Change, View};
use sward_scene::{Camera, Scene};

/// Drift, over all views and changes.
#[derive(Debug, Clone, Serialize)]
pub struct Drift {
    /// Of the share of the picture that is grass.
    pub coverage: f32,
    /// Of the light.
    pub luminance: f32,
    /// Of the colour, brightness left out.
    pub colour: f32,
    /// The largest standard error of coverage and luminance across a change, as a share: what chance
    /// makes of it, by which plants are kept and where they stand.
    pub error: f32,
    /// Each view.
    pub views: Vec<ViewDrift>,
}

/// What one camera sees.
#[derive(Debug, Clone, Serialize)]
pub struct ViewDrift {
    /// Which cameras.
    pub camera: String,
    /// Ranges of distance, nearest first.
    pub bins: Vec<Bin>,
    /// Changes that the ranges reach across.
    pub changes: Vec<ChangeDrift>,
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
    /// Largest standard error of the two first, as a share.
    pub error: f32,
}

/// Measures from groups of cameras, each of which is taken together.
pub(super) fn measure(
    pair: &mut Pair,
    scene: &Scene,
    options: &StageOptions,
    views: &[(&str, Vec<Camera>)],
    step: &dyn Fn(),
) -> Result<Drift> {
    pair.show_sky(false);
    let tallest = scene.fields.iter().flat_map(|field| &field.desc.species);
    let tallest_m = tallest.fold(0.0, |most: f32, species| most.max(species.height_m.max));
    let mut drifts = Vec::new();
    for (name, cameras) in views {
        let mut bins = Bins::new(options.size, tallest_m);
        for camera in cameras {
            pair.look_from(camera)?;
            let places = pair.opaque_places()?;
            let (reference, test) = pair.light_maps()?;
            bins.add(camera, &places, &reference, &test);
            step();
        }
        let bins = bins.sums();
        let changes = cameras.first().map(|camera| changes(scene, options, camera));
        let across = changes.iter().flatten().filter_map(|change| across(&bins, change)).collect();
        drifts.push(ViewDrift { camera: (*name).into(), bins, changes: across });
    }
    pair.show_sky(true);
    let largest = |pick: fn(&ChangeDrift) -> f32| {
        drifts.iter().flat_map(|view| &view.changes).map(pick).fold(0.0, f32::max)
    };
    let (coverage, luminance) = (largest(|c| c.coverage), largest(|c| c.luminance));
    let error = largest(|c| c.error);
    Ok(Drift { coverage, luminance, colour: largest(|c| c.colour), error, views: drifts })
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

/// From the last range before a change to the first after it; `None` where they do not reach so far.
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
        error: largest(&|bin| {
            let both = bin.error.iter().zip(first.error).map(|(own, other)| own.hypot(other));
            both.fold(0.0, f32::max)
        }),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bin(range_m: [f32; 2], ratio: f32) -> Bin {
        let gray = [1.0; 3];
        let coverage = [0.2, 0.2 * ratio];
        Bin { range_m, coverage, luminance: [0.3; 2], colour: [gray; 2], error: [0.01; 2] }
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
