//! The bodies' world: rapier's, stepped.

use super::grass::Grass;
use super::{BodyGroup, BodyShape, Start};
use crate::{MovingSphere, Path, Scene};
use glam::{Quat, Vec3};
use rapier3d::prelude::{
    ColliderBuilder, PhysicsWorld, RigidBodyBuilder, RigidBodyHandle, TriMeshFlags,
};
use std::fmt;
use sward::Pose;

/// Steps a second.
const RATE: f64 = 120.0;
/// A body so far below everything has fallen off the world, metres.
const LOST_M: f32 = 50.0;
/// Standard gravity, metres a second squared.
const GRAVITY: f32 = 9.806_65;

/// A body at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Index of its group in [`Scene::bodies`].
    pub group: usize,
    /// Its number in the group.
    pub number: usize,
    /// How much bigger it is than the group's shape.
    pub scale: f32,
    /// Where it is; none before it starts, and once it has fallen off the world.
    pub pose: Option<Pose>,
    /// Where it was at the time asked for before.
    pub last_pose: Option<Pose>,
}

/// A body in the world.
struct Item {
    start: Start,
    shape: BodyShape,
    drag: f32,
    handle: Option<RigidBodyHandle>,
    lost: bool,
    /// At the step before the newest, and at the newest.
    poses: [Option<Pose>; 2],
}

/// Every body of a scene, and time.
pub struct Bodies {
    world: PhysicsWorld,
    grass: Grass,
    items: Vec<Item>,
    groups: Vec<BodyGroup>,
    shown: Vec<Body>,
    /// Things on paths, which bodies bounce off.
    pushers: Vec<(RigidBodyHandle, Path)>,
    steps: u64,
    lowest_m: f32,
}

impl fmt::Debug for Bodies {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Bodies")
            .field("count", &self.items.len())
            .field("steps", &self.steps)
            .finish_non_exhaustive()
    }
}

impl Bodies {
    /// The bodies of a scene before time 0: none is there yet. None where the scene has no bodies.
    pub fn new(scene: &Scene) -> Option<Self> {
        if scene.bodies.is_empty() {
            return None;
        }
        let mut world = PhysicsWorld::new();
        let gravity = &scene.gravity;
        world.gravity = gravity.direction * gravity.strength * GRAVITY;
        world.integration_parameters.dt = RATE.recip() as f32;
        let mut lowest_m = f32::INFINITY;
        let mut pushers = Vec::new();
        for object in scene.objects.iter().filter(|o| o.visible || o.carries_grass) {
            let low = object.mesh.positions.iter().fold(f32::INFINITY, |low, p| low.min(p.y));
            lowest_m = lowest_m.min(low);
            if let Some(collider) = mesh_collider(&object.mesh) {
                insert_solid(&mut world, &mut pushers, collider, object.path.as_ref());
            }
        }
        for MovingSphere { radius, path, .. } in &scene.spheres {
            let ball = ColliderBuilder::ball(*radius).friction(0.7);
            insert_solid(&mut world, &mut pushers, ball, Some(path));
        }
        let (mut items, mut shown) = (Vec::new(), Vec::new());
        for (group, bodies) in scene.bodies.iter().enumerate() {
            for (number, &start) in bodies.starts.iter().enumerate() {
                let (shape, drag) = (bodies.shape, bodies.grass_drag);
                items.push(Item {
                    start,
                    shape,
                    drag,
                    handle: None,
                    lost: false,
                    poses: [None; 2],
                });
                let scale = start.scale;
                shown.push(Body { group, number, scale, pose: None, last_pose: None });
            }
        }
        let groups = scene.bodies.clone();
        let grass = Grass::new(scene);
        Some(Self { world, grass, items, groups, shown, pushers, steps: 0, lowest_m })
    }

    /// Moves on to a time, seconds; what has passed does not come back. Where each body is then is
    /// the same, bit for bit, whatever times were asked for on the way.
    pub fn advance_to(&mut self, time_s: f64) {
        let exact = time_s.max(0.0) * RATE;
        // Times that are whole steps but for rounding are taken as such
        let whole = (exact + 1e-6).floor();
        let share = (exact - whole).max(0.0) as f32;
        let between = share > 1e-5;
        let wanted = whole as u64 + u64::from(between);
        if time_s >= 0.0 && self.steps == 0 {
            self.begin(0);
            self.keep();
        }
        while self.steps < wanted {
            self.step();
        }
        for (item, body) in self.items.iter().zip(&mut self.shown) {
            body.last_pose = body.pose;
            body.pose = match item.poses {
                [Some(a), Some(b)] if between => Some(mix(a, b, share)),
                [_, newest] if !between => newest,
                _ => None,
            };
        }
    }

    /// Every body, group by group.
    pub fn all(&self) -> &[Body] {
        &self.shown
    }

    /// How many move; the others have not started, or rest.
    pub fn moving(&self) -> usize {
        let handles = self.items.iter().filter_map(|item| item.handle);
        handles.filter(|h| self.world.bodies.get(*h).is_some_and(|b| !b.is_sleeping())).count()
    }

