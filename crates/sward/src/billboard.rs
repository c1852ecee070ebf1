//! Plants as textured quads about their up direction (Wang and Yao 2023).

use crate::error::within;
use crate::{Error, Look, Plant, Range, Species};

/// Most quads of a plant.
pub(crate) const MAX_QUADS: u32 = 6;

/// A plant of upright quads that share its middle line and stand on its base point: from `y` to
/// `y + height`. (The print has them reach half the height to either side, which would bury half of
/// the plant.) Near the camera it is a model, where its look has one.
///
/// The species' height and width are those of the quads: a picture is stretched over them.
#[derive(Debug, Clone, PartialEq)]
pub struct Billboard {
    /// What it looks like.
    pub look: Look,
    /// Quads, 1..=6. More look fuller from all around and cost as many vertices and pixels more.
    pub quads: u32,
    /// Angle from one quad to the next, degrees, 0..=180. 180 over the number of quads spreads them
    /// evenly: 60 for three.
    pub angle_deg: f32,
    /// How plants are turned about their up direction, degrees: equation 2, `theta0 + r`, as its least
    /// and largest value.
    pub turn_deg: Range,
    /// How common its sizes are: equation 3, `s0 + r`.
    pub sizes: Sizes,
    /// How far wind from the side turns it about its up direction, 0..=4 radians for each height that
    /// its tip moves sideways; 0 only bends it.
    pub wind_turn: f32,
    /// How much lighter it gets as wind bends it, 0..=1. More shows gusts more.
    pub wind_tint: f32,
    /// How much light it keeps from what is behind it, 0..=2, for each of its radii that the light
    /// passes: 0 is clear, 0.4 a loose tuft, 1 a dense one. Its sunny side is as much brighter, so that
    /// it is as bright in all at any setting.
    pub absorption: f32,
}

/// How common the three classes of size are, relative to each other. Small, medium and large have
/// their middle `s0` at 1/6, 1/2 and 5/6 of the species' heights; `r` is uniform and at most 1/6 of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sizes {
    /// Share of small ones, 0 or more.
    pub small: f32,
    /// Share of medium ones.
    pub medium: f32,
    /// Share of large ones.
    pub large: f32,
}

impl Default for Sizes {
    fn default() -> Self {
        Self { small: 0.3, medium: 0.5, large: 0.2 }
    }
}

impl Sizes {
    /// Place in the species' heights, 0..=1, of two draws in 0..1: the class, and `r` in it.
    pub(crate) fn place(self, class: f32, r: f32) -> f32 {
        let at = class * (self.small + self.medium + self.large);
        let s0 = if at < self.small {
            1.0 / 6.0
        } else if at < self.small + self.medium || self.large == 0.0 {
            0.5
        } else {
            5.0 / 6.0
        };
        (s0 + (2.0 * r - 1.0) / 6.0).clamp(0.0, 1.0)
    }

    fn check(self, path: &str) -> Result<(), Error> {
        for (name, share) in [("small", self.small), ("medium", self.medium), ("large", self.large)]
        {
            within(&format!("{path}.{name}"), share, 0.0, 1e6)?;
        }
        if self.small + self.medium + self.large > 0.0 {
            return Ok(());
        }
        Err(Error::setting(path, "all sizes have the share 0; give one of them more"))
    }
}

impl Billboard {
    /// Three quads 60 degrees apart, turned anyhow.
    pub fn new(look: impl Into<Look>) -> Self {
        Self {
            look: look.into(),
            quads: 3,
            angle_deg: 60.0,
            turn_deg: Range::new(0.0, 360.0),
            sizes: Sizes::default(),
            wind_turn: 1.0,
            wind_tint: 0.3,
            absorption: 0.4,
        }
    }

    /// Checks every value; `path` names it in messages.
    pub(crate) fn check(&self, path: &str) -> Result<(), Error> {
        let at = |setting: &str| format!("{path}.{setting}");
        if !(1..=MAX_QUADS).contains(&self.quads) {
            let cause = format!("{} is out of range; use 1 to {MAX_QUADS}", self.quads);
            return Err(Error::setting(at("quads"), cause));
        }
        within(&at("angle_deg"), self.angle_deg, 0.0, 180.0)?;
        let Range { min, max } = self.turn_deg;
        for end in [min, max] {
            within(&at("turn_deg"), end, -36_000.0, 36_000.0)?;
        }
        if min > max {
            let cause = format!("{min} is above {max}; swap them");
            return Err(Error::setting(at("turn_deg"), cause));
        }
        self.sizes.check(&at("sizes"))?;
        within(&at("wind_turn"), self.wind_turn, 0.0, 4.0)?;
        within(&at("wind_tint"), self.wind_tint, 0.0, 1.0)?;
        within(&at("absorption"), self.absorption, 0.0, 2.0)
    }
}

impl Species {
    /// A plant of the library's, as a model near the camera and as quads beyond: of its common height,
    /// as wide as it is painted.
    pub fn plant(plant: Plant) -> Self {
        let (height, share) = (plant.height_m(), plant.width_share());
        Self {
            name: plant.name().into(),
            form: crate::Form::Billboard(Billboard::new(plant)),
            height_m: height,
            width_m: Range::new(height.min * share, height.max * share),
            // What has a head stands straighter than a blade
            droop: if plant.is_grass() { Range::new(0.08, 0.2) } else { Range::new(0.03, 0.12) },
            arch: 0.0,
            ridge: 0.0,
            ..Self::default()
        }
    }
}
