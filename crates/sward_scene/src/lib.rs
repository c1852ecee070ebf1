//! Scene files, meshes, heightmaps and textures, read into the types of [`sward`].
//!
//! A scene is a RON file; the smallest useful one is three lines:
//!
//! ```ron
//! (
//!     fields: [(on: Terrain(size_m: 60))],
//! )
//! ```
//!
//! [`load`] reads it with all that it refers to, checks every value, and returns a [`Scene`] whose
//! parts are ready for the library: meshes in world space, surfaces, field descriptions, wind. Every
//! key, its unit, range and default are listed in the crate's README and on the types of
//! [`schema`].
//!
//! Anything wrong is one [`SceneError`] of one line: the file, the line or the object, the cause and
//! what to do. No input makes this crate panic. It prints nothing; what is worth telling is in
//! [`Scene::notes`].

mod assets;
pub mod atmosphere;
mod bodies;
mod build;
pub mod camera;
mod check;
mod daylight;
mod error;
mod locate;
mod motion;
mod objects;
mod presets;
pub mod schema;
mod spheres;
mod wind;

pub use assets::TextureImage;
pub use bodies::{Bodies, Body, BodyGroup, BodyShape};
pub use build::{load, parse};
pub use camera::Camera;
pub use daylight::{Course, Daylight, Heavens, Luminary, SceneLight};
pub use error::SceneError;
pub use motion::{Path, PathKey};
pub use objects::{ColliderPiece, Object};
pub use presets::LightPreset;
pub use spheres::MovingSphere;
pub use wind::SceneWind;

use glam::Vec3;
use std::path::PathBuf;

/// A scene, ready to grow and draw.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Its name: the `name` key, or the file's stem.
    pub name: String,
    /// The file that it was read from.
    pub path: PathBuf,
    /// Opaque things, in world space; some carry grass.
    pub objects: Vec<Object>,
    /// What to grow; at least one.
    pub fields: Vec<SceneField>,
    /// Cameras; at least one, the first is the default.
    pub cameras: Vec<Camera>,
    /// Terms of the wind; none is still air.
    pub wind: Vec<SceneWind>,
    /// Spheres that push blades aside.
    pub spheres: Vec<MovingSphere>,
    /// Rigid bodies, by kind; [`Bodies`] moves them.
    pub bodies: Vec<BodyGroup>,
    /// The sun; at time 0 where it moves.
    pub light: SunSettings,
    /// Sky and haze; at time 0 where they change.
    pub sky: SkySettings,
    /// Sun and sky by physics, which is where `light` and `sky` then are from.
    pub heavens: Option<Heavens>,
    /// How light becomes colours; [`Scene::tone`] says what it is where this is none.
    pub tone: Option<Tone>,
    /// Stops that pictures are exposed by; none: [`SceneLight::exposure_ev`].
    pub exposure_ev: Option<f32>,
    /// Fog by distance.
    pub fog: Option<FogSettings>,
    /// Depth of field.
    pub depth_of_field: Option<DepthOfFieldSettings>,
    /// Gravity.
    pub gravity: sward::Gravity,
    /// Physical model.
    pub physics: sward::PhysicsModel,
    /// Which forms plants are drawn in.
    pub technique: sward::Technique,
    /// Which tests cull blades.
    pub culling: sward::Culling,
    /// Where plants of quads change their form.
    pub bands: sward::Bands,
    /// What moves between the field and the sun.
    pub shade: Option<ShadeSettings>,
    /// Look of bare ground.
    pub ground: GroundSettings,
    /// Seconds simulated before time 0, so that grass starts in motion.
    pub warm_up_s: f32,
    /// Frames a second of a rendered sequence.
    pub fps: f32,
    /// What is not wrong but worth telling, such as a height image of 8 bits: one line each.
    pub notes: Vec<String>,
}

