//! Views: cameras and shadow cascades that share one simulation.

use crate::{Bands, DebugView, Observer, Technique};
use glam::Mat4;

/// Which tests cull blades, and how.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Culling {
    /// Frustum test on patches and blades.
    pub frustum: bool,
    /// Thinning by projected size (or J equation 20).
    pub distance: bool,
    /// Blades seen edge-on.
    pub orientation: bool,
    /// Blades hidden by the opaque scene.
    pub occlusion: bool,
    /// The paper's own tests (J equations 17 to 20) instead of ours.
    pub paper: bool,
    /// Farthest distance that blades are drawn at, metres.
    pub max_distance_m: f32,
}

impl Default for Culling {
    fn default() -> Self {
        Self {
            frustum: true,
            distance: true,
            orientation: true,
            occlusion: true,
            paper: false,
            max_distance_m: f32::INFINITY,
        }
    }
}

/// A camera or a shadow cascade that blades are culled for and drawn to.
#[derive(Debug, Clone, Copy)]
pub struct View<'a> {
    /// World to view: right-handed, looking along -z.
    pub view_from_world: Mat4,
    /// View to clip, z in 0..w.
    pub clip_from_view: Mat4,
    /// Size of the target, pixels.
    pub size: [u32; 2],
    /// Depth of the opaque scene as seen from this view, for the occlusion test.
    pub opaque_depth: Option<&'a wgpu::TextureView>,
    /// Which tests.
    pub culling: Culling,
    /// Detail: 1 is the default; higher keeps more segments and thins later; infinity keeps all.
    pub detail: f32,
    /// Which forms plants are drawn in.
    pub technique: Technique,
    /// Where plants of quads change their form.
    pub bands: Bands,
    /// Draws every blade at this level, 0 to 3: with 8, 4, 2 or 1 segments, without morphs; `None`
    /// chooses by size. For pictures that compare levels; more segments cost more vertices.
    pub level: Option<u8>,
    /// What to show in place of the blades' own look; `None` is their look. Of
    /// [`crate::Renderer::cull`] only, as is `observer`. Of several views, only one at a time may
    /// show `Culling` or `Awake`.
    pub debug: Option<DebugView>,
    /// Draws what this view culled as another camera sees it; `opaque_depth` stays this view's.
    pub observer: Option<Observer>,
    /// Keep blades at least a pixel wide (J equation 24); off for supersampled references.
    pub width_correction: bool,
    /// Most blades to list; `None` has room for all (4 bytes a blade of the field and view). What
    /// does not fit is dropped and counted. Kept first are pointed blades, nearest level first, then
    /// flat-tipped ones likewise, then clusters, strips, billboards.
    pub max_blades: Option<u32>,
}

impl View<'_> {
    /// A view with the default culling and detail.
    pub fn new(view_from_world: Mat4, clip_from_view: Mat4, size: [u32; 2]) -> Self {
        Self {
            view_from_world,
            clip_from_view,
            size,
            opaque_depth: None,
            culling: Culling::default(),
            detail: 1.0,
            technique: Technique::default(),
            bands: Bands::default(),
            level: None,
            debug: None,
            observer: None,
            width_correction: true,
            max_blades: None,
        }
    }
}
