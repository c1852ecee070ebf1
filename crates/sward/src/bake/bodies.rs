//! What the plants of quads of a field look like.

use super::color::{Tones, plant_tones, tones};
use crate::Field;
use crate::plants::body::Body;
use crate::shared::noise_twin::hash01;
use std::sync::Arc;

/// By species and variant; none for blades.
pub(super) struct Bodies(Vec<Vec<Arc<Body>>>);

impl Bodies {
    pub(super) fn of(field: &Field) -> Self {
        let variants = |form| Body::variants(form).into_iter().map(Arc::new).collect();
        Self(field.species().iter().map(|species| variants(&species.form)).collect())
    }

    /// Whether any plant has one.
    pub(super) fn any(&self) -> bool {
        self.0.iter().any(|variants| !variants.is_empty())
    }

    /// The twin of `variant_of` in look.wgsl.
    pub(super) fn body(&self, field: &Field, index: usize) -> Option<&Arc<Body>> {
        let variants = self.0.get(usize::from(field.blades()[index].species))?;
        let at = (hash01(index as u32, 41) * variants.len() as f32) as usize;
        variants.get(at.min(variants.len().saturating_sub(1)))
    }

    /// A plant's colours.
    pub(super) fn tones(&self, field: &Field, index: usize) -> Tones {
        if let Some(body) = self.body(field, index) {
            return plant_tones(body.mean, index as u32);
        }
        let mix = if field.color(index).is_some() { field.tint_mix() } else { 0.0 };
        let species = &field.species()[usize::from(field.blades()[index].species)];
        tones(species, index as u32, mix)
    }
}
