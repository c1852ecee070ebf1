//! How colliders push a blade's tip, the reference of `contact.wgsl`. Lengths are in units of the
//! blade's height.

use super::cuboid_twin::cuboid_push;
use super::primitive::Primitive;
use crate::frame::physics::twin::Blade;
use crate::shared::curve_twin::{curve_point, middle_point, project_tip, safe_normalize};
use glam::{DVec3, Vec3};

/// Longest push of one step: beyond it only the direction of the tip would matter anyway.
pub(super) const PUSH_LIMIT: f64 = 4.0;
/// A ball that moved is passed in pieces no longer than this share of its radius,
const PIECE: f64 = 0.0625;
/// and no more of them than this.
const MOST_PIECES: f64 = 16.0;

/// A segment with a radius, as seen from the blade's root.
#[derive(Debug, Clone, Copy)]
pub(super) struct Round {
    from: DVec3,
    to: DVec3,
    radius: f64,
}

impl Round {
    fn seen_from(blade: &Blade, from: Vec3, to: Vec3, radius: f32) -> Self {
        let seen = |p: Vec3| (p.as_dvec3() - blade.root) / blade.height;
        Self { from: seen(from), to: seen(to), radius: f64::from(radius) / blade.height }
    }

    fn piece(&self, index: u32, count: u32) -> Self {
        let at = |i: u32| self.from.lerp(self.to, f64::from(i) / f64::from(count));
        Self { from: at(index), to: at(index + 1), radius: self.radius }
    }

    fn pieces(&self) -> u32 {
        let count = (self.from.distance(self.to) / (PIECE * self.radius)).ceil();
        count.clamp(1.0, MOST_PIECES) as u32
    }
}

/// Where the curve, taken as four straight pieces, is nearest to the segment.
struct Nearest {
    /// From the segment to the curve.
    apart: DVec3,
    /// Parameter of the curve.
    t: f64,
}

/// Parameters of the nearest points of `p + u d` and `q + v e`, both within 0 to 1. Of parallel
/// ones the pair nearest to the first's start.
fn nearest_of_segments(p: DVec3, d: DVec3, q: DVec3, e: DVec3) -> (f64, f64) {
    let r = p - q;
    let (a, b, c) = (d.length_squared().max(1e-12), d.dot(e), d.dot(r));
    let (ee, f) = (e.length_squared(), e.dot(r));
    if ee < 1e-12 {
        return ((-c / a).clamp(0.0, 1.0), 0.0);
    }
    let slant = d.cross(e).length_squared();
    let u = if slant > 1e-6 * a * ee { ((b * f - c * ee) / slant).clamp(0.0, 1.0) } else { 0.0 };
    let v = ((b * u + f) / ee).clamp(0.0, 1.0);
    (((b * v - c) / a).clamp(0.0, 1.0), v)
}

fn nearest_on_curve(blade: &Blade, tip: DVec3, round: &Round) -> Nearest {
    let middle = middle_point(tip, blade.up, blade.arch);
    let axis = round.to - round.from;
    let mut nearest = Nearest { apart: DVec3::MAX, t: 0.0 };
    for piece in 0..4 {
        let start = curve_point(middle, tip, f64::from(piece) * 0.25);
        let along = curve_point(middle, tip, f64::from(piece + 1) * 0.25) - start;
        let (u, v) = nearest_of_segments(start, along, round.from, axis);
        let apart = start + along * u - (round.from + axis * v);
        if apart.length_squared() < nearest.apart.length_squared() {
            nearest = Nearest { apart, t: (f64::from(piece) + u) * 0.25 };
        }
    }
    nearest
}

/// The blade's lean: the way out for what has none of its own.
pub(super) fn lean(blade: &Blade, tip: DVec3) -> DVec3 {
    safe_normalize(tip - blade.up * tip.dot(blade.up), blade.facing)
}

/// Displacement of the tip that moves the curve by `depth` at its parameter `t`, at most 4. The
/// curve moves by t^2 of what its tip moves (J equation 15 has this for t = 1/2).
pub(super) fn tip_move(depth: f64, t: f64) -> f64 {
    (depth / (t * t).max(0.25)).min(PUSH_LIMIT)
}

fn round_push(blade: &Blade, tip: DVec3, round: &Round) -> DVec3 {
    let Nearest { apart, t } = nearest_on_curve(blade, tip, round);
    let depth = round.radius - apart.length();
    if depth.is_nan() || depth <= 0.0 {
        return DVec3::ZERO;
    }
    // A point on the axis has no way out of its own: follow the present lean.
    let lean = lean(blade, tip);
    let away = if apart.length_squared() > 1e-10 { safe_normalize(apart, lean) } else { lean };
    away * tip_move(depth, t)
}

/// Displacement of the tip that moves the nearest point of the curve out of a primitive; zero
/// without contact. J's two points (equations 14 and 15) let a ball lower than 0.75 h pass; the
/// whole curve does not.
pub fn contact_push(blade: &Blade, tip: DVec3, primitive: &Primitive) -> DVec3 {
    if !primitive.is_sound() {
        return DVec3::ZERO;
    }
    match *primitive {
        Primitive::Capsule { from, to, radius } | Primitive::Swept { from, to, radius } => {
            round_push(blade, tip, &Round::seen_from(blade, from, to, radius))
        }
        Primitive::Cuboid { center, half_extents, rotation } => {
            cuboid_push(blade, tip, center, half_extents, rotation)
        }
    }
}

/// What contact leaves of a blade.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// The tip, out of the way.
    pub tip: DVec3,
    /// The farthest from upright that it was on the way, squared.
    pub bend: f64,
}

/// Moves a blade out of the way of the primitive that pushes it most; none without contact.
///
/// A ball that moved is passed in pieces, one after the other, as a ball that moves slowly would
/// push the blade: before it, then down.
pub fn contact(blade: &Blade, tip: DVec3, primitives: &[Primitive]) -> Option<Hit> {
    let mut largest = (DVec3::ZERO, None);
    for primitive in primitives {
        let push = contact_push(blade, tip, primitive);
        if push.length_squared() > largest.0.length_squared() {
            largest = (push, Some(primitive));
        }
    }
    let (push, Some(primitive)) = largest else { return None };
    let moved = |tip| project_tip(tip, blade.up, blade.facing, blade.arch);
    let Primitive::Swept { from, to, radius } = *primitive else {
        let tip = moved(tip + push);
        return Some(Hit { tip, bend: tip.distance_squared(blade.up) });
    };
    let whole = Round::seen_from(blade, from, to, radius);
    let count = whole.pieces();
    let mut hit = Hit { tip, bend: 0.0 };
    for index in 0..count {
        let push = round_push(blade, hit.tip, &whole.piece(index, count));
        if push != DVec3::ZERO {
            hit.tip = moved(hit.tip + push);
            hit.bend = hit.bend.max(hit.tip.distance_squared(blade.up));
        }
    }
    (hit.bend > 0.0).then_some(hit)
}
