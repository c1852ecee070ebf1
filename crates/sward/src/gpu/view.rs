//! A view's uniform: matrices, frustum planes, projected sizes, flags.

use super::layout::GpuView;
use crate::frame::level::FULL_DETAIL_PX;
use crate::gpu::quantize::SEGMENTS;
use crate::{Error, Technique, View};
use glam::{Mat4, Vec3, Vec4};

/// Survivors are widened to this many pixels at detail 1.
pub const LEAST_WIDTH_PX: f32 = 1.4;

/// Mean height of the grass, pixels at detail 1, where blades begin to turn into clusters, and where
/// all have.
pub const CLUSTER_HEIGHT_PX: [f32; 2] = [20.0, 12.0];
/// Clusters are thinned and widened to this many pixels at detail 1.
pub const LEAST_CLUSTER_PX: f32 = 4.0;
/// Heights count so many times where segments are chosen, beside those of `Technique::Blades`: what
/// clusters save far away is spent on curves near by.
pub const FINER_LEVELS: f32 = 1.1;

pub const FRUSTUM: u32 = 1;
pub const DISTANCE: u32 = 2;
pub const ORIENTATION: u32 = 4;
pub const OCCLUSION: u32 = 8;
pub const PAPER: u32 = 16;
pub const WIDTH_CORRECTION: u32 = 32;
pub const HAS_DEPTH: u32 = 64;
/// Set beside where a page is swept.
pub const GROUND_SWEPT: u32 = 128;

fn normalized_plane(plane: Vec4) -> [f32; 4] {
    let length = plane.truncate().length();
    // An infinite far plane has no normal: it lies behind nothing
    if length > 1e-12 { (plane / length).to_array() } else { [0.0, 0.0, 0.0, 1.0] }
}

/// Inward planes of the clip volume: left, right, bottom, top, near, far.
pub fn frustum_planes(clip_from_world: Mat4) -> [[f32; 4]; 6] {
    let m = clip_from_world.transpose();
    let (x, y, z, w) = (m.x_axis, m.y_axis, m.z_axis, m.w_axis);
    [w + x, w - x, w + y, w - y, z, w - z].map(normalized_plane)
}

/// What is known of a view before its pipelines are made.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct Known {
    pub technique: Technique,
    /// Bits of `GpuView::flags`.
    pub flags: u32,
}

impl Known {
    /// Of a view.
    pub fn of(view: &View) -> Self {
        Self { technique: technique_of(view), flags: flags(view) }
    }

    /// With these flags only, for stages that have no use for others.
    pub fn only(self, flags: u32) -> Self {
        Self { flags: self.flags & flags, ..self }
    }

