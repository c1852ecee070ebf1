//! How objects push grass aside and keep roots out.

use super::shapes;
use crate::assets::{Part, mesh, packs};
use crate::build::Context;
use crate::check::{Key, Problem};
use crate::error::SceneError;
use crate::schema::{CollideFile, ObjectFile, Source};
use glam::{Affine3A, Quat, Vec3};
use std::sync::Arc;
use sward::{ColliderShape, Mesh, Obstacle, PackDesc, Pose, Solid, Sphere};

/// One copy of an object as a thing that pushes grass aside.
#[derive(Debug, Clone)]
pub struct ColliderPiece {
    /// Where it stands, in the space of [`crate::Object::mesh`]: the world, or the object's own
    /// where it moves.
    pub pose: Pose,
    shape: Shape,
}

#[derive(Debug, Clone)]
enum Shape {
    Sphere(f32),
    Capsule { from: Vec3, to: Vec3, radius: f32 },
    Cuboid(Vec3),
    Packed { spheres: Vec<Sphere>, solid: Arc<Solid>, scale: f32 },
}

impl ColliderPiece {
    /// Its shape, as the library takes it.
    pub fn shape(&self) -> ColliderShape<'_> {
        match &self.shape {
            Shape::Sphere(radius) => ColliderShape::Sphere { radius: *radius },
            Shape::Capsule { from, to, radius } => {
                ColliderShape::Capsule { from: *from, to: *to, radius: *radius }
            }
            Shape::Cuboid(half_extents) => ColliderShape::Cuboid { half_extents: *half_extents },
            Shape::Packed { spheres, .. } => ColliderShape::Spheres(spheres),
        }
    }

    /// Spheres, capsules and boxes that it is made of.
    pub(crate) fn count(&self) -> usize {
        match &self.shape {
            Shape::Packed { spheres, .. } => spheres.len(),
            _ => 1,
        }
    }

    /// The same as a thing that no root grows inside of: of a packed mesh the mesh itself.
    pub fn obstacle(&self) -> Obstacle {
        let pose = self.pose;
        match &self.shape {
            Shape::Sphere(radius) => {
                Obstacle::Sphere(Sphere { center: pose.translation, radius: *radius })
            }
            Shape::Capsule { from, to, radius } => {
                Obstacle::Capsule { from: pose.point(*from), to: pose.point(*to), radius: *radius }
            }
            Shape::Cuboid(half_extents) => Obstacle::Cuboid { half_extents: *half_extents, pose },
            Shape::Packed { solid, scale, .. } => {
                Obstacle::Solid { solid: solid.clone(), pose, scale: *scale }
            }
        }
    }
}

/// Where a copy of an object stands: size, turn, place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stand {
    pub(crate) scale: f32,
    pub(crate) turn: Quat,
    pub(crate) at: Vec3,
}

/// What the pieces of an object are made from: its mesh, or each copy's, before it is placed.
#[derive(Debug)]
pub(crate) struct Pieces<'a> {
    file: &'a ObjectFile,
    kind: Kind,
    key: Key,
    /// Merged meshes: one for all copies, or one a shape that copies take in turn.
    meshes: Vec<Mesh>,
    /// What is coarser than asked for.
    note: Option<String>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    None,
    Box,
    Sphere,
    Capsule,
    Trunk(f32),
    Packed(PackDesc),
}

/// Spheres of a rock: it is round.
const ROCK: PackDesc = PackDesc { spheres: 80, bulge: 0.006 };
/// Spheres of a ball that a scale has stretched, and of a ring.
const ROUND: PackDesc = PackDesc { spheres: 200, bulge: 0.002 };
/// Spheres of one object.
const MOST_SPHERES: usize = 1_000_000;
/// Spheres, capsules and boxes of a scene's objects. The default limits of wgpu hold a few more.
pub(crate) const MOST_SHAPES: usize = 2_000_000;

