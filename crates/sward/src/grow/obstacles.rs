//! Where no root grows: inside the things that stand in the grass.

use super::FARTHEST_M;
use crate::solid::{Bvh, Solid};
use crate::{Error, Pose, Sphere};
use glam::Vec3;
use std::sync::Arc;

/// A thing that no root grows inside of, in world space.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Obstacle {
    /// A ball.
    Sphere(Sphere),
    /// All that is near a segment.
    Capsule {
        /// One end of the segment, metres.
        from: Vec3,
        /// The other; may be the same.
        to: Vec3,
        /// Radius, metres, above 0.
        radius: f32,
    },
    /// A box round its pose's origin.
    Cuboid {
        /// Half its edges, metres, each above 0.
        half_extents: Vec3,
        /// Where it stands.
        pose: Pose,
    },
    /// The inside of a mesh.
    Solid {
        /// The mesh, shared by all copies of it.
        solid: Arc<Solid>,
        /// Where it stands; its mesh's space is local.
        pose: Pose,
        /// How much larger it is here than its mesh, above 0.
        scale: f32,
    },
}

/// Obstacles by place: a field has up to millions of roots.
#[derive(Debug)]
pub(crate) struct Obstacles<'a> {
    all: &'a [Obstacle],
    bvh: Bvh,
}

impl<'a> Obstacles<'a> {
    /// Obstacles that have been checked.
    pub(crate) fn new(all: &'a [Obstacle]) -> Self {
        let boxes: Vec<_> = all.iter().map(Obstacle::bounds).collect();
        Self { all, bvh: Bvh::new(&boxes) }
    }

    /// Whether a point lies in one of them.
    pub(crate) fn contain(&self, point: Vec3) -> bool {
        let order = self.bvh.order();
        self.bvh.any_at(point, |place| self.all[order[place as usize] as usize].contains(point))
    }
}

impl Obstacle {
    /// Whether a point of the world lies inside.
    pub fn contains(&self, point: Vec3) -> bool {
        match self {
            Self::Sphere(sphere) => sphere.center.distance(point) <= sphere.radius,
            Self::Capsule { from, to, radius } => {
                let axis = *to - *from;
                let along =
                    (point - *from).dot(axis) / axis.length_squared().max(f32::MIN_POSITIVE);
                (*from + axis * along.clamp(0.0, 1.0)).distance(point) <= *radius
            }
            Self::Cuboid { half_extents, pose } => {
                local(pose, point).abs().cmple(*half_extents).all()
            }
            Self::Solid { solid, pose, scale } => solid.contains(local(pose, point) / *scale),
        }
    }

    /// Smallest and largest corner of a box that holds it.
    fn bounds(&self) -> (Vec3, Vec3) {
        let round = |center: Vec3, radius: f32| (center - radius, center + radius);
        let (low, high) = match self {
            Self::Sphere(sphere) => round(sphere.center, sphere.radius),
            Self::Capsule { from, to, radius } => {
                (from.min(*to) - *radius, from.max(*to) + *radius)
            }
            Self::Cuboid { half_extents, pose } => turned(pose, (-*half_extents, *half_extents)),
            Self::Solid { solid, pose, scale } => {
                let (low, high) = solid.bounds();
                turned(pose, (low * *scale, high * *scale))
            }
        };
        // Rounding must not cut a point off that `contains` would find.
        let slack = (low.abs().max(high.abs()) * 4.0 * f32::EPSILON).max(Vec3::splat(1e-30));
        (low - slack, high + slack)
    }

    /// Checks its numbers; `index` names it.
    pub(crate) fn check(&self, index: usize) -> Result<(), Error> {
        let bad = |part: &str, cause: String| {
            Err(Error::setting(format!("obstacles[{index}].{part}"), cause))
        };
        // Each test is also false for NaN.
        let near = |point: Vec3| point.abs().cmple(Vec3::splat(FARTHEST_M)).all();
        let place = |part: &str, point: Vec3| match near(point) {
            true => Ok(()),
            false => bad(part, format!("{point} is not within {FARTHEST_M:e} m")),
        };
        let length = |part: &str, length: f32| match length > 0.0 && length <= FARTHEST_M {
            true => Ok(()),
            false => bad(part, format!("{length} is out of range; use above 0 to {FARTHEST_M:e}")),
        };
        let sound = |pose: &Pose| match pose.sound() {
            Some(pose) => place("pose", pose.translation),
            None => bad("pose", "it is not finite, or its rotation is 0".into()),
        };
        match self {
            Self::Sphere(sphere) => {
                place("center", sphere.center)?;
                length("radius", sphere.radius)
            }
            Self::Capsule { from, to, radius } => {
                place("from", *from)?;
                place("to", *to)?;
                length("radius", *radius)
            }
            Self::Cuboid { half_extents, pose } => {
                half_extents
                    .to_array()
                    .iter()
                    .try_for_each(|&half| length("half_extents", half))?;
                sound(pose)
            }
            Self::Solid { pose, scale, .. } => {
                length("scale", *scale)?;
                sound(pose)
            }
        }
    }
}

/// A point of the world, seen from a pose that has been checked.
fn local(pose: &Pose, point: Vec3) -> Vec3 {
    pose.rotation.normalize().conjugate() * (point - pose.translation)
}

/// Box about a turned box.
fn turned(pose: &Pose, (low, high): (Vec3, Vec3)) -> (Vec3, Vec3) {
    let rotation = pose.rotation.normalize();
    let center = rotation * ((low + high) * 0.5) + pose.translation;
    let half = (high - low) * 0.5;
    let axes = [Vec3::X * half.x, Vec3::Y * half.y, Vec3::Z * half.z];
    let reach: Vec3 = axes.iter().map(|&axis| (rotation * axis).abs()).sum();
    (center - reach, center + reach)
}
