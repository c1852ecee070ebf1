//! The pictures of all of a field's plants as layers of two arrays, and their models.

use super::kinds::model;
use super::mesh::{RIBBON_POINTS, points};
use super::model::{MAX_RIBBONS, Model};
use super::paint::paint_model;
use super::{Angle, Look, Picture, Plant, strip};
use crate::Error;
use crate::bake::layers::{Layers, color_of, thin_of};
use crate::bake::mips::{Chain, chain, passing};
use rayon::prelude::*;
use std::f32::consts::TAU;
use std::sync::{Arc, OnceLock};

/// Texels a side of a layer.
pub(crate) const LAYER_SIZE: u32 = 128;
/// Variants of a kind.
pub(crate) const VARIANTS: u32 = 4;
/// Layers of a variant: seen from three sides, 60 degrees apart, one for each quad.
pub(crate) const VIEWS: u32 = 3;
/// Points of a model, absent ribbons included.
pub(crate) const MODEL_POINTS: u32 = MAX_RIBBONS as u32 * RIBBON_POINTS;

/// Layers of a field. A kind of plant has [`VARIANTS`] by [`VIEWS`] of them, those of kinds first;
/// then come pictures, one each; the last is the blade of strips.
#[derive(Debug)]
pub(crate) struct PlantLayers {
    pub(crate) color: Layers,
    pub(crate) normal: Layers,
    /// A row of [`MODEL_POINTS`] a variant, all of zeros beyond its ribbons.
    pub(crate) models: Vec<[u32; 4]>,
    looks: Vec<Look>,
}

/// Which layers a look has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct LayerRange {
    pub(crate) first: u32,
    pub(crate) count: u32,
}

/// The angle of a view of a variant.
pub(crate) fn view_angle(view: u32) -> Angle {
    Angle::Side { turned: view as f32 * TAU / 6.0 }
}

fn layers_of(look: &Look) -> u32 {
    match look {
        Look::Plant(_) => VARIANTS * VIEWS,
        Look::Picture(_) => 1,
    }
}

/// A variant, and its views with their mips.
type Painted = (Model, Vec<Chain>);

fn painted(plant: Plant, variant: u32) -> Painted {
    let model = model(plant, u64::from(variant));
    let view = |view| {
        let tile = paint_model(&model, plant.width_share(), view_angle(view), LAYER_SIZE);
        let cover = tile.coverage();
        chain(tile, cover)
    };
    let views = (0..VIEWS).into_par_iter().map(view).collect();
    (model, views)
}

fn picture_chain(picture: &Picture) -> Chain {
    let tile = picture.resampled(LAYER_SIZE);
    let shown = passing(&tile);
    chain(tile, shown)
}

/// The blade of strips, made once.
fn strip_chain() -> &'static Chain {
    static STRIP: OnceLock<Chain> = OnceLock::new();
    STRIP.get_or_init(|| {
        let tile = strip::strip(LAYER_SIZE);
        let shown = passing(&tile);
        chain(tile, shown)
    })
}

fn model_row(model: &Model, width: f32) -> Vec<[u32; 4]> {
    let mut row: Vec<_> = model.ribbons.iter().flat_map(|r| points(r, width)).collect();
    row.resize(MODEL_POINTS as usize, [0; 4]);
    row
}

impl PlantLayers {
    /// Paints what the looks need, each once.
    pub(crate) fn new<'a>(wanted: impl Iterator<Item = &'a Look>) -> Self {
        let mut looks: Vec<Look> = Vec::new();
        for look in wanted {
            if !looks.iter().any(|known| same(known, look)) {
                looks.push(look.clone());
            }
        }
        // Kinds first, so that a layer tells its model's row
        looks.sort_by_key(|look| matches!(look, Look::Picture(_)));
        let kinds = looks.iter().filter_map(|look| match look {
            Look::Plant(plant) => Some(*plant),
            Look::Picture(_) => None,
        });
        let variants: Vec<_> = kinds.flat_map(|k| (0..VARIANTS).map(move |v| (k, v))).collect();
        let widths = variants.clone().into_iter().map(|(kind, _)| kind.width_share());
        let painted: Vec<Painted> = variants.into_par_iter().map(|(k, v)| painted(k, v)).collect();
        let row = |(painted, width): (&Painted, f32)| model_row(&painted.0, width);
        let models = painted.iter().zip(widths).flat_map(row).collect();
        let mut chains: Vec<Chain> = painted.into_iter().flat_map(|(_, views)| views).collect();
        for look in &looks {
            if let Look::Picture(picture) = look {
                chains.push(picture_chain(picture));
            }
        }
        chains.push(strip_chain().clone());
        Self {
            color: Layers::new(&chains, color_of),
            normal: Layers::new(&chains, thin_of),
            models,
            looks,
        }
    }

    /// Checks that the layers fit one array of the device.
    pub(crate) fn check(&self, limits: &wgpu::Limits) -> Result<(), Error> {
        let needed = self.color.count;
        if needed <= limits.max_texture_array_layers {
            return Ok(());
        }
        Err(Error::Limit {
            what: format!("a field with {needed} pictures of plants"),
            limit: "max_texture_array_layers",
            needed: needed.into(),
            available: limits.max_texture_array_layers.into(),
            remedy: "use fewer kinds of plants, each of which has 12, or fewer pictures".into(),
        })
    }

    /// The layers of a look; those of the strips' blade where it is not among them.
    pub(crate) fn range(&self, look: &Look) -> LayerRange {
        let mut first = 0;
        for known in &self.looks {
            let count = layers_of(known);
            if same(known, look) {
                return LayerRange { first, count };
            }
            first += count;
        }
        self.strip()
    }

    /// The layer of the blade of strips.
    pub(crate) fn strip(&self) -> LayerRange {
        LayerRange { first: self.color.count - 1, count: 1 }
    }
}

/// Pictures are the same where they are one in memory, or alike.
fn same(a: &Look, b: &Look) -> bool {
    match (a, b) {
        (Look::Picture(a), Look::Picture(b)) => Arc::ptr_eq(a, b) || a == b,
        _ => a == b,
    }
}