    /// Values of a pipeline's constants.
    pub fn constants(self) -> [(&'static str, f64); 2] {
        [("TECHNIQUE", f64::from(self.technique as u32)), ("FLAGS", self.flags.into())]
    }
}

fn flags(view: &View) -> u32 {
    let culling = view.culling;
    [
        (culling.frustum, FRUSTUM),
        (culling.distance, DISTANCE),
        (culling.orientation, ORIENTATION),
        (culling.occlusion, OCCLUSION),
        (culling.paper, PAPER),
        (view.width_correction, WIDTH_CORRECTION),
        (view.opaque_depth.is_some(), HAS_DEPTH),
    ]
    .iter()
    .fold(0, |sum, (on, bit)| if *on { sum | bit } else { sum })
}

fn smaller(texture: &wgpu::Texture, size: [u32; 2]) -> bool {
    texture.width() < size[0] || texture.height() < size[1]
}

fn check_depth(depth: &wgpu::Texture, size: [u32; 2]) -> Result<(), Error> {
    let bad = |cause: &str| Err(Error::setting("view.opaque_depth", cause));
    if smaller(depth, size) {
        return bad("must be at least as large as view.size");
    }
    if !depth.format().has_depth_aspect() || depth.dimension() != wgpu::TextureDimension::D2 {
        return bad("must be a two-dimensional depth texture");
    }
    if !depth.usage().contains(wgpu::TextureUsages::TEXTURE_BINDING) {
        return bad("must be made with TextureUsages::TEXTURE_BINDING");
    }
    Ok(())
}

/// Checks that a view is a camera.
///
/// # Errors
/// [`Error::Setting`] where a matrix is not finite or not invertible, the size is zero, the depth
/// cannot be read, or detail or distance are not above 0.
pub fn check_view(view: &View) -> Result<(), Error> {
    let is_camera = |clip_from_world: Mat4| {
        clip_from_world.is_finite() && clip_from_world.inverse().is_finite()
    };
    let observer = view.observer.is_none_or(|o| is_camera(o.clip_from_view * o.view_from_world));
    if !observer || !is_camera(view.clip_from_view * view.view_from_world) {
        let which = if observer { "view" } else { "view.observer" };
        return Err(Error::setting(which, "its matrices must be finite and invertible"));
    }
    if view.size.contains(&0) {
        return Err(Error::setting("view.size", "must be at least 1 x 1 pixels"));
    }
    if let Some(depth) = view.opaque_depth {
        check_depth(depth.texture(), view.size)?;
    }
    // NaN is not above 0 either
    let above_zero = |x: f32| x > 0.0;
    if !above_zero(view.detail) || !above_zero(view.culling.max_distance_m) {
        return Err(Error::setting("view", "detail and max_distance_m must be above 0"));
    }
    view.bands.check()?;
    if let Some(level) = view.level
        && usize::from(level) >= SEGMENTS.len()
    {
        let cause = format!("{level} is out of range; use 0 to 3");
        return Err(Error::setting("view.level", cause));
    }
    Ok(())
}

/// Heights that levels are chosen within: any, or one amid the forced level, where nothing morphs.
fn level_height(level: Option<u8>) -> [f32; 2] {
    let Some(level) = level else { return [0.0, f32::MAX] };
    [FULL_DETAIL_PX * 0.25_f32.powf(f32::from(level) + 0.35); 2]
}

/// Pixels that a metre covers at distance 1 (perspective) or at any (orthographic).
pub fn focal_px(view: &View) -> f32 {
    let clip = view.clip_from_view;
    (clip.y_axis.y.abs() * view.size[1] as f32 * 0.5)
        .max(clip.x_axis.x.abs() * view.size[0] as f32 * 0.5)
}

/// A forced level is one of single blades.
pub fn technique_of(view: &View) -> Technique {
    if view.level.is_some() { Technique::Blades } else { view.technique }
}

/// The uniform of a view that [`check_view`] let pass.
pub fn gpu_view(view: &View, capacity: u32) -> GpuView {
    let clip_from_world = view.clip_from_view * view.view_from_world;
    let world_from_view = view.view_from_world.inverse();
    let clip = view.clip_from_view;
    let perspective = clip.w_axis.w.abs() < 0.5;
    let row = view.view_from_world.transpose().z_axis;
    let eye: Vec3 = world_from_view.w_axis.truncate();
    let bands = view.bands;
    let detail = view.detail.clamp(1e-3, 1e6);
    let technique = technique_of(view);
    GpuView {
        clip_from_world: clip_from_world.to_cols_array_2d(),
        eye: eye.extend(if perspective { 1.0 } else { 0.0 }).to_array(),
        depth_row: (-row).to_array(),
        planes: frustum_planes(clip_from_world),
        depth_from_value: [-clip.w_axis.z, -clip.w_axis.w, clip.z_axis.w, clip.z_axis.z],
        size: [view.size[0] as f32, view.size[1] as f32],
        focal: focal_px(view),
        detail,
        least_width: LEAST_WIDTH_PX / detail,
        max_distance: view.culling.max_distance_m.min(1e30),
        flags: flags(view),
        capacity,
        level_height: level_height(view.level),
        cluster_height: CLUSTER_HEIGHT_PX.map(|px| px / detail),
        technique: technique as u32,
        least_cluster: LEAST_CLUSTER_PX / detail,
        far_share: bands.far_share,
        far_size: bands.far_size,
        bands: [bands.near_m, bands.middle_m, bands.far_m.min(1e30), bands.jitter],
        level_scale: if technique == Technique::Blades { 1.0 } else { FINER_LEVELS },
        reserved_a: 0.0,
        reserved_b: 0.0,
        reserved_c: 0.0,
    }
}
