// How a box pushes a blade's tip, in units of the blade's height.

// Halvings of the search for the deepest point of a piece of the curve.
const SEARCH: u32 = 10u;
// A face that looks along up or against it by more than this is the top or the bottom.
const STEEP: f32 = 0.7;
// Of points as deep as each other the one nearest to the tip counts: it needs the least move.
const TOWARDS_TIP: f32 = 0.02;

struct Deepest {
    // In the box's axes
    point: vec3<f32>,
    // Parameter of the curve; below 0 where it does not meet the box
    t: f32,
}

struct WayOut {
    // Unit direction for a side; the normal for the bottom
    away: vec3<f32>,
    depth: f32,
    below: bool,
}

// Part of the segment start + u along, u in 0 to 1, that is inside a box: empty where x is not
// below y.
fn clip_to_box(start: vec3<f32>, along: vec3<f32>, half: vec3<f32>) -> vec2<f32> {
    var part = vec2<f32>(0.0, 1.0);
    for (var axis = 0u; axis < 3u; axis++) {
        let p = start[axis];
        let d = along[axis];
        let h = half[axis];
        if abs(d) < 1e-9 {
            if abs(p) >= h {
                return vec2<f32>(1.0, 0.0);
            }
            continue;
        }
        let a = (-h - p) / d;
        let b = (h - p) / d;
        part = vec2<f32>(max(part.x, min(a, b)), min(part.y, max(a, b)));
    }
    return part;
}

fn box_depth(point: vec3<f32>, half: vec3<f32>) -> f32 {
    let beyond = abs(point) - half;
    return max(beyond.x, max(beyond.y, beyond.z));
}

// The deepest point of the curve, taken as four straight pieces.
fn deepest_on_curve(blade: Blade, tip: vec3<f32>, seen: Cuboid) -> Deepest {
    let middle = middle_point(tip, blade.up, blade.arch);
    var best = Deepest(vec3<f32>(0.0), -1.0);
    var least = 0.0;
    var start = unturned(seen.turn, -seen.center);
    for (var i = 0u; i < 4u; i++) {
        let end = unturned(seen.turn, curve_point(middle, tip, f32(i + 1u) * 0.25) - seen.center);
        let along = end - start;
        var part = clip_to_box(start, along, seen.half);
        if part.x < part.y {
            for (var n = 0u; n < SEARCH; n++) {
                let third = (part.y - part.x) / 3.0;
                let low = part.x + third;
                let high = part.y - third;
                let deep_low = box_depth(start + along * low, seen.half) - TOWARDS_TIP * low;
                let deep_high = box_depth(start + along * high, seen.half) - TOWARDS_TIP * high;
                part = select(vec2<f32>(low, part.y), vec2<f32>(part.x, high), deep_low < deep_high);
            }
            let u = 0.5 * (part.x + part.y);
            let point = start + along * u;
            let rated = box_depth(point, seen.half) - TOWARDS_TIP * (u + f32(i));
            if best.t < 0.0 || rated < least {
                least = rated;
                best = Deepest(point, (f32(i) + u) * 0.25);
            }
        }
        start = end;
    }
    return best;
}

// The nearest face that a blade can leave a box by: a side, of which only what is not against `up`
// counts, or the bottom. The top is no way out for what is rooted below.
fn way_out(point: vec3<f32>, cuboid: Cuboid, up: vec3<f32>) -> WayOut {
    var best = WayOut(vec3<f32>(0.0), 1e30, false);
    for (var face = 0u; face < 6u; face++) {
        let axis = face >> 1u;
        let sign = 1.0 - 2.0 * f32(face & 1u);
        var local = vec3<f32>(0.0);
        local[axis] = sign;
        let normal = turned(cuboid.turn, local);
        let depth = cuboid.half[axis] - sign * point[axis];
        let rise = dot(normal, up);
        if rise > STEEP || best.depth <= depth {
            continue;
        }
        let below = rise < -STEEP;
        best = WayOut(select(normalize(normal - up * min(rise, 0.0)), normal, below), depth, below);
    }
    return best;
}

// How far the tip must move along its lean so that it comes down by `fall`.
fn lean_to_lower(blade: Blade, tip: vec3<f32>, fall: f32) -> f32 {
    let height = dot(tip, blade.up);
    let squared = dot(tip, tip);
    let low = max(height - fall, 0.05);
    let flat = sqrt(max(squared - height * height, 0.0));
    let stretched = sqrt(max(squared - low * low, 0.0)) / low * height;
    return clamp(stretched - flat, 0.0, PUSH_LIMIT);
}

fn cuboid_push(blade: Blade, tip: vec3<f32>, cuboid: Cuboid) -> vec3<f32> {
    let center = (cuboid.center - blade.root) / blade.height;
    let seen = Cuboid(center, cuboid.half / blade.height, cuboid.turn);
    if !(is_finite3(seen.center) && is_finite3(seen.half)) {
        return vec3<f32>(0.0);
    }
    let deepest = deepest_on_curve(blade, tip, seen);
    if deepest.t < 0.0 {
        return vec3<f32>(0.0);
    }
    let out = way_out(deepest.point, seen, blade.up);
    let moved = tip_move(max(out.depth, 0.0), deepest.t);
    let lean = lean_of(blade, tip);
    if out.below {
        return lean * lean_to_lower(blade, tip, moved);
    }
    return safe_normalize(out.away, lean) * moved;
}
