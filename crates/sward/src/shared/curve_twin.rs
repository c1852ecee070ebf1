//! The blade's curve: a quadratic Bezier from the root, in units of the blade's height. The
//! reference of `curve.wgsl`; equation numbers are J's (Jahrmann & Wimmer 2017).

use glam::DVec3;

/// `v` of unit length, or `fallback` where `v` has no direction.
pub(crate) fn safe_normalize(v: DVec3, fallback: DVec3) -> DVec3 {
    let size = v.abs().max_element();
    if !(v.is_finite() && size > 1e-12 && size < 1e30) {
        return fallback;
    }
    (v / size).normalize()
}

/// Correction of the curve's size: 1 for J's own rule (`arch` 0). Under an arch, J's estimate of
/// the length (equation 12) is up to 16 % off; this fit brings the true arc length to within
/// 1.9 % of the height for every lean of 0 to 90 degrees and every arch of 0 to 1.
fn arch_scale(sin_lean: f64, arch: f64) -> f64 {
    let s = sin_lean;
    1.0 + arch * s * (0.0921 - 0.0616 * s + arch * (0.0654 - 0.242 * s))
}

/// Chord length `|v2 - v0| / h` of a blade of full length whose chord leans by this angle from
/// `up`. `arch` is kappa, 0 (J's rule for v1) to 1 (v1 stays at full height).
///
/// With `n = 2`, equation 12 says `L = (2 L0 + L1) / 3`, where `L0 = rho` and
/// `L1 = f + |v2 - v1|`, and v1 is at height f above the root. `L = 1` gives
/// `|v2 - v1| = 3 - 2 rho - f`; squared, and with `|v2 - v1|^2 = rho^2 - 2 rho f cos + f^2`:
/// `3 rho^2 - 12 rho + 9 - 6 f + 4 rho f + 2 rho f cos = 0`. Equation 11 in its usual range,
/// `f = 1 - c rho` with `c = (1 - kappa) sin`, makes it a quadratic, as does its floor, f = 0.05.
/// The first one's discriminant is written with `1 - cos` factored out as `sin^2 / (1 + cos)`:
/// as printed it is 36 - 36 for an upright blade, and its square root would magnify the rounding.
pub fn reach(cos_lean: f64, sin_lean: f64, arch: f64) -> f64 {
    let c = (1.0 - arch) * sin_lean;
    let versine = sin_lean * sin_lean / (1.0 + cos_lean.max(0.0));
    let q = versine * (7.0 - cos_lean - 12.0 * c) + 9.0 * c * c;
    let mut rho = 3.0 / (4.0 - 3.0 * c - cos_lean + q.max(0.0).sqrt());
    if 1.0 - c * rho < 0.05 {
        let e = 11.8 - 0.1 * cos_lean;
        rho = (e - (e * e - 104.4).sqrt()) / 6.0;
    }
    rho * arch_scale(sin_lean, arch)
}

/// `(v1 - v0) / h` for a tip `(v2 - v0) / h` (equations 10 and 11, softened by the arch).
pub fn middle_point(tip: DVec3, up: DVec3, arch: f64) -> DVec3 {
    let l = (tip - up * tip.dot(up)).length();
    let scale = arch_scale(l / tip.length().max(1e-6), arch);
    up * (scale - (1.0 - arch) * l).max(0.05 * l.max(scale))
}

/// The curve at `t` in `0..=1`, relative to the root.
pub fn curve_point(middle: DVec3, tip: DVec3, t: f64) -> DVec3 {
    middle * (2.0 * t * (1.0 - t)) + tip * (t * t)
}

/// The pose nearest to `tip`: above the root plane (equation 9), on the same ray from the root,
/// and of full length. Where the tip is at the root, the blade lies along `facing`.
pub fn project_tip(tip: DVec3, up: DVec3, facing: DVec3, arch: f64) -> DVec3 {
    let above = tip - up * tip.dot(up).min(0.0);
    let direction = safe_normalize(above, facing);
    let cos_lean = direction.dot(up).max(0.0);
    let sin_lean = (direction - up * cos_lean).length().min(1.0);
    direction * reach(cos_lean, sin_lean, arch)
}

/// True arc length of a blade of unit height, by summing `pieces` chords.
pub fn arc_length(middle: DVec3, tip: DVec3, pieces: u32) -> f64 {
    let at = |i: u32| curve_point(middle, tip, f64::from(i) / f64::from(pieces));
    (0..pieces).map(|i| at(i).distance(at(i + 1))).sum()
}