/// What to grow, and on which object.
#[derive(Debug, Clone)]
pub struct SceneField {
    /// Its name, for messages.
    pub name: String,
    /// Index into [`Scene::objects`] of the object that it grows on.
    pub object: usize,
    /// That object's mesh, checked.
    pub surface: sward::Surface,
    /// What to grow.
    pub desc: sward::FieldDesc,
    /// Where its species come of plants by probability: see [`Scene::set_garden`].
    pub mix: Option<sward::Mix>,
}

/// What moves between the field and the sun; [`Scene::shade_at`] says where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShadeSettings {
    /// Share of the sun kept away where it is darkest, 0..=1.
    pub depth: f32,
    /// Size of its patches, metres.
    pub size_m: f32,
    /// Its height (y), metres.
    pub height_m: f32,
    /// How it drifts, x and z, metres a second.
    pub drift_mps: glam::Vec2,
}

impl ShadeSettings {
    /// Where it is at a time, as the library takes it.
    pub fn at(&self, time_s: f64) -> sward::Shade {
        let Self { depth, size_m, height_m, drift_mps } = *self;
        sward::Shade { depth, size_m, height_m, offset_m: drift_mps.as_dvec2() * time_s }
    }
}

/// The sun: where it stands and how bright it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SunSettings {
    /// Compass direction of the sun, degrees: 0 is -z (north), 90 is +x (east).
    pub azimuth_deg: f32,
    /// Height over the horizon, degrees.
    pub elevation_deg: f32,
    /// Irradiance, linear RGB: colour times strength.
    pub irradiance: Vec3,
}

impl SunSettings {
    /// Unit direction from the ground to the sun.
    pub fn to_sun(&self) -> Vec3 {
        let (sin_a, cos_a) = self.azimuth_deg.to_radians().sin_cos();
        let (sin_e, cos_e) = self.elevation_deg.to_radians().sin_cos();
        Vec3::new(sin_a * cos_e, sin_e, -cos_a * cos_e)
    }
}

/// Sky and haze, linear RGB radiance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkySettings {
    /// Background overhead.
    pub zenith: Vec3,
    /// Background at the horizon; haze takes this colour.
    pub horizon: Vec3,
    /// Light that the sky sheds on upward faces.
    pub ambient: Vec3,
    /// Light that the ground sheds on downward faces.
    pub bounce: Vec3,
    /// Distance at which haze hides 63 % of a thing (1 - 1/e), metres; infinity is clear air.
    pub haze_m: f32,
}

/// How light becomes a picture's colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Tone {
    /// Khronos PBR Neutral: colours stay as they are up to a shoulder.
    #[default]
    Neutral,
    /// AgX, after Sobotka: a film's curve, in which bright colours go to white.
    Agx,
}

/// Fog by distance, over the finished picture; the sky stays clear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FogSettings {
    /// Its colour, linear RGB radiance; none: that of the sky's horizon.
    pub color: Option<Vec3>,
    /// Share of the light that is lost a metre, 0 or more.
    pub density_per_m: f32,
    /// Distance from the eye at which it starts, metres.
    pub start_m: f32,
    /// Height (y) at which it has that density, metres.
    pub base_m: f32,
    /// Height over which it thins to 1/e, metres, above 0; infinity: as dense at any height.
    pub falloff_m: f32,
}

/// Depth of field: a thin lens.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DepthOfFieldSettings {
    /// Distance of the plane in focus along the line of sight, metres, above 0.
    pub focus_m: f32,
    /// Diameter of the lens's opening, metres, 0 or more.
    pub aperture_m: f32,
}

/// How bare ground looks between and beyond the blades.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroundSettings {
    /// Soil, linear RGB reflectance: the colour of objects that carry grass and set none.
    pub soil: [f32; 3],
    /// How far ground that carries grass takes the grass's own mean colour, 0..=1: higher hides the
    /// end of the field and of thinned levels, lower shows the soil between the blades.
    pub grass_tint: f32,
}

/// Sun and sky as the library takes them, with no shade between.
pub fn light(sun: &SunSettings, sky: &SkySettings) -> sward::Light {
    sward::Light {
        to_sun: sun.to_sun(),
        sun: sun.irradiance,
        sky: sky.ambient,
        ground: sky.bounce,
        haze: sky.horizon,
        haze_per_m: sky.haze_m.recip(),
        shade: sward::Shade::default(),
    }
}

