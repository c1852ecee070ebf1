//! Colliders near patches, which patches they wake, and how the others catch up.

use super::decoded::{decode, states};
use super::rig::Rig;
use super::scenes::{Draws, breeze, random_field, see_all, see_none};
use crate::frame::collide::chunks::Chunks;
use crate::frame::collide::expand::expand;
use crate::frame::collide::primitive::{Bounds, GpuPrimitive, Primitive};
use crate::gpu::layout::{CHUNK_STRIDE, NEAR_SLOTS, NEAR_STRIDE};
use crate::{Collider, ColliderShape, Frame, PhysicsModel, Pose, Sphere, View};
use glam::{Quat, Vec3};
use std::collections::BTreeSet;

/// Of each patch: entries of the primitives that its list names, and whether all are named.
fn near_lists(rig: &Rig, chunks: u32) -> Vec<(BTreeSet<u32>, bool)> {
    let words: Vec<u32> = rig.read(&rig.page(0).near);
    let list = |words: &[u32]| {
        let slots = (words[0] >> 8) as usize & 0xff;
        let mut named = BTreeSet::new();
        for slot in words[2..].chunks(3).take(slots) {
            let bits = u64::from(slot[1]) | u64::from(slot[2]) << 32;
            let members = (0..64).filter(|i| bits >> i & 1 == 1);
            named.extend(members.map(|i| slot[0] * CHUNK_STRIDE as u32 + 1 + i));
        }
        (named, words[1] >= chunks)
    };
    let count = rig.field.patches().len();
    words.chunks(NEAR_STRIDE as usize).take(count).map(list).collect()
}

/// Every primitive that the colliders make, by its entry on the GPU.
fn entries(colliders: &[Collider]) -> (Vec<(u32, Primitive)>, u32) {
    let expanded = expand(colliders, PhysicsModel::Sward);
    let (resting, moving) = (Chunks::new(&expanded.resting), Chunks::new(&expanded.moving));
    let all: Vec<GpuPrimitive> = [&resting.entries[..], &moving.entries].concat();
    let known: Vec<_> = expanded.resting.iter().chain(&expanded.moving).copied().collect();
    let place = |primitive: Primitive| {
        let packed = GpuPrimitive::from(&primitive);
        let is_member = |i: usize| !i.is_multiple_of(CHUNK_STRIDE) && all[i] == packed;
        let index = (0..all.len()).find(|i| is_member(*i)).expect("every primitive is sent");
        (index as u32, primitive)
    };
    let chunks = (resting.count() + moving.count()) as u32;
    (known.into_iter().map(place).collect(), chunks)
}

/// Entries of the primitives near each patch: a box about each and a ball about each must touch.
fn brute_force(rig: &Rig, entries: &[(u32, Primitive)]) -> Vec<BTreeSet<u32>> {
    let patches = rig.field.patches().iter();
    patches
        .map(|patch| {
            let reach = Bounds { min: patch.reach_min, max: patch.reach_max };
            let meets = |p: &Primitive| {
                let (center, radius) = p.ball();
                let nearest = center.clamp(reach.min, reach.max);
                p.bounds().overlaps(&reach) && nearest.distance_squared(center) < radius * radius
            };
            entries.iter().filter(|(_, p)| meets(p)).map(|(i, _)| *i).collect()
        })
        .collect()
}

fn random_balls(seed: u32, count: u32) -> Vec<Collider<'static>> {
    let mut draws = Draws::new(seed);
    let mut ball = || {
        let center = draws.vector(-7.0, 7.0) * Vec3::new(1.0, 0.2, 1.0);
        let mut ball = Collider::ball(Sphere { center, radius: draws.between(0.05, 1.0) });
        let moved = Vec3::new(draws.between(-1.0, 1.0), 0.0, draws.between(-1.0, 1.0));
        ball.last_pose = Some(Pose::at(center + moved * 0.3));
        ball
    };
    (0..count).map(|_| ball()).collect()
}

/// Balls, capsules and boxes that rest or move.
fn random_mix(seed: u32, count: u32) -> Vec<Collider<'static>> {
    let mut draws = Draws::new(seed);
    let mut colliders = random_balls(seed + 100, count);
    for (i, collider) in colliders.iter_mut().enumerate() {
        let turn = Quat::from_euler(glam::EulerRot::YXZ, draws.between(0.0, 6.0), 0.3, 0.2);
        let before = turn * Quat::from_rotation_y(draws.between(-0.2, 0.2));
        let size = draws.between(0.05, 0.8);
        let reach = draws.vector(0.05, 0.9);
        match i % 4 {
            0 => collider.last_pose = None,
            1 => {
                let (from, to, radius) = (Vec3::ZERO, reach, size * 0.5);
                collider.shape = ColliderShape::Capsule { from, to, radius };
                turned(collider, turn, before);
            }
            2 => {
                collider.shape = ColliderShape::Cuboid { half_extents: reach };
                turned(collider, turn, before);
            }
            _ => {}
        }
    }
    colliders
}

