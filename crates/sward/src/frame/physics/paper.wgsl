// J's own model, equations 1 to 16 with the errata: an explicit step and one pass of the length
// correction. Velocities are in units of the blade's height; only the crush is in metres.

// The step is explicit: at s dt > 1 it would pass the rest pose, above 2 it would explode.
fn paper_step_s(blade: Blade, gap_s: f32) -> f32 {
    return min(gap_s, min(0.1, 1.0 / blade.response));
}

// Move of a point out of a sphere, metres (equation 14); `lean` where it is at the centre.
fn paper_push(point: vec3<f32>, sphere: vec4<f32>, lean: vec3<f32>) -> vec3<f32> {
    let to_center = sphere.xyz - point;
    let distance = length(to_center);
    let inside = min(distance - sphere.w, 0.0);
    return inside * safe_normalize(to_center, -lean);
}

// Collision of the tip and of the curve's midpoint (equations 14 to 16): xyz the tip's
// displacement, in heights; w what the crush gains. Positions are relative to the root, as a small
// blade far from the origin has few digits left otherwise.
fn paper_collision(blade: Blade, tip: vec3<f32>, first_sphere: u32, sphere_count: u32)
    -> vec4<f32> {
    let middle = middle_point(tip, blade.up, 0.0);
    let tip_m = tip * blade.height;
    let midpoint_m = (middle * 0.5 + tip * 0.25) * blade.height;
    let lean = safe_normalize(tip - blade.up * dot(tip, blade.up), blade.facing);
    var sum = vec4<f32>(0.0);
    for (var i = 0u; i < sphere_count; i++) {
        let sphere = near_sphere(first_sphere + i) - vec4<f32>(blade.root, 0.0);
        if !(is_finite3(sphere.xyz) && is_finite(sphere.w)) {
            continue;
        }
        let at_tip = paper_push(tip_m, sphere, lean);
        let at_midpoint = paper_push(midpoint_m, sphere, lean);
        // The midpoint moves by a quarter of what the tip moves.
        let displacement = (at_tip + 4.0 * at_midpoint) / blade.height;
        sum += vec4<f32>(displacement, dot(at_tip, at_tip) + dot(at_midpoint, at_midpoint));
    }
    return sum;
}

// Ground, and one pass of the length correction (equations 9 to 13). As v1 and v2 are both scaled
// by h / L about the root, the tip is as well.
fn paper_valid_tip(blade: Blade, moved: vec3<f32>) -> vec3<f32> {
    let tip = moved - blade.up * min(dot(blade.up, moved), 0.0);
    let middle = middle_point(tip, blade.up, 0.0);
    let chord = length(tip);
    let polygon = length(middle) + length(tip - middle);
    let approximate_length = (2.0 * chord + polygon) / 3.0;
    return tip / max(approximate_length, 1e-6);
}

// Advances a blade by one explicit step; time that the step cannot hold is lost, as it is there.
fn advance_paper(
    blade: Blade,
    state: BladeState,
    gap_s: f32,
    first_sphere: u32,
    sphere_count: u32,
) -> BladeState {
    if !(gap_s > 0.0) {
        return state;
    }
    let dt_s = paper_step_s(blade, gap_s);
    let tip = state.tip;
    let recovery = (blade.up - tip) * recovery_rate(blade, state.crush);
    let pull = gravity_pull(blade.root);
    let gravity =
        (pull + blade.facing * (length(pull) * 0.25)) * (blade.droop * blade.response);
    let wind = wind_velocity(blade, tip, wind_at(blade.root, 0.5 * dt_s));
    let hit = paper_collision(blade, tip, first_sphere, sphere_count);
    let moved = tip + (recovery + gravity + wind) * dt_s + hit.xyz;
    let crush = max(state.crush - frame.crush_decay * dt_s, 0.0) + hit.w;
    let next = BladeState(paper_valid_tip(blade, moved), clamp(crush, 0.0, 2.0));
    if !(is_finite3(next.tip) && is_finite(next.crush)) {
        return sound_state(blade, state);
    }
    return next;
}
