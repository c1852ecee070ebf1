//! Which draw lists the plants of a page may be in.

use super::layout::{BILLBOARD_BUCKETS, BLADE_BUCKETS, BUCKETS, MODEL_BUCKET};
use super::quantize::has_flat_tip;
use crate::{Form, Look, Species, Technique};

/// A set of buckets.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Buckets(u16);

impl Buckets {
    /// Those that plants of these species may be in, in a view of that technique.
    pub fn of(species: &[Species], technique: Technique) -> Self {
        match technique {
            Technique::Blades | Technique::Strips => Self::blades(species.iter()),
            Technique::Billboards | Technique::Continuum => Self::bands(species),
        }
    }

    /// Those of single blades.
    fn blades<'a>(species: impl Iterator<Item = &'a Species>) -> Self {
        let lists = |s: &Species| if has_flat_tip(s) { 0xf0 } else { 0x0f };
        Self(species.map(lists).fold(0, |all, own| all | own))
    }

    /// Plants of quads in their three bands, and blades of the others.
    fn bands(species: &[Species]) -> Self {
        let of_quads = |s: &&Species| matches!(s.form, Form::Billboard(_));
        let blades = Self::blades(species.iter().filter(|s| !of_quads(s)));
        let modelled = |s: &Species| matches!(s.form.look(), Some(Look::Plant(_)));
        let [middle, far] = BILLBOARD_BUCKETS;
        let any_quads = species.iter().any(|s| of_quads(&s));
        let quads = if any_quads { 1 << middle | 1 << far } else { 0 };
        let models = if species.iter().any(modelled) { 1 << MODEL_BUCKET } else { 0 };
        Self(blades.0 | quads | models)
    }

    /// Of these, those of single blades.
    pub fn blades_only(self) -> Self {
        Self(self.0 & ((1 << BLADE_BUCKETS) - 1))
    }

    /// In order.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..BUCKETS).filter(move |bucket| self.0 >> bucket & 1 == 1)
    }
}
