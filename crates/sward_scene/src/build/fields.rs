//! Fields and species.

use super::{Context, forms, plants};
use crate::assets;
use crate::check::{Key, MAX_M, Problem};
use crate::error::SceneError;
use crate::schema::{
    Color, DensityMapFile, FieldFile, MetricFile, OrderFile, SceneFile, ShapeFile, SpeciesFile,
};
use sward::{BladeOrder, ColorRange, DensityMap, FieldDesc, Metric, Shape, Species, Tufts};

/// A description for each field, in order.
pub(super) fn descriptions(
    context: &mut Context,
    file: &SceneFile,
) -> Result<Vec<FieldDesc>, SceneError> {
    let fields = file.fields.iter().enumerate();
    fields.map(|(index, field)| description(context, field, &Key::list("fields", index))).collect()
}

fn description(
    context: &mut Context,
    field: &FieldFile,
    key: &Key,
) -> Result<FieldDesc, SceneError> {
    let mut desc = checked(field, key).map_err(|problem| context.error(problem))?;
    let files = field.species.as_deref().unwrap_or_default();
    forms::read_textures(context, files, &mut desc.species)?;
    desc.density_map = match &field.density_map {
        None => None,
        Some(DensityMapFile::VertexColor) => Some(DensityMap::VertexColor),
        Some(DensityMapFile::Texture(image)) => {
            let image = context.resolve(image);
            Some(assets::image::density(&image, &assets::read(&image)?)?)
        }
    };
    Ok(desc)
}

fn checked(field: &FieldFile, key: &Key) -> Result<FieldDesc, Problem> {
    if field.density.is_some() && field.count.is_some() {
        return Err(key.at("count").problem("give `density` or `count`, not both"));
    }
    if field.inside.is_some() && field.density_map.is_some() {
        return Err(key.at("inside").problem("give `density_map` or `inside`, not both"));
    }
    let default = FieldDesc::default();
    let density = field.density.unwrap_or(default.density);
    let count = field.count.map(|count| key.at("count").integer(count, 1, u64::MAX));
    let limits = key.at("height_limits_m").span(field.height_limits_m, not_nan)?;
    let patch_size = key.at("patch_size").integer(field.patch_size.into(), 64, 1024)?;
    if patch_size % 64 != 0 {
        let cause = format!("{patch_size} is no multiple of 64");
        return Err(key.at("patch_size").problem(cause));
    }
    Ok(FieldDesc {
        // How many fit is the adapter's to say.
        density: key.at("density").above_zero(density, f32::MAX)?,
        count: count.transpose()?,
        seed: field.seed,
        species: kinds(field, key)?,
        tufts: tufts(field, &key.at("tufts"))?,
        density_map: None,
        color_map: None,
        color_mix: key.at("color_mix").within(field.color_mix, 0.0, 1.0)?,
        max_slope_deg: key.at("max_slope_deg").within(field.max_slope_deg, 0.0, 180.0)?,
        height_limits_m: (limits.min, limits.max),
        obstacles: Vec::new(),
        upright: key.at("upright").within(field.upright, 0.0, 1.0)?,
        patch_size: field.patch_size,
        metric: match field.metric {
            MetricFile::Euclidean => Metric::Euclidean,
            MetricFile::Manhattan => Metric::Manhattan,
        },
        order: match field.order {
            OrderFile::Progressive => BladeOrder::Progressive,
            OrderFile::Morton => BladeOrder::Morton,
            OrderFile::Lexicographic => BladeOrder::Lexicographic,
        },
        max_blades: key.at("max_blades").integer(field.max_blades, 1, u64::MAX)?,
    })
}

/// The species, or what the plants come to.
fn kinds(field: &FieldFile, key: &Key) -> Result<Vec<Species>, Problem> {
    if let Some(mix) = plants::checked(field, key)? {
        return Ok(plants::mixed(&mix, key)?.species);
    }
    let Some(species) = &field.species else {
        return Ok(vec![self::species(&SpeciesFile::default(), key)?]);
    };
    let (key, count) = (key.at("species"), species.len() as u64);
    key.integer(count, 1, 256)
        .map_err(|_| key.problem(format!("{count} kinds: there must be 1 to 256")))?;
    let species = species.iter().enumerate();
    species.map(|(i, kind)| self::species(kind, &key.index(i))).collect()
}

fn not_nan(key: &Key, value: f32) -> Result<f32, Problem> {
    if value.is_nan() { Err(key.problem("NaN is no height")) } else { Ok(value) }
}

fn tufts(field: &FieldFile, key: &Key) -> Result<Option<Tufts>, Problem> {
    let Some(tufts) = &field.tufts else { return Ok(None) };
    Ok(Some(Tufts {
        share: key.at("share").within(tufts.share, 0.0, 1.0)?,
        radius_m: key.at("radius_m").above_zero(tufts.radius_m, MAX_M)?,
        spread_m: key.at("spread_m").above_zero(tufts.spread_m, MAX_M)?,
    }))
}

fn species(kind: &SpeciesFile, key: &Key) -> Result<Species, Problem> {
    let length = |key: &Key, value| key.above_zero(value, 1000.0);
    let unit = |name: &str, value| key.at(name).within(value, 0.0, 1.0);
    Ok(Species {
        name: kind.name.clone(),
        share: key.at("share").above_zero(kind.share, 1e6)?,
        shape: match kind.shape {
            ShapeFile::Quad => Shape::Quad,
            ShapeFile::Triangle => Shape::Triangle,
            ShapeFile::Quadratic => Shape::Quadratic,
            ShapeFile::Dandelion => Shape::Dandelion,
            ShapeFile::TriangleTip(tip) if (0.0..1.0).contains(&tip) => Shape::TriangleTip { tip },
            ShapeFile::TriangleTip(tip) => {
                let cause = format!("TriangleTip({tip}) is out of range: 0 to below 1");
                return Err(key.at("shape").problem(cause));
            }
        },
        form: forms::form(&kind.form, &key.at("form"))?,
        height_m: key.at("height_m").span(kind.height_m, length)?,
        width_m: key.at("width_m").span(kind.width_m, length)?,
        response: key.at("response").span(kind.response, length)?,
        droop: key.at("droop").span(kind.droop, |key, value| key.within(value, 0.0, 10.0))?,
        gust: key.at("gust").within(kind.gust, 0.0, 10.0)?,
        arch: unit("arch", kind.arch)?,
        ridge: unit("ridge", kind.ridge)?,
        root_color: colors(kind.root_color, &key.at("root_color"))?,
        tip_color: colors(kind.tip_color, &key.at("tip_color"))?,
    })
}

fn colors((from, to): (Color, Color), key: &Key) -> Result<ColorRange, Problem> {
    Ok(ColorRange { from: key.color(from)?, to: key.color(to)? })
}
