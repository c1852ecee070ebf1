//! Meshes from a scene's sources.

use super::shapes;
use crate::assets::{self, Part, heights};
use crate::build::Context;
use crate::check::{Key, MAX_M, Problem};
use crate::error::SceneError;
use crate::schema::{HeightmapFile, Source};
use glam::{UVec2, Vec2, Vec3};
use sward::Mesh;

/// Makes what a source describes; `copy` numbers the copies of rocks and trees, which all differ.
pub(crate) fn parts(
    context: &mut Context,
    source: &Source,
    key: &Key,
    copy: u32,
) -> Result<Vec<Part>, SceneError> {
    let mesh = match source {
        Source::File(file) => return assets::load_mesh(&context.resolve(file)),
        Source::Heightmap(map) => heightmap(context, map, key)?,
        Source::Object(name) => {
            let cause = format!("Object(\"{name}\") is for a field's `on`; name a mesh here");
            return Err(context.error(key.problem(cause)));
        }
        generated => generate(generated, key, copy).map_err(|problem| context.error(problem))?,
    };
    Ok(vec![mesh.into()])
}

fn generate(source: &Source, key: &Key, copy: u32) -> Result<Mesh, Problem> {
    let segments = |count: u32| key.at("segments").integer(count.into(), 3, 1024);
    let radius = |name: &str, value: f32| key.at(name).above_zero(value, MAX_M);
    Ok(match source {
        Source::Plane(plane) => {
            for side in plane.size_m {
                key.at("size_m").above_zero(side, MAX_M)?;
            }
            for cells in plane.divisions {
                key.at("divisions").integer(cells.into(), 1, 2048)?;
            }
            let cells = UVec2::from(plane.divisions);
            grid(plane.size_m.into(), cells.x as usize + 1, cells.y as usize + 1, |_, _| 0.0)
        }
        Source::Terrain(terrain) => return hills(terrain, key),
        Source::Sphere(sphere) => {
            segments(sphere.segments)?;
            shapes::sphere(radius("radius_m", sphere.radius_m)?, sphere.segments)
        }
        Source::Torus(torus) => {
            segments(torus.segments)?;
            key.at("tube_m").above_zero(torus.tube_m, torus.radius_m)?;
            shapes::torus(radius("radius_m", torus.radius_m)?, torus.tube_m, torus.segments)
        }
        Source::Mobius(band) => {
            segments(band.segments)?;
            key.at("width_m").above_zero(band.width_m, 2.0 * band.radius_m)?;
            shapes::mobius(radius("radius_m", band.radius_m)?, band.width_m, band.segments)
        }
        Source::Rock(rock) => {
            key.at("rough").within(rock.rough, 0.0, 1.0)?;
            let seed = rock.seed.wrapping_add(copy);
            shapes::rock(radius("radius_m", rock.radius_m)?, rock.rough, seed)
        }
        Source::Tree(tree) => shapes::tree(&shapes::Tree {
            height_m: radius("height_m", tree.height_m)?,
            crown_m: radius("crown_m", tree.crown_m)?,
            leaf: key.at("leaf_color").color(tree.leaf_color)?,
            bark: key.at("bark_color").color(tree.bark_color)?,
            seed: tree.seed.wrapping_add(copy),
        }),
        Source::File(_) | Source::Heightmap(_) | Source::Object(_) => Mesh::default(),
    })
}

fn hills(terrain: &crate::schema::TerrainFile, key: &Key) -> Result<Mesh, Problem> {
    key.at("size_m").above_zero(terrain.size_m, MAX_M)?;
    key.at("relief_m").within(terrain.relief_m, 0.0, MAX_M)?;
    key.at("hill_m").above_zero(terrain.hill_m, MAX_M)?;
    key.at("base_m").within(terrain.base_m, -MAX_M, MAX_M)?;
    key.at("octaves").integer(terrain.octaves.into(), 1, 10)?;
    key.at("divisions").integer(terrain.divisions.into(), 1, 2048)?;
    let points = terrain.divisions as usize + 1;
    let k = terrain.size_m / terrain.hill_m * std::f32::consts::TAU;
    let height = |u: f32, v: f32| {
        terrain.base_m + terrain.relief_m * 0.25 * ((u * k).sin() + (v * k * 0.8 + u).sin())
    };
    Ok(grid(Vec2::splat(terrain.size_m), points, points, height))
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
    let points = |side: f32| ((samples - 1.0) * side / width.max(depth)).round().max(1.0) as usize + 1;
    let height = |u, v| map.base_m + map.height_m * heights.sample(u, v);
    Ok(grid(Vec2::new(width, depth), points(width), points(depth), height))
}

/// Most vertices along a heightmap's side.
const MAX_SAMPLES: u32 = 2049;

/// A rectangle of `columns` by `rows` points, centred on the origin, at the heights of (u, v) in
/// 0..=1; (0, 0) is at -x, -z.
pub(crate) fn grid(
    size: Vec2,
    columns: usize,
    rows: usize,
    height: impl Fn(f32, f32) -> f32,
) -> Mesh {
    let mut mesh = Mesh::default();
    for row in 0..rows {
        for column in 0..columns {
            let u = column as f32 / (columns - 1) as f32;
            let v = row as f32 / (rows - 1) as f32;
            let (x, z) = ((u - 0.5) * size.x, (v - 0.5) * size.y);
            mesh.positions.push(Vec3::new(x, height(u, v), z));
            mesh.uvs.push(Vec2::new(u, v));
        }
    }
    let across = columns as u32;
    for row in 0..rows as u32 - 1 {
        for column in 0..across - 1 {
            let a = row * across + column;
            let (b, c, d) = (a + 1, a + across, a + across + 1);
            mesh.triangles.extend([[a, c, b], [b, c, d]]);
        }
    }
    mesh
}
