//! How a box pushes a blade's tip, the reference of `cuboid.wgsl`.

use super::primitive::Primitive;
use super::twin::{PUSH_LIMIT, lean, tip_move};
use crate::frame::physics::twin::Blade;
use crate::shared::curve_twin::{curve_point, middle_point, safe_normalize};
use glam::{DVec3, Quat, Vec3};

/// Halvings of the search for the deepest point of a piece of the curve.
const SEARCH: u32 = 10;
/// A face that looks along up or against it by more than this is the top or the bottom.
const STEEP: f64 = 0.7;
/// Of points as deep as each other the one nearest to the tip counts: it needs the least move.
const TOWARDS_TIP: f64 = 0.02;

/// A box as seen from the blade's root, in heights.
struct Seen {
    center: DVec3,
    half: DVec3,
    rotation: Quat,
}

impl Seen {
    fn local(&self, point: DVec3) -> DVec3 {
        Primitive::into_box(self.rotation, point - self.center)
    }
}

/// Part of a segment `start + u along`, u in 0 to 1, that is inside a box.
fn clip(start: DVec3, along: DVec3, half: DVec3) -> Option<(f64, f64)> {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..3 {
        let (p, d, h) = (start[axis], along[axis], half[axis]);
        if d.abs() < 1e-9 {
            if p.abs() >= h {
                return None;
            }
            continue;
        }
        let (a, b) = ((-h - p) / d, (h - p) / d);
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    (enter < leave).then_some((enter, leave))
}

/// Where along the segment, between `enter` and `leave`, it is deepest.
fn deepest(seen: &Seen, start: DVec3, along: DVec3, enter: f64, leave: f64) -> (f64, f64) {
    let depth = |u: f64| ((start + along * u).abs() - seen.half).max_element() - TOWARDS_TIP * u;
    let (mut low, mut high) = (enter, leave);
    for _ in 0..SEARCH {
        let third = (high - low) / 3.0;
        if depth(low + third) < depth(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    let u = 0.5 * (low + high);
    (u, depth(u))
}

/// The deepest point of the curve, in the box's axes, and its parameter.
fn deepest_on_curve(blade: &Blade, tip: DVec3, seen: &Seen) -> Option<(DVec3, f64)> {
    let middle = middle_point(tip, blade.up, blade.arch);
    let mut best: Option<(DVec3, f64)> = None;
    let mut least = 0.0;
    for piece in 0..4 {
        let from = f64::from(piece);
        let start = seen.local(curve_point(middle, tip, from * 0.25));
        let along = seen.local(curve_point(middle, tip, (from + 1.0) * 0.25)) - start;
        let Some((enter, leave)) = clip(start, along, seen.half) else { continue };
        let (u, depth) = deepest(seen, start, along, enter, leave);
        let rated = depth - TOWARDS_TIP * from;
        if best.is_none() || rated < least {
            least = rated;
            best = Some((start + along * u, (from + u) * 0.25));
        }
    }
    best
}

/// A way out of a box.
pub(crate) struct WayOut {
    /// Unit direction for a side; the normal for the bottom.
    pub(crate) away: DVec3,
    /// How far that way.
    pub(crate) depth: f64,
    /// Whether it is through the bottom.
    pub(crate) below: bool,
}

/// The nearest face that a blade can leave a box by: a side, of which only what is not against
/// `up` counts, or the bottom. The top is no way out for what is rooted below.
pub(crate) fn way_out(point: DVec3, half: DVec3, rotation: Quat, up: DVec3) -> Option<WayOut> {
    let mut best: Option<WayOut> = None;
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let normal = rotation.as_dquat() * (DVec3::AXES[axis] * sign);
            let depth = half[axis] - sign * point[axis];
            let rise = normal.dot(up);
            if rise > STEEP || best.as_ref().is_some_and(|b| b.depth <= depth) {
                continue;
            }
            let below = rise < -STEEP;
            let away = if below { normal } else { (normal - up * rise.min(0.0)).normalize() };
            best = Some(WayOut { away, depth, below });
        }
    }
    best
}

/// How far the tip must move along its lean so that it comes down by `fall`.
fn lean_to_lower(blade: &Blade, tip: DVec3, fall: f64) -> f64 {
    let (height, length) = (tip.dot(blade.up), tip.length());
    let target = (height - fall).max(0.05);
    let flat = (length * length - height * height).max(0.0).sqrt();
    let stretched = (length * length - target * target).max(0.0).sqrt() / target * height;
    (stretched - flat).clamp(0.0, PUSH_LIMIT)
}

pub(super) fn cuboid_push(
    blade: &Blade,
    tip: DVec3,
    center: Vec3,
    half_extents: Vec3,
    rotation: Quat,
) -> DVec3 {
    let seen = Seen {
        center: (center.as_dvec3() - blade.root) / blade.height,
        half: half_extents.as_dvec3() / blade.height,
        rotation,
    };
    let Some((point, t)) = deepest_on_curve(blade, tip, &seen) else { return DVec3::ZERO };
    let Some(out) = way_out(point, seen.half, rotation, blade.up) else { return DVec3::ZERO };
    let lean = lean(blade, tip);
    let moved = tip_move(out.depth.max(0.0), t);
    if out.below {
        return lean * lean_to_lower(blade, tip, moved);
    }
    safe_normalize(out.away, lean) * moved
}
