//! Plants other than single blades: models made of ribbons, and pictures of them.
//!
//! A [`Plant`] is a small model, made anew from a seed for each of its variants. Near plants are
//! drawn as that model; the textures of billboards are pictures of it, so that near and far agree
//! in shape and colour. A host may give its own [`Picture`] instead.

pub(crate) mod body;
mod builder;
mod kinds;
pub(crate) mod layers;
pub(crate) mod mesh;
pub(crate) mod model;
mod paint;
mod picture;
mod strip;
#[cfg(test)]
mod tests;

pub use picture::{MipLevel, Picture};

use crate::Range;
use std::sync::Arc;

/// A kind of plant that the library can model and paint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Plant {
    /// A tuft of broad arching blades.
    MeadowGrass,
    /// A tuft with high stalks that bear seed heads.
    TallGrass,
    /// A dense tuft of thin, nearly upright blades.
    FineGrass,
    /// Leaves of three, and round pink heads.
    Clover,
    /// White rays round a yellow disc, over a rosette of leaves.
    Daisy,
    /// Red cups on hairy stems, with a nodding bud.
    Poppy,
    /// Blue heads of trumpet-shaped florets on slender stems.
    Cornflower,
    /// The white ball of seeds of a dandelion, over its toothed leaves.
    DandelionClock,
}

impl Plant {
    /// Every kind, grasses first.
    pub const ALL: [Self; 8] = [
        Self::MeadowGrass,
        Self::TallGrass,
        Self::FineGrass,
        Self::Clover,
        Self::Daisy,
        Self::Poppy,
        Self::Cornflower,
        Self::DandelionClock,
    ];

    /// Its name, in lower case with hyphens, such as `dandelion-clock`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::MeadowGrass => "meadow-grass",
            Self::TallGrass => "tall-grass",
            Self::FineGrass => "fine-grass",
            Self::Clover => "clover",
            Self::Daisy => "daisy",
            Self::Poppy => "poppy",
            Self::Cornflower => "cornflower",
            Self::DandelionClock => "dandelion-clock",
        }
    }

    /// The kind of that [name](Self::name).
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|plant| plant.name() == name)
    }

    /// Whether it is a grass: without flowers other than seed heads.
    pub const fn is_grass(self) -> bool {
        matches!(self, Self::MeadowGrass | Self::TallGrass | Self::FineGrass)
    }

    /// Full width of its box as a share of its height. A plant whose width is set otherwise is
    /// stretched.
    pub const fn width_share(self) -> f32 {
        match self {
            Self::MeadowGrass => 0.9,
            Self::TallGrass => 0.5,
            Self::FineGrass => 0.7,
            Self::Clover => 1.0,
            Self::Daisy => 0.8,
            Self::Poppy => 0.55,
            Self::Cornflower => 0.5,
            Self::DandelionClock => 0.8,
        }
    }

    /// How high it commonly grows, metres.
    pub const fn height_m(self) -> Range {
        match self {
            Self::MeadowGrass => Range::new(0.2, 0.4),
            Self::TallGrass => Range::new(0.6, 1.0),
            Self::FineGrass => Range::new(0.15, 0.3),
            Self::Clover => Range::new(0.12, 0.22),
            Self::Daisy => Range::new(0.1, 0.18),
            Self::Poppy => Range::new(0.35, 0.6),
            Self::Cornflower => Range::new(0.4, 0.7),
            Self::DandelionClock => Range::new(0.2, 0.35),
        }
    }
}

/// From where a plant is painted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Angle {
    /// From the side, on the level.
    Side {
        /// How far to go round the plant, against the clock seen from above, radians; 0 looks along
        /// -z.
        turned: f32,
    },
    /// From straight above, with -z up.
    Above,
}

/// What a plant looks like: a kind that the library models, or a picture.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Look {
    /// Modelled by the library: near plants are drawn as the model, farther ones as pictures of it,
    /// in several variants.
    Plant(Plant),
    /// A picture that the host gives. It has no model: near plants are drawn as blades, or as the
    /// picture. Shared, as a picture may be of many species.
    Picture(Arc<Picture>),
}

impl From<Plant> for Look {
    fn from(plant: Plant) -> Self {
        Self::Plant(plant)
    }
}

impl From<Picture> for Look {
    fn from(picture: Picture) -> Self {
        Self::Picture(Arc::new(picture))
    }
}
