//! Wind whose sources move along paths.

use crate::Path;
use glam::Vec3;
use sward::WindSource;

/// A term of the wind, and where it is.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneWind {
    /// What blows; its place and its motion are the path's.
    pub source: WindSource,
    /// Where it is, for a kind that has a place. The turns of the keys turn a fan.
    pub path: Path,
}

/// Over so long a path's velocity is taken, seconds.
const STEP_S: f64 = 1.0 / 60.0;
/// Fastest that the library takes, metres a second along each axis: a path may jump.
const FASTEST_MPS: f32 = 1000.0;

impl SceneWind {
    /// The source as it is at a time, seconds, with the velocity that it has had just before.
    pub fn at(&self, time_s: f64) -> WindSource {
        let pose = self.path.pose_at(time_s);
        let before = self.path.pose_at(time_s - STEP_S).translation;
        let most = Vec3::splat(FASTEST_MPS);
        let velocity = ((pose.translation - before) / STEP_S as f32).clamp(-most, most);
        let mut source = self.source.clone();
        source.place(pose.translation, velocity);
        if let WindSource::Fan(fan) = &mut source {
            fan.direction = pose.rotation * fan.direction;
        }
        source
    }
}

#[cfg(test)]
mod tests {
    use glam::vec3;
    use std::path::Path;
    use sward::WindSource;

    fn wind(text: &str) -> Vec<super::SceneWind> {
        let text = format!(
            "(objects: [(name: \"hill\", source: Plane(size_m: (20, 20)), translate: (0, 3, 0))],
              fields: [(on: Object(\"hill\"), count: 10)], wind: [{text}])"
        );
        crate::parse(&text, Path::new("s.ron")).expect("a scene").wind
    }

    #[test]
    fn sources_move_and_turn_with_their_paths() {
        let all = wind(
            "Waves(), Vortex(path: (keys: [(0, 0, 0, 0), (2, 8, 0, -2)], smooth: false)),
             Rotor(above: \"hill\", at: (1, 4, 2)),
             Fan(path: [(time_s: 0, at: (0, 1, 0)), (time_s: 1, at: (0, 1, 0), rotate_deg: (0, 90, 0))])",
        );
        assert_eq!(all[0].at(1.0), all[0].at(9.0));
        let WindSource::Vortex(vortex) = all[1].at(1.0) else { panic!("a vortex") };
        assert!(vortex.position.distance(vec3(4.0, 0.0, -1.0)) < 1e-4);
        assert!(vortex.velocity.distance(vec3(4.0, 0.0, -1.0)) < 1e-2, "{}", vortex.velocity);
        let WindSource::Vortex(vortex) = all[1].at(9.0) else { panic!("a vortex") };
        assert_eq!(vortex.velocity, glam::Vec3::ZERO, "it rests at its end");
        let WindSource::Rotor(rotor) = all[2].at(1.0) else { panic!("a rotor") };
        assert_eq!(rotor.position, vec3(1.0, 7.0, 2.0));
        let WindSource::Fan(fan) = all[3].at(1.0) else { panic!("a fan") };
        assert!(fan.direction.distance(-glam::Vec3::Z) < 1e-5, "{}", fan.direction);
        let WindSource::Fan(fan) = all[3].at(0.0) else { panic!("a fan") };
        assert_eq!(fan.direction, glam::Vec3::X);
    }

    /// What a scene takes the library takes too, at both ends of every range and by default.
    #[test]
    fn the_library_takes_what_a_scene_may_say() {
        let text = "Waves(), Gusts(), Cosine(), Rotor(), Vortex(), Fan(), Texture(),
            Texture(gusts: 64, size_m: 0.01, speed_mps: -100, strength: 20, direction: (0, 1e-6)),
            Cosine(wavelength_m: inf, period_s: 0.01, strength: 20),
            Rotor(radius_m: 0.01, range_m: 10000, rpm: -10000, blades: 16, speed_mps: 0.01),
            Rotor(radius_m: 1000, downwash: 4, swirl: -4, path: [(0, 0, 0, 0), (0.001, 100000, 0, 0)]),
            Vortex(inflow: -4, updraft: 4, speed_mps: 1000, strength: 0, at: (-100000, 0, 100000)),
            Fan(half_angle_deg: 0.1, direction: (0, 0.000001, 0)),
            Fan(half_angle_deg: 80, direction: (100000, 100000, 100000), speed_mps: 0)";
        let all = wind(text);
        for time_s in [0.0, 0.0005, 0.001, 1.0] {
            let sources: Vec<_> = all.iter().map(|wind| wind.at(time_s)).collect();
            let wind = sward::Wind::new(sources).expect("what a scene may say");
            assert!(wind.strength_at(vec3(1.0, 2.0, 3.0), 0.5).is_finite());
            assert_eq!(wind.gpu_sources().len(), all.len());
        }
    }
}
