//! Meshes from a scene's sources.

use super::shapes;
use crate::assets::{self, Part, heights};
use crate::build::Context;
use crate::check::{Key, MAX_M, Problem};
use crate::error::SceneError;
use crate::schema::{HeightmapFile, Source, TerrainFile};
use glam::{UVec2, Vec2};
use sward::Mesh;
use sward::grow::terrain::NoiseTerrain;

/// Makes what a source describes; `shape` numbers the shapes of rocks and trees.
pub(crate) fn parts(
    context: &mut Context,
    source: &Source,
    key: &Key,
    shape: u32,
) -> Result<Vec<Part>, SceneError> {
    let mesh = match source {
        Source::File(file) => return assets::load_mesh(&context.resolve(file)),
        Source::Heightmap(map) => heightmap(context, map, key)?,
        Source::Object(name) => {
            let cause = format!("Object(\"{name}\") is for a field's `on`; name a mesh here");
            return Err(context.error(key.problem(cause)));
        }
        generated => generate(generated, key, shape).map_err(|problem| context.error(problem))?,
    };
    Ok(vec![mesh.into()])
}

fn generate(source: &Source, key: &Key, shape: u32) -> Result<Mesh, Problem> {
    let segments = |count: u32| {
        key.at("segments").integer(count.into(), 4, 1024)?;
        Ok(count.div_ceil(2))
    };
    let length = |name: &str, value: f32| key.at(name).above_zero(value, MAX_M);
    let made = match source {
        Source::Plane(plane) => {
            for side in plane.size_m {
                length("size_m", side)?;
            }
            for cells in plane.divisions {
                key.at("divisions").integer(cells.into(), 1, 2048)?;
            }
            Mesh::plane(plane.size_m.into(), plane.divisions.into())
        }
        Source::Terrain(terrain) => return hills(terrain, key),
        Source::Sphere(sphere) => {
            let rings = segments(sphere.segments)?;
            let radius_m = length("radius_m", sphere.radius_m)?;
            let relief_m = key.at("relief_m").within(sphere.relief_m, 0.0, radius_m)?;
            let hill_m = length("hill_m", sphere.hill_m.unwrap_or(radius_m))?;
            if relief_m > 0.0 {
                let planet = shapes::Planet { radius_m, relief_m, hill_m, seed: sphere.seed };
                return Ok(shapes::planet(&planet, rings));
            }
            Mesh::sphere(radius_m, rings)
        }
        Source::Torus(torus) => {
            let round = segments(torus.segments)?.max(3);
            let ring = length("radius_m", torus.radius_m)?;
            let tube = length("tube_m", torus.tube_m)?;
            Mesh::torus(ring, tube, UVec2::new(torus.segments, round))
        }
        Source::Mobius(band) => {
            segments(band.segments)?;
            let ring = length("radius_m", band.radius_m)?;
            let width = length("width_m", band.width_m)?;
            Mesh::mobius(ring, width, UVec2::new(band.segments, 8))
        }
        Source::Rock(rock) => {
            key.at("rough").within(rock.rough, 0.0, 1.0)?;
            let seed = rock.seed.wrapping_add(shape);
            Ok(shapes::rock(length("radius_m", rock.radius_m)?, rock.rough, seed))
        }
        Source::Tree(tree) => Ok(shapes::tree(&shapes::Tree {
            height_m: length("height_m", tree.height_m)?,
            crown_m: length("crown_m", tree.crown_m)?,
            leaf: key.at("leaf_color").color(tree.leaf_color)?,
            bark: key.at("bark_color").color(tree.bark_color)?,
            seed: tree.seed.wrapping_add(shape),
        })),
        Source::File(_) | Source::Heightmap(_) | Source::Object(_) => Ok(Mesh::default()),
    };
    made.map_err(|error| library(&error, key))
}

/// What the library finds wrong with a value that passed here: how two values go together.
fn library(error: &sward::Error, key: &Key) -> Problem {
    match error {
        sward::Error::Setting { cause, .. } => key.problem(cause.clone()),
        other => key.problem(other.to_string()),
    }
}

fn hills(terrain: &TerrainFile, key: &Key) -> Result<Mesh, Problem> {
    let base = key.at("base_m").within(terrain.base_m, -MAX_M, MAX_M)?;
    let mut mesh = Mesh::terrain(NoiseTerrain {
        size_m: key.at("size_m").above_zero(terrain.size_m, MAX_M)?,
        height_m: key.at("relief_m").within(terrain.relief_m, 0.0, MAX_M)?,
        feature_m: key.at("hill_m").above_zero(terrain.hill_m, MAX_M)?,
        octaves: key.at("octaves").integer(terrain.octaves.into(), 1, 10)? as u32,
        resolution: key.at("divisions").integer(terrain.divisions.into(), 1, 2048)? as u32,
        seed: terrain.seed,
    })
    .map_err(|error| library(&error, key))?;
    mesh.positions.iter_mut().for_each(|p| p.y += base);
    Ok(mesh)
}

fn heightmap(context: &mut Context, map: &HeightmapFile, key: &Key) -> Result<Mesh, SceneError> {
    let check = || -> Result<(), Problem> {
        for side in map.size_m {
            key.at("size_m").above_zero(side, MAX_M)?;
        }
        key.at("height_m").within(map.height_m, 0.0, MAX_M)?;
        key.at("base_m").within(map.base_m, -MAX_M, MAX_M)?;
        key.at("smooth_m").within(map.smooth_m, 0.0, MAX_M)?;
        let samples = map.samples.unwrap_or(2);
        key.at("samples").integer(samples.into(), 2, u64::from(MAX_SAMPLES)).map(|_| ())
    };
    check().map_err(|problem| context.error(problem))?;
    let file = context.resolve(&map.file);
    let (heights, coarse) = heights::parse(&file, &assets::read(&file)?)?;
    if coarse {
        let step = map.height_m / 255.0;
        context.note(format!(
            "{}: has 8 bits, so heights come in steps of {step:.3} m; 16-bit grey is smoother",
            file.display()
        ));
    }
    let [width, depth] = map.size_m;
    let texels = Vec2::new(heights.columns as f32 - 1.0, heights.rows as f32 - 1.0);
    let heights = heights.blurred(map.smooth_m / width * texels.x, map.smooth_m / depth * texels.y);
    let longest = heights.columns.max(heights.rows) as u32;
    let samples = map.samples.unwrap_or(longest.clamp(257, MAX_SAMPLES)) as f32;
    let points =
        |side: f32| ((samples - 1.0) * side / width.max(depth)).round().max(1.0) as u32 + 1;
    let (columns, rows) = (points(width), points(depth));
    let share = |i: u32, count: u32| i as f32 / (count - 1) as f32;
    let heights_m: Vec<f32> = (0..rows * columns)
        .map(|i| {
            let (u, v) = (share(i % columns, columns), share(i / columns, rows));
            map.base_m + map.height_m * heights.sample(u, v)
        })
        .collect();
    Mesh::heightmap(columns, rows, &heights_m, map.size_m.into())
        .map_err(|error| context.error(library(&error, key)))
}

/// Most vertices along a heightmap's side.
const MAX_SAMPLES: u32 = 2049;
