//! Terms of the wind.

use super::Context;
use crate::assets;
use crate::check::{Key, Problem};
use crate::error::SceneError;
use crate::motion::{self, Path};
use crate::objects::{Placed, find};
use crate::schema::{
    CosineFile, FanFile, GustsFile, PathFile, RotorFile, SceneFile, VortexFile, WavesFile,
    WindFile, WindTextureFile,
};
use crate::wind::SceneWind;
use glam::{Vec2, Vec3};
use std::sync::Arc;
use sward::{Cosine, Fan, Gusts, Rotor, Vortex, Waves, Wind, WindMap, WindSource, WindTexture};

/// Strongest wind, `beta`.
const MAX_WIND: f32 = 20.0;

pub(super) fn sources(
    context: &Context,
    file: &SceneFile,
    placed: &[Placed],
) -> Result<Vec<SceneWind>, SceneError> {
    let count = file.wind.len();
    if count > Wind::MAX_SOURCES {
        let cause = format!("{count} sources: at most {} are taken", Wind::MAX_SOURCES);
        return Err(context.error(Key::name("wind").problem(cause)));
    }
    let sources = file.wind.iter().enumerate();
    let source = |(index, source): (usize, &WindFile)| match source {
        WindFile::Texture(texture) => {
            let source = texture_source(context, texture, &Key::list("wind", index))?;
            Ok(everywhere(WindSource::Texture(source)))
        }
        _ => self::source(source, index, placed).map_err(|problem| context.error(problem)),
    };
    sources.map(source).collect()
}

fn everywhere(source: WindSource) -> SceneWind {
    SceneWind { source, path: Path::still(Vec3::ZERO) }
}

fn source(file: &WindFile, index: usize, placed: &[Placed]) -> Result<SceneWind, Problem> {
    let key = Key::list("wind", index);
    Ok(match file {
        WindFile::Texture(_) => everywhere(WindSource::Texture(WindTexture::default())),
        WindFile::Waves(waves) => everywhere(WindSource::Waves(wave_source(waves, &key)?)),
        WindFile::Gusts(gusts) => everywhere(WindSource::Gusts(gust_source(gusts, &key)?)),
        WindFile::Cosine(cosine) => everywhere(WindSource::Cosine(cosine_source(cosine, &key)?)),
        WindFile::Rotor(r) => SceneWind {
            source: WindSource::Rotor(rotor_source(r, &key)?),
            path: path(r.at, r.path.as_ref(), r.above.as_deref(), &key, placed)?,
        },
        WindFile::Vortex(v) => SceneWind {
            source: WindSource::Vortex(vortex_source(v, &key)?),
            path: path(v.at, v.path.as_ref(), None, &key, placed)?,
        },
        WindFile::Fan(f) => SceneWind {
            source: WindSource::Fan(fan_source(f, &key)?),
            path: path(f.at, f.path.as_ref(), f.above.as_deref(), &key, placed)?,
        },
    })
}

/// Where a source is at which time.
fn path(
    at: [f32; 3],
    path: Option<&PathFile>,
    above: Option<&str>,
    key: &Key,
    placed: &[Placed],
) -> Result<Path, Problem> {
    let path = match path {
        Some(path) => Path::from_file(path, &key.at("path"))?,
        None => Path::still(key.at("at").vector(at)?),
    };
    let Some(name) = above else { return Ok(path) };
    let ground = find(placed, name, &key.at("above"))?.ground();
    motion::along_ground(&path, ground, 0.0, &key.at("path"))
}

fn wave_source(waves: &WavesFile, key: &Key) -> Result<Waves, Problem> {
    Ok(Waves {
        direction: Vec2::from(key.at("direction").direction(waves.direction)?),
        mean: key.at("mean").within(waves.mean, 0.0, MAX_WIND)?,
        amplitude: key.at("amplitude").within(waves.amplitude, 0.0, MAX_WIND)?,
        wavelength_m: key.at("wavelength_m").within(waves.wavelength_m, 0.01, 10_000.0)?,
        speed_mps: key.at("speed_mps").within(waves.speed_mps, -100.0, 100.0)?,
    })
}

fn gust_source(gusts: &GustsFile, key: &Key) -> Result<Gusts, Problem> {
    Ok(Gusts {
        direction: Vec2::from(key.at("direction").direction(gusts.direction)?),
        strength: key.at("strength").within(gusts.strength, 0.0, MAX_WIND)?,
        size_m: key.at("size_m").within(gusts.size_m, 0.01, 10_000.0)?,
        speed_mps: key.at("speed_mps").within(gusts.speed_mps, -100.0, 100.0)?,
        turbulence: key.at("turbulence").within(gusts.turbulence, 0.0, 1.0)?,
        seed: gusts.seed,
    })
}

