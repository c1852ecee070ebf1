use super::*;
use crate::{Scene, parse};
use std::path::Path;

fn scene(text: &str) -> Scene {
    parse(text, Path::new("s.ron")).unwrap_or_else(|error| panic!("{error}"))
}

/// Balls over hills, thrown.
fn balls(more: &str) -> Scene {
    scene(&format!(
        "(objects: [(name: \"g\", source: Terrain(size_m: 30, relief_m: 2, hill_m: 12, divisions: 48))],
          fields: [(on: Object(\"g\"), density: 1)],
          bodies: [(shape: Sphere(radius_m: 0.15), count: 30, above: \"g\", at: (0, 1, 0),
            spread_m: (4, 0.5, 4), velocity_mps: (3, 2, 0), velocity_spread_mps: 2,
            spin_spread_rps: 1, every_s: 0.02, {more})])"
    ))
}

fn positions(bodies: &Bodies) -> Vec<Option<[u32; 3]>> {
    let bits = |body: &Body| Some(body.pose?.translation.to_array().map(f32::to_bits));
    bodies.all().iter().map(bits).collect()
}

/// Whatever times lead there: equal steps of a frame, uneven ones, or a single leap.
#[test]
fn a_time_has_one_answer_bit_for_bit() {
    let scene = balls("copy_scale: (0.8, 1.2)");
    let run = |times: &[f64]| {
        let mut bodies = Bodies::new(&scene).expect("bodies");
        times.iter().for_each(|&t| bodies.advance_to(t));
        positions(&bodies)
    };
    let even: Vec<_> = (0..=90).map(|i| f64::from(i) / 60.0).collect();
    let leap = run(&[1.5]);
    assert!(leap.iter().all(Option::is_some));
    assert_eq!(run(&even), leap);
    assert_eq!(run(&[-3.0, 0.0, 0.013, 0.9, 1.4999, 1.5]), leap);
    assert_ne!(run(&[1.497]), leap, "between two steps");
    let other = Bodies::new(&balls("copy_scale: (0.8, 1.2), seed: 2")).map(|mut bodies| {
        bodies.advance_to(1.5);
        positions(&bodies)
    });
    assert_ne!(other, Some(leap), "another seed is another throw");
}

#[test]
fn bodies_start_one_after_another() {
    let scene = balls("start_s: 0.5");
    let mut bodies = Bodies::new(&scene).expect("bodies");
    let there = |bodies: &Bodies| bodies.all().iter().filter(|b| b.pose.is_some()).count();
    bodies.advance_to(0.49);
    assert_eq!(there(&bodies), 0);
    bodies.advance_to(0.5);
    assert_eq!(there(&bodies), 1);
    assert_eq!(
        bodies.all()[0].pose.map(|p| p.translation),
        Some(scene.bodies[0].starts[0].position)
    );
    bodies.advance_to(0.5 + 0.2 + 1e-3);
    assert_eq!(there(&bodies), 11);
    assert!(bodies.all()[0].last_pose.is_some() && bodies.all()[10].last_pose.is_none());
}

/// Each lies on the ground in the end, neither in it nor over it, and none has moved since.
#[test]
fn balls_come_to_rest_on_the_ground() {
    let scene = balls("");
    let mut bodies = Bodies::new(&scene).expect("bodies");
    bodies.advance_to(14.0);
    let before = positions(&bodies);
    assert_eq!(bodies.moving(), 0);
    bodies.advance_to(15.0);
    assert_eq!(positions(&bodies), before);
    let ground = crate::objects::ground::Ground::new(&scene.objects[0].mesh);
    for body in bodies.all() {
        let at = body.pose.expect("still there").translation;
        let flat = glam::Vec2::new(at.x, at.z);
        let slope = ground.normal(flat).expect("over ground").y;
        let height = (at.y - ground.height(flat).expect("over ground")) * slope;
        assert!((height - 0.15).abs() < 0.02, "{height}");
    }
}

/// The drag is what stops a ball: without it, it is still under way.
#[test]
fn grass_stops_a_ball_that_would_roll_on() {
    let rolled = |drag: f32| {
        let scene = scene(&format!(
            "(objects: [(name: \"g\", source: Plane(size_m: (200, 20)))],
              fields: [(on: Object(\"g\"), density: 1)],
              bodies: [(above: \"g\", at: (-90, 0, 0), velocity_mps: (5, 0, 0), grass_drag: {drag})])"
        ));
        let mut bodies = Bodies::new(&scene).expect("bodies");
        bodies.advance_to(10.0);
        (bodies.all()[0].pose.expect("there").translation.x + 90.0, bodies.moving())
    };
    let ((free, free_moves), (slowed, slowed_moves)) = (rolled(0.0), rolled(1.0));
    assert!(free > 30.0 && free_moves == 1, "{free}");
    // It starts by sliding, which costs two sevenths; dv/dt = -(1 + 0.6 v) then stops it.
    assert!((2.5..6.0).contains(&slowed) && slowed_moves == 0, "{slowed}");
}

#[test]
fn fast_balls_do_not_fall_through_and_what_leaves_the_ground_is_let_go() {
    let scene = scene(
        "(objects: [(name: \"g\", source: Plane(size_m: (20, 20)))],
          fields: [(on: Object(\"g\"), density: 1)],
          bodies: [
            (count: 20, above: \"g\", at: (0, 3, 0), spread_m: (8, 1, 8), velocity_mps: (0, -60, 0)),
            (at: (30, 1, 0), shape: Box()),
            (at: (-40, 1, 0), shape: Capsule()),
          ])",
    );
    let mut bodies = Bodies::new(&scene).expect("bodies");
    bodies.advance_to(0.5);
    assert!(bodies.all()[..20].iter().all(|b| b.pose.is_some_and(|p| p.translation.y > 0.0)));
    bodies.advance_to(6.0);
    assert_eq!(bodies.all()[20].pose, None);
    assert_eq!(bodies.all()[21].pose, None);
    bodies.advance_to(7.0);
    assert_eq!(bodies.all()[20].pose, None);
}

/// A sphere on a path pushes a ball that lies in its way.
#[test]
fn things_on_paths_push_bodies() {
    let scene = scene(
        "(objects: [(name: \"g\", source: Plane(size_m: (20, 20)))],
          fields: [(on: Object(\"g\"), density: 1)],
          spheres: [(radius_m: 0.5, path: [(0, -3, 0.5, 0), (2, 3, 0.5, 0)])],
          bodies: [(above: \"g\", at: (0, 0, 0))])",
    );
    let mut bodies = Bodies::new(&scene).expect("bodies");
    bodies.advance_to(0.5);
    let x = |bodies: &Bodies| bodies.all()[0].pose.expect("there").translation.x;
    assert!(x(&bodies).abs() < 0.01);
    bodies.advance_to(2.0);
    assert!(
        x(&bodies).abs() > 0.5
            || bodies.all()[0].pose.unwrap_or_default().translation.z.abs() > 0.3
    );
}
