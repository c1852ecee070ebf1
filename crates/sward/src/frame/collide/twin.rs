//! How spheres push a blade's tip, the reference of `contact.wgsl`. Lengths are in units of the
//! blade's height.

use crate::Sphere;
use crate::frame::physics::twin::Blade;
use crate::shared::curve_twin::{curve_point, middle_point, safe_normalize};
use glam::DVec3;

/// Longest push of one step: beyond it only the direction of the tip would matter anyway.
const PUSH_LIMIT: f64 = 4.0;

/// A sphere as seen from the blade's root, in heights; none where it is not finite.
fn seen_from(blade: &Blade, sphere: &Sphere) -> Option<(DVec3, f64)> {
    let center = (sphere.center.as_dvec3() - blade.root) / blade.height;
    let radius = f64::from(sphere.radius) / blade.height;
    (center.is_finite() && radius.is_finite()).then_some((center, radius))
}

/// The point of the curve, taken as four straight pieces, that is nearest to `center`, and its
/// parameter.
fn nearest_on_curve(blade: &Blade, tip: DVec3, center: DVec3) -> (DVec3, f64) {
    let middle = middle_point(tip, blade.up, blade.arch);
    let mut nearest = (DVec3::ZERO, 0.0);
    for piece in 0..4 {
        let start = curve_point(middle, tip, f64::from(piece) * 0.25);
        let along = curve_point(middle, tip, f64::from(piece + 1) * 0.25) - start;
        let u = ((center - start).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
        let point = start + along * u;
        if point.distance_squared(center) < nearest.0.distance_squared(center) {
            nearest = (point, (f64::from(piece) + u) * 0.25);
        }
    }
    nearest
}

/// Displacement of the tip that moves the nearest point of the curve out of `sphere`; zero
/// without contact. J's two points (equations 14 and 15) let a ball lower than 0.75 h pass; the
/// whole curve does not.
pub fn contact_push(blade: &Blade, tip: DVec3, sphere: &Sphere) -> DVec3 {
    let Some((center, radius)) = seen_from(blade, sphere) else { return DVec3::ZERO };
    let (nearest, t) = nearest_on_curve(blade, tip, center);
    let depth = radius - nearest.distance(center);
    if depth <= 0.0 {
        return DVec3::ZERO;
    }
    // A point at the centre has no way out of its own: follow the present lean.
    let lean = safe_normalize(tip - blade.up * tip.dot(blade.up), blade.facing);
    let away = if nearest.distance_squared(center) > 1e-10 {
        safe_normalize(nearest - center, lean)
    } else {
        lean
    };
    // The curve moves by t^2 of what its tip moves (equation 15 has this for t = 1/2).
    away * (depth / (t * t).max(0.25)).min(PUSH_LIMIT)
}

/// The largest push of `spheres`.
pub fn contact_largest(blade: &Blade, tip: DVec3, spheres: &[Sphere]) -> DVec3 {
    spheres.iter().map(|sphere| contact_push(blade, tip, sphere)).fold(
        DVec3::ZERO,
        |largest, push| {
            if push.length_squared() > largest.length_squared() { push } else { largest }
        },
    )
}