fn turned(collider: &mut Collider, turn: Quat, before: Quat) {
    collider.pose.rotation = turn;
    if let Some(last) = &mut collider.last_pose {
        last.rotation = before;
    }
}

fn frame<'a>(wind: &'a crate::Wind, colliders: &'a [Collider]) -> Frame<'a> {
    Frame { colliders, ..Frame::new(0.02, wind) }
}

fn moving(sphere: Sphere, from: Vec3) -> Collider<'static> {
    Collider { last_pose: Some(Pose::at(from)), ..Collider::ball(sphere) }
}

#[test]
fn near_lists_equal_brute_force() {
    let wind = breeze();
    let mut rig = Rig::new(random_field(1, 3000, 6.0, 64));
    for (seed, count) in [(1, 1), (2, 20), (3, 40), (4, 100)] {
        let colliders = random_mix(seed, count);
        rig.step(&frame(&wind, &colliders), &[see_all()]);
        let (entries, chunks) = entries(&colliders);
        let expected = brute_force(&rig, &entries);
        for ((named, whole), expected) in near_lists(&rig, chunks).iter().zip(&expected) {
            assert!(*whole, "{count} colliders: no list is full");
            assert_eq!(named, expected, "{count} colliders");
        }
        let statistics = rig.statistics();
        assert_eq!(statistics.patches_crowded, 0);
        // Blades test members of their patch's list, less the chunks that they are not near
        let listed = (rig.field.patches().iter().zip(&expected))
            .map(|(patch, list)| u64::from(patch.count) * list.len() as u64);
        let listed = listed.sum::<u64>();
        let tested = statistics.spheres_tested;
        assert!((tested > 0 || count == 1) && tested <= listed, "{tested} of {listed}");
        // A second look at the same step moves nothing and counts the same
        let before = rig.states();
        rig.cull(&[see_all()]);
        assert_eq!(rig.states(), before);
        assert_eq!(rig.statistics(), statistics);
    }
    rig.step(&frame(&wind, &[]), &[see_all()]);
    assert!(near_lists(&rig, 0).iter().all(|(l, _)| l.is_empty()), "what left is forgotten");
    assert_eq!((rig.statistics().spheres_tested, rig.statistics().patches_crowded), (0, 0));
}

/// Thousands of balls on a few patches: more chunks than a list has room for.
#[test]
fn a_full_list_leaves_nothing_out() {
    let wind = breeze();
    let field = random_field(5, 256, 2.0, 64);
    let many = random_balls(9, 3000);
    let mut balls: Vec<_> = many
        .iter()
        .map(|ball| {
            let pose = Pose::at(ball.pose.translation * 0.3);
            let last_pose = Some(Pose::at(pose.translation + Vec3::X * 0.01));
            let shape = ColliderShape::Sphere { radius: 0.02 };
            Collider { shape, pose, last_pose }
        })
        .collect();
    let (entries, chunks) = entries(&balls);
    let mut crowded = Rig::new(field.clone());
    crowded.step(&frame(&wind, &balls), &[see_all()]);
    let lists = near_lists(&crowded, chunks);
    let expected = brute_force(&crowded, &entries);
    let full = lists.iter().filter(|(_, whole)| !whole).count() as u64;
    assert!(full > 0 && crowded.statistics().patches_crowded == full, "{full}");
    let words: Vec<u32> = crowded.read(&crowded.page(0).near);
    for (index, ((named, whole), expected)) in lists.iter().zip(&expected).enumerate() {
        let list = &words[index * NEAR_STRIDE as usize..];
        let named_chunks = list[0] >> 8 & 0xff;
        assert_eq!(*whole, list[1] >= chunks);
        assert!(named_chunks <= NEAR_SLOTS && (*whole || named_chunks == NEAR_SLOTS));
        // What is named, and all from the first chunk without a place on
        let (before, rest) = expected.iter().partition::<BTreeSet<u32>, _>(|entry| {
            **entry / CHUNK_STRIDE as u32 >= list[1] && !*whole
        });
        assert_eq!((rest, before.is_empty()), (named.clone(), *whole));
    }
    // The same balls in another order push the same blades the same way
    let mut other = Rig::new(field);
    balls.reverse();
    other.step(&frame(&wind, &balls), &[see_all()]);
    assert_eq!(crowded.states(), other.states());
    let still = Rig::new(crowded.field.clone());
    assert_ne!(crowded.states(), still.states());
}

