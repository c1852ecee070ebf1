//! The CPU reference of tests.wgsl and cull.wgsl: the tests of one blade and of one patch.

use crate::frame::level::twin::{rank_fade, widening};
use crate::gpu::layout::GpuView;
use crate::gpu::quantize::tangent_frame;
use crate::grow::Blade;
use glam::{Mat4, Vec2, Vec3, Vec4};

pub(crate) const FRUSTUM: u32 = 1;
pub(crate) const DISTANCE: u32 = 2;
pub(crate) const ORIENTATION: u32 = 4;
pub(crate) const OCCLUSION: u32 = 8;
pub(crate) const PAPER: u32 = 16;

/// Failed tests, by bit.
pub(crate) const FAILED_ORIENTATION: u32 = 1;
pub(crate) const FAILED_FRUSTUM: u32 = 2;
pub(crate) const FAILED_DISTANCE: u32 = 4;
pub(crate) const FAILED_OCCLUSION: u32 = 8;

/// Points of a blade's curve.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pose {
    pub root: Vec3,
    pub knee: Vec3,
    pub tip: Vec3,
}

impl Pose {
    fn middle(&self) -> Vec3 {
        0.25 * self.root + 0.5 * self.knee + 0.25 * self.tip
    }
}

fn distance_to(view: &GpuView, p: Vec3) -> f32 {
    if view.eye[3] < 0.5 {
        return Vec4::from(view.depth_row).dot(p.extend(1.0)).abs();
    }
    p.distance(Vec4::from(view.eye).truncate())
}

pub(crate) fn pixels_per_metre(view: &GpuView, distance: f32) -> f32 {
    view.focal / if view.eye[3] > 0.5 { distance.max(0.01) } else { 1.0 }
}

fn has(view: &GpuView, flag: u32) -> bool {
    view.flags & flag != 0
}

fn clip(view: &GpuView, p: Vec3) -> Vec4 {
    Mat4::from_cols_array_2d(&view.clip_from_world) * p.extend(1.0)
}

fn side_of(blade: &Blade) -> Vec3 {
    let (first, second) = tangent_frame(blade.up);
    let facing = first * blade.facing.cos() + second * blade.facing.sin();
    blade.up.cross(facing)
}

fn view_ray(view: &GpuView, p: Vec3) -> Vec3 {
    if view.eye[3] < 0.5 {
        return Vec4::from(view.depth_row).truncate();
    }
    (p - Vec4::from(view.eye).truncate()) / distance_to(view, p).max(1e-6)
}

fn fails_frustum(view: &GpuView, pose: &Pose, width: f32) -> bool {
    if has(view, PAPER) {
        return [pose.root, pose.middle(), pose.tip].iter().all(|p| {
            let c = clip(view, *p);
            let w = c.w * 1.05 + 0.05;
            c.x.abs() > w || c.y.abs() > w || c.z > w || c.z < -0.05
        });
    }
    let center = 0.5 * (pose.root + pose.tip);
    let radius = pose.root.distance(center).max(pose.knee.distance(center)) + width;
    view.planes.iter().any(|plane| Vec4::from(*plane).dot(center.extend(1.0)) < -radius)
}

fn fails_orientation_paper(view: &GpuView, blade: &Blade) -> bool {
    let ray = view_ray(view, blade.root);
    let level = ray - blade.up * ray.dot(blade.up);
    level.dot(side_of(blade)).abs() > 0.9 * level.length().max(1e-6)
}

fn fails_distance_paper(view: &GpuView, blade: &Blade, local: u32) -> bool {
    let offset = blade.root - Vec4::from(view.eye).truncate();
    let d = (offset - blade.up * offset.dot(blade.up)).length();
    (local % 16) as f32 >= (16.0 * (1.0 - d / view.max_distance)).ceil()
}

fn hidden(view: &GpuView, p: Vec3, depth_at: &dyn Fn(Vec2) -> f32) -> bool {
    let c = clip(view, p);
    if c.w <= 0.0 {
        return false;
    }
    let uv = Vec2::new(c.x, -c.y) / c.w * 0.5 + 0.5;
    if uv.min_element() < 0.0 || uv.max_element() >= 1.0 {
        return false;
    }
    let d = depth_at(uv);
    let k = view.depth_from_value;
    let opaque = (k[0] - d * k[1]) / (d * k[2] - k[3]);
    Vec4::from(view.depth_row).dot(p.extend(1.0)) > opaque * 1.01 + 0.05
}

/// Failed tests of a blade, and what is left of its width.
pub(crate) fn decide(
    view: &GpuView,
    blade: &Blade,
    ridge: f32,
    pose: &Pose,
    (local, count): (u32, u32),
    depth_at: &dyn Fn(Vec2) -> f32,
) -> (u32, f32) {
    let distance = distance_to(view, blade.root + blade.up * (0.5 * blade.height));
    let width_px = blade.width * pixels_per_metre(view, distance);
    let thins = has(view, DISTANCE) && !has(view, PAPER);
    let keep = if thins { width_px / view.least_width } else { 1e6 };
    let (mut failed, mut fade) = (0, 1.0);
    let mut fail = |on: bool, bit: u32| failed |= if on { bit } else { 0 };
    if has(view, DISTANCE) {
        if has(view, PAPER) {
            fail(fails_distance_paper(view, blade, local), FAILED_DISTANCE);
        } else {
            let range = (view.max_distance - distance) / (0.1 * view.max_distance);
            fade = rank_fade(keep, (local as f32 + 0.5) / count as f32) * range.clamp(0.0, 1.0);
            fail(fade <= 0.0, FAILED_DISTANCE);
        }
    }
    if has(view, ORIENTATION) {
        if has(view, PAPER) {
            fail(fails_orientation_paper(view, blade), FAILED_ORIENTATION);
        } else {
            let along = view_ray(view, pose.middle()).dot(side_of(blade));
            let flat = (1.0 - along * along).max(0.0).sqrt();
            let shown = width_px * widening(keep) * flat.max(0.5 * ridge);
            let turn = ((shown - 0.1) / 0.2).clamp(0.0, 1.0);
            fail(turn <= 0.0, FAILED_ORIENTATION);
            fade *= turn;
        }
    }
    if has(view, FRUSTUM) {
        fail(fails_frustum(view, pose, blade.width * widening(keep)), FAILED_FRUSTUM);
    }
    if has(view, OCCLUSION) {
        let points = [pose.root, pose.middle(), pose.tip];
        fail(points.iter().all(|p| hidden(view, *p, depth_at)), FAILED_OCCLUSION);
    }
    (failed, fade)
}

/// What a patch keeps in a view: how many of its blades are dispatched.
pub(crate) fn kept_blades(
    view: &GpuView,
    low: Vec3,
    high: Vec3,
    max_width: f32,
    count: u32,
) -> u32 {
    let outside = view.planes.iter().any(|plane| {
        let plane = Vec4::from(*plane);
        let normal = plane.truncate();
        let corner = Vec3::select(normal.cmpgt(Vec3::ZERO), high, low);
        normal.dot(corner) + plane.w < 0.0
    });
    let eye = Vec4::from(view.eye).truncate();
    let nearest = distance_to(view, eye.clamp(low, high));
    if (has(view, FRUSTUM) && outside) || (has(view, DISTANCE) && nearest > view.max_distance) {
        return 0;
    }
    if !has(view, DISTANCE) || has(view, PAPER) {
        return count;
    }
    let share = max_width * pixels_per_metre(view, nearest) / view.least_width;
    (share * count as f32).ceil().clamp(0.0, count as f32) as u32
}
