// How a sphere pushes a blade's tip, in units of the blade's height.

// Longest push of one step: beyond it only the direction of the tip would matter anyway.
const PUSH_LIMIT: f32 = 4.0;

// Displacement of the tip that moves the nearest point of the curve out of `sphere` (xyz centre,
// w radius, metres); zero without contact. The curve is taken as four straight pieces.
fn contact_push(blade: Blade, tip: vec3<f32>, sphere: vec4<f32>) -> vec3<f32> {
    let center = (sphere.xyz - blade.root) / blade.height;
    let radius = sphere.w / blade.height;
    if !(is_finite3(center) && is_finite(radius)) {
        return vec3<f32>(0.0);
    }
    let middle = middle_point(tip, blade.up, blade.arch);
    var nearest = vec3<f32>(0.0);
    var nearest_t = 0.0;
    var nearest_squared = dot(center, center);
    var start = vec3<f32>(0.0);
    for (var i = 0u; i < 4u; i++) {
        let end = curve_point(middle, tip, f32(i + 1u) * 0.25);
        let along = end - start;
        let u = clamp(dot(center - start, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
        let point = start + along * u;
        let squared = dot(center - point, center - point);
        if squared < nearest_squared {
            nearest = point;
            nearest_t = (f32(i) + u) * 0.25;
            nearest_squared = squared;
        }
        start = end;
    }
    let depth = radius - sqrt(nearest_squared);
    if !(depth > 0.0) {
        return vec3<f32>(0.0);
    }
    // A point at the centre has no way out of its own: follow the present lean.
    let lean = safe_normalize(tip - blade.up * dot(tip, blade.up), blade.facing);
    let away = select(lean, safe_normalize(nearest - center, lean), nearest_squared > 1e-10);
    // The curve moves by t^2 of what its tip moves (J equation 15 has this for t = 1/2).
    return away * min(depth / max(nearest_t * nearest_t, 0.25), PUSH_LIMIT);
}

// The largest push of the spheres near this blade.
fn contact_largest(blade: Blade, tip: vec3<f32>, first_sphere: u32, sphere_count: u32)
    -> vec3<f32> {
    var largest = vec3<f32>(0.0);
    for (var i = 0u; i < sphere_count; i++) {
        let push = contact_push(blade, tip, near_sphere(first_sphere + i));
        if dot(push, push) > dot(largest, largest) {
            largest = push;
        }
    }
    return largest;
}
