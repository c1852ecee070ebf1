use super::*;
use crate::objects::ground::Ground;
use crate::schema::PathKeyFile;
use glam::{Vec2, Vec3Swizzles};

fn key(time_s: f32, at: [f32; 3], rotate_deg: [f32; 3]) -> PathKeyFile {
    PathKeyFile { time_s, at, rotate_deg }
}

fn file(keys: Vec<PathKeyFile>, smooth: bool, repeat: bool) -> PathFile {
    PathFile { keys, smooth, repeat, listed: true }
}

fn path(keys: Vec<PathKeyFile>, smooth: bool, repeat: bool) -> Path {
    Path::from_file(&file(keys, smooth, repeat), &Key::name("path")).expect("a path")
}

fn x_keys(xs: &[(f32, f32)]) -> Vec<PathKeyFile> {
    xs.iter().map(|&(t, x)| key(t, [x, 0.0, 0.0], [0.0; 3])).collect()
}

#[test]
fn straight_paths_rest_at_both_ends() {
    let path = path(x_keys(&[(1.0, 0.0), (3.0, 4.0)]), false, false);
    let at = |t| path.pose_at(t).translation.x;
    assert_eq!([at(-3.0), at(1.0), at(1.5), at(2.0), at(9.0)], [0.0, 0.0, 1.0, 2.0, 4.0]);
    assert!(path.moves() && !Path::still(Vec3::ONE).moves());
    assert_eq!(Path::still(Vec3::ONE).pose_at(7.0), Pose::at(Vec3::ONE));
}

#[test]
fn smooth_paths_pass_their_keys_and_never_overshoot() {
    let keys = [(0.0, 0.0), (1.0, 2.0), (1.5, 2.0), (3.0, -1.0), (3.2, 5.0), (6.0, 5.5)];
    let path = path(x_keys(&keys), true, false);
    for pair in keys.windows(2) {
        let ((from_s, a), (to_s, b)) = (pair[0], pair[1]);
        assert_eq!(path.pose_at(from_s.into()).translation.x, a);
        for i in 0..=50 {
            let x = path.pose_at((from_s + (to_s - from_s) * i as f32 / 50.0).into()).translation.x;
            assert!(x >= a.min(b) - 1e-5 && x <= a.max(b) + 1e-5, "{from_s}..{to_s}: {x}");
        }
    }
    assert_eq!(path.pose_at(1.2).translation.x, 2.0, "held still by two equal keys");
}

/// The speed has no step at a key; a straight path's has.
#[test]
fn smooth_paths_have_no_corners() {
    let keys = [(0.0, 0.0), (1.0, 1.0), (2.0, 4.0), (3.0, 5.0)];
    let corner = |smooth| {
        let path = path(x_keys(&keys), smooth, false);
        let x = |t: f64| path.pose_at(t).translation.x;
        let h = 0.01;
        let jumps = [1.0, 2.0].map(|t| (x(t + h) - 2.0 * x(t) + x(t - h)).abs() / h as f32);
        jumps[0].max(jumps[1])
    };
    assert!(corner(true) < 0.1, "{}", corner(true));
    assert!(corner(false) > 1.9);
}

#[test]
fn repeated_paths_go_on_for_ever_without_a_jump() {
    let path = path(x_keys(&[(1.0, 0.0), (2.0, 3.0), (3.0, 0.0)]), true, true);
    for t in [-5.3, 0.0, 1.25, 2.9, 77.7] {
        let (a, b) = (path.pose_at(t).translation, path.pose_at(t + 2.0).translation);
        assert!(a.distance(b) < 1e-3, "{t}: {a} {b}");
        let (before, after) = (path.pose_at(t - 1e-3), path.pose_at(t + 1e-3));
        assert!(before.translation.distance(after.translation) < 0.02);
    }
}

#[test]
fn turns_take_the_shorter_way_evenly() {
    let keys = vec![key(0.0, [0.0; 3], [0.0, 350.0, 0.0]), key(1.0, [0.0; 3], [0.0, 30.0, 0.0])];
    let path = path(keys, true, false);
    for i in 0..=4 {
        let t = i as f32 / 4.0;
        let expected = Quat::from_rotation_y((-10.0 + 40.0 * t).to_radians());
        assert!(path.pose_at(t.into()).rotation.angle_between(expected) < 2e-3, "{t}");
    }
}

