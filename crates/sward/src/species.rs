//! Species: what one kind of plant is.

use crate::error::{above_zero, within};
use crate::{Billboard, Error, Look, Picture};
use std::sync::Arc;

/// Longest and widest blade, metres.
const LARGEST_M: f32 = 1000.0;
/// Highest response, 1/s.
const STIFFEST: f32 = 1000.0;

/// An inclusive range that a per-blade value is drawn from: uniformly, but for heights, which also
/// follow their neighbours (broad waves over the field, and a size for each tuft).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Smallest value.
    pub min: f32,
    /// Largest value.
    pub max: f32,
}

impl Range {
    /// A range from `min` to `max`.
    pub const fn new(min: f32, max: f32) -> Self {
        Self { min, max }
    }
    /// The value at `t` in 0..=1.
    pub fn at(self, t: f32) -> f32 {
        self.min + (self.max - self.min) * t
    }
}

/// A pair of linear sRGB colours; each blade's colour lies between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ColorRange {
    /// One end, linear sRGB reflectance, 0..=1.
    pub from: [f32; 3],
    /// The other end.
    pub to: [f32; 3],
}

/// The outline of a blade, from the root (v = 0) to the tip (v = 1). J section 5.2, equation 22.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Shape {
    /// Full width to the top.
    Quad,
    /// Tapers evenly to a point.
    Triangle,
    /// One straight edge, one parabolic: a point at one side.
    Quadratic,
    /// Full width up to `tip`, then a triangle.
    TriangleTip {
        /// Share of the length, 0..1, where the taper begins: higher is blunter.
        tip: f32,
    },
    /// The outline of a dandelion leaf, our own: a narrow stalk, lobes that grow towards the tip and
    /// hang back towards the root, a blunt end. It is cut from the full width pixel by pixel, so
    /// that the lobes stay at every level; a pixel costs a little more than one of another shape.
    Dandelion,
}

/// Two textured triangle strips that share the plant's middle line (Olofsson and Silven 2012, called
/// O), of the species' own height and width. They follow the plant's curve, so wind, gravity and
/// colliders move them, and sway beside on a sinusoid. The texture gives their outline: the species'
/// [`Shape`] and ridge are not used.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// Angle that the two strips are folded towards each other by, degrees, 0..=150: 0 is one flat
    /// blade; higher is seen from more sides, and narrower from the front.
    pub fold_deg: f32,
    /// How far the tip swings on O's sinusoid at wind of strength 1, radians, 0..=1. Each plant has a
    /// phase of its own; the strongest cosine of the wind gives the time, the winds that blow
    /// everywhere the strength. 0 leaves all motion to the physics.
    pub sway: f32,
    /// Most of O's orange that is mixed into the tint of a plant, 0..=1: each has a share of its own.
    pub orange: f32,
    /// Height on the screen, pixels at detail 1, about which a strip changes from many rings to few;
    /// above 0. Higher is faster, and shows corners in bent strips.
    pub few_rings_px: f32,
    /// A picture of the blade in place of the library's own, [`Picture::strip`]: its tip above, in greys
    /// of a mean reflectance of about a half, which the species' colours tint.
    pub texture: Option<Arc<Picture>>,
}

impl Default for Strip {
    fn default() -> Self {
        Self { fold_deg: 60.0, sway: 0.2, orange: 0.35, few_rings_px: 70.0, texture: None }
    }
}

impl Strip {
    fn check(&self, path: &str) -> Result<(), Error> {
        let at = |setting: &str| format!("{path}.{setting}");
        within(&at("fold_deg"), self.fold_deg, 0.0, 150.0)?;
        within(&at("sway"), self.sway, 0.0, 1.0)?;
        within(&at("orange"), self.orange, 0.0, 1.0)?;
        above_zero(&at("few_rings_px"), self.few_rings_px, 1e6)
    }

    /// What `GpuSpecies::look_values` holds of it.
    pub(crate) fn values(&self) -> [f32; 4] {
        [self.fold_deg.to_radians(), self.sway, self.orange, self.few_rings_px]
    }
}

/// What a plant is drawn as near the camera, in views whose technique leaves the choice.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub enum Form {
    /// A curved blade.
    #[default]
    Blade,
    /// Strips.
    Strip(Strip),
    /// A modelled plant, then quads.
    Billboard(Billboard),
}

impl Form {
    /// Number in the shaders.
    pub(crate) fn number(&self) -> u32 {
        match self {
            Self::Blade => 0,
            Self::Strip(_) => 1,
            Self::Billboard(_) => 2,
        }
    }

