//! Settings of the whole scene: light, sky, gravity, culling.

use super::plants;
use crate::check::{Key, MAX_M, Problem};
use crate::schema::{
    CullingFile, DepthOfFieldFile, FogFile, GravityFile, PhysicsFile, SceneFile, SkyFile, SunFile,
    TechniqueFile, ToneFile,
};
use crate::{
    Course, Daylight, DepthOfFieldSettings, FogSettings, GroundSettings, Heavens, Luminary,
    ShadeSettings, SkySettings, SunSettings, Tone,
};
use glam::Vec3;
use sward::{Bands, Culling, Gravity, PhysicsModel, Technique};

pub(super) struct Settings {
    pub(super) light: SunSettings,
    pub(super) sky: SkySettings,
    pub(super) heavens: Option<Heavens>,
    pub(super) tone: Option<Tone>,
    pub(super) exposure_ev: Option<f32>,
    pub(super) fog: Option<FogSettings>,
    pub(super) depth_of_field: Option<DepthOfFieldSettings>,
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
        let heavens = daylight(file)?.map(Heavens::new);
        let by_hand = || -> Result<_, Problem> {
            let (sun_file, sky_file) = (file.sun.clone(), file.sky.clone());
            Ok((sun(&sun_file.unwrap_or_default())?, sky(&sky_file.unwrap_or_default())?))
        };
        let (light, sky) = match &heavens {
            None => by_hand()?,
            Some(heavens) => {
                let now = heavens.at(0.0);
                (now.sun, now.sky)
            }
        };
        let exposed = |ev| Key::name("exposure_ev").within(ev, -20.0, 20.0);
        Ok(Self {
            light,
            sky,
            heavens,
            tone: file.tone.map(|tone| match tone {
                ToneFile::Neutral => Tone::Neutral,
                ToneFile::Agx => Tone::Agx,
            }),
            exposure_ev: file.exposure_ev.map(exposed).transpose()?,
            fog: file.fog.as_ref().map(fog).transpose()?,
            depth_of_field: file.depth_of_field.as_ref().map(depth_of_field).transpose()?,
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

fn daylight(file: &SceneFile) -> Result<Option<Daylight>, Problem> {
    let Some(light) = &file.light else { return Ok(None) };
    let key = Key::name("light");
    for (name, given) in [("sun", file.sun.is_some()), ("sky", file.sky.is_some())] {
        if given {
            let cause = format!("it sets sun and sky by the time of day; leave out `{name}`");
            return Err(key.problem(cause));
        }
    }
    let hours = |name, value: f64, least, most| {
        key.at(name).within(value as f32, least, most).map(|_| value)
    };
    let course = Course::Day {
        time_h: hours("time_h", light.time_h, 0.0, 24.0)?,
        hours_per_s: hours("hours_per_s", light.hours_per_s, -24.0, 24.0)?,
        latitude_deg: key.at("latitude_deg").within(light.latitude_deg, -90.0, 90.0)?,
        day_of_year: key.at("day_of_year").within(light.day_of_year, 1.0, 366.0)?,
    };
    Ok(Some(Daylight {
        course,
        luminary: Luminary::Sun,
        turbidity: key.at("turbidity").within(light.turbidity, 1.0, 10.0)?,
        ground_albedo: key.at("ground_albedo").color(light.ground_albedo)?.into(),
        clouds: 0.0,
        strength: key.at("strength").within(light.strength, 0.0, 100.0)?,
        haze_m: key.at("haze_m").above_zero(light.haze_m, f32::INFINITY)?,
        brighter_ev: 0.0,
    }))
}

fn fog(fog: &FogFile) -> Result<FogSettings, Problem> {
    let key = Key::name("fog");
    let color = fog.color.map(|color| key.at("color").radiance(color, 1.0));
    Ok(FogSettings {
        color: color.transpose()?,
        density_per_m: key.at("density_per_m").within(fog.density_per_m, 0.0, 10.0)?,
        start_m: key.at("start_m").within(fog.start_m, 0.0, MAX_M)?,
        base_m: key.at("base_m").within(fog.base_m, -MAX_M, MAX_M)?,
        falloff_m: key.at("falloff_m").within(fog.falloff_m, 0.01, f32::INFINITY)?,
    })
}

fn depth_of_field(lens: &DepthOfFieldFile) -> Result<DepthOfFieldSettings, Problem> {
    let key = Key::name("depth_of_field");
    Ok(DepthOfFieldSettings {
        focus_m: key.at("focus_m").above_zero(lens.focus_m, MAX_M)?,
        aperture_m: key.at("aperture_mm").within(lens.aperture_mm, 0.0, 10_000.0)? * 1e-3,
    })
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