impl Scene {
    /// Sun and sky as the library takes them, at time 0.
    pub fn light(&self) -> sward::Light {
        sward::Light { shade: self.shade_at(0.0), ..light(&self.light, &self.sky) }
    }

    /// Sun and sky at a time, and the exposure.
    pub fn light_at(&self, time_s: f64) -> SceneLight {
        let mut light = match &self.heavens {
            Some(heavens) => heavens.at(time_s),
            None => {
                let (sun, sky) = (self.light, self.sky);
                SceneLight { sun, sky, dome: None, exposure_ev: 0.0, rods: 0.0 }
            }
        };
        light.exposure_ev = self.exposure_ev.unwrap_or(light.exposure_ev);
        light
    }

    /// How light becomes colours: what the scene says, else AgX where its light is physical.
    pub fn tone(&self) -> Tone {
        let usual = if self.heavens.is_some() { Tone::Agx } else { Tone::Neutral };
        self.tone.unwrap_or(usual)
    }

    /// Puts a light in the place of the scene's own, with its exposure and [`Tone::Agx`]. The
    /// direction of the sun and the haze stay.
    pub fn set_light(&mut self, preset: LightPreset) {
        let heavens = Heavens::new(preset.daylight(self.light.azimuth_deg, self.sky.haze_m));
        let now = heavens.at(0.0);
        (self.light, self.sky) = (now.sun, now.sky);
        self.heavens = Some(heavens);
        (self.tone, self.exposure_ev) = (None, None);
    }

    /// What moves between the field and the sun at a time, as the library takes it.
    pub fn shade_at(&self, time_s: f64) -> sward::Shade {
        self.shade.map_or_else(sward::Shade::default, |shade| shade.at(time_s))
    }

    /// Takes plants from grassland, 0, to garden, 1, in every field that has them by probability.
    ///
    /// # Errors
    /// [`SceneError::Value`] where no field has, or where flowers or grasses are asked for and there are
    /// none.
    pub fn set_garden(&mut self, garden: f32) -> Result<(), SceneError> {
        let error = |problem: check::Problem| SceneError::Value {
            file: self.path.clone(),
            at: None,
            key: problem.key,
            cause: problem.cause,
        };
        if self.fields.iter().all(|field| field.mix.is_none()) {
            let key = check::Key::name("garden");
            return Err(error(key.problem("no field has `plants`, which it would mix")));
        }
        for (index, field) in self.fields.iter_mut().enumerate() {
            let Some(mix) = &mut field.mix else { continue };
            mix.garden = Some(garden);
            let key = check::Key::list("fields", index);
            field.desc.species = build::plants::mixed(mix, &key).map_err(error)?.species;
        }
        Ok(())
    }

    /// The camera of that name; without a name the first.
    ///
    /// # Errors
    /// [`SceneError::Camera`] where there is none of that name; it lists those that there are.
    pub fn camera(&self, name: Option<&str>) -> Result<&Camera, SceneError> {
        let found = match name {
            None => self.cameras.first(),
            Some(name) => self.cameras.iter().find(|camera| camera.name == name),
        };
        found.ok_or_else(|| SceneError::Camera {
            file: self.path.clone(),
            name: name.unwrap_or("default").into(),
            known: self.cameras.iter().map(|c| c.name.as_str()).collect::<Vec<_>>().join(", "),
        })
    }

    /// The terms of the wind at a time, as the library takes them.
    pub fn wind_at(&self, time_s: f64) -> Vec<sward::WindSource> {
        self.wind.iter().map(|wind| wind.at(time_s)).collect()
    }

    /// The spheres at a time, as the library takes them.
    pub fn spheres_at(&self, time_s: f64) -> Vec<sward::Sphere> {
        self.spheres.iter().map(|sphere| sphere.at(time_s)).collect()
    }
}

/// The README's program compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
