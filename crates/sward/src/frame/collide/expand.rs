//! Colliders to primitives: which rest, which move, and how those that move are swept.

use super::primitive::Primitive;
use crate::{Collider, ColliderShape, PhysicsModel, Pose};
use glam::{Quat, Vec3};

/// Farther than this in one step, metres, and a thing is taken to be put elsewhere, not moved.
pub(crate) const LONGEST_SWEEP_M: f32 = 20.0;
/// A turn is swept along chords of at most this angle, radians.
const CHORD: f32 = 0.5;
/// Distance between the places that a moving capsule is put at, over its radius.
const SPACING: f32 = 0.5;
/// Most places of a moving capsule, and most of a moving box.
const MOST_CAPSULES: f32 = 64.0;
const MOST_CUBOIDS: f32 = 16.0;

/// The primitives of one step.
#[derive(Debug, Default, Clone, PartialEq)]
pub(crate) struct Expanded {
    /// Of colliders that rest.
    pub(crate) resting: Vec<Primitive>,
    /// Of colliders that move, swept.
    pub(crate) moving: Vec<Primitive>,
}

/// Takes colliders apart. J's model knows no sweep: there a thing is where it is now. And it crushes
/// a little more in every step, so that nothing counts as at rest, and no blade near it sleeps.
pub(crate) fn expand(colliders: &[Collider], model: PhysicsModel) -> Expanded {
    let sweep = model == PhysicsModel::Sward;
    let mut all = Expanded::default();
    for collider in colliders {
        let Some(pose) = collider.pose.sound().filter(|_| has_size(&collider.shape)) else {
            continue;
        };
        let last = collider.last_pose.and_then(Pose::sound).filter(|last| *last != pose);
        let moves = last.is_some() || !sweep;
        let into = if moves { &mut all.moving } else { &mut all.resting };
        let near = last
            .filter(|last| sweep && last.translation.distance(pose.translation) <= LONGEST_SWEEP_M);
        let first = into.len();
        match near {
            Some(last) => swept(&collider.shape, last, pose, into),
            None => placed(&collider.shape, pose, into),
        }
        keep_sound(into, first);
    }
    all
}

/// Drops what cannot touch anything of those that were added.
fn keep_sound(primitives: &mut Vec<Primitive>, first: usize) {
    let mut index = 0;
    primitives.retain(|primitive| {
        index += 1;
        index <= first || primitive.is_sound()
    });
}

/// Whether a shape has a size: what is swept grows, which would hide that it has none.
fn has_size(shape: &ColliderShape) -> bool {
    let above_zero = |size: f32| size.is_finite() && size > 0.0;
    match *shape {
        ColliderShape::Sphere { radius } | ColliderShape::Capsule { radius, .. } => {
            above_zero(radius)
        }
        ColliderShape::Cuboid { half_extents: h } => h.to_array().into_iter().all(above_zero),
        ColliderShape::Spheres(_) => true,
    }
}

fn placed(shape: &ColliderShape, pose: Pose, into: &mut Vec<Primitive>) {
    let ball = |center: Vec3, radius| {
        let center = pose.point(center);
        Primitive::Capsule { from: center, to: center, radius }
    };
    match *shape {
        ColliderShape::Sphere { radius } => into.push(ball(Vec3::ZERO, radius)),
        ColliderShape::Capsule { from, to, radius } => {
            into.push(Primitive::Capsule { from: pose.point(from), to: pose.point(to), radius })
        }
        ColliderShape::Cuboid { half_extents } => into.push(Primitive::Cuboid {
            center: pose.translation,
            half_extents,
            rotation: pose.rotation,
        }),
        ColliderShape::Spheres(spheres) => {
            into.extend(spheres.iter().map(|s| ball(s.center, s.radius)));
        }
    }
}

