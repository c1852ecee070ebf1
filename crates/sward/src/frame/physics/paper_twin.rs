//! J's own model of one blade (equations 1 to 16 with the errata), the reference of `paper.wgsl`:
//! an explicit step and one pass of the length correction.
//!
//! It takes the same scale-free species as the default model: its `|gE|` is `gamma s h` and its
//! `|wi|` is `beta gust s h`, so that both models can be compared on one scene. As in J, and
//! unlike the default, the crush is in squared metres (equation 16), and it depends on the frame
//! rate; v1 is not kept, but follows from the tip by equations 10 and 11.

use super::twin::{Blade, State, Surroundings, gravity_pull, recovery_rate, wind_velocity};
use crate::frame::collide::cuboid_twin::way_out;
use crate::frame::collide::primitive::Primitive;
use crate::shared::curve_twin::{middle_point, safe_normalize};
use glam::DVec3;

/// The step that is taken for a gap: at most 0.1 s and at most `1 / s`. It is explicit: beyond
/// `1 / s` it would pass the rest pose, beyond twice that it would explode. Time beyond it is lost.
pub fn step_s(blade: &Blade, gap_s: f64) -> f64 {
    gap_s.min(0.1).min(1.0 / blade.response)
}

/// Move of a point out of a sphere, metres (equation 14): the printed `min` keeps what is inside
/// only. `lean` is the way out for a point at the centre.
///
/// Ours, as J has spheres only: a capsule is the sphere on its axis that is nearest to the point,
/// and a box moves the point out of its nearest face, see `way_out`.
pub fn push_out(point: DVec3, primitive: &Primitive, blade: &Blade, lean: DVec3) -> DVec3 {
    match *primitive {
        Primitive::Capsule { from, to, radius } | Primitive::Swept { from, to, radius } => {
            let (from, axis) = (from.as_dvec3(), to.as_dvec3() - from.as_dvec3());
            let along = (point - from).dot(axis) / axis.length_squared().max(1e-12);
            let to_center = from + axis * along.clamp(0.0, 1.0) - point;
            let inside = (to_center.length() - f64::from(radius)).min(0.0);
            inside * safe_normalize(to_center, -lean)
        }
        Primitive::Cuboid { center, half_extents, rotation } => {
            let half = half_extents.as_dvec3();
            let local = Primitive::into_box(rotation, point - center.as_dvec3());
            if local.abs().cmpge(half).any() {
                return DVec3::ZERO;
            }
            way_out(local, half, rotation, blade.up)
                .map_or(DVec3::ZERO, |out| if out.below { lean } else { out.away } * out.depth)
        }
    }
}

/// Collision of the tip and of the curve's midpoint with all primitives (equations 14 to 16): the
/// tip's displacement in heights, and what the crush gains. The midpoint's move counts four times,
/// as it moves by a quarter of what the tip moves; the crush counts its own, before the four.
pub fn collision(blade: &Blade, tip: DVec3, primitives: &[Primitive]) -> (DVec3, f64) {
    let middle = middle_point(tip, blade.up, 0.0);
    let tip_m = blade.root + tip * blade.height;
    let midpoint_m = blade.root + (middle / 2.0 + tip / 4.0) * blade.height;
    let lean = safe_normalize(tip - blade.up * tip.dot(blade.up), blade.facing);
    let sound = primitives.iter().filter(|primitive| primitive.is_sound());
    sound.fold((DVec3::ZERO, 0.0), |(moved, crush), primitive| {
        let at_tip = push_out(tip_m, primitive, blade, lean);
        let at_midpoint = push_out(midpoint_m, primitive, blade, lean);
        let displacement = (at_tip + 4.0 * at_midpoint) / blade.height;
        (moved + displacement, crush + at_tip.length_squared() + at_midpoint.length_squared())
    })
}

/// Ground, and one pass of the length correction (equations 9 to 13). As v1 and v2 are both
/// scaled by `h / L` about the root, the tip is as well.
pub fn valid_tip(blade: &Blade, moved: DVec3) -> DVec3 {
    let tip = moved - blade.up * moved.dot(blade.up).min(0.0);
    let middle = middle_point(tip, blade.up, 0.0);
    let polygon = middle.length() + tip.distance(middle);
    let approximate_length = (2.0 * tip.length() + polygon) / 3.0;
    tip / approximate_length.max(1e-6)
}

/// Advances a blade by one explicit step of [`step_s`] (equations 1 to 16).
pub fn advance(blade: &Blade, state: State, gap_s: f64, around: &Surroundings) -> State {
    if gap_s.is_nan() || gap_s <= 0.0 {
        return state;
    }
    let dt_s = step_s(blade, gap_s);
    let tip = state.tip;
    let recovery = (blade.up - tip) * recovery_rate(blade, state.crush);
    let pull = gravity_pull(&around.gravity, blade.root);
    let front = blade.facing * (pull.length() / 4.0);
    let gravity = (pull + front) * (blade.droop * blade.response);
    let wind = wind_velocity(blade, tip, around.wind.strength_at_f64(blade.root, 0.5 * dt_s));
    let (hit, crushed) = collision(blade, tip, around.primitives);
    let moved = tip + (recovery + gravity + wind) * dt_s + hit;
    let crush = (state.crush - around.crush_decay * dt_s).max(0.0) + crushed;
    let next = State { tip: valid_tip(blade, moved), crush: crush.clamp(0.0, 2.0) };
    if next.is_finite() { next } else { state.sound(blade) }
}