    fn step(&mut self) {
        self.slow_in_grass();
        let next_s = (self.steps + 1) as f64 / RATE;
        for (handle, path) in &self.pushers {
            if let Some(body) = self.world.bodies.get_mut(*handle) {
                let Pose { translation, rotation } = path.pose_at(next_s as f32);
                body.set_next_kinematic_translation(translation);
                body.set_next_kinematic_rotation(rotation);
            }
        }
        self.world.step();
        self.steps += 1;
        self.begin(self.steps);
        self.keep();
    }

    /// Adds the bodies that start by this step.
    fn begin(&mut self, step: u64) {
        let mut group_of = self.shown.iter().map(|body| body.group);
        for item in &mut self.items {
            let group = group_of.next().and_then(|group| self.groups.get(group));
            let starts = (f64::from(item.start.time_s) * RATE - 1e-6).ceil().max(0.0) as u64;
            let waits = item.handle.is_none() && !item.lost && starts <= step;
            let Some(group) = group.filter(|_| waits) else { continue };
            let start = &item.start;
            let body = RigidBodyBuilder::dynamic()
                .translation(start.position)
                .rotation(start.rotation.to_scaled_axis())
                .linvel(start.velocity)
                .angvel(start.spin)
                .ccd_enabled(true);
            let collider = body_collider(item.shape, start.scale)
                .restitution(group.restitution)
                .friction(group.friction)
                .density(group.density);
            item.handle = Some(self.world.insert(body, collider).0);
        }
    }

    /// Keeps where every body is, and lets those go that fell off the world.
    fn keep(&mut self) {
        for item in &mut self.items {
            let body = item.handle.and_then(|handle| self.world.bodies.get(handle));
            let pose = body
                .map(|body| Pose { translation: body.translation(), rotation: *body.rotation() });
            // Written so that NaN is lost too
            let stays = pose.is_none_or(|p| p.translation.y > self.lowest_m - LOST_M);
            if let (false, Some(handle)) = (stays, item.handle) {
                self.world.remove_body(handle);
                (item.handle, item.lost) = (None, true);
            }
            item.poses = [item.poses[1], pose.filter(|_| !item.lost)];
        }
    }

    fn slow_in_grass(&mut self) {
        let dt_s = RATE.recip() as f32;
        for item in self.items.iter().filter(|item| item.drag > 0.0) {
            let body = item.handle.and_then(|handle| self.world.bodies.get(handle));
            let Some(body) = body.filter(|body| !body.is_sleeping()) else { continue };
            let reach = item.shape.reach() * item.start.scale;
            let share = self.grass.share(body.translation(), reach);
            let kept = Grass::kept(body.linvel().length(), item.drag * share, dt_s);
            if kept == 1.0 {
                continue;
            }
            let body = item.handle.and_then(|handle| self.world.bodies.get_mut(handle));
            if let Some(body) = body {
                let (velocity, spin) = (body.linvel(), body.angvel());
                body.set_linvel(velocity * kept, false);
                body.set_angvel(spin * kept, false);
            }
        }
    }
}

fn mix(a: Pose, b: Pose, share: f32) -> Pose {
    Pose {
        translation: a.translation.lerp(b.translation, share),
        rotation: a.rotation.slerp(b.rotation, share),
    }
}

fn insert_solid(
    world: &mut PhysicsWorld,
    pushers: &mut Vec<(RigidBodyHandle, Path)>,
    collider: ColliderBuilder,
    path: Option<&Path>,
) {
    match path {
        None => {
            world.insert_collider(collider, None);
        }
        Some(path) => {
            let Pose { translation, rotation } = path.pose_at(0.0);
            let body = RigidBodyBuilder::kinematic_position_based()
                .translation(translation)
                .rotation(Quat::to_scaled_axis(rotation));
            let (handle, _) = world.insert(body, collider);
            pushers.push((handle, path.clone()));
        }
    }
}

fn body_collider(shape: BodyShape, scale: f32) -> ColliderBuilder {
    match shape {
        BodyShape::Sphere(radius) => ColliderBuilder::ball(radius * scale),
        BodyShape::Box(half) => {
            let Vec3 { x, y, z } = half * scale;
            ColliderBuilder::cuboid(x, y, z)
        }
        BodyShape::Capsule { radius, half } => {
            ColliderBuilder::capsule_y(half * scale, radius * scale)
        }
    }
}

/// Edges inside a mesh are no bumps, and either side of it is solid.
fn mesh_collider(mesh: &sward::Mesh) -> Option<ColliderBuilder> {
    let flags = TriMeshFlags::FIX_INTERNAL_EDGES_TWO_SIDED;
    let parts = || (mesh.positions.clone(), mesh.triangles.clone());
    let (vertices, triangles) = parts();
    let joined = ColliderBuilder::trimesh_with_flags(vertices, triangles, flags);
    let plain = || ColliderBuilder::trimesh(parts().0, parts().1);
    // Only a mesh without triangles is none at all, and no surface that was checked is so
    let collider = joined.or_else(|_| plain()).ok()?;
    Some(collider.friction(0.8).restitution(0.5))
}
