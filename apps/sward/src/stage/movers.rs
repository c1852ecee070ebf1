//! What moves in a scene: spheres and objects on paths, and rigid bodies. Where each is depends on
//! the time alone, and is drawn and pushes blades there.

use super::meshes::{self, GpuPlacement, NO_GRASS, NO_STRIPES, STRIPES};
use super::shapes;
use glam::Vec3;
use sward::{Collider, ColliderShape, Mesh, Pose};
use sward_scene::{
    Bodies, Body, BodyGroup, ColliderPiece, MovingSphere, Path, Scene, TextureImage,
};

/// An object that moves.
#[derive(Debug)]
struct MovingObject {
    path: Path,
    /// Its looks; where it is changes.
    looks: GpuPlacement,
}

/// A mesh that is drawn at places that change.
pub(super) struct Thing<'a> {
    pub mesh: Mesh,
    pub texture: Option<&'a TextureImage>,
}

/// Everything that moves.
#[derive(Debug)]
pub(super) struct Movers {
    spheres: Vec<MovingSphere>,
    objects: Vec<MovingObject>,
    groups: Vec<BodyGroup>,
    bodies: Option<Bodies>,
    /// Pieces of objects that push blades, those that rest among them.
    pieces: Vec<(ColliderPiece, Option<Path>)>,
}

impl Movers {
    pub fn new(scene: &Scene) -> Self {
        let shown = scene.objects.iter().enumerate().filter(|(_, object)| object.visible);
        let moving = shown.filter_map(|(i, object)| {
            let looks = meshes::object_placement(scene, i);
            Some(MovingObject { path: object.path.clone()?, looks })
        });
        Self {
            spheres: scene.spheres.clone(),
            objects: moving.collect(),
            groups: scene.bodies.clone(),
            bodies: Bodies::new(scene),
            pieces: (scene.objects.iter())
                .flat_map(|o| o.collider.iter().map(|piece| (piece.clone(), o.path.clone())))
                .collect(),
        }
    }

    /// What is drawn of it: objects, all spheres, each group of bodies.
    pub fn things<'a>(&self, scene: &'a Scene) -> Vec<Thing<'a>> {
        let shown = scene.objects.iter().filter(|object| object.visible && object.path.is_some());
        let mut things: Vec<_> = shown
            .map(|object| Thing {
                mesh: meshes::with_normals(&object.mesh),
                texture: object.texture.as_ref(),
            })
            .collect();
        things.push(Thing { mesh: shapes::ball(shapes::FINE), texture: None });
        things.extend(self.groups.iter().map(|group| {
            let rings = if group.count() > 16 { shapes::COARSE } else { shapes::FINE };
            Thing { mesh: shapes::body(group.shape, rings), texture: None }
        }));
        things
    }

    /// Moves the bodies on.
    pub fn advance(&mut self, time_s: f64) {
        if let Some(bodies) = &mut self.bodies {
            bodies.advance_to(time_s);
        }
    }

    /// Places of each of [`Movers::things`]; as many as ever.
    pub fn placements(&self, time_s: f32) -> Vec<Vec<GpuPlacement>> {
        let object =
            |object: &MovingObject| vec![placed(object.looks, object.path.pose_at(time_s))];
        let mut places: Vec<_> = self.objects.iter().map(object).collect();
        let spheres = self.spheres.iter().filter(|sphere| sphere.visible);
        places.push(spheres.map(|sphere| sphere_placement(sphere, time_s)).collect());
        let first_body = places.len();
        places.extend(self.groups.iter().map(|group| Vec::with_capacity(group.count())));
        for body in self.bodies.iter().flat_map(Bodies::all) {
            let group = self.groups.get(body.group).filter(|group| group.visible);
            if let (Some(group), Some(list)) = (group, places.get_mut(first_body + body.group)) {
                list.push(body_placement(group, body));
            }
        }
        places
    }

    /// What pushes blades, swept from where it was before the step.
    pub fn colliders(&self, time_s: f32, dt_s: f32) -> Vec<Collider<'_>> {
        let sphere = |sphere: &MovingSphere| {
            let shape = ColliderShape::Sphere { radius: sphere.radius };
            collider(shape, sphere.pose_at(time_s), Some(sphere.pose_at(time_s - dt_s)))
        };
        let body = |body: &Body| {
            let shape = self.groups.get(body.group)?.shape.collider(body.scale);
            Some(collider(shape, body.pose?, body.last_pose))
        };
        let bodies = self.bodies.iter().flat_map(Bodies::all).filter_map(body);
        let pieces = self.pieces.iter().map(|piece| of_object(piece, time_s, dt_s));
        self.spheres.iter().map(sphere).chain(pieces).chain(bodies).collect()
    }
}

/// A piece of an object, which moves where the object has a path.
fn of_object(
    (piece, path): &(ColliderPiece, Option<Path>),
    time_s: f32,
    dt_s: f32,
) -> Collider<'_> {
    let Some(path) = path else { return Collider::resting(piece.shape(), piece.pose) };
    let at = |time_s| within(path.pose_at(time_s), piece.pose);
    collider(piece.shape(), at(time_s), Some(at(time_s - dt_s)))
}

/// A thing that has not moved since rests.
fn collider(shape: ColliderShape<'_>, pose: Pose, last_pose: Option<Pose>) -> Collider<'_> {
    Collider { shape, pose, last_pose: last_pose.filter(|last| *last != pose) }
}

/// A pose within a thing that has a pose itself.
fn within(outer: Pose, inner: Pose) -> Pose {
    Pose { translation: outer.point(inner.translation), rotation: outer.rotation * inner.rotation }
}

fn placed(looks: GpuPlacement, pose: Pose) -> GpuPlacement {
    GpuPlacement { position: pose.translation, rotation: pose.rotation.to_array(), ..looks }
}

fn ball_looks(
    color: [f32; 3],
    stripe_color: Option<[f32; 3]>,
    roughness: f32,
    scale: f32,
) -> GpuPlacement {
    GpuPlacement {
        position: Vec3::ZERO,
        scale,
        rotation: glam::Quat::IDENTITY.to_array(),
        color,
        roughness,
        grass: NO_GRASS,
        stripe: stripe_color.map_or(NO_STRIPES, |[r, g, b]| [r, g, b, STRIPES]),
    }
}

fn sphere_placement(sphere: &MovingSphere, time_s: f32) -> GpuPlacement {
    let MovingSphere { base_color, stripe_color, roughness, radius, .. } = *sphere;
    let looks = ball_looks(base_color, stripe_color, roughness, radius);
    placed(looks, sphere.pose_at(time_s))
}

/// A body that is not there is as small as a point, and so not drawn.
fn body_placement(group: &BodyGroup, body: &Body) -> GpuPlacement {
    let scale = if body.pose.is_some() { body.scale } else { 0.0 };
    let round = matches!(group.shape, sward_scene::BodyShape::Sphere(_));
    let stripes = group.stripe_color.filter(|_| round);
    let looks = ball_looks(group.color(body.number), stripes, group.roughness, scale);
    placed(looks, body.pose.unwrap_or_default())
}

impl super::Stage {
    /// Spheres, capsules and boxes that push the blades at this time; 0 where collisions are off.
    pub fn collider_parts(&self) -> u64 {
        let parts = |collider: &Collider| match collider.shape {
            ColliderShape::Spheres(spheres) => spheres.len() as u64,
            _ => 1,
        };
        match self.options.collisions {
            true => self.movers.colliders(self.time_s as f32, 0.0).iter().map(parts).sum(),
            false => 0,
        }
    }
}
