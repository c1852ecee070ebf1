//! Growing: once per field, on the CPU. `surface -> scatter -> blades -> patches`.

pub(crate) mod blades;
mod darts;
mod fragment;
mod mask;
mod noise;
pub(crate) mod obstacles;
mod order;
pub(crate) mod patches;
pub(crate) mod random;
pub(crate) mod scatter;
pub mod shapes;
pub mod surface;
pub mod terrain;
mod texels;
mod tint;
pub(crate) mod tufts;
mod walk;
pub(crate) mod weld;

use crate::{Error, Range, Species};
use glam::Vec3;

/// One plant, unquantised, in world space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blade {
    /// Root v0, metres.
    pub root: Vec3,
    /// Unit up direction.
    pub up: Vec3,
    /// Facing: angle about `up`, radians in 0..2 pi, from the first axis of the tangent frame of `up`
    /// (`crate::gpu::quantize::tangent_frame`).
    pub facing: f32,
    /// Length, metres.
    pub height: f32,
    /// Full width at the root, metres.
    pub width: f32,
    /// Response `s`, 1/s.
    pub response: f32,
    /// Index into the field's species.
    pub species: u8,
}

/// A run of blades that lie near each other: the unit of coarse culling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// Index of its first blade; patch `i` starts at `i * patch_size`.
    pub first: u32,
    /// Number of blades: `patch_size`, or fewer in the last patch.
    pub count: u32,
    /// Smallest corner of the roots' bounding box.
    pub root_min: Vec3,
    /// Largest corner of the roots' bounding box.
    pub root_max: Vec3,
    /// Smallest corner of a box that holds every pose of every blade.
    pub reach_min: Vec3,
    /// Largest corner of that box.
    pub reach_max: Vec3,
}

/// Coordinates beyond this are refused: squares of them must fit an `f32`.
pub(crate) const FARTHEST_M: f32 = 1e9;

impl Blade {
    /// Checks a blade that was placed by hand; `index` names it in messages.
    pub(crate) fn check(&self, index: usize, species: &[Species]) -> Result<(), Error> {
        let bad = |part: &str, cause: String| {
            Err(Error::setting(format!("blades[{index}].{part}"), cause))
        };
        // Each test is also false for NaN.
        if !self.root.abs().cmple(Vec3::splat(FARTHEST_M)).all() {
            return bad("root", format!("{} is not within {FARTHEST_M:e} m", self.root));
        }
        if !self.up.is_normalized() {
            return bad("up", format!("{} is not a unit vector; normalise it", self.up));
        }
        if !self.facing.is_finite() {
            return bad("facing", format!("{} is not an angle", self.facing));
        }
        let Some(own) = species.get(usize::from(self.species)) else {
            let cause = format!("{} of {}, counted from 0", self.species, species.len());
            return bad("species", cause);
        };
        // The GPU keeps each as a step in the species' range
        let parts = [
            ("height", self.height, own.height_m),
            ("width", self.width, own.width_m),
            ("response", self.response, own.response),
        ];
        for (part, value, range) in parts {
            let slack = 1e-4 * range.max;
            if !(value >= range.min - slack && value <= range.max + slack) {
                let (name, Range { min, max }) = (&own.name, range);
                return bad(part, format!("{value} is not within {name}'s {min} to {max}"));
            }
        }
        Ok(())
    }
}
