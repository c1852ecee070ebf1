//! Spheres near patches, which patches they wake, and how the others catch up.

use super::decoded::{decode, states};
use super::rig::Rig;
use super::scenes::{Draws, breeze, random_field, see_all, see_none};
use crate::gpu::layout::NEAR_STRIDE;
use crate::{Collider, Frame, PhysicsModel, Sphere, View};
use glam::Vec3;

fn near_lists(rig: &Rig) -> Vec<Vec<u32>> {
    let words: Vec<u32> = rig.read(&rig.page(0).near);
    words
        .chunks(NEAR_STRIDE as usize)
        .take(rig.field.patches().len())
        .map(|list| list[1..=list[0] as usize].to_vec())
        .collect()
}

/// The first 31 spheres that touch each patch's box, and how many more there are.
fn brute_force(rig: &Rig, spheres: &[Sphere]) -> (Vec<Vec<u32>>, u64) {
    let mut beyond = 0;
    let lists = rig.field.patches().iter().map(|patch| {
        let touches = |s: &Sphere| {
            let nearest = s.center.clamp(patch.reach_min, patch.reach_max);
            nearest.distance_squared(s.center) < s.radius * s.radius
        };
        let mut list: Vec<u32> =
            (0..).zip(spheres).filter(|(_, s)| touches(s)).map(|(i, _)| i).collect();
        beyond += list.len().saturating_sub(31) as u64;
        list.truncate(31);
        list
    });
    (lists.collect(), beyond)
}

fn random_spheres(seed: u32, count: u32) -> Vec<Sphere> {
    let mut draws = Draws::new(seed);
    (0..count)
        .map(|_| Sphere {
            center: draws.vector(-7.0, 7.0) * Vec3::new(1.0, 0.2, 1.0),
            radius: draws.between(0.05, 2.0),
        })
        .collect()
}

fn frame<'a>(wind: &'a crate::Wind, colliders: &'a [Collider]) -> Frame<'a> {
    Frame { colliders, ..Frame::new(0.02, wind) }
}

fn balls(spheres: &[Sphere]) -> Vec<Collider<'static>> {
    spheres.iter().copied().map(Collider::ball).collect()
}

#[test]
fn near_lists_equal_brute_force() {
    let wind = breeze();
    let mut rig = Rig::new(random_field(1, 3000, 6.0, 64));
    for (seed, count) in [(1, 1), (2, 20), (3, 65), (4, 1500)] {
        let spheres = random_spheres(seed, count);
        rig.step(&frame(&wind, &balls(&spheres)), &[see_all()]);
        let (expected, beyond) = brute_force(&rig, &spheres);
        assert_eq!(near_lists(&rig), expected, "{count} spheres");
        let statistics = rig.statistics();
        assert_eq!(statistics.spheres_dropped, beyond);
        assert_eq!(beyond > 0, count == 1500, "{beyond}");
        let tested = (rig.field.patches().iter().zip(&expected))
            .map(|(patch, list)| u64::from(patch.count) * list.len() as u64);
        assert_eq!(statistics.spheres_tested, tested.sum::<u64>());
        // A second look at the same step moves nothing and counts the same
        let before = rig.states();
        rig.cull(&[see_all()]);
        assert_eq!(rig.states(), before);
        assert_eq!(rig.statistics(), statistics);
    }
    rig.step(&frame(&wind, &[]), &[see_all()]);
    assert!(near_lists(&rig).iter().all(Vec::is_empty), "spheres that left are forgotten");
    assert_eq!((rig.statistics().spheres_tested, rig.statistics().spheres_dropped), (0, 0));
}

#[test]
fn only_touched_patches_wake_out_of_view() {
    let wind = breeze();
    let mut rig = Rig::new(random_field(2, 2000, 6.0, 64));
    rig.step(&frame(&wind, &[]), &[see_all()]);
    let before = rig.bands();
    let ball = [Sphere { center: Vec3::new(3.0, 0.2, 3.0), radius: 0.5 }];
    let (touched, _) = brute_force(&rig, &ball);
    for turn in 1..4 {
        rig.step(&frame(&wind, &balls(&ball)), &[see_none()]);
        assert_eq!(rig.statistics().patches_visible, 0);
        for (i, ((now, then), list)) in rig.bands().iter().zip(&before).zip(&touched).enumerate() {
            let steps = if list.is_empty() { 0 } else { turn };
            assert_eq!(now.step, then.step + steps, "patch {i}");
        }
    }
    let woken = touched.iter().filter(|list| !list.is_empty()).count();
    assert!(woken > 0 && woken < touched.len() / 2, "{woken} of {}", touched.len());
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
