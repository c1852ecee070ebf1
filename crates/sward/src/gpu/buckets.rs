//! Which draw lists the plants of a page may be in.

use super::layout::{BILLBOARD_BUCKETS, BUCKETS, CLUSTER_BUCKET, MODEL_BUCKET, STRIP_BUCKETS};
use super::quantize::has_flat_tip;
use crate::{Form, Look, Species, Technique};

/// A set of buckets.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Buckets(u16);

impl Buckets {
    /// Those that plants of these species may be in, in a view of that technique.
    pub fn of(species: &[Species], technique: Technique) -> Self {
        match technique {
            Technique::Blades => Self::blades(species.iter()),
            Technique::Strips => Self::strips(),
            Technique::Billboards => Self::bands(species),
            Technique::Continuum => {
                let strips = species.iter().any(|s| matches!(s.form, Form::Strip(_)));
                let strips = if strips { Self::strips().0 } else { 0 };
                Self(Self::bands(species).0 | strips | 1 << CLUSTER_BUCKET)
            }
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

    /// Every plant a strip.
    fn strips() -> Self {
        Self(STRIP_BUCKETS.iter().fold(0, |all, bucket| all | 1 << bucket))
    }

    /// In order.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..BUCKETS).filter(move |bucket| self.0 >> bucket & 1 == 1)
    }
}
