//! What moves fast misses no blade, and what it leaves fades as it should: on the shipped shaders.

use super::decoded::{Decoded, decode, states};
use super::rig::{Rig, shared};
use super::scenes::{breeze, random_field, see_all, see_none, surroundings};
use crate::frame::collide::expand::{Expanded, LONGEST_SWEEP_M, expand};
use crate::frame::collide::primitive::Primitive;
use crate::frame::collide::twin::contact_push;
use crate::frame::physics::twin::{State, advance};
use crate::gpu::test_device;
use crate::{Collider, ColliderShape, Error, Frame, PhysicsModel, Pose, Sphere, Wind};
use glam::{DVec3, Quat, Vec3};

const DT_S: f32 = 1.0 / 30.0;

/// Blades at rest, awake.
fn awake(seed: u32, count: u32) -> (Rig, Vec<Decoded>, Wind) {
    let mut rig = Rig::new(random_field(seed, count, 6.0, 64));
    let wind = breeze();
    for _ in 0..2 {
        rig.step(&Frame::new(DT_S, &wind), &[see_all()]);
    }
    let blades = decode(&rig.field);
    (rig, blades, wind)
}

fn rig_states(rig: &Rig, blades: &[Decoded]) -> Vec<State> {
    states(blades, &rig.states(), PhysicsModel::Sward)
}