fn swept(shape: &ColliderShape, last: Pose, pose: Pose, into: &mut Vec<Primitive>) {
    match *shape {
        ColliderShape::Sphere { radius } => {
            into.push(Primitive::Swept { from: last.translation, to: pose.translation, radius })
        }
        ColliderShape::Spheres(spheres) => {
            let poses = chords(last, pose);
            for sphere in spheres {
                sweep_ball(&poses, sphere.center, sphere.radius, into);
            }
        }
        ColliderShape::Capsule { from, to, radius } => {
            sweep_capsule(last, pose, (from, to, radius), into);
        }
        ColliderShape::Cuboid { half_extents } => sweep_cuboid(last, pose, half_extents, into),
    }
}

/// Poses on the way, from the last one to the present, with small turns between them.
fn chords(last: Pose, pose: Pose) -> Vec<Pose> {
    let count = (turn_between(last, pose) / CHORD).ceil().max(1.0);
    (0..=count as u32).map(|i| between(last, pose, i as f32 / count)).collect()
}

fn turn_between(last: Pose, pose: Pose) -> f32 {
    last.rotation.angle_between(pose.rotation)
}

fn between(last: Pose, pose: Pose, share: f32) -> Pose {
    // A quaternion and its opposite are the same turn: the short way
    let flipped = last.rotation.dot(pose.rotation) < 0.0;
    let to: Quat = if flipped { -pose.rotation } else { pose.rotation };
    Pose {
        translation: last.translation.lerp(pose.translation, share),
        rotation: last.rotation.slerp(to, share).normalize(),
    }
}

fn sweep_ball(poses: &[Pose], center: Vec3, radius: f32, into: &mut Vec<Primitive>) {
    let way = poses.windows(2).map(|pair| Primitive::Swept {
        from: pair[0].point(center),
        to: pair[1].point(center),
        radius,
    });
    into.extend(way);
}

/// A capsule is put at places on its way that lie close, or its axis is a row of balls that are
/// swept: whichever is fewer. Both are a little thicker, so that nothing slips between them.
fn sweep_capsule(
    last: Pose,
    pose: Pose,
    (from, to, radius): (Vec3, Vec3, f32),
    into: &mut Vec<Primitive>,
) {
    let turned = turn_between(last, pose) * from.length().max(to.length());
    let way = last.translation.distance(pose.translation) + turned;
    let length = from.distance(to);
    let count = |room: f32| (room / (SPACING * radius)).ceil().clamp(1.0, MOST_CAPSULES);
    let thicker = |room: f32| radius.hypot(room / count(room) * 0.5);
    if way <= length {
        let (count, radius) = (count(way), thicker(way));
        for i in 1..=count as u32 {
            let at = between(last, pose, i as f32 / count);
            let (from, to) = (at.point(from), at.point(to));
            into.push(Primitive::Capsule { from, to, radius });
        }
    } else {
        let poses = chords(last, pose);
        let (count, radius) = (count(length), thicker(length));
        for i in 0..=count as u32 {
            sweep_ball(&poses, from.lerp(to, i as f32 / count), radius, into);
        }
    }
}

/// A box on its way is a few boxes, each grown by what it moves: together they hold all that it
/// passes, and little more. The last one is the box where it is now.
fn sweep_cuboid(last: Pose, pose: Pose, half: Vec3, into: &mut Vec<Primitive>) {
    let turn = turn_between(last, pose);
    // A box that moves along its own edge is one longer box: only what is aslant needs more
    let moved = (pose.rotation.inverse() * (pose.translation - last.translation)).abs();
    let aslant = moved.element_sum() - moved.max_element() - moved.min_element();
    let count =
        ((aslant + turn * half.length()) / half.min_element()).ceil().clamp(1.0, MOST_CUBOIDS);
    for i in 0..count as u32 {
        let at = between(last, pose, (i as f32 + 0.5) / count);
        let moved = (pose.translation - last.translation) * (0.5 / count);
        let grown = (at.rotation.inverse() * moved).abs();
        let turned = half.length() * (turn * 0.5 / count).min(1.0);
        into.push(Primitive::Cuboid {
            center: at.translation,
            half_extents: half + grown + turned,
            rotation: at.rotation,
        });
    }
    placed(&ColliderShape::Cuboid { half_extents: half }, pose, into);
}
