//! Things that push blades aside.

use crate::Sphere;
use glam::{Quat, Vec3};

/// Place and turn of a thing: world from local.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Where its origin is, metres.
    pub translation: Vec3,
    /// How it is turned; need not be unit length, must not be zero.
    pub rotation: Quat,
}

impl Pose {
    /// At a place, not turned.
    pub fn at(translation: Vec3) -> Self {
        Self { translation, ..Self::default() }
    }

    /// A point of the thing in the world.
    pub fn point(&self, local: Vec3) -> Vec3 {
        self.rotation * local + self.translation
    }

    /// With a turn of unit length; none where the pose is not finite, or its turn is none.
    pub(crate) fn sound(self) -> Option<Self> {
        let length = self.rotation.length();
        let is_turn = length.is_finite() && length > 1e-6;
        let sound = Self { rotation: self.rotation * length.recip(), ..self };
        (self.translation.is_finite() && is_turn).then_some(sound)
    }
}

impl Default for Pose {
    /// At the origin, not turned.
    fn default() -> Self {
        Self { translation: Vec3::ZERO, rotation: Quat::IDENTITY }
    }
}

/// Shape of a collider, in its own space. It borrows, so that a packed mesh is not copied.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum ColliderShape<'a> {
    /// A ball round the pose's origin.
    Sphere {
        /// Radius, metres, above 0.
        radius: f32,
    },
    /// All that is near a segment.
    Capsule {
        /// One end of the segment, metres.
        from: Vec3,
        /// The other; may be the same.
        to: Vec3,
        /// Radius, metres, above 0.
        radius: f32,
    },
    /// A box round the pose's origin.
    Cuboid {
        /// Half its edges, metres, each above 0.
        half_extents: Vec3,
    },
    /// Many balls at once, such as a mesh that was packed with them.
    Spheres(&'a [Sphere]),
}

/// A thing that pushes blades aside.
///
/// What cannot touch anything is left out: a pose that is not finite, a radius or half extent
/// that is not finite and above 0, an end or centre that is not finite. Of a packed mesh, only the
/// balls at fault are left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Collider<'a> {
    /// Its shape.
    pub shape: ColliderShape<'a>,
    /// Where it is at the end of the step.
    pub pose: Pose,
    /// Where it was at the last step: it is swept from there, so that nothing on its way is
    /// missed. None, or the same pose, for what rests, or for what was put elsewhere: it wakes no
    /// blade that sleeps, and costs the GPU nothing while it stays; the host still reads its shape in
    /// each step. More than 20 m from `pose` counts as put elsewhere too.
    pub last_pose: Option<Pose>,
}

impl<'a> Collider<'a> {
    /// A thing that rests.
    pub fn resting(shape: ColliderShape<'a>, pose: Pose) -> Self {
        Self { shape, pose, last_pose: None }
    }

    /// A ball that rests.
    pub fn ball(sphere: Sphere) -> Self {
        Self::resting(ColliderShape::Sphere { radius: sphere.radius }, Pose::at(sphere.center))
    }
}
