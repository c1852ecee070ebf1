//! Settings of the whole scene: light, sky, gravity, culling.

use super::plants;
use crate::check::{Key, Problem};
use crate::schema::{
    CullingFile, GravityFile, PhysicsFile, SceneFile, SkyFile, SunFile, TechniqueFile,
};
use crate::{GroundSettings, ShadeSettings, SkySettings, SunSettings};
use glam::Vec3;
use sward::{Bands, Culling, Gravity, PhysicsModel, Technique};

pub(super) struct Settings {
    pub(super) light: SunSettings,
    pub(super) sky: SkySettings,
    pub(super) gravity: Gravity,
    pub(super) physics: PhysicsModel,
    pub(super) technique: Technique,
    pub(super) bands: Bands,
    pub(super) shade: Option<ShadeSettings>,
    pub(super) culling: Culling,
    pub(super) ground: GroundSettings,
    pub(super) warm_up_s: f32,
    pub(super) fps: f32,
}

impl Settings {
    pub(super) fn check(file: &SceneFile) -> Result<Self, Problem> {
        let ground = Key::name("ground");
        Ok(Self {
            light: sun(&file.sun)?,
            sky: sky(&file.sky)?,
            gravity: gravity(&file.gravity)?,
            physics: match file.physics {
                PhysicsFile::Sward => PhysicsModel::Sward,
                PhysicsFile::Paper => PhysicsModel::Paper,
            },
            technique: match file.technique {
                TechniqueFile::Blades => Technique::Blades,
                TechniqueFile::Strips => Technique::Strips,
                TechniqueFile::Billboards => Technique::Billboards,
                TechniqueFile::Continuum => Technique::Continuum,
            },
            bands: plants::bands(&file.bands)?,
            shade: file.shade.as_ref().map(plants::shade).transpose()?,
            culling: culling(&file.culling)?,
            ground: GroundSettings {
                soil: ground.at("soil").color(file.ground.soil)?,
                grass_tint: ground.at("grass_tint").within(file.ground.grass_tint, 0.0, 1.0)?,
            },
            warm_up_s: Key::name("warm_up_s").within(file.warm_up_s, 0.0, 60.0)?,
            fps: Key::name("fps").within(file.fps, 1.0, 1000.0)?,
        })
    }
}

fn sun(sun: &SunFile) -> Result<SunSettings, Problem> {
    let key = Key::name("sun");
    let strength = key.at("strength").within(sun.strength, 0.0, 100.0)?;
    Ok(SunSettings {
        azimuth_deg: key.at("azimuth_deg").within(sun.azimuth_deg, -36_000.0, 36_000.0)?,
        elevation_deg: key.at("elevation_deg").within(sun.elevation_deg, -90.0, 90.0)?,
        irradiance: key.at("color").radiance(sun.color, strength)?,
    })
}

fn sky(sky: &SkyFile) -> Result<SkySettings, Problem> {
    let key = Key::name("sky");
    let strength = key.at("strength").within(sky.strength, 0.0, 100.0)?;
    Ok(SkySettings {
        zenith: key.at("zenith").radiance(sky.zenith, strength)?,
        horizon: key.at("horizon").radiance(sky.horizon, strength)?,
        ambient: key.at("ambient").radiance(sky.ambient, strength)?,
        bounce: key.at("bounce").radiance(sky.bounce, strength)?,
        haze_m: key.at("haze_m").above_zero(sky.haze_m, f32::INFINITY)?,
    })
}

fn gravity(gravity: &GravityFile) -> Result<Gravity, Problem> {
    let key = Key::name("gravity");
    let direction = Vec3::from(key.at("direction").direction(gravity.direction)?);
    Ok(Gravity {
        direction: direction.normalize_or(Vec3::NEG_Y),
        strength: key.at("strength").within(gravity.strength, 0.0, 10.0)?,
        center: key.at("center").vector(gravity.center)?,
        center_strength: key.at("center_strength").within(gravity.center_strength, -10.0, 10.0)?,
        blend: key.at("blend").within(gravity.blend, 0.0, 1.0)?,
    })
}

fn culling(culling: &CullingFile) -> Result<Culling, Problem> {
    let farthest = Key::name("culling").at("max_distance_m");
    Ok(Culling {
        frustum: culling.frustum,
        distance: culling.distance,
        orientation: culling.orientation,
        occlusion: culling.occlusion,
        paper: culling.paper,
        max_distance_m: farthest.above_zero(culling.max_distance_m, f32::INFINITY)?,
    })
}