#[test]
fn bad_keys_name_themselves() {
    let error = |keys, repeat| {
        let problem = Path::from_file(&file(keys, true, repeat), &Key::name("p"));
        let problem = problem.expect_err("bad");
        format!("{}: {}", problem.key, problem.cause)
    };
    assert!(error(vec![], false).starts_with("p: is empty"));
    let repeated = error(x_keys(&[(0.0, 0.0), (1.0, 1.0), (1.0, 2.0)]), false);
    assert!(repeated.starts_with("p[2]: time 1 must be after"), "{repeated}");
    assert!(error(x_keys(&[(1.0, 0.0), (0.5, 1.0)]), false).starts_with("p[1]: time 0.5"));
    assert!(error(x_keys(&[(f32::NAN, 0.0)]), false).starts_with("p[0]: NaN is out of range"));
    assert!(error(x_keys(&[(0.0, f32::NAN)]), false).starts_with("p[0]: NaN"));
    assert!(error(x_keys(&[(-1.0, 0.0)]), false).starts_with("p[0]: -1"));
    assert!(error(vec![key(0.0, [0.0; 3], [f32::INFINITY, 0.0, 0.0])], false).contains("inf"));
    assert!(error(x_keys(&[(0.0, 0.0), (1.0, 1.0)]), true).starts_with("p.repeat: the last key"));
    assert!(error(x_keys(&[(0.0, 0.0)]), true).starts_with("p.repeat: needs two"));
    let turned = |degrees| vec![key(0.0, [0.0; 3], [0.0; 3]), key(1.0, [0.0; 3], degrees)];
    let turned_off = error(turned([0.0, 40.0, 0.0]), true);
    assert!(turned_off.contains("is 40.0 degrees off"), "{turned_off}");
    path(turned([0.0, 360.0, 0.0]), true, true);
}

/// After a day, where single precision steps by 8 ms.
#[test]
fn late_times_are_as_fine_as_early_ones() {
    let path = path(x_keys(&[(0.0, 0.0), (1.0, 3.0), (2.0, 0.0)]), false, true);
    let x = |t: f64| path.pose_at(t).translation.x;
    for i in 0..=50 {
        let t = f64::from(i) * 1e-3;
        assert!((x(86_400.0 + t) - x(t)).abs() < 1e-5, "{t}");
    }
}

/// Keys close together, corners, and hills that are small or far apart: none is cut, however long
/// the path takes; what rests takes no keys at all.
#[test]
fn ground_is_followed_at_keys_and_by_distance() {
    let heights: Vec<f32> = (0..201 * 201).map(|i| ((i % 201) as f32 * 0.7).sin()).collect();
    let mesh = sward::Mesh::heightmap(201, 201, &heights, Vec2::splat(40.0)).expect("waves");
    let ground = Ground::new(&mesh);
    let follow =
        |keys, smooth| along_ground(&path(keys, smooth, false), &ground, 0.0, &Key::name("path"));
    for (slow, smooth) in [(1.0, false), (1.0, true), (9000.0, false), (9000.0, true)] {
        let flat =
            x_keys(&[(0.0, -9.0), (1.0 * slow, 0.13), (1.03 * slow, 0.9), (3.0 * slow, -9.0)]);
        let above = path(flat.clone(), smooth, false);
        let followed = follow(flat, smooth).expect("a path");
        for i in 0..=997 {
            let t = f64::from(slow) * 3.0 * f64::from(i) / 997.0;
            let (at, of) = (followed.pose_at(t).translation, above.pose_at(t).translation);
            assert!((at.x - of.x).abs() < 0.02, "{slow} {smooth} {t}: {at} {of}");
            let floor = ground.height(at.xz()).expect("over it");
            assert!((at.y - floor).abs() < 0.03, "{slow} {smooth} {t}: {at} {floor}");
        }
    }
    let rests = follow(x_keys(&[(0.0, 1.0), (90_000.0, 1.0)]), true).expect("a path");
    assert_eq!(rests.keys().len(), 2);
    let far = follow(x_keys(&[(0.0, 0.0), (10.0, 90_000.0)]), false);
    let problem = far.expect_err("too far");
    assert!(problem.cause.contains("at most 200000"), "{}", problem.cause);
}

/// A ball that rolls a length turns by the length over its radius, about the axis across its way,
/// whichever way the ground slopes; one that flies keeps its turn.
#[test]
fn balls_roll_without_sliding() {
    let heights: Vec<f32> = (0..81 * 81).map(|i| (i % 81) as f32 * 0.05).collect();
    let mesh = sward::Mesh::heightmap(81, 81, &heights, Vec2::splat(20.0)).expect("a slope");
    let ground = Ground::new(&mesh);
    let radius = 0.4;
    let keys = |y| vec![key(0.0, [-4.0, y, 0.0], [0.0; 3]), key(4.0, [4.0, y, 0.0], [0.0; 3])];
    let turn_at = |y, t| {
        let above = path(keys(y), false, false);
        let followed = along_ground(&above, &ground, radius, &Key::name("path")).expect("a path");
        let rolled = rolling(&followed, &above, &ground, radius);
        assert_eq!(rolled.pose_at(t).translation, followed.pose_at(t).translation);
        rolled.pose_at(t)
    };
    let (start, end) = (turn_at(0.0, 0.0), turn_at(0.0, 0.2));
    let length = end.translation.distance(start.translation);
    assert!((length - 0.4 * (1.0 + 0.2_f32.powi(2)).sqrt()).abs() < 2e-3, "{length}");
    // Towards +x over ground that faces up: about -z.
    let expected = Quat::from_rotation_z(-length / radius);
    assert!(end.rotation.angle_between(expected) < 2e-3);
    assert_eq!(turn_at(2.0, 3.0).rotation, Quat::IDENTITY);
    let floor = ground.height(end.translation.xz()).expect("over it");
    assert!((end.translation.y - floor - radius).abs() < 1e-3);
}
