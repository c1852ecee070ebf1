//! Three paths of a camera, anchored at the scene's own: the same on any scene.

use super::PATH_STEPS;
use super::ground::Ground;
use glam::{Quat, Vec3};
use sward_scene::{Camera, Scene};

/// Metres of the dolly, and of the distance that the others keep.
const LENGTH_M: f32 = 20.0;
/// Heights over the ground where the fly-down starts and ends, metres.
const HEIGHTS_M: [f32; 2] = [60.0, 2.0];
/// How far behind the point that it looks at the fly-down goes down, metres.
const BEHIND_M: f32 = 30.0;
/// Neighbouring frames that are drawn together where not all are drawn.
const RUN: u32 = 4;
/// Sides from which drift is looked at, over a quarter turn.
pub(super) const SIDES: u32 = 4;

/// Where on the fly-down drift is measured, too: 8 and 31 m over the ground.
const RAISED: f32 = 0.9;
const ABOVE: f32 = 0.5;

/// Which path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Which {
    /// Straight ahead, over the ground.
    Dolly,
    /// A quarter turn about a point ahead, over the ground.
    Orbit,
    /// Straight down, looking at that point.
    FlyDown,
}

/// The frames to draw, of [`PATH_STEPS`]: all, or runs of neighbours.
pub(super) fn frames(count: u32) -> Vec<u32> {
    if count >= PATH_STEPS {
        return (0..PATH_STEPS).collect();
    }
    let runs = (count / RUN).max(1);
    let length = (count / runs).max(2);
    let room = PATH_STEPS - length;
    // In the middle of equal parts
    let start = |run: u32| room * (2 * run + 1) / (2 * runs);
    (0..runs).flat_map(|run| start(run)..start(run) + length).collect()
}

/// The paths of a scene. Inside, y is the camera's up.
#[derive(Debug)]
pub(super) struct Paths {
    ground: Ground,
    camera: Camera,
    /// To y up.
    turn: Quat,
    /// Level, unit.
    forward: Vec3,
    /// What the orbit turns about, on the ground.
    center: Vec3,
    /// Of the orbit, radians.
    angle: f32,
    scale: f32,
}

impl Paths {
    pub fn new(scene: &Scene, camera: &Camera) -> Self {
        let turn = Quat::from_rotation_arc(camera.up.normalize_or(Vec3::Y), Vec3::Y);
        let ground = Ground::new(scene, turn);
        let camera =
            Camera { eye: turn * camera.eye, target: turn * camera.target, ..camera.clone() };
        let ahead = camera.target - camera.eye;
        let forward = ahead.with_y(0.0).normalize_or(Vec3::NEG_Z);
        let scale = scale(&ground, &camera, forward);
        let far = ahead.with_y(0.0).length().clamp(0.25 * LENGTH_M * scale, LENGTH_M * scale);
        let center = camera.eye + forward * far;
        let center = center.with_y(ground.height(center).unwrap_or(camera.target.y));
        let quarter = std::f32::consts::FRAC_PI_2;
        let mut paths = Self { ground, camera, turn, forward, center, angle: quarter, scale };
        let end = paths.orbit(1.0).eye;
        if paths.ground.height(end).is_none() {
            paths.angle = -quarter;
        }
        paths
    }

    /// Share of the full lengths that fits the scene.
    pub fn scale(&self) -> f32 {
        self.scale
    }

    /// The camera at a share of a path, 0..=1.
    pub fn camera(&self, which: Which, t: f32) -> Camera {
        let camera = match which {
            Which::Dolly => self.dolly(t),
            Which::Orbit => self.orbit(t),
            Which::FlyDown => self.fly_down(t),
        };
        let back = self.turn.inverse();
        Camera {
            eye: back * camera.eye,
            target: back * camera.target,
            up: self.camera.up,
            ..camera
        }
    }