impl<'a> Pieces<'a> {
    /// `carries`: whether grass grows on it.
    pub(crate) fn new(
        file: &'a ObjectFile,
        key: &Key,
        carries: bool,
        copies: usize,
    ) -> Result<Self, Problem> {
        let key = key.at("collide");
        let mut note = None;
        let kind = match file.collide {
            CollideFile::Auto if carries || !file.visible => Kind::None,
            CollideFile::Auto => match automatic(file) {
                Kind::Packed(desc) => {
                    let spheres = desc.spheres.min((MOST_SPHERES / copies.max(1)).max(1) as u32);
                    if spheres < desc.spheres {
                        let cause = format!("{copies} copies have {spheres} spheres each");
                        note = Some(format!("{cause}, not {}; see `collide`", desc.spheres));
                    }
                    Kind::Packed(PackDesc { spheres, ..desc })
                }
                other => other,
            },
            CollideFile::None => Kind::None,
            CollideFile::Box => Kind::Box,
            CollideFile::Sphere => Kind::Sphere,
            CollideFile::Capsule => match &file.source {
                Source::Tree(tree) => Kind::Trunk(tree.height_m),
                _ => Kind::Capsule,
            },
            CollideFile::Packed(packed) => {
                let spheres = key.at("spheres").integer(packed.spheres.into(), 1, 65_536)?;
                let bulge = key.at("bulge").within(packed.bulge, 0.0, 0.1)?;
                let all = (spheres as usize).saturating_mul(copies);
                if all > MOST_SPHERES {
                    return Err(key.at("spheres").problem(format!(
                        "{copies} copies of {spheres} spheres are more than {MOST_SPHERES}; use fewer"
                    )));
                }
                Kind::Packed(PackDesc { spheres: spheres as u32, bulge })
            }
        };
        Ok(Self { file, kind, key, meshes: Vec::new(), note })
    }

    /// Takes a shape of its copies, before it is placed.
    pub(crate) fn take(&mut self, parts: &[Part]) {
        if self.kind != Kind::None {
            let mut merged = Mesh::default();
            parts.iter().for_each(|part| mesh::append(&mut merged, &part.mesh));
            self.meshes.push(merged);
        }
    }

    /// The pieces of all copies, which take the shapes in turn; `transform` is what each copy has had before it was placed.
    pub(crate) fn finish(
        mut self,
        context: &mut Context,
        name: &str,
        transform: Affine3A,
        stands: &[Stand],
    ) -> Result<Vec<ColliderPiece>, SceneError> {
        let (scale, rotation, translation) = transform.to_scale_rotation_translation();
        let even = scale.max_element() - scale.min_element() < 1e-5 * scale.max_element();
        let (stretch, size) = if even { (Vec3::ONE, scale.x) } else { (scale, 1.0) };
        if !even {
            self.meshes
                .iter_mut()
                .for_each(|mesh| mesh.positions.iter_mut().for_each(|p| *p *= scale));
        }
        let mut models = Vec::with_capacity(self.meshes.len());
        for mesh in &self.meshes {
            match self.model(context, name, mesh, stretch) {
                Ok(model) => models.push(model),
                Err(cause) if self.file.collide == CollideFile::Auto => {
                    context.note(format!("object '{name}' pushes no grass: {cause}"));
                    return Ok(Vec::new());
                }
                Err(cause) => return Err(context.error(self.key.problem(cause))),
            }
        }
        if let Some(note) = self.note {
            context.note(format!("object '{name}': {note}"));
        }
        let piece = |(i, stand): (usize, &Stand)| {
            let (model, center) = models.get(i % models.len().max(1))?;
            let factor = stand.scale * size;
            let turn = stand.turn * rotation;
            let at = stand.at + stand.turn * translation * stand.scale;
            let pose = Pose { translation: at + turn * *center * factor, rotation: turn };
            Some(ColliderPiece { pose, shape: scaled(model, factor) })
        };
        Ok(stands.iter().enumerate().filter_map(piece).collect())
    }

