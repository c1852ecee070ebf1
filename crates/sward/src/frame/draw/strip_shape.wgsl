// The surface of a strip (O section 4).

// Segments along the strip, and in how many it turns as it becomes the next level's: a divisor
override SEGMENTS: u32 = 12u;
override COARSE: u32 = 3u;
// Share of the length at a curve parameter, for a speed that runs evenly from the root's to the tip's.
fn length_share(t: f32, knee: vec3<f32>, tip: vec3<f32>) -> f32 {
    let a = length(knee);
    let b = length(tip - knee);
    return clamp(t * (2.0 * a + (b - a) * t) / max(a + b, 1e-6), 0.0, 1.0);
}

fn turned_about(v: vec3<f32>, axis: vec3<f32>, angle: f32) -> vec3<f32> {
    let c = cos(angle);
    return v * c + cross(axis, v) * sin(angle) + axis * (dot(axis, v) * (1.0 - c));
}

// What bends a strip beyond its curve: O's sinusoid, on which each plant has a phase of its own.
struct Sway {
    axis: vec3<f32>,
    // Radians at the tip
    angle: f32,
}

fn sway_of(blade: Blade, tip: vec3<f32>) -> Sway {
    let wind = vec3<f32>(frame.sway.x, 0.0, frame.sway.y);
    let axis = cross(blade.up, wind);
    let strength = length(axis);
    if strength < 1e-6 {
        return Sway(blade.facing, 0.0);
    }
    let phase = frame.sway.z + 6.2831853 * hash01(blade.id, 24u);
    // One that lies on the ground has no room to sway
    let upright = clamp(1.5 * dot(tip, blade.up), 0.0, 1.0);
    let reach = min(strength * blade.gust, 2.0) * strip_values(blade.species).y;
    return Sway(axis / strength, reach * upright * sin(phase));
}

struct StripPoint {
    position: vec3<f32>,
    normal: vec3<f32>,
    side: vec3<f32>,
    // Of the length
    share: f32,
}

// A point of the surface: at curve parameter t, `across` from -1 to 1. Rings stand evenly by the
// parameter, nearer each other where the curve bends most, towards the tip.
fn strip_point(blade: Blade, tip: vec3<f32>, sway: Sway, width: f32, t: f32, across: f32) -> StripPoint {
    let knee = middle_point(tip, blade.up, blade.arch);
    let share = length_share(t, knee, tip);
    let center = knee * (2.0 * t * (1.0 - t)) + tip * (t * t);
    var along = unit_or(knee * (1.0 - 2.0 * t) + tip * t, blade.up);
    let flat_side = cross(blade.up, blade.facing);
    var side = unit_or(flat_side - along * dot(flat_side, along), flat_side);
    var normal = cross(side, along);
    // Grown from the root: each ring is bent further than the one below it
    let angle = sway.angle * share;
    let swayed = turned_about(center, sway.axis, angle);
    side = turned_about(side, sway.axis, angle);
    normal = turned_about(normal, sway.axis, angle);
    let fold = 0.5 * strip_values(blade.species).x;
    let edge = side * (across * cos(fold)) + normal * (abs(across) * sin(fold));
    let position = blade.root + swayed * blade.height + edge * (0.5 * width);
    return StripPoint(position, normal, side, share);
}

// The same, moved onto the edges of the coarser strip as the plant turns into it.
fn morphed_point(blade: Blade, tip: vec3<f32>, sway: Sway, width: f32, ring: u32, across: f32, morph: f32) -> StripPoint {
    let n = f32(SEGMENTS);
    var own = strip_point(blade, tip, sway, width, f32(ring) / n, across);
    let step = SEGMENTS / COARSE;
    let below = ring / step * step;
    if morph <= 0.0 || below == ring {
        return own;
    }
    let low = strip_point(blade, tip, sway, width, f32(below) / n, across);
    let high = strip_point(blade, tip, sway, width, f32(below + step) / n, across);
    let part = f32(ring - below) / f32(step);
    own.position = mix(own.position, mix(low.position, high.position, part), morph);
    own.normal = mix(own.normal, mix(low.normal, high.normal, part), morph);
    own.side = mix(own.side, mix(low.side, high.side, part), morph);
    own.share = mix(own.share, mix(low.share, high.share, part), morph);
    return own;
}
