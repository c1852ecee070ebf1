//! Cameras.

use glam::camera::rh::{proj::directx::perspective, view::look_at_mat4};
use glam::{Mat4, Vec3};

/// A camera: perspective, right-handed, clip z from 0 (near) to 1 (far).
#[derive(Debug, Clone, PartialEq)]
pub struct Camera {
    /// Its name.
    pub name: String,
    /// Where it stands, metres.
    pub eye: Vec3,
    /// What it looks at, metres.
    pub target: Vec3,
    /// Which way is up; not along the line of sight.
    pub up: Vec3,
    /// Vertical field of view, degrees.
    pub vertical_fov_deg: f32,
    /// Nearest distance drawn, metres.
    pub near_m: f32,
    /// Farthest distance drawn, metres.
    pub far_m: f32,
}

impl Camera {
    /// World to view: looking along -z.
    pub fn view_from_world(&self) -> Mat4 {
        look_at_mat4(self.eye, self.target, self.up)
    }

    /// View to clip, for a target of `aspect` (width over height).
    pub fn clip_from_view(&self, aspect: f32) -> Mat4 {
        perspective(self.vertical_fov_deg.to_radians(), aspect, self.near_m, self.far_m)
    }
}