    /// Cameras that drift is measured from, those of a name together: at the scene's own height, half
    /// way down the fly-down, and near its end; from sides spread over the orbit.
    pub fn views(&self) -> [(&'static str, Vec<Camera>); 3] {
        let around = |at: &dyn Fn(f32) -> Camera| {
            (0..SIDES).map(|i| at(i as f32 / (SIDES - 1) as f32)).collect()
        };
        let back = self.turn.inverse();
        let down = |t: f32| {
            let camera = self.fly_down(t);
            around(&|side| {
                let turn = Quat::from_rotation_y(self.angle * side);
                let eye = self.center + turn * (camera.eye - self.center);
                let up = self.camera.up;
                Camera { eye: back * eye, target: back * camera.target, up, ..camera.clone() }
            })
        };
        let own = around(&|t| self.camera(Which::Orbit, t));
        [("camera", own), ("raised", down(RAISED)), ("above", down(ABOVE))]
    }

    fn dolly(&self, t: f32) -> Camera {
        let eye = self.above(self.camera.eye + self.forward * (LENGTH_M * self.scale * t));
        let target = eye + self.camera.target - self.camera.eye;
        Camera { eye, target, ..self.camera.clone() }
    }

    fn orbit(&self, t: f32) -> Camera {
        let from_center = self.camera.eye - self.center;
        let eye = self.center + Quat::from_rotation_y(self.angle * t) * from_center;
        let eye = self.above(eye);
        // The pitch of the scene's camera
        let ahead = self.camera.target - self.camera.eye;
        let slope = ahead.y / ahead.with_y(0.0).length().max(1e-3);
        let distance = from_center.with_y(0.0).length();
        let target = self.center.with_y(eye.y + slope.clamp(-3.0, 3.0) * distance);
        Camera { eye, target, ..self.camera.clone() }
    }

    fn fly_down(&self, t: f32) -> Camera {
        let [high, low] = HEIGHTS_M.map(|height| height * self.scale);
        let below = self.center - self.forward * (BEHIND_M * self.scale);
        let floor = self.ground.height(below).unwrap_or(self.center.y);
        let eye = below.with_y(floor + high + (low - high) * t);
        Camera { eye, target: self.center, ..self.camera.clone() }
    }

    /// As high over the ground as the scene's camera stands; unchanged where there is no ground.
    fn above(&self, at: Vec3) -> Vec3 {
        let heights = (self.ground.height(self.camera.eye), self.ground.height(at));
        match heights {
            (Some(own), Some(here)) => at.with_y(here + self.camera.eye.y - own),
            _ => at,
        }
    }
}

/// 1, or less where the dolly would leave the ground.
fn scale(ground: &Ground, camera: &Camera, forward: Vec3) -> f32 {
    let mut scale = 1.0;
    if ground.height(camera.eye).is_none() {
        // Nothing to go along: what there is to see gives the measure
        return (ground.farthest(camera.eye) / (4.0 * LENGTH_M)).clamp(1e-3, 1.0);
    }
    for _ in 0..8 {
        if ground.height(camera.eye + forward * (LENGTH_M * scale)).is_some() {
            break;
        }
        scale *= 0.5;
    }
    scale
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn runs_of_neighbours_are_spread_over_the_path() {
        assert_eq!(frames(500).len(), 120);
        for count in 1..120 {
            let frames = frames(count);
            assert!(frames.is_sorted_by(|a, b| a < b) && frames.len() >= 2, "{count}");
            assert!(frames.iter().all(|&f| f < PATH_STEPS), "{count}: {frames:?}");
        }
        assert_eq!(frames(8), [29, 30, 31, 32, 87, 88, 89, 90]);
    }

    fn paths(size_m: u32) -> Paths {
        let text = format!(
            "(objects: [(name: \"g\", source: Terrain(size_m: {size_m}, relief_m: 3))],
              fields: [(on: Object(\"g\"), count: 1)],
              cameras: [(above: \"g\", eye: (0, 1.7, 0), target: (0, 1, -9))])"
        );
        let scene = sward_scene::parse(&text, Path::new("s.ron")).unwrap();
        Paths::new(&scene, &scene.cameras[0])
    }

    #[test]
    fn paths_have_their_lengths_and_stay_over_the_ground() {
        let paths = paths(200);
        assert_eq!(paths.scale(), 1.0);
        let at = |which, t| paths.camera(which, t);
        let level = |a: Vec3, b: Vec3| (a - b).with_y(0.0).length();
        let dolly = [at(Which::Dolly, 0.0), at(Which::Dolly, 1.0)];
        assert!((level(dolly[0].eye, dolly[1].eye) - 20.0).abs() < 1e-3);
        for t in [0.0, 0.3, 1.0] {
            for which in [Which::Dolly, Which::Orbit] {
                let eye = at(which, t).eye;
                let height = eye.y - paths.ground.height(eye).unwrap();
                assert!((height - 1.7).abs() < 1e-3, "{which:?} {height}");
            }
        }
        let (from, to) = (at(Which::Orbit, 0.0), at(Which::Orbit, 1.0));
        let arm = |camera: &Camera| (camera.eye - paths.center).with_y(0.0);
        assert!(arm(&from).dot(arm(&to)).abs() < 1e-2 && arm(&to).length() > 8.9);
        let heights = [0.0, 1.0].map(|t| {
            let eye = at(Which::FlyDown, t).eye;
            eye.y - paths.ground.height(eye).unwrap()
        });
        assert!((heights[0] - 60.0).abs() < 1e-2 && (heights[1] - 2.0).abs() < 1e-2);
    }

    #[test]
    fn small_scenes_get_short_paths() {
        let paths = paths(16);
        assert_eq!(paths.scale(), 0.25);
        assert!(paths.ground.height(paths.camera(Which::Dolly, 1.0).eye).is_some());
    }
}
