//! Placing objects: transforms, copies, and what stands on what.

use super::collide::{ColliderPiece, Pieces, Stand};
use super::ground::Ground;
use super::random::Random;
use super::{Object, generate};
use crate::Path;
use crate::assets::{self, Part, mesh};
use crate::build::Context;
use crate::check::{Key, MAX_M, Problem};
use crate::error::SceneError;
use crate::motion::{self, euler_deg};
use crate::schema::{ObjectFile, ScatterFile, Source};
use glam::{Affine3A, Quat, Vec2, Vec3, Vec3Swizzles};
use std::cell::OnceCell;
use sward::{Mesh, Obstacle};

/// A scene's object, made and placed: one part a material.
#[derive(Debug)]
pub(crate) struct Placed {
    pub(crate) name: String,
    pub(crate) parts: Vec<Part>,
    visible: bool,
    path: Option<Path>,
    collider: Vec<ColliderPiece>,
    ground: OnceCell<Ground>,
}

/// A copy: where, how big, which way round, and its number.
struct Copy {
    at: Vec3,
    scale: f32,
    turn: f32,
    number: u32,
}

impl Placed {
    /// A mesh without keys of its own, as a field's `on` makes it.
    pub(crate) fn from_source(
        context: &mut Context,
        name: String,
        source: &Source,
        key: &Key,
    ) -> Result<Self, SceneError> {
        let parts = generate::parts(context, source, key, 0)?;
        let (path, collider, ground) = (None, Vec::new(), OnceCell::new());
        Ok(Self { name, parts, visible: true, path, collider, ground })
    }

    /// An object with its transform and copies; `others` are those listed before it, `carries`
    /// whether grass grows on it.
    pub(crate) fn from_file(
        context: &mut Context,
        file: &ObjectFile,
        index: usize,
        others: &[Self],
        carries: impl Fn(&str) -> bool,
    ) -> Result<Self, SceneError> {
        let key = Key::list("objects", index);
        let name = file.name.clone().unwrap_or_else(|| format!("object {index}"));
        let transform = transform(file, &key).map_err(|problem| context.error(problem))?;
        let path = path(file, &key, others).map_err(|problem| context.error(problem))?;
        let copies = copies(file, &key, others).map_err(|problem| context.error(problem))?;
        let mut pieces = Pieces::new(file, &key, carries(&name), copies.len())
            .map_err(|problem| context.error(problem))?;
        let parts = assemble(context, file, &key, transform, &copies, &mut pieces)?;
        let stands: Vec<Stand> = copies.iter().map(Copy::stand).collect();
        let collider = pieces.finish(context, &name, transform, &stands)?;
        let ground = OnceCell::new();
        let mut placed = Self { name, parts, visible: file.visible, path, collider, ground };
        placed.set_looks(context, file, &key)?;
        Ok(placed)
    }

    fn set_looks(
        &mut self,
        context: &Context,
        file: &ObjectFile,
        key: &Key,
    ) -> Result<(), SceneError> {
        let checked = || -> Result<_, Problem> {
            let color = file.base_color.map(|color| key.at("base_color").color(color));
            let roughness = file.roughness.map(|r| key.at("roughness").within(r, 0.0, 1.0));
            Ok((color.transpose()?, roughness.transpose()?))
        };
        let (color, roughness) = checked().map_err(|problem| context.error(problem))?;
        let texture = match &file.texture {
            Some(texture) => {
                let texture = context.resolve(texture);
                Some(assets::image::texture(&texture, &assets::read(&texture)?)?)
            }
            None => None,
        };
        for part in &mut self.parts {
            part.base_color = color.or(part.base_color);
            part.roughness = roughness.or(part.roughness);
            part.texture = texture.clone().or(part.texture.take());
        }
        Ok(())
    }

    /// All parts as one mesh.
    pub(crate) fn merged(&self) -> Mesh {
        let mut merged = Mesh::default();
        for part in &self.parts {
            mesh::append(&mut merged, &part.mesh);
        }
        merged
    }

    /// Spheres, capsules and boxes that push grass aside for it.
    pub(crate) fn shapes(&self) -> usize {
        self.collider.iter().map(ColliderPiece::count).sum()
    }

    /// What keeps roots out: what moves does not.
    pub(crate) fn obstacles(&self) -> impl Iterator<Item = Obstacle> {
        let resting = self.collider.iter().filter(|_| self.path.is_none());
        resting.map(ColliderPiece::obstacle)
    }

