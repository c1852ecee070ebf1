//! The reference of quads.wgsl.

use crate::shared::curve_twin::{middle_point, safe_normalize};
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// A plant of quads: its frame, its tip, relative to the root and in heights, and its size.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plant {
    pub(crate) root: DVec3,
    pub(crate) up: DVec3,
    pub(crate) facing: DVec3,
    pub(crate) tip: DVec3,
    pub(crate) arch: f64,
    /// Width and height, metres.
    pub(crate) size: DVec2,
    /// How far its top is turned, radians.
    pub(crate) twist: f64,
}

/// Quads left far off.
pub(crate) fn far_quads(quads: u32) -> u32 {
    quads.div_ceil(2)
}

/// Angle of a quad, and the share of its width that is left.
pub(crate) fn quad_of(quad: u32, quads: u32, angle: f64, morph: f64) -> (f64, f64) {
    let left = far_quads(quads);
    if quad >= left {
        return (f64::from(quad) * angle, 1.0 - morph);
    }
    let even = PI / f64::from(left);
    (f64::from(quad) * (angle + (even - angle) * morph), 1.0)
}

impl Plant {
    /// A corner: `u` across, `v` the share of the height.
    pub(crate) fn corner(&self, turn: f64, u: f64, v: f64) -> DVec3 {
        let knee = middle_point(self.tip, self.up, self.arch);
        let t = 1.0 - (1.0 - v).sqrt();
        let (a, b) = (knee * t, knee.lerp(self.tip, t));
        let center = self.root + a.lerp(b, t) * self.size.y;
        let along = safe_normalize(b - a, self.up);
        let (sin, cos) = (turn + self.twist * v).sin_cos();
        let level = self.up.cross(self.facing) * cos - self.facing * sin;
        let side = level - (self.up + along) * (level.dot(along) / (1.0 + self.up.dot(along)));
        center + side * ((u - 0.5) * self.size.x)
    }

    /// The same, its middle row on the way to the far form.
    pub(crate) fn morphed(&self, turn: f64, u: f64, v: f64, morph: f64) -> DVec3 {
        let own = self.corner(turn, u, v);
        if v <= 0.0 || v >= 1.0 {
            return own;
        }
        let straight = self.corner(turn, u, 0.0).lerp(self.corner(turn, u, 1.0), v);
        own.lerp(straight, morph)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{dvec2, dvec3};

    fn upright() -> Plant {
        Plant {
            root: dvec3(1.0, 2.0, 3.0),
            up: DVec3::Y,
            facing: DVec3::Z,
            tip: DVec3::Y,
            arch: 0.0,
            size: dvec2(0.4, 0.6),
            twist: 0.0,
        }
    }

    /// Wang and Yao's corners run from y to y + height over the base point, and are not half buried.
    #[test]
    fn quads_stand_on_their_base_point() {
        for quad in 0..3 {
            let (turn, _) = quad_of(quad, 3, PI / 3.0, 0.0);
            let corner = |u, v| upright().corner(turn, u, v) - upright().root;
            assert!(corner(0.5, 0.0).length() < 1e-12);
            assert!(
                (corner(0.5, 0.3).y - 0.18).abs() < 1e-12,
                "upright, pictures are not stretched"
            );
            for u in [0.0, 1.0] {
                assert!(corner(u, 0.0).y.abs() < 1e-12 && (corner(u, 1.0).y - 0.6).abs() < 1e-12);
                assert!((corner(u, 0.7).with_y(0.0).length() - 0.2).abs() < 1e-12);
            }
            let across = (corner(1.0, 0.0) - corner(0.0, 0.0)).normalize();
            let first = upright().corner(0.0, 1.0, 0.0) - upright().root;
            assert!((across.angle_between(first) - f64::from(quad) * PI / 3.0).abs() < 1e-6);
        }
    }

    #[test]
    fn a_bent_plant_keeps_its_width_and_its_angles() {
        let tip = dvec3(0.6, 0.7, 0.2);
        let plant = Plant { tip, ..upright() };
        for v in [0.0, 0.3, 1.0] {
            let side = |turn| plant.corner(turn, 1.0, v) - plant.corner(turn, 0.0, v);
            let (a, b) = (side(0.0), side(PI / 3.0));
            assert!((a.length() - 0.4).abs() < 1e-12 && (b.length() - 0.4).abs() < 1e-12);
            assert!((a.angle_between(b) - PI / 3.0).abs() < 1e-9);
        }
    }

    #[test]
    fn far_quads_are_fewer_and_even() {
        assert_eq!([1, 2, 3, 4, 6].map(far_quads), [1, 1, 2, 2, 3]);
        for quads in 1..=6 {
            let angle = PI / f64::from(quads);
            let far: Vec<_> = (0..quads).map(|q| quad_of(q, quads, angle, 1.0)).collect();
            let left = far.iter().filter(|(_, width)| *width == 1.0).count() as u32;
            assert_eq!(left, far_quads(quads));
            assert!(far.iter().skip(left as usize).all(|(_, width)| *width == 0.0));
            let step = PI / f64::from(left);
            for (i, (turn, _)) in far.iter().take(left as usize).enumerate() {
                assert!((turn - step * i as f64).abs() < 1e-12);
            }
        }
    }
}
