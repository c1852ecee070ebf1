//! How a scene is drawn, and the view that the renderer takes from it.

use super::frame::CameraMatrices;
use super::reference::Crop;
use anyhow::Result;
use glam::Vec3Swizzles;
use sward::{
    Bands, ColorRange, Culling, DebugView, Light, Observer, PhysicsModel, Technique, View,
};
use sward_scene::atmosphere::LUMINANCE;
use sward_scene::{Camera, DepthOfFieldSettings, FogSettings, Scene, SceneLight, Tone};

/// How a scene is drawn.
#[derive(Debug, Clone)]
pub struct StageOptions {
    /// Size of the picture, pixels.
    pub size: [u32; 2],
    /// Samples a pixel; a reference always has 64.
    pub samples: u32,
    /// Where from.
    pub camera: Camera,
    /// How blades move.
    pub physics: PhysicsModel,
    /// Which forms plants are drawn in.
    pub technique: Technique,
    /// Where plants of quads change their form.
    pub bands: Bands,
    /// How blades are culled.
    pub culling: Culling,
    /// All blades, with all segments, none culled, 64 samples a pixel averaged in linear light.
    pub reference: bool,
    /// Leaves out of a reference what is out of view: the same picture, sooner.
    pub reference_in_view: bool,
    /// Sky; black, where it is not drawn.
    pub sky: bool,
    /// Haze, where the scene has any.
    pub haze: bool,
    /// Fog by distance, over the picture; the scene's.
    pub fog: Option<FogSettings>,
    /// Depth of field; the scene's.
    pub depth_of_field: Option<DepthOfFieldSettings>,
    /// How light becomes colours; the scene's.
    pub tone: Tone,
    /// Stops that the picture is exposed by; none: as many as suit the light.
    pub exposure_ev: Option<f32>,
    /// Whether spheres push the blades.
    pub collisions: bool,
    /// What to show in place of the blades' own look.
    pub debug: Option<DebugView>,
    /// Where blades are culled from, where that is not where the picture is drawn from.
    pub culling_camera: Option<Camera>,
    /// Level that every blade is drawn at, 0 to 3; none: by size.
    pub level: Option<u8>,
}

/// Exposed luminance of the sky in view from which on the exposure gives way: who looks at a low sun
/// closes the aperture.
const DAZZLES: f32 = 0.9;
/// Stops that it gives way a stop.
const DAZZLED: f32 = 0.7;

impl StageOptions {
    /// The scene's own way, seen by its first camera or the one of that name.
    ///
    /// # Errors
    /// Where there is no such camera.
    pub fn new(scene: &Scene, camera: Option<&str>, size: [u32; 2], samples: u32) -> Result<Self> {
        Ok(Self {
            size,
            samples,
            camera: scene.camera(camera)?.clone(),
            physics: scene.physics,
            technique: scene.technique,
            bands: scene.bands,
            culling: scene.culling,
            reference: false,
            reference_in_view: false,
            sky: true,
            haze: true,
            fog: scene.fog,
            depth_of_field: scene.depth_of_field,
            tone: scene.tone(),
            exposure_ev: scene.exposure_ev,
            collisions: true,
            debug: None,
            culling_camera: None,
            level: None,
        })
    }

    /// Whether ground between blades is just that, near and far: where all grass is drawn, or stood in
    /// for by wider blades, by clusters, or at the end by the ground's own look of it.
    pub(super) fn draws_all(&self) -> bool {
        let endless = self.culling.max_distance_m.is_infinite();
        let stood_in = matches!(self.technique, Technique::Blades | Technique::Continuum);
        self.reference || stood_in && endless
    }

    /// A scene's light as the picture has it: haze and fog take the colour of the sky behind them, that
    /// of the horizon where the camera looks, and the exposure is the options'.
    pub(super) fn seen(&self, mut light: SceneLight) -> SceneLight {
        if let Some(dome) = &light.dome {
            let Camera { eye, target, vertical_fov_deg, .. } = self.camera;
            let aspect = self.size[0] as f32 / self.size[1] as f32;
            let half = ((0.5 * vertical_fov_deg).to_radians().tan() * aspect).atan();
            let heading = (target - eye).xz();
            light.sky.horizon = dome.horizon(heading, half, 0.5);
            let seen = dome.horizon(heading, half, 10.0) * light.exposure_ev.exp2();
            let dazzles = (seen.dot(LUMINANCE) / DAZZLES).max(1.0).log2();
            light.exposure_ev -= DAZZLED * dazzles;
        }
        light.exposure_ev = self.exposure_ev.unwrap_or(light.exposure_ev);
        light
    }

    /// The camera of the picture.
    pub(super) fn drawn_from(&self, crop: Crop) -> CameraMatrices {
        CameraMatrices::new(&self.camera, self.size, crop)
    }

    /// The camera that blades are culled for.
    pub(super) fn culled_from(&self, crop: Crop) -> CameraMatrices {
        let camera = self.culling_camera.as_ref().unwrap_or(&self.camera);
        CameraMatrices::new(camera, self.size, crop)
    }
}

/// The light of sun and sky, without the haze where the options leave it out.
pub(super) fn light(options: &StageOptions, now: &SceneLight) -> Light {
    let light = sward_scene::light(&now.sun, &now.sky);
    Light { haze_per_m: if options.haze { light.haze_per_m } else { 0.0 }, ..light }
}

/// The renderer's view of the camera. `size` is in pixels of the picture, of which a reference's
/// target has many samples each: what is chosen by size in pixels must not see them.
pub(super) fn view<'a>(
    options: &StageOptions,
    camera: CameraMatrices,
    size: [u32; 2],
    opaque_depth: &'a wgpu::TextureView,
) -> View<'a> {
    let mut view = View::new(camera.view_from_world, camera.clip_from_view, size);
    view.opaque_depth = Some(opaque_depth);
    view.technique = options.technique;
    view.bands = options.bands;
    view.culling = options.culling;
    view.level = options.level;
    view.debug = options.debug;
    view.observer = options.culling_camera.as_ref().map(|_| {
        let CameraMatrices { view_from_world, clip_from_view } =
            options.drawn_from(Crop::whole(options.size));
        Observer { view_from_world, clip_from_view }
    });
    if options.reference {
        view.culling = no_culling(options.culling);
        view.culling.frustum = options.reference_in_view;
        view.detail = f32::INFINITY;
        view.width_correction = false;
    }
    view
}

/// The same with every test switched off, so that every blade is drawn.
pub fn no_culling(culling: Culling) -> Culling {
    Culling {
        frustum: false,
        distance: false,
        orientation: false,
        occlusion: false,
        max_distance_m: f32::INFINITY,
        ..culling
    }
}

/// The same with grey ground under the grass, on which a debug view's colours stand out.
pub(super) fn on_grey_ground(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.ground.grass_tint = 1.0;
    let grey = ColorRange { from: [0.16; 3], to: [0.16; 3] };
    for field in &mut scene.fields {
        field.desc.color_map = None;
        for species in &mut field.desc.species {
            species.root_color = grey;
            species.tip_color = grey;
        }
    }
    scene
}
