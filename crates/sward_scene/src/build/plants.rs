//! Plants by probability, their bands, and the shade that moves over them.

use super::{Context, pictures};
use crate::ShadeSettings;
use crate::check::{Key, MAX_M, Problem};
use crate::error::{SceneError, one_line};
use crate::schema::{BandsFile, FieldFile, PlantFile, ShadeFile};
use glam::Vec2;
use sward::{Bands, Billboard, Form, Kind, Mix, Plant, Range, Sizes, Species};

/// The mix of a field whose plants are given by probability, its pictures read.
pub(super) fn mix(
    context: &mut Context,
    field: &FieldFile,
    key: &Key,
) -> Result<Option<Mix>, SceneError> {
    let mut mix = checked(field, key).map_err(|problem| context.error(problem))?;
    let kinds = mix.iter_mut().flat_map(|mix| &mut mix.kinds);
    for (kind, file) in kinds.zip(&field.plants) {
        let Some(picture) = &file.picture else { continue };
        if let Form::Billboard(billboard) = &mut kind.species.form {
            billboard.look = pictures::picture(context, picture)?.into();
        }
    }
    Ok(mix)
}

/// The same, without the pictures.
pub(super) fn checked(field: &FieldFile, key: &Key) -> Result<Option<Mix>, Problem> {
    if field.plants.is_empty() {
        return match field.garden {
            None => Ok(None),
            Some(_) => Err(key.at("garden").problem("it mixes `plants`, and there are none")),
        };
    }
    if field.species.is_some() {
        return Err(key.at("plants").problem("give `plants` or `species`, not both"));
    }
    let count = field.plants.len() as u64;
    key.at("plants").integer(count, 1, 256)?;
    let kinds = field.plants.iter().enumerate();
    let kinds = kinds.map(|(i, plant)| kind(plant, &key.at("plants").index(i)));
    let mix = Mix { kinds: kinds.collect::<Result<_, _>>()?, garden: field.garden };
    Ok(Some(mix))
}

/// What a mix comes to; the library names the setting, and `key` its field.
pub(crate) fn mixed(mix: &Mix, key: &Key) -> Result<sward::Mixed, Problem> {
    mix.species().map_err(|error| match error {
        sward::Error::Setting { setting, cause } => key.at(&setting).problem(cause),
        other => key.problem(one_line(&other.to_string())),
    })
}

/// The kind that a plant is, or that its picture stands in for.
fn plant(file: &PlantFile, key: &Key) -> Result<Option<Plant>, Problem> {
    let Some(name) = &file.kind else {
        if file.picture.is_some() {
            return Ok(None);
        }
        return Err(key.problem("give the plant a `kind` or a `picture`"));
    };
    if let Some(plant) = Plant::from_name(name) {
        return Ok(Some(plant));
    }
    let known: Vec<_> = Plant::ALL.iter().map(|plant| plant.name()).collect();
    let cause = format!("unknown plant '{name}'; known: {}", known.join(", "));
    Err(key.at("kind").problem(cause))
}

/// The common species of a kind; of a picture that stands in for none, with a look that is replaced.
fn common(plant: Option<Plant>, file: &PlantFile) -> Species {
    let picture = file.picture.as_ref();
    match plant {
        Some(plant) => Species::plant(plant),
        None => Species {
            name: picture.map(|picture| picture.color.clone()).unwrap_or_default(),
            height_m: Species::default().height_m,
            ..Species::plant(Plant::Daisy)
        },
    }
}

fn kind(file: &PlantFile, key: &Key) -> Result<Kind, Problem> {
    let plant = plant(file, key)?;
    let mut species = common(plant, file);
    if let Some(height) = file.height_m {
        species.height_m = key.at("height_m").span(height, |key, h| key.above_zero(h, 1000.0))?;
    }
    let stretch = key.at("stretch").within(file.stretch, 0.1, 10.0)?;
    let share = plant.map_or(1.0, Plant::width_share);
    let width = |height: f32| height * share * stretch;
    species.width_m = Range::new(width(species.height_m.min), width(species.height_m.max));
    species.gust = key.at("gust").within(file.gust, 0.0, 10.0)?;
    let quads = key.at("quads").integer(file.quads.into(), 1, 6)? as u32;
    let angle = file.angle_deg.unwrap_or(180.0 / quads as f32);
    species.form = Form::Billboard(Billboard {
        quads,
        angle_deg: key.at("angle_deg").within(angle, 0.0, 180.0)?,
        turn_deg: key
            .at("turn_deg")
            .span(file.turn_deg, |k, v| k.within(v, -36_000.0, 36_000.0))?,
        sizes: sizes(file.sizes, &key.at("sizes"))?,
        wind_turn: key.at("wind_turn").within(file.wind_turn, 0.0, 4.0)?,
        wind_tint: key.at("wind_tint").within(file.wind_tint, 0.0, 1.0)?,
        absorption: key.at("absorption").within(file.absorption, 0.0, 2.0)?,
        ..Billboard::new(plant.unwrap_or(Plant::Daisy))
    });
    let flower = file.flower.unwrap_or(!plant.is_some_and(Plant::is_grass));
    Ok(Kind { species, probability: file.probability, flower })
}

fn sizes((small, medium, large): (f32, f32, f32), key: &Key) -> Result<Sizes, Problem> {
    for share in [small, medium, large] {
        key.within(share, 0.0, 1e6)?;
    }
    if small + medium + large == 0.0 {
        return Err(key.problem("all are 0: give one size a share"));
    }
    Ok(Sizes { small, medium, large })
}

/// Where the bands end.
pub(super) fn bands(file: &BandsFile) -> Result<Bands, Problem> {
    let key = Key::name("bands");
    let distances = key.at("distances_m");
    let [near_m, middle_m, far_m] = file.distances_m[..] else {
        let count = file.distances_m.len();
        let cause = format!("{count} bands: there are three, so give three distances");
        return Err(distances.problem(cause));
    };
    for (i, distance) in file.distances_m.iter().enumerate() {
        let most = if i == 2 { f32::INFINITY } else { 1e6 };
        distances.index(i).above_zero(*distance, most)?;
    }
    if !(near_m < middle_m && middle_m < far_m) {
        let cause = format!(
            "{near_m}, {middle_m}, {far_m} are out of order: each band must end beyond the one before"
        );
        return Err(distances.problem(cause));
    }
    let share = |name: &str, value| key.at(name).above_zero(value, 1.0);
    Ok(Bands {
        near_m,
        middle_m,
        far_m,
        jitter: key.at("jitter").within(file.jitter, 0.0, 0.9)?,
        far_share: share("far_share", file.far_share)?,
        far_size: share("far_size", file.far_size)?,
    })
}

/// What moves between the field and the sun.
pub(super) fn shade(file: &ShadeFile) -> Result<ShadeSettings, Problem> {
    let key = Key::name("shade");
    let drift = |value| key.at("drift_mps").within(value, -1000.0, 1000.0);
    Ok(ShadeSettings {
        depth: key.at("depth").within(file.depth, 0.0, 1.0)?,
        size_m: key.at("size_m").within(file.size_m, 0.01, MAX_M)?,
        height_m: key.at("height_m").within(file.height_m, -MAX_M, MAX_M)?,
        drift_mps: Vec2::new(drift(file.drift_mps[0])?, drift(file.drift_mps[1])?),
    })
}