    pub(crate) fn ground(&self) -> &Ground {
        self.ground.get_or_init(|| Ground::new(&self.merged()))
    }

    /// The objects of its parts, without normals where they are still to be computed.
    pub(crate) fn into_objects(self, carries_grass: bool, soil: [f32; 3]) -> Vec<Object> {
        let alone = self.parts.len() == 1;
        let parts = self.parts.into_iter().enumerate();
        let object = |(i, part): (usize, Part)| Object {
            collider: if i == 0 { self.collider.clone() } else { Vec::new() },
            name: if alone { self.name.clone() } else { format!("{} part {i}", self.name) },
            base_color: part.base_color.unwrap_or(
                match (part.mesh.colors.is_empty() && part.texture.is_none(), carries_grass) {
                    (false, _) => [1.0; 3],
                    (true, true) => soil,
                    (true, false) => GREY,
                },
            ),
            mesh: part.mesh,
            roughness: part.roughness.unwrap_or(0.9),
            visible: self.visible,
            carries_grass,
            // Known when the mesh has been checked.
            area_m2: 0.0,
            dropped_triangles: 0,
            texture: part.texture,
            path: self.path.clone(),
        };
        parts.map(object).collect()
    }
}

impl Copy {
    fn stand(&self) -> Stand {
        Stand { scale: self.scale, turn: Quat::from_rotation_y(self.turn), at: self.at }
    }
}

/// The meshes of all copies, one part a material; `pieces` gets each mesh before it is placed.
fn assemble(
    context: &mut Context,
    file: &ObjectFile,
    key: &Key,
    transform: Affine3A,
    copies: &[Copy],
    pieces: &mut Pieces,
) -> Result<Vec<Part>, SceneError> {
    let mut parts: Vec<Part> = Vec::new();
    let differ = matches!(file.source, Source::Rock(_) | Source::Tree(_));
    let mut shapes: Vec<Vec<Part>> = Vec::new();
    for copy in copies {
        let shape = if differ { copy.number % SHAPES } else { 0 };
        if shapes.len() as u32 == shape {
            shapes.push(generate::parts(context, &file.source, &key.at("source"), shape)?);
            shapes.last().into_iter().for_each(|made| pieces.take(made));
        }
        let Some(made) = shapes.get(shape as usize) else { continue };
        let Stand { scale, turn, at } = copy.stand();
        let placed = Affine3A::from_scale_rotation_translation(Vec3::splat(scale), turn, at);
        for (i, part) in made.iter().enumerate() {
            let mut part = part.clone();
            mesh::transform(&mut part.mesh, placed * transform);
            match parts.get_mut(i) {
                Some(all) => mesh::append(&mut all.mesh, &part.mesh),
                None => parts.push(part),
            }
        }
        let vertices: usize = parts.iter().map(|part| part.mesh.positions.len()).sum();
        if vertices > MAX_VERTICES {
            let cause = format!("its copies have more than {MAX_VERTICES} vertices; use fewer");
            return Err(context.error(key.problem(cause)));
        }
    }
    mesh::check(parts.iter().map(|part| &part.mesh))
        .map_err(|cause| context.error(key.problem(cause)))?;
    Ok(parts)
}

/// Colour of an object that sets none.
const GREY: [f32; 3] = [0.35, 0.34, 0.32];

/// Shapes that rocks and trees come in; copies take them in turn, so that many thousand load soon.
const SHAPES: u32 = 64;

/// Most vertices of all copies of an object.
const MAX_VERTICES: usize = 50_000_000;

fn transform(file: &ObjectFile, key: &Key) -> Result<Affine3A, Problem> {
    for factor in file.scale.0 {
        if factor == 0.0 {
            return Err(key.at("scale").problem("0 flattens the mesh: it must not be 0"));
        }
    }
    let scale = key.at("scale").vector(file.scale.0)?;
    let turn = euler_deg(key.at("rotate_deg").vector(file.rotate_deg)?);
    let translate = key.at("translate").vector(file.translate)?;
    Ok(Affine3A::from_scale_rotation_translation(scale, turn, translate))
}

/// Where it moves; heights are over the object that it is above.
fn path(file: &ObjectFile, key: &Key, others: &[Placed]) -> Result<Option<Path>, Problem> {
    let Some(path) = &file.path else { return Ok(None) };
    let key_of = key.at("path");
    if !file.at.is_empty() || file.scatter.is_some() {
        return Err(
            key_of.problem("a thing that moves has no copies: leave out `at` and `scatter`")
        );
    }
    let path = Path::from_file(path, &key_of)?;
    Ok(Some(match &file.above {
        None => path,
        Some(name) => {
            let ground = find(others, name, &key.at("above"))?.ground();
            motion::along_ground(&path, ground, 0.0, &key_of)?
        }
    }))
}

