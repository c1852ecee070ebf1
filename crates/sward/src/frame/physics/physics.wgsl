// The default model: an exact step of the linear recovery, and length by projection. Velocities
// and displacements are in units of the blade's height; equation numbers are J's.

// A sleeping blade catches up in at most this many substeps.
const MAX_SUBSTEPS: u32 = 32u;
// Largest k dt of the last substep.
const SUBSTEP: f32 = 0.25;
// Each substep is this much longer than the next: what is long past is soon forgotten.
const SUBSTEP_GROWTH: f32 = 1.1;

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
// lean as the blade lies down; otherwise a flattened blade swims towards its facing. It turns
// beyond the lean of a blade at rest: else nothing would bring that blade back to its facing.
fn gravity_velocity(blade: Blade, tip: vec3<f32>) -> vec3<f32> {
    let pull = gravity_pull(blade.root);
    let flat = tip - blade.up * dot(tip, blade.up);
    let l = length(flat);
    let turned = smoothstep(0.4, 0.9, l);
    let front = blade.facing * (1.0 - turned) + flat * (turned / max(l, 0.1));
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

// The tip of an undisturbed blade, where recovery and gravity are even: of one that leans less than
// lets its front part turn.
fn rest_tip(blade: Blade) -> vec3<f32> {
    let pull = gravity_pull(blade.root);
    let sag = (pull + blade.facing * (length(pull) * 0.25)) * blade.droop;
    if is_paper_model() {
        return paper_valid_tip(blade, blade.up + sag);
    }
    return project_tip(blade.up + sag, blade.up, blade.facing, blade.arch);
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

// Crush after `seconds` without contact (equation 2).
fn crush_after(crush: f32, seconds: f32) -> f32 {
    return max(crush - frame.crush_decay * seconds, 0.0);
}

// The tip after `gap_s` of wind, gravity and recovery, in substeps that are longer the longer ago
// they are. A sleep that they cannot cover starts from recovery alone; they then forget it.
fn move_freely(blade: Blade, state: BladeState, gap_s: f32) -> vec3<f32> {
    let k_end = recovery_rate(blade, crush_after(state.crush, gap_s));
    // Lengths of the substeps in units of the last one's, and their number.
    var count = 1u;
    var total = 1.0;
    var first = 1.0;
    while count < MAX_SUBSTEPS && total * SUBSTEP < k_end * gap_s - 1e-3 {
        first *= SUBSTEP_GROWTH;
        total += first;
        count += 1u;
    }
    let window = min(gap_s, total * SUBSTEP / k_end);
    let skipped = gap_s - window;
    let k_skipped = recovery_rate(blade, crush_after(state.crush, skipped * 0.5));
    let woken = blade.up + (state.tip - blade.up) * exp(-k_skipped * skipped);
    var tip = project_tip(woken, blade.up, blade.facing, blade.arch);
    var dt_s = window * first / total;
    var ago = window;
    for (var i = 0u; i < count; i++) {
        let middle = ago - 0.5 * dt_s;
        let wind = wind_at(blade.root, middle);
        let k = recovery_rate(blade, crush_after(state.crush, gap_s - middle));
        tip = substep(blade, tip, wind, k, dt_s);
        ago -= dt_s;
        dt_s /= SUBSTEP_GROWTH;
    }
    return tip;
}

// Advances a blade by `gap_s`, the time since it was last advanced: a frame, or a whole sleep.
// `list` says which primitives are near.
fn advance_sward(
    blade: Blade,
    state: BladeState,
    gap_s: f32,
    list: u32,
) -> BladeState {
    if !(gap_s > 0.0) {
        return state;
    }
    let tip = move_freely(blade, state, gap_s);
    var next = BladeState(tip, crush_after(state.crush, gap_s));
    let hit = contact(blade, tip, list);
    if hit.bend > 0.0 {
        next.tip = hit.tip;
        // Contact holds the crush: it fades only over the part of the gap that was a sleep.
        let held = crush_after(state.crush, max(gap_s - frame.dt_s, 0.0));
        next.crush = max(held, min(hit.bend, 2.0));
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
