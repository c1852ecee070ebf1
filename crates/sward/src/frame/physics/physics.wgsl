// The default model: an exact step of the linear recovery, and length by projection. Velocities
// and displacements are in units of the blade's height; equation numbers are J's.

const MAX_SUBSTEPS: f32 = 8.0;
// Largest k dt of a substep.
const SUBSTEP: f32 = 0.5;

// Recovery rate k, 1/s (equation 3).
fn recovery_rate(blade: Blade, crush: f32) -> f32 {
    return blade.response * max(1.0 - crush, 0.1);
}

// The pull of gravity at the root, without the species' droop (equation 4).
fn gravity_pull(root: vec3<f32>) -> vec3<f32> {
    let zero = vec3<f32>(0.0);
    let direction = safe_normalize(frame.gravity_direction.xyz, zero) * frame.gravity_direction.w;
    let center = safe_normalize(frame.gravity_center.xyz - root, zero) * frame.gravity_center.w;
    return mix(direction, center, frame.gravity_blend);
}

// Velocity by gravity (equations 4 to 6). The front part turns from the facing to the present
// lean as the blade lies down; otherwise a flattened blade swims towards its facing.
fn gravity_velocity(blade: Blade, tip: vec3<f32>) -> vec3<f32> {
    let pull = gravity_pull(blade.root);
    let flat = tip - blade.up * dot(tip, blade.up);
    let l = length(flat);
    let front = blade.facing * (1.0 - min(l / 0.3, 1.0)) + flat / max(l, 0.3);
    return (pull + front * (length(pull) * 0.25)) * (blade.droop * blade.response);
}

// Velocity by wind of strength `wind` (equations 7 and 8). Wind along the blade's width acts half.
fn wind_velocity(blade: Blade, tip: vec3<f32>, wind: vec3<f32>) -> vec3<f32> {
    let direction = safe_normalize(wind, vec3<f32>(0.0));
    let along = abs(dot(direction, safe_normalize(tip, blade.up)));
    let broadside = mix(1.0, abs(dot(direction, blade.facing)), 0.5);
    let height_ratio = dot(tip, blade.up);
    let share = max(1.0 - along, 0.0) * height_ratio * broadside;
    return wind * (share * blade.gust * blade.response);
}

// Where the tip would go in `dt_s` were the forces those at `at`, and were it free of the length.
fn free_move(blade: Blade, tip: vec3<f32>, at: vec3<f32>, wind: vec3<f32>, k: f32, dt_s: f32)
    -> vec3<f32> {
    let force = gravity_velocity(blade, at) + wind_velocity(blade, at, wind);
    // (1 - e^-kdt) of the way to rest + force / k
    return (blade.up + force / k - tip) * (1.0 - exp(-k * dt_s));
}

// One substep by the midpoint rule. Only the move across the middle direction turns the blade:
// the part along it would shorten the lever and make the turn depend on dt.
fn substep(blade: Blade, tip: vec3<f32>, wind: vec3<f32>, k: f32, dt_s: f32) -> vec3<f32> {
    let half_move = free_move(blade, tip, tip, wind, k, 0.5 * dt_s);
    let middle = project_tip(tip + half_move, blade.up, blade.facing, blade.arch);
    let whole = free_move(blade, tip, middle, wind, k, dt_s);
    let reach_middle = length(middle);
    let direction = middle / reach_middle;
    let turn = whole - direction * dot(whole, direction);
    let start = safe_normalize(tip, blade.facing) * reach_middle;
    return project_tip(start + turn, blade.up, blade.facing, blade.arch);
}

// Advances a blade by `gap_s`, the time since it was last advanced: a frame, or a whole sleep.
// A sleep longer than four response times is cut to those: what came before is forgotten.
fn advance_sward(
    blade: Blade,
    state: BladeState,
    gap_s: f32,
    first_sphere: u32,
    sphere_count: u32,
) -> BladeState {
    if !(gap_s > 0.0) {
        return state;
    }
    let crush_end = max(state.crush - frame.crush_decay * gap_s, 0.0);
    let k_end = recovery_rate(blade, crush_end);
    let window = min(gap_s, MAX_SUBSTEPS * SUBSTEP / k_end);
    let count = clamp(ceil(k_end * window / SUBSTEP - 1e-3), 1.0, MAX_SUBSTEPS);
    let dt_s = window / count;
    var tip = project_tip(state.tip, blade.up, blade.facing, blade.arch);
    for (var i = 0.0; i < count; i += 1.0) {
        let ago = (count - i - 0.5) * dt_s;
        let crush = min(crush_end + frame.crush_decay * ago, state.crush);
        let wind = wind_at(blade.root, ago);
        tip = substep(blade, tip, wind, recovery_rate(blade, crush), dt_s);
    }
    var next = BladeState(tip, crush_end);
    let push = contact_largest(blade, tip, first_sphere, sphere_count);
    if dot(push, push) > 0.0 {
        next.tip = project_tip(tip + push, blade.up, blade.facing, blade.arch);
        // Contact holds the crush: it fades only over the part of the gap that was a sleep.
        let asleep = max(gap_s - frame.dt_s, 0.0);
        let held = max(state.crush - frame.crush_decay * asleep, 0.0);
        let bend = next.tip - blade.up;
        next.crush = max(held, min(dot(bend, bend), 2.0));
    }
    if !(is_finite3(next.tip) && is_finite(next.crush)) {
        return sound_state(blade, state);
    }
    return next;
}

// `state`, or an upright blade where it is not a number.
fn sound_state(blade: Blade, state: BladeState) -> BladeState {
    if is_finite3(state.tip) && is_finite(state.crush) {
        return state;
    }
    return BladeState(blade.up, 0.0);
}

// The tip of an undisturbed blade: the equilibrium of recovery and gravity.
fn rest_tip(blade: Blade) -> vec3<f32> {
    let dt_s = SUBSTEP / blade.response;
    var tip = blade.up;
    for (var i = 0u; i < 32u; i++) {
        tip = substep(blade, tip, vec3<f32>(0.0), blade.response, dt_s);
    }
    return select(blade.up, tip, is_finite3(tip));
}
