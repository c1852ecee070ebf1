// J's own model, equations 1 to 16 with the errata: an explicit step and one pass of the length
// correction. Velocities are in units of the blade's height; only the crush is in metres.

// The step is explicit: at s dt > 1 it would pass the rest pose, above 2 it would explode.
fn paper_step_s(blade: Blade, gap_s: f32) -> f32 {
    return min(gap_s, min(0.1, 1.0 / blade.response));
}

// Move of a point out of a primitive, metres, all relative to the root (equation 14); `lean` where
// it has no way of its own. Ours, as J has spheres only: a capsule is the sphere on its axis that is
// nearest to the point, and a box moves the point out of its nearest face.
fn paper_push(blade: Blade, point: vec3<f32>, primitive: GpuPrimitive, lean: vec3<f32>)
    -> vec3<f32> {
    if kind_of(primitive) == CUBOID {
        let cuboid = cuboid_of(primitive);
        let local = unturned(cuboid.turn, point - (cuboid.center - blade.root));
        if !all(abs(local) < cuboid.half) {
            return vec3<f32>(0.0);
        }
        let out = way_out(local, cuboid, blade.up);
        return select(out.away, lean, out.below) * out.depth;
    }
    let round = round_of(primitive);
    if !(is_finite3(round.start) && is_finite3(round.end) && is_finite(round.radius)) {
        return vec3<f32>(0.0);
    }
    let start = round.start - blade.root;
    let axis = round.end - round.start;
    let along = clamp(dot(point - start, axis) / max(dot(axis, axis), 1e-12), 0.0, 1.0);
    let to_center = start + axis * along - point;
    let inside = min(length(to_center) - round.radius, 0.0);
    return inside * safe_normalize(to_center, -lean);
}

// Collision of the tip and of the curve's midpoint (equations 14 to 16): xyz the tip's
// displacement, in heights; w what the crush gains. Positions are relative to the root, as a small
// blade far from the origin has few digits left otherwise.
fn paper_collision(blade: Blade, tip: vec3<f32>, list: u32) -> vec4<f32> {
    if !COLLIDERS {
        return vec4<f32>(0.0);
    }
    let middle = middle_point(tip, blade.up, 0.0);
    let tip_m = tip * blade.height;
    let midpoint_m = (middle * 0.5 + tip * 0.25) * blade.height;
    let lean = safe_normalize(tip - blade.up * dot(tip, blade.up), blade.facing);
    var sum = vec4<f32>(0.0);
    let radius = 1.001 * max(length(tip_m) * 0.5, distance(middle * blade.height, tip_m * 0.5));
    var at = near_begin(list, blade.root + tip_m * 0.5, radius);
    loop {
        let index = near_next(&at);
        if index == NO_PRIMITIVE {
            break;
        }
        tests_made++;
        let primitive = primitives[index];
        let at_tip = paper_push(blade, tip_m, primitive, lean);
        let at_midpoint = paper_push(blade, midpoint_m, primitive, lean);
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
    list: u32,
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
    let hit = paper_collision(blade, tip, list);
    let moved = tip + (recovery + gravity + wind) * dt_s + hit.xyz;
    let crush = max(state.crush - frame.crush_decay * dt_s, 0.0) + hit.w;
    let next = BladeState(paper_valid_tip(blade, moved), clamp(crush, 0.0, 2.0));
    if !(is_finite3(next.tip) && is_finite(next.crush)) {
        return sound_state(blade, state);
    }
    return next;
}