    /// What is painted or given for it; none for blades, and for strips of the library's own texture.
    pub(crate) fn look(&self) -> Option<Look> {
        match self {
            Self::Blade => None,
            Self::Strip(strip) => strip.texture.clone().map(Look::Picture),
            Self::Billboard(billboard) => Some(billboard.look.clone()),
        }
    }
}

/// One kind of plant.
#[derive(Debug, Clone, PartialEq)]
pub struct Species {
    /// Name, for messages.
    pub name: String,
    /// Share of the mix, relative to the other species' shares; above 0.
    pub share: f32,
    /// Outline.
    pub shape: Shape,
    /// What it is drawn as near the camera.
    pub form: Form,
    /// Length of the blade, metres, above 0.
    pub height_m: Range,
    /// Full width at the root, metres, above 0.
    pub width_m: Range,
    /// Response `s`, 1/s: how fast the blade returns to rest. Higher is stiffer and livelier;
    /// 3 to 8 look like grass.
    pub response: Range,
    /// Droop `gamma`: gravity's pull as a share of the height. 0.3 to 0.65 lean 6 to 25 degrees.
    pub droop: Range,
    /// How strongly wind acts, times the wind's own strength. 1 is grass, 0 a blade of steel.
    pub gust: f32,
    /// Arch `kappa`, 0..=1: 0 is J's rule (equation 10), higher lets the tip hang over.
    pub arch: f32,
    /// 3D displacement, 0..=1: 0 is flat, 1 folds the blade to a right angle (J equation 23).
    pub ridge: f32,
    /// Colour at the root.
    pub root_color: ColorRange,
    /// Colour at the tip.
    pub tip_color: ColorRange,
}

impl Default for Species {
    /// Meadow grass about 40 cm high.
    fn default() -> Self {
        Self {
            name: "grass".into(),
            share: 1.0,
            shape: Shape::TriangleTip { tip: 0.5 },
            form: Form::default(),
            height_m: Range::new(0.25, 0.5),
            width_m: Range::new(0.008, 0.014),
            response: Range::new(3.5, 6.5),
            droop: Range::new(0.3, 0.6),
            gust: 1.0,
            arch: 0.2,
            ridge: 0.5,
            root_color: ColorRange { from: [0.03, 0.07, 0.012], to: [0.05, 0.08, 0.02] },
            tip_color: ColorRange { from: [0.16, 0.30, 0.05], to: [0.34, 0.38, 0.10] },
        }
    }
}

impl Species {
    /// Checks every value; `path` names the species in messages, such as `species[1]`.
    pub(crate) fn check(&self, path: &str) -> Result<(), Error> {
        let at = |setting: &str| format!("{path}.{setting}");
        above_zero(&at("share"), self.share, 1e6)?;
        if let Shape::TriangleTip { tip } = self.shape
            && !(0.0..1.0).contains(&tip)
        {
            let cause = format!("{tip} is out of range; use 0 to below 1");
            return Err(Error::setting(at("shape.tip"), cause));
        }
        if let Form::Strip(strip) = &self.form {
            strip.check(&at("form.strip"))?;
        }
        self.height_m.check(&at("height_m"), Some(LARGEST_M))?;
        self.width_m.check(&at("width_m"), Some(LARGEST_M))?;
        self.response.check(&at("response"), Some(STIFFEST))?;
        self.droop.check(&at("droop"), None)?;
        within(&at("gust"), self.gust, 0.0, 100.0)?;
        within(&at("arch"), self.arch, 0.0, 1.0)?;
        within(&at("ridge"), self.ridge, 0.0, 1.0)?;
        if let Form::Billboard(billboard) = &self.form {
            billboard.check(&at("form"))?;
        }
        self.root_color.check(&at("root_color"))?;
        self.tip_color.check(&at("tip_color"))
    }
}

impl Range {
    /// Checks that both ends are above 0 and at most `most`; or, without, that they lie in 0..=10.
    fn check(self, path: &str, most: Option<f32>) -> Result<(), Error> {
        for (end, value) in [("min", self.min), ("max", self.max)] {
            let setting = format!("{path}.{end}");
            match most {
                Some(most) => above_zero(&setting, value, most)?,
                None => within(&setting, value, 0.0, 10.0)?,
            }
        }
        if self.min > self.max {
            let cause = format!("min {} is above max {}; swap them", self.min, self.max);
            return Err(Error::setting(path, cause));
        }
        Ok(())
    }
}

impl ColorRange {
    fn check(&self, path: &str) -> Result<(), Error> {
        for (end, color) in [("from", self.from), ("to", self.to)] {
            for value in color {
                within(&format!("{path}.{end}"), value, 0.0, 1.0)?;
            }
        }
        Ok(())
    }
}