/// A thing that flies over the field along x, a metre a step: where it is after so many.
fn flies(shape: ColliderShape<'_>, step: u32, turn: Quat) -> Collider<'_> {
    let at =
        |step: u32| Pose { translation: Vec3::new(step as f32 - 6.5, 0.25, 0.3), rotation: turn };
    Collider { shape, pose: at(step + 1), last_pose: Some(at(step)) }
}

/// 30 m/s at 30 Hz: every blade in the way of a ball, a capsule or a box is pushed and crushed.
#[test]
fn nothing_tunnels_at_30_mps_and_30_hz() {
    let beam = Quat::from_rotation_y(0.7);
    let shapes = [
        (ColliderShape::Sphere { radius: 0.2 }, Quat::IDENTITY),
        (ColliderShape::Capsule { from: Vec3::NEG_Z, to: Vec3::Z, radius: 0.06 }, beam),
        (ColliderShape::Cuboid { half_extents: Vec3::new(0.05, 0.2, 0.8) }, beam),
        (ColliderShape::Spheres(&[Sphere { center: Vec3::Z, radius: 0.15 }]), beam),
    ];
    let (mut rig, blades, wind) = awake(3, 3000);
    let mut hit = 0;
    for (index, (shape, turn)) in shapes.iter().enumerate() {
        for step in 0..4 {
            let before = rig_states(&rig, &blades);
            let thing = [flies(*shape, step * 3 + index as u32 % 3, *turn)];
            rig.step(&Frame { colliders: &thing, ..Frame::new(DT_S, &wind) }, &[see_none()]);
            let after = rig_states(&rig, &blades);
            hit += all_in_the_way_are_hit(&blades, &before, &after, (&thing[0], &wind));
        }
    }
    assert!(hit > 200, "{hit}");
}

/// Whether each blade that is well within what a thing passed, worked out from many places on its
/// way, was pushed and crushed; how many were.
fn all_in_the_way_are_hit(
    blades: &[Decoded],
    before: &[State],
    after: &[State],
    (thing, wind): (&Collider, &Wind),
) -> usize {
    let Some(last) = thing.last_pose else { return 0 };
    let places: Vec<Primitive> = (0..=200)
        .flat_map(|i| {
            let translation = last.translation.lerp(thing.pose.translation, i as f32 / 200.0);
            let pose = Pose { translation, ..thing.pose };
            expand(&[Collider { pose, last_pose: None, ..*thing }], PhysicsModel::Sward).resting
        })
        .collect();
    let around = surroundings(wind, &[], DT_S);
    let mut hit = 0;
    for ((blade, old), new) in blades.iter().zip(before).zip(after) {
        let free = advance(&blade.physics, *old, DT_S.into(), &around).tip;
        let push = |p: &Primitive| contact_push(&blade.physics, free, p).length();
        if places.iter().map(push).fold(0.0, f64::max) < 0.02 {
            continue;
        }
        let moved = new.tip.distance(free);
        assert!(moved > 0.001 && new.crush > 0.0, "{:?}: moved by {moved}", blade.blade.root);
        hit += 1;
    }
    hit
}

/// What is put elsewhere passes nothing: no last pose, or one too far away.
#[test]
fn a_leap_is_not_swept() {
    let ball = ColliderShape::Sphere { radius: 0.3 };
    let pose = Pose::at(Vec3::new(3.0, 0.2, 0.0));
    let far = Pose::at(Vec3::new(3.0 - LONGEST_SWEEP_M * 1.01, 0.2, 0.0));
    let near = Pose::at(Vec3::new(-3.0, 0.2, 0.0));
    let still = Primitive::from(Sphere { center: pose.translation, radius: 0.3 });
    for (last_pose, moves) in [(None, false), (Some(far), true), (Some(pose), false)] {
        let thing = [Collider { shape: ball, pose, last_pose }];
        let expected = match moves {
            true => Expanded { resting: vec![], moving: vec![still] },
            false => Expanded { resting: vec![still], moving: vec![] },
        };
        assert_eq!(expand(&thing, PhysicsModel::Sward), expected);
    }
    let thing = [Collider { shape: ball, pose, last_pose: Some(near) }];
    let swept = Primitive::Swept { from: near.translation, to: pose.translation, radius: 0.3 };
    let expected = Expanded { resting: vec![], moving: vec![swept] };
    assert_eq!(expand(&thing, PhysicsModel::Sward), expected);
    let expected = Expanded { resting: vec![], moving: vec![still] };
    assert_eq!(expand(&thing, PhysicsModel::Paper), expected, "J has no sweep");
}

/// What cannot touch anything is left out, member by member.
#[test]
fn unsound_colliders_are_left_out() {
    let balls = [0.1, 0.0, -1.0, f32::NAN, f32::INFINITY, 0.2]
        .map(|radius| Sphere { center: Vec3::X, radius });
    let sphere = |radius| ColliderShape::Sphere { radius };
    let nowhere = Pose::at(Vec3::NAN);
    let no_turn = Pose { rotation: Quat::from_xyzw(0.0, 0.0, 0.0, 0.0), ..Pose::default() };
    let cases = [
        (ColliderShape::Spheres(&balls), Pose::default(), 2),
        (ColliderShape::Spheres(&[]), Pose::default(), 0),
        (sphere(0.0), Pose::default(), 0),
        (sphere(1.0), nowhere, 0),
        (sphere(1.0), no_turn, 0),
        (sphere(1.0), Pose { rotation: Quat::IDENTITY * 3.0, ..Pose::default() }, 1),
        (ColliderShape::Cuboid { half_extents: Vec3::new(1.0, 0.0, 1.0) }, Pose::default(), 0),
        (ColliderShape::Cuboid { half_extents: Vec3::NAN }, Pose::default(), 0),
        (
            ColliderShape::Capsule { from: Vec3::ZERO, to: Vec3::NAN, radius: 1.0 },
            Pose::default(),
            0,
        ),
    ];
    for (shape, pose, left) in cases {
        let resting = expand(&[Collider::resting(shape, pose)], PhysicsModel::Sward).resting;
        assert_eq!(resting.len(), left, "{shape:?}");
        let last_pose = Some(Pose { translation: Vec3::splat(0.1), ..pose });
        let moving = expand(&[Collider { shape, pose, last_pose }], PhysicsModel::Sward).moving;
        assert!(moving.iter().all(Primitive::is_sound) && (left > 0 || moving.is_empty()));
    }
    // From nowhere is as from no place at all
    let thing = Collider { last_pose: Some(nowhere), ..Collider::ball(balls[0]) };
    assert_eq!(expand(&[thing], PhysicsModel::Sward).resting.len(), 1);
}

/// The places of things that turn and move hold what they pass.
#[test]
fn sweeps_hold_what_is_passed() {
    let (from, to) = (Vec3::new(-0.7, 0.0, 0.2), Vec3::new(0.9, 0.1, 0.0));
    let half_extents = Vec3::new(0.1, 0.3, 0.6);
    let poses = |i: u32| {
        let t = i as f32;
        let turn = Quat::from_rotation_y(t * 0.37) * Quat::from_rotation_x(t * 0.11);
        Pose { translation: Vec3::new(t.sin(), 0.1 * t, t * 0.4), rotation: turn }
    };
    for i in 0..12 {
        let (last, pose) = (poses(i), poses(i + 1));
        for radius in [0.02, 0.2] {
            let shape = ColliderShape::Capsule { from, to, radius };
            let points = (0..=20).map(|k| from.lerp(to, k as f32 / 20.0));
            assert_held(shape, last, pose, points.collect());
        }
        let corner = |k: u32| {
            let side = |bit: u32| if k >> bit & 1 == 1 { 0.98 } else { -0.98 };
            Vec3::new(side(0), side(1), side(2)) * half_extents
        };
        let shape = ColliderShape::Cuboid { half_extents };
        assert_held(shape, last, pose, (0..8).map(corner).collect());
    }
}

fn assert_held(shape: ColliderShape, last: Pose, pose: Pose, points: Vec<Vec3>) {
    let thing = Collider { shape, pose, last_pose: Some(last) };
    let held = expand(&[thing], PhysicsModel::Sward).moving;
    for step in 0..=30 {
        let share = step as f32 / 30.0;
        let at = Pose {
            translation: last.translation.lerp(pose.translation, share),
            rotation: last.rotation.slerp(pose.rotation, share),
        };
        for point in &points {
            let point = at.point(*point);
            assert!(held.iter().any(|p| holds(p, point)), "{shape:?} at {share}: {point}");
        }
    }
}

fn holds(primitive: &Primitive, point: Vec3) -> bool {
    match *primitive {
        Primitive::Capsule { from, to, radius } | Primitive::Swept { from, to, radius } => {
            let axis = to - from;
            let t = (point - from).dot(axis) / axis.length_squared().max(1e-12);
            (from + axis * t.clamp(0.0, 1.0)).distance(point) <= radius * 1.001
        }
        Primitive::Cuboid { center, half_extents, rotation } => {
            let local = Primitive::into_box(rotation, (point - center).as_dvec3());
            (local.abs() - half_extents.as_dvec3()).max_element() <= 1e-4
        }
    }
}

/// The trail of a ball is there 5 s later, and gone when response and crush say; those pushed
/// deeper stand later.
#[test]
fn a_trail_lasts_and_goes() {
    let (mut rig, blades, wind) = awake(8, 1500);
    let mut bare = Rig::on(shared(), rig.field.clone());
    for _ in 0..2 {
        bare.step(&Frame::new(DT_S, &wind), &[see_all()]);
    }
    for step in 0..12 {
        let ball = [flies(ColliderShape::Sphere { radius: 0.4 }, step, Quat::IDENTITY)];
        rig.step(&Frame { colliders: &ball, ..Frame::new(DT_S, &wind) }, &[see_all()]);
        bare.step(&Frame::new(DT_S, &wind), &[see_all()]);
    }
    let start = rig_states(&rig, &blades);
    let touched: Vec<usize> = (0..blades.len()).filter(|i| start[*i].crush > 0.3).collect();
    assert!(touched.len() > 40, "{}", touched.len());
    let mut stood_s = vec![f64::INFINITY; blades.len()];
    for second in 1..=14 {
        for _ in 0..3 {
            for rig in [&mut rig, &mut bare] {
                rig.step(&Frame::new(1.0 / 3.0, &wind), &[see_all()]);
            }
        }
        let (now, other) = (rig_states(&rig, &blades), rig_states(&bare, &blades));
        let apart = |i: usize| now[i].tip.distance(other[i].tip);
        for i in touched.iter().copied().filter(|i| apart(*i) < 0.1) {
            stood_s[i] = stood_s[i].min(f64::from(second));
        }
        let deep: Vec<f64> =
            touched.iter().filter(|i| start[**i].crush > 1.2).map(|i| apart(*i)).collect();
        let mean = deep.iter().sum::<f64>() / deep.len() as f64;
        println!("{second} s: the deep are {mean:.3} h apart");
        if second == 5 {
            assert!(mean > 0.3, "the trail shows after 5 s: {mean}");
        }
    }
    // Crush fades by 0.25 a second; the blade then needs some 3 over its response
    for i in &touched {
        let limit = start[*i].crush / 0.25 + 3.0 / blades[*i].physics.response + 1.0;
        assert!(stood_s[*i] <= limit, "{:?}: {} s, not {limit}", start[*i], stood_s[*i]);
    }
    let mean = |low: f64, high: f64| {
        let group = touched.iter().filter(|i| (low..high).contains(&start[**i].crush));
        let times: Vec<f64> = group.map(|i| stood_s[*i]).collect();
        times.iter().sum::<f64>() / times.len() as f64
    };
    let (light, middle, deep) = (mean(0.3, 0.8), mean(0.8, 1.4), mean(1.4, 2.1));
    println!("stand after {light:.1}, {middle:.1}, {deep:.1} s");
    assert!(light < middle && middle < deep);
}

/// The same steps twice end in the same bits, whatever the order of the colliders.
#[test]
fn the_same_steps_end_in_the_same_bits() {
    let run = |reverse: bool| {
        let (mut rig, _, wind) = awake(4, 1000);
        for step in 0..4 {
            let mut things: Vec<_> = (0..5)
                .map(|k| {
                    let radius = 0.1 + 0.05 * k as f32;
                    let mut thing =
                        flies(ColliderShape::Sphere { radius }, step * 2 + k, Quat::IDENTITY);
                    thing.pose.translation.z += k as f32;
                    thing
                })
                .collect();
            if reverse {
                things.reverse();
            }
            rig.step(&Frame { colliders: &things, ..Frame::new(DT_S, &wind) }, &[see_all()]);
        }
        rig.states()
    };
    let first = run(false);
    assert_eq!(first, run(false));
    assert_eq!(first, run(true));
}

#[test]
fn too_many_colliders_are_an_error_that_says_how_many_fit() {
    let limits = wgpu::Limits { max_storage_buffer_binding_size: 1 << 15, ..Default::default() };
    let mut rig = Rig::on(test_device::with_limits(limits), random_field(1, 100, 1.0, 64));
    let wind = Wind::default();
    // 15 chunks of 65 entries of 32 bytes in 32 KiB, one of which may be cut in two
    let ball = Sphere { center: Vec3::ZERO, radius: 0.1 };
    let mut simulate = |count: usize| {
        let balls = vec![ball; count];
        let thing = [Collider::resting(ColliderShape::Spheres(&balls), Pose::default())];
        let frame = Frame { colliders: &thing, ..Frame::new(DT_S, &wind) };
        rig.submit(|renderer, (device, _), encoder| renderer.simulate(device, encoder, &frame))
    };
    assert_eq!(simulate(14 * 64), Ok(()));
    let error = simulate(15 * 64 + 1).expect_err("too many");
    let text = error.to_string();
    assert!(text.contains("961 spheres") && text.contains("896 fit"), "{text}");
    let Error::Limit { needed, available, .. } = error else { panic!("{error}") };
    assert!(needed > available);
    assert_eq!(simulate(3), Ok(()), "a refusal changes nothing");
}

/// A wall leans blades away from it, and no blade into the ground.
#[test]
fn a_wall_leans_blades_away() {
    let (mut rig, blades, wind) = awake(6, 1500);
    let half_extents = Vec3::new(4.0, 1.0, 0.5);
    let wall = [Collider::resting(ColliderShape::Cuboid { half_extents }, Pose::at(Vec3::Y))];
    for _ in 0..20 {
        rig.step(&Frame { colliders: &wall, ..Frame::new(DT_S, &wind) }, &[see_all()]);
    }
    let (mut inside, mut leaning) = (0, 0);
    for (blade, state) in blades.iter().zip(rig_states(&rig, &blades)) {
        let root = blade.physics.root;
        assert!(state.tip.dot(blade.physics.up) > -1e-4);
        let beside = root.x.abs() < 3.0 && (0.5..0.7).contains(&root.z.abs());
        if !beside {
            continue;
        }
        leaning += 1;
        let tip: DVec3 = root + state.tip * blade.physics.height;
        inside += usize::from(tip.z.abs() < 0.45 && tip.y > 0.0);
    }
    println!("{inside} of {leaning} tips beside the wall are in it");
    assert!(leaning > 20 && inside * 50 <= leaning, "{inside} of {leaning}");
}