#[test]
fn only_touched_patches_wake_out_of_view() {
    let wind = breeze();
    let mut rig = Rig::new(random_field(2, 2000, 6.0, 64));
    rig.step(&frame(&wind, &[]), &[see_all()]);
    let before = rig.bands();
    let ball = Sphere { center: Vec3::new(3.0, 0.2, 3.0), radius: 0.5 };
    let rolls = [moving(ball, ball.center + Vec3::X * 0.02)];
    let (entries, _) = entries(&rolls);
    let touched = brute_force(&rig, &entries);
    for turn in 1..4 {
        rig.step(&frame(&wind, &rolls), &[see_none()]);
        assert_eq!(rig.statistics().patches_visible, 0);
        for (i, ((now, then), list)) in rig.bands().iter().zip(&before).zip(&touched).enumerate() {
            let steps = if list.is_empty() { 0 } else { turn };
            assert_eq!(now.step, then.step + steps, "patch {i}");
        }
    }
    let woken = touched.iter().filter(|list| !list.is_empty()).count();
    assert!(woken > 0 && woken < touched.len() / 2, "{woken} of {}", touched.len());
}

/// What rests wakes no one, is listed once, and pushes the blades of patches that are seen.
#[test]
fn what_rests_wakes_no_one() {
    let wind = breeze();
    let field = random_field(2, 2000, 6.0, 64);
    let (mut rig, mut bare) = (Rig::new(field.clone()), Rig::new(field));
    for rig in [&mut rig, &mut bare] {
        rig.step(&frame(&wind, &[]), &[see_all()]);
    }
    let before = rig.bands();
    let rock = [Collider::ball(Sphere { center: Vec3::new(3.0, 0.2, 3.0), radius: 0.5 })];
    for _ in 0..3 {
        rig.step(&frame(&wind, &rock), &[see_none()]);
        bare.step(&frame(&wind, &[]), &[see_none()]);
    }
    let steps = |bands: Vec<crate::gpu::layout::GpuBand>| -> Vec<u32> {
        bands.iter().map(|band| band.step).collect()
    };
    assert_eq!(steps(rig.bands()), steps(before), "a rock wakes no patch");
    // A ball beside it comes and goes: the rock stays in the lists
    let far = Sphere { center: Vec3::new(-4.0, 0.2, -4.0), radius: 0.4 };
    let both = [rock[0], moving(far, far.center + Vec3::X * 0.1)];
    rig.step(&frame(&wind, &both), &[see_none()]);
    bare.step(&frame(&wind, &both[1..]), &[see_none()]);
    rig.step(&frame(&wind, &rock), &[see_all()]);
    bare.step(&frame(&wind, &[]), &[see_all()]);
    assert!(rig.statistics().spheres_tested > 0 && bare.statistics().spheres_tested == 0);
    let pushed = rig.states().iter().zip(bare.states()).filter(|(a, b)| **a != *b).count();
    assert!((10..600).contains(&pushed), "{pushed}");
    rig.step(&frame(&wind, &[]), &[see_all()]);
    assert_eq!(rig.statistics().spheres_tested, 0);
}

/// A field that comes later knows what rests.
#[test]
fn new_fields_learn_what_rests() {
    let wind = breeze();
    let rock = [Collider::ball(Sphere { center: Vec3::new(1.0, 0.2, 1.0), radius: 0.8 })];
    let mut rig = Rig::new(random_field(2, 500, 3.0, 64));
    rig.step(&frame(&wind, &rock), &[see_all()]);
    let tested = rig.statistics().spheres_tested;
    let field = rig.field.clone();
    rig.replace(field);
    rig.step(&frame(&wind, &rock), &[see_all()]);
    assert!(tested > 0 && rig.statistics().spheres_tested == tested);
}

/// A patch that was not seen for a while stands where it would stand had it been seen throughout.
#[test]
fn sleepers_catch_up() {
    let (mut awake, mut asleep) = {
        let field = random_field(3, 512, 5.0, 64);
        (Rig::new(field.clone()), Rig::new(field))
    };
    let blades = decode(&awake.field);
    let mut wind = breeze();
    let dt_s = 1.0 / 30.0;
    let mut batch = |frames: u32| {
        let winds: Vec<_> = (0..frames)
            .map(|_| {
                wind.advance(f64::from(dt_s));
                wind.clone()
            })
            .collect();
        let run = |rig: &mut Rig, view: View| {
            rig.submit(|renderer, (device, _), encoder| {
                for wind in &winds {
                    let frame = Frame::new(dt_s, wind);
                    renderer.simulate(device, encoder, &frame).expect("valid frame");
                    renderer.cull(device, encoder, &[view]).expect("valid view");
                }
            });
        };
        run(&mut awake, see_all());
        run(&mut asleep, see_none());
        let still = asleep.states();
        asleep.cull(&[see_all()]);
        assert_ne!(asleep.states(), still);
        let [a, b] =
            [&awake, &asleep].map(|rig| states(&blades, &rig.states(), PhysicsModel::Sward));
        a.iter().zip(&b).map(|(a, b)| a.tip.distance(b.tip)).fold(0.0, f64::max)
    };
    for frames in [30, 3, 120] {
        let worst = batch(frames);
        println!("asleep for {frames} frames: {worst:.4} h");
        assert!(worst < 0.03, "{frames} frames: {worst}");
    }
}