fn copies(file: &ObjectFile, key: &Key, others: &[Placed]) -> Result<Vec<Copy>, Problem> {
    let sizes = key.at("copy_scale").span(file.copy_scale, |key, v| key.above_zero(v, 1000.0))?;
    let ground = file.above.as_deref().map(|name| find(others, name, &key.at("above")));
    let ground = ground.transpose()?.map(Placed::ground);
    let seed = file.scatter.as_ref().map_or(1, |scatter| scatter.seed);
    let mut random = Random::new(seed, 21);
    let mut places = Vec::new();
    for (i, &[x, z]) in file.at.iter().enumerate() {
        let key = key.at("at").index(i);
        let at = key.vector([x, 0.0, z])?.xz();
        let height = match ground {
            None => 0.0,
            Some(ground) => ground.height(at).ok_or_else(|| {
                key.problem(format!("({x}, {z}) is beside the object that it stands on"))
            })?,
        };
        places.push(Vec3::new(at.x, height, at.y));
    }
    if let Some(scatter) = &file.scatter {
        let ground = ground.ok_or_else(|| {
            key.at("scatter").problem("needs `above`: the object to strew the copies over")
        })?;
        strew(scatter, &key.at("scatter"), ground, &mut random, &mut places)?;
    }
    if file.path.is_some() {
        return Ok(vec![Copy { at: Vec3::ZERO, scale: 1.0, turn: 0.0, number: 0 }]);
    }
    if file.at.is_empty() && file.scatter.is_none() {
        let height = ground.and_then(|ground| ground.height(Vec2::ZERO)).unwrap_or(0.0);
        return Ok(vec![Copy { at: Vec3::Y * height, scale: 1.0, turn: 0.0, number: 0 }]);
    }
    let copy = |(number, at)| Copy {
        at,
        scale: sizes.at(random.between(0.0, 1.0)),
        turn: random.between(0.0, std::f32::consts::TAU),
        number,
    };
    Ok((0..).zip(places).map(copy).collect())
}

fn strew(
    scatter: &ScatterFile,
    key: &Key,
    ground: &Ground,
    random: &mut Random,
    places: &mut Vec<Vec3>,
) -> Result<(), Problem> {
    let count = key.at("count").integer(scatter.count.into(), 1, 10_000)? as usize;
    let radius = key.at("radius_m").above_zero(scatter.radius_m, MAX_M)?;
    let margin = key.at("margin_m").within(scatter.margin_m, 0.0, MAX_M)?;
    let (low, high) = (ground.min.xz() + margin, ground.max.xz() - margin);
    let center = match scatter.center {
        Some([x, z]) => Some(key.at("center").vector([x, 0.0, z])?.xz()),
        None => None,
    };
    let wanted = places.len() + count;
    // Ground may cover little of its bounding box; give up in the end.
    for _ in 0..count * 200 {
        if places.len() == wanted {
            return Ok(());
        }
        let at = match center {
            Some(center) => {
                let (sin, cos) = random.between(0.0, std::f32::consts::TAU).sin_cos();
                center + Vec2::new(sin, cos) * radius * random.between(0.0, 1.0).sqrt()
            }
            None => Vec2::new(random.between(low.x, high.x), random.between(low.y, high.y)),
        };
        if at.cmplt(low).any() || at.cmpgt(high).any() {
            continue;
        }
        places.extend(ground.height(at).map(|height| Vec3::new(at.x, height, at.y)));
    }
    if places.len() == wanted {
        return Ok(());
    }
    Err(key.problem("finds no place on the object; check `center`, `radius_m` and `margin_m`"))
}

/// The object of that name.
pub(crate) fn find<'a>(
    objects: &'a [Placed],
    name: &str,
    key: &Key,
) -> Result<&'a Placed, Problem> {
    let found = objects.iter().find(|object| object.name == name).ok_or_else(|| {
        let known = objects.iter().map(|object| object.name.as_str()).collect::<Vec<_>>();
        let known = if known.is_empty() { "none".into() } else { known.join(", ") };
        key.problem(format!("no object '{name}' before this; there are: {known}"))
    })?;
    if found.path.is_some() {
        return Err(key.problem(format!("'{name}' has a path: name an object that rests")));
    }
    Ok(found)
}
