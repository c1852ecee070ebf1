//! Spheres that move along keyframes and push blades aside.

use glam::Vec3;

/// Where a sphere is at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphereKey {
    /// Time, seconds.
    pub time_s: f32,
    /// Centre, metres.
    pub center: Vec3,
    /// Radius, metres.
    pub radius: f32,
}

/// A sphere on a path; one keyframe stands still.
#[derive(Debug, Clone, PartialEq)]
pub struct MovingSphere {
    /// Its name, for messages.
    pub name: String,
    /// Keyframes, by rising time.
    pub path: Vec<SphereKey>,
    /// Whether it is drawn too.
    pub visible: bool,
    /// Its colour, linear RGB reflectance.
    pub base_color: [f32; 3],
    /// Roughness, 0 (mirror) to 1 (chalk).
    pub roughness: f32,
}

impl MovingSphere {
    /// The sphere at a time: straight between keyframes, at rest before the first and after the
    /// last. `None` only for an empty path.
    pub fn at(&self, time_s: f32) -> Option<sward::Sphere> {
        let after = self.path.partition_point(|key| key.time_s <= time_s);
        let next = self.path.get(after).or(self.path.last())?;
        let last = self.path.get(after.saturating_sub(1)).unwrap_or(next);
        let span_s = next.time_s - last.time_s;
        let t = if span_s > 0.0 { ((time_s - last.time_s) / span_s).clamp(0.0, 1.0) } else { 0.0 };
        Some(sward::Sphere {
            center: last.center.lerp(next.center, t),
            radius: last.radius + (next.radius - last.radius) * t,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(time_s: f32, x: f32) -> SphereKey {
        SphereKey { time_s, center: Vec3::X * x, radius: 1.0 + x }
    }

    fn sphere(path: Vec<SphereKey>) -> MovingSphere {
        let (name, base_color) = (String::new(), [0.5; 3]);
        MovingSphere { name, path, visible: true, base_color, roughness: 0.5 }
    }

    #[test]
    fn moves_straight_and_rests_at_both_ends() {
        let ball = sphere(vec![key(1.0, 0.0), key(3.0, 4.0)]);
        let at = |t| ball.at(t).map(|s| (s.center.x, s.radius));
        assert_eq!(at(-3.0), Some((0.0, 1.0)));
        assert_eq!(at(1.0), Some((0.0, 1.0)));
        assert_eq!(at(1.5), Some((1.0, 2.0)));
        assert_eq!(at(9.0), Some((4.0, 5.0)));
        assert_eq!(sphere(vec![]).at(0.0), None);
        assert_eq!(sphere(vec![key(5.0, 2.0)]).at(0.0).map(|s| s.radius), Some(3.0));
    }
}