    /// The shape of a mesh that has been stretched, and where its middle is.
    fn model(
        &self,
        context: &mut Context,
        name: &str,
        mesh: &Mesh,
        stretch: Vec3,
    ) -> Result<(Shape, Vec3), String> {
        let low = mesh.positions.iter().copied().fold(Vec3::INFINITY, Vec3::min);
        let high = mesh.positions.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
        let (center, half) = ((low + high) * 0.5, (high - low) * 0.5);
        let farthest = |measure: &dyn Fn(Vec3) -> Vec3| {
            mesh.positions.iter().map(|&p| measure(p - center).length()).fold(0.0, f32::max)
        };
        let sound = |length: f32, shape, center| match length > 0.0 {
            true => Ok((shape, center)),
            false => Err("it is flat; use Packed, or None".to_owned()),
        };
        match self.kind {
            Kind::None | Kind::Box => sound(half.min_element(), Shape::Cuboid(half), center),
            Kind::Sphere => {
                let radius = farthest(&|p| p);
                sound(radius, Shape::Sphere(radius), center)
            }
            Kind::Capsule => {
                let axis = Vec3::AXES[half.max_position()];
                let radius = farthest(&|p| p - axis * p.dot(axis));
                let end = mesh.positions.iter().map(|&p| {
                    let (along, out) = ((p - center).dot(axis), (p - center).reject_from(axis));
                    along.abs() - (radius * radius - out.length_squared()).max(0.0).sqrt()
                });
                let end = axis * end.fold(0.0, f32::max);
                sound(radius, Shape::Capsule { from: -end, to: end, radius }, center)
            }
            Kind::Trunk(height_m) => {
                let (from, to, radius) = shapes::trunk_capsule(height_m);
                let radius = radius * stretch.x.abs().max(stretch.z.abs());
                let (from, to) = (from * stretch, to * stretch);
                sound(radius, Shape::Capsule { from, to, radius }, Vec3::ZERO)
            }
            Kind::Packed(desc) => {
                let file = match &self.file.source {
                    Source::File(file) => Some(context.resolve(file)),
                    _ => None,
                };
                let solid = Solid::new(mesh).map_err(|error| error.to_string())?;
                let packing = packs::pack(context, file.as_deref(), name, mesh, &solid, &desc)?;
                let (spheres, solid) = (packing.spheres, Arc::new(solid));
                Ok((Shape::Packed { spheres, solid, scale: 1.0 }, Vec3::ZERO))
            }
        }
    }
}

fn automatic(file: &ObjectFile) -> Kind {
    let even = file.scale.0.iter().all(|&factor| factor == file.scale.0[0] && factor > 0.0);
    match &file.source {
        Source::File(_) => Kind::Packed(PackDesc::default()),
        Source::Rock(_) => Kind::Packed(ROCK),
        Source::Tree(tree) => Kind::Trunk(tree.height_m),
        Source::Sphere(_) if even => Kind::Sphere,
        Source::Sphere(_) | Source::Torus(_) => Kind::Packed(ROUND),
        Source::Object(_)
        | Source::Heightmap(_)
        | Source::Plane(_)
        | Source::Terrain(_)
        | Source::Mobius(_) => Kind::None,
    }
}

fn scaled(shape: &Shape, factor: f32) -> Shape {
    match shape {
        Shape::Sphere(radius) => Shape::Sphere(radius * factor),
        Shape::Capsule { from, to, radius } => {
            Shape::Capsule { from: *from * factor, to: *to * factor, radius: radius * factor }
        }
        Shape::Cuboid(half) => Shape::Cuboid(*half * factor),
        Shape::Packed { spheres, solid, scale } => {
            let sphere =
                |s: &Sphere| Sphere { center: s.center * factor, radius: s.radius * factor };
            Shape::Packed {
                spheres: spheres.iter().map(sphere).collect(),
                solid: solid.clone(),
                scale: scale * factor,
            }
        }
    }
}
