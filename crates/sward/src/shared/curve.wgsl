// The blade's curve: a quadratic Bezier from the root, in units of the blade's height.

// `v` of unit length, or `fallback` where `v` has no direction.
fn safe_normalize(v: vec3<f32>, fallback: vec3<f32>) -> vec3<f32> {
    let size = max(abs(v.x), max(abs(v.y), abs(v.z)));
    if !(size > 1e-12 && size < 1e30) {
        return fallback;
    }
    let scaled = v / size;
    return scaled / sqrt(dot(scaled, scaled));
}

// The same for vectors of about unit size, which need no scaling.
fn unit_or(v: vec3<f32>, fallback: vec3<f32>) -> vec3<f32> {
    let square = dot(v, v);
    return select(fallback, v * inverseSqrt(max(square, 1e-12)), square > 1e-12);
}

// By the bits: a compiler may assume that no NaN exists and fold `x != x`.
fn is_finite(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7f800000u) != 0x7f800000u;
}

fn is_finite3(v: vec3<f32>) -> bool {
    return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}

// Correction of the curve's size: 1 for J's own rule; under an arch J's estimate of the length
// (equation 12) is up to 16 % off. Fitted, so that the true arc length is h within 1.9 %.
fn arch_scale(sin_lean: f32, arch: f32) -> f32 {
    let s = sin_lean;
    return 1.0 + arch * s * (0.0921 - 0.0616 * s + arch * (0.0654 - 0.242 * s));
}

// Chord length |v2 - v0| / h of a blade of full length at this lean: J equation 12 solved for it.
// In the quadratic's discriminant 1 - cos is factored out, as its plain form cancels near 0 lean.
fn reach(cos_lean: f32, sin_lean: f32, arch: f32) -> f32 {
    let c = (1.0 - arch) * sin_lean;
    let versine = sin_lean * sin_lean / (1.0 + max(cos_lean, 0.0));
    let q = versine * (7.0 - cos_lean - 12.0 * c) + 9.0 * c * c;
    var rho = 3.0 / (4.0 - 3.0 * c - cos_lean + sqrt(max(q, 0.0)));
    if 1.0 - c * rho < 0.05 {
        let e = 11.8 - 0.1 * cos_lean;
        rho = (e - sqrt(e * e - 104.4)) / 6.0;
    }
    return rho * arch_scale(sin_lean, arch);
}

// (v1 - v0) / h for a tip (v2 - v0) / h: J equations 10 and 11, softened by the arch.
fn middle_point(tip: vec3<f32>, up: vec3<f32>, arch: f32) -> vec3<f32> {
    let l = length(tip - up * dot(tip, up));
    let scale = arch_scale(l / max(length(tip), 1e-6), arch);
    return up * max(scale - (1.0 - arch) * l, 0.05 * max(l, scale));
}

// The curve at t in 0..1, relative to the root.
fn curve_point(middle: vec3<f32>, tip: vec3<f32>, t: f32) -> vec3<f32> {
    return middle * (2.0 * t * (1.0 - t)) + tip * (t * t);
}

// The pose nearest to `tip`: above the root plane (J equation 9), on the same ray, of full length.
fn project_tip(tip: vec3<f32>, up: vec3<f32>, facing: vec3<f32>, arch: f32) -> vec3<f32> {
    let above = tip - up * min(dot(tip, up), 0.0);
    let direction = safe_normalize(above, facing);
    let cos_lean = max(dot(direction, up), 0.0);
    let flat = direction - up * cos_lean;
    return direction * reach(cos_lean, min(length(flat), 1.0), arch);
}
