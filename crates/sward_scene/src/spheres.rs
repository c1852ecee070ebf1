//! Spheres that move along paths and push blades aside.

use crate::Path;
use sward::Pose;

/// A sphere on a path.
#[derive(Debug, Clone, PartialEq)]
pub struct MovingSphere {
    /// Its name, for messages.
    pub name: String,
    /// Radius, metres.
    pub radius: f32,
    /// Where its centre is; it is turned too where it rolls.
    pub path: Path,
    /// Whether it is drawn too.
    pub visible: bool,
    /// Its colour, linear RGB reflectance.
    pub base_color: [f32; 3],
    /// Colour of every other stripe, by which its turning shows; none: it is plain.
    pub stripe_color: Option<[f32; 3]>,
    /// Roughness, 0 (mirror) to 1 (chalk).
    pub roughness: f32,
}

impl MovingSphere {
    /// The sphere at a time, seconds.
    pub fn at(&self, time_s: f64) -> sward::Sphere {
        sward::Sphere { center: self.pose_at(time_s).translation, radius: self.radius }
    }

    /// Place and turn at a time, seconds.
    pub fn pose_at(&self, time_s: f64) -> Pose {
        self.path.pose_at(time_s)
    }
}
