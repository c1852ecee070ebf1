//! Which draw lists the plants of a page may be in.

use super::layout::{BLADE_BUCKETS, BUCKETS};
use super::quantize::has_flat_tip;
use crate::{Species, Technique};

/// A set of buckets.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Buckets(u16);

impl Buckets {
    /// Those that plants of these species may be in, in a view of that technique.
    pub fn of(species: &[Species], technique: Technique) -> Self {
        match technique {
            Technique::Blades
            | Technique::Strips
            | Technique::Billboards
            | Technique::Continuum => Self::blades(species),
        }
    }

    /// Those of single blades.
    fn blades(species: &[Species]) -> Self {
        let lists = |s: &Species| if has_flat_tip(s) { 0xf0 } else { 0x0f };
        Self(species.iter().map(lists).fold(0, |all, own| all | own))
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