fn cosine_source(cosine: &CosineFile, key: &Key) -> Result<Cosine, Problem> {
    Ok(Cosine {
        direction: Vec2::from(key.at("direction").direction(cosine.direction)?),
        strength: key.at("strength").within(cosine.strength, 0.0, MAX_WIND)?,
        period_s: key.at("period_s").within(cosine.period_s, 0.01, 10_000.0)?,
        wavelength_m: key.at("wavelength_m").within(cosine.wavelength_m, 0.01, f32::INFINITY)?,
    })
}

fn rotor_source(rotor: &RotorFile, key: &Key) -> Result<Rotor, Problem> {
    Ok(Rotor {
        position: Vec3::ZERO,
        velocity: Vec3::ZERO,
        radius_m: key.at("radius_m").within(rotor.radius_m, 0.01, 1000.0)?,
        strength: key.at("strength").within(rotor.strength, 0.0, MAX_WIND)?,
        range_m: key.at("range_m").within(rotor.range_m, 0.01, 10_000.0)?,
        downwash: key.at("downwash").within(rotor.downwash, 0.0, 4.0)?,
        swirl: key.at("swirl").within(rotor.swirl, -4.0, 4.0)?,
        blades: key.at("blades").integer(rotor.blades.into(), 1, 16)? as u32,
        rpm: key.at("rpm").within(rotor.rpm, -10_000.0, 10_000.0)?,
        pulse: key.at("pulse").within(rotor.pulse, 0.0, 1.0)?,
        speed_mps: key.at("speed_mps").within(rotor.speed_mps, 0.01, 1000.0)?,
        turbulence: key.at("turbulence").within(rotor.turbulence, 0.0, 1.0)?,
        seed: rotor.seed,
    })
}

fn vortex_source(vortex: &VortexFile, key: &Key) -> Result<Vortex, Problem> {
    Ok(Vortex {
        position: Vec3::ZERO,
        velocity: Vec3::ZERO,
        radius_m: key.at("radius_m").within(vortex.radius_m, 0.01, 1000.0)?,
        strength: key.at("strength").within(vortex.strength, 0.0, MAX_WIND)?,
        range_m: key.at("range_m").within(vortex.range_m, 0.01, 10_000.0)?,
        inflow: key.at("inflow").within(vortex.inflow, -4.0, 4.0)?,
        updraft: key.at("updraft").within(vortex.updraft, -4.0, 4.0)?,
        clockwise: vortex.clockwise,
        speed_mps: key.at("speed_mps").within(vortex.speed_mps, 0.01, 1000.0)?,
        turbulence: key.at("turbulence").within(vortex.turbulence, 0.0, 1.0)?,
        seed: vortex.seed,
    })
}

fn fan_source(fan: &FanFile, key: &Key) -> Result<Fan, Problem> {
    let direction = Vec3::from(key.at("direction").direction(fan.direction)?);
    Ok(Fan {
        position: Vec3::ZERO,
        velocity: Vec3::ZERO,
        // Of unit length: what is 100 km long or 1 um still is a direction.
        direction: (direction / direction.abs().max_element()).normalize(),
        radius_m: key.at("radius_m").within(fan.radius_m, 0.01, 1000.0)?,
        half_angle_deg: key.at("half_angle_deg").within(fan.half_angle_deg, 0.1, 80.0)?,
        strength: key.at("strength").within(fan.strength, 0.0, MAX_WIND)?,
        range_m: key.at("range_m").within(fan.range_m, 0.01, 10_000.0)?,
        speed_mps: key.at("speed_mps").within(fan.speed_mps, 0.0, 1000.0)?,
        turbulence: key.at("turbulence").within(fan.turbulence, 0.0, 1.0)?,
        seed: fan.seed,
    })
}

fn texture_source(
    context: &Context,
    texture: &WindTextureFile,
    key: &Key,
) -> Result<WindTexture, SceneError> {
    let checked = || {
        let noise = texture.gusts.is_some() || texture.seed.is_some();
        if texture.file.is_some() && noise {
            return Err(key
                .at("file")
                .problem("give `file`, or `gusts` and `seed` of noise, not both"));
        }
        let gusts = key.at("gusts").integer(texture.gusts.unwrap_or(4).into(), 1, 64)?;
        Ok(WindTexture {
            direction: Vec2::from(key.at("direction").direction(texture.direction)?),
            map: Arc::new(WindMap::noise(gusts as u32, texture.seed.unwrap_or(1))),
            strength: key.at("strength").within(texture.strength, 0.0, MAX_WIND)?,
            size_m: key.at("size_m").within(texture.size_m, 0.01, 100_000.0)?,
            speed_mps: key.at("speed_mps").within(texture.speed_mps, -100.0, 100.0)?,
        })
    };
    let mut source = checked().map_err(|problem| context.error(problem))?;
    if let Some(file) = &texture.file {
        let file = context.resolve(file);
        source.map = Arc::new(assets::image::wind(&file, &assets::read(&file)?)?);
    }
    Ok(source)
}
