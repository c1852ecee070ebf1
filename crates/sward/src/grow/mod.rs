//! Growing: once per field, on the CPU. `surface -> scatter -> blades -> patches`.

pub mod blades;
pub mod patches;
pub mod scatter;
pub mod surface;

use glam::Vec3;

/// One plant, unquantised, in world space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blade {
    /// Root v0, metres.
    pub root: Vec3,
    /// Unit up direction.
    pub up: Vec3,
    /// Facing: angle about `up`, radians in 0..2 pi, from the first axis of the tangent frame of `up`
    /// (`crate::gpu::layout::tangent_frame`).
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
