// How colliders push a blade's tip, in units of the blade's height.

// Longest push of one step: beyond it only the direction of the tip would matter anyway.
const PUSH_LIMIT: f32 = 4.0;
// A ball that moved is passed in pieces no longer than this share of its radius,
const PIECE: f32 = 0.0625;
// and no more of them than this.
const MOST_PIECES: f32 = 16.0;

// Tests of this blade against primitives, counted to be reported.
var<private> tests_made: u32;

// What contact leaves of a blade: its tip, and the farthest from upright that it was on the way,
// squared; 0 without contact.
struct Hit {
    tip: vec3<f32>,
    bend: f32,
}

struct Nearest {
    // From the segment to the curve
    apart: vec3<f32>,
    // Parameter of the curve
    t: f32,
}

// Parameters of the nearest points of p + u d and q + v e, both within 0 to 1. Of parallel ones
// the pair nearest to the first's start.
fn nearest_of_segments(p: vec3<f32>, d: vec3<f32>, q: vec3<f32>, e: vec3<f32>) -> vec2<f32> {
    let r = p - q;
    let a = max(dot(d, d), 1e-12);
    let b = dot(d, e);
    let c = dot(d, r);
    let ee = dot(e, e);
    let f = dot(e, r);
    if ee < 1e-12 {
        return vec2<f32>(clamp(-c / a, 0.0, 1.0), 0.0);
    }
    // As |d x e|^2: a ee - b b cancels
    let across = cross(d, e);
    let slant = dot(across, across);
    var u = 0.0;
    if slant > 1e-6 * a * ee {
        u = clamp((b * f - c * ee) / slant, 0.0, 1.0);
    }
    let v = clamp((b * u + f) / ee, 0.0, 1.0);
    return vec2<f32>(clamp((b * v - c) / a, 0.0, 1.0), v);
}

// Where the curve, taken as four straight pieces, is nearest to the segment.
fn nearest_on_curve(blade: Blade, tip: vec3<f32>, round: Round) -> Nearest {
    let middle = middle_point(tip, blade.up, blade.arch);
    let axis = round.end - round.start;
    var nearest = Nearest(vec3<f32>(1e18), 0.0);
    var start = vec3<f32>(0.0);
    for (var i = 0u; i < 4u; i++) {
        let end = curve_point(middle, tip, f32(i + 1u) * 0.25);
        let along = end - start;
        let at = nearest_of_segments(start, along, round.start, axis);
        let apart = start + along * at.x - (round.start + axis * at.y);
        if dot(apart, apart) < dot(nearest.apart, nearest.apart) {
            nearest = Nearest(apart, (f32(i) + at.x) * 0.25);
        }
        start = end;
    }
    return nearest;
}

fn lean_of(blade: Blade, tip: vec3<f32>) -> vec3<f32> {
    return safe_normalize(tip - blade.up * dot(tip, blade.up), blade.facing);
}

// Displacement of the tip that moves the curve by `depth` at its parameter t. The curve moves by
// t^2 of what its tip moves (J equation 15 has this for t = 1/2).
fn tip_move(depth: f32, t: f32) -> f32 {
    return min(depth / max(t * t, 0.25), PUSH_LIMIT);
}

fn round_push(blade: Blade, tip: vec3<f32>, round: Round) -> vec3<f32> {
    let nearest = nearest_on_curve(blade, tip, round);
    let squared = dot(nearest.apart, nearest.apart);
    let depth = round.radius - sqrt(squared);
    if !(depth > 0.0) {
        return vec3<f32>(0.0);
    }
    // A point on the axis has no way out of its own: follow the present lean.
    let lean = lean_of(blade, tip);
    let away = select(lean, safe_normalize(nearest.apart, lean), squared > 1e-10);
    return away * tip_move(depth, nearest.t);
}

// A round as seen from the blade's root, in heights. Of what is not finite none is left.
fn seen_round(blade: Blade, primitive: GpuPrimitive) -> Round {
    var round = round_of(primitive);
    round.start = (round.start - blade.root) / blade.height;
    round.end = (round.end - blade.root) / blade.height;
    round.radius /= blade.height;
    if !(is_finite3(round.start) && is_finite3(round.end) && is_finite(round.radius)) {
        return Round(vec3<f32>(0.0), vec3<f32>(0.0), -1.0);
    }
    return round;
}

// Displacement of the tip that moves the curve out of a primitive; zero without contact.
fn contact_push(blade: Blade, tip: vec3<f32>, primitive: GpuPrimitive) -> vec3<f32> {
    if kind_of(primitive) == CUBOID {
        return cuboid_push(blade, tip, cuboid_of(primitive));
    }
    return round_push(blade, tip, seen_round(blade, primitive));
}

// A ball that moved, passed in pieces, one after the other, as a ball that moves slowly would push
// the blade: before it, then down.
fn pass_swept(blade: Blade, tip: vec3<f32>, whole: Round) -> Hit {
    let axis = whole.end - whole.start;
    let count = clamp(ceil(length(axis) / (PIECE * whole.radius)), 1.0, MOST_PIECES);
    var hit = Hit(tip, 0.0);
    for (var i = 0.0; i < count; i += 1.0) {
        let piece = Round(whole.start + axis * (i / count), whole.start + axis * ((i + 1.0) / count),
            whole.radius);
        let push = round_push(blade, hit.tip, piece);
        if dot(push, push) > 0.0 {
            hit.tip = project_tip(hit.tip + push, blade.up, blade.facing, blade.arch);
            let bend = hit.tip - blade.up;
            hit.bend = max(hit.bend, dot(bend, bend));
        }
    }
    return hit;
}

// Moves a blade out of the way of that primitive near it which pushes it most. `list` says which
// are near.
fn contact(blade: Blade, tip: vec3<f32>, list: u32) -> Hit {
    if !COLLIDERS {
        return Hit(tip, 0.0);
    }
    // The curve lies in the triangle of its control points; a little more for rounding
    let middle = middle_point(tip, blade.up, blade.arch);
    let half_tip = tip * 0.5;
    let radius = 1.001 * blade.height * max(length(half_tip), distance(middle, half_tip));
    let center = blade.root + half_tip * blade.height;
    var at = near_begin(list, center, radius);
    var largest = vec3<f32>(0.0);
    var winner = NO_PRIMITIVE;
    loop {
        let index = near_next(&at);
        if index == NO_PRIMITIVE {
            break;
        }
        tests_made++;
        let primitive = primitives[index];
        if !meets_ball(primitive, center, radius) {
            continue;
        }
        let push = contact_push(blade, tip, primitive);
        if dot(push, push) > dot(largest, largest) {
            largest = push;
            winner = index;
        }
    }
    if winner == NO_PRIMITIVE {
        return Hit(tip, 0.0);
    }
    let primitive = primitives[winner];
    if kind_of(primitive) == SWEPT {
        return pass_swept(blade, tip, seen_round(blade, primitive));
    }
    let moved = project_tip(tip + largest, blade.up, blade.facing, blade.arch);
    let bend = moved - blade.up;
    return Hit(moved, dot(bend, bend));
}
