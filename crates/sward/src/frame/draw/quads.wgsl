// Where the corners of a plant's quads are (Wang and Yao).

struct Quad {
    // Angle about up from the plant's own side, radians
    turn: f32,
    // Share of the width that is left
    width: f32,
}

// How many of the quads are left far off.
fn far_quads(quads: u32) -> u32 {
    return (quads + 1u) / 2u;
}

// On the way to the far form the quads that go grow narrow, and the others turn until they are spread
// evenly again.
fn quad_of(quad: u32, quads: u32, angle: f32, morph: f32) -> Quad {
    let left = far_quads(quads);
    if quad >= left {
        return Quad(f32(quad) * angle, 1.0 - morph);
    }
    let even = 3.14159265 / f32(left);
    return Quad(f32(quad) * mix(angle, even, morph), 1.0);
}

struct QuadPoint {
    position: vec3<f32>,
    // The plant's middle line there
    center: vec3<f32>,
    // Unit: across the quad, along the plant
    side: vec3<f32>,
    along: vec3<f32>,
}

// The plant bends as a blade does, equation 21 of J, and turns about its up direction, the more the
// higher, by `twist` at its top. `u` is across, 0 to 1, `v` the
// share of the height; size is width and height in metres.
fn quad_point(
    blade: Blade,
    tip: vec3<f32>,
    size: vec2<f32>,
    turn: f32,
    twist: f32,
    u: f32,
    v: f32,
) -> QuadPoint {
    let spine = spine_at(blade, tip, v);
    var point: QuadPoint;
    point.center = blade.root + spine.center * size.y;
    point.along = spine.along;
    let angle = turn + twist * v;
    let level = cross(blade.up, blade.facing) * cos(angle) - blade.facing * sin(angle);
    // The shortest turn from up to along, of a direction perpendicular to up
    let over = max(1.0 + dot(blade.up, point.along), 1e-3);
    point.side = level - (blade.up + point.along) * (dot(level, point.along) / over);
    point.position = point.center + point.side * ((u - 0.5) * size.x);
    return point;
}

// The same, the middle row moved onto the straight line between bottom and top as it morphs: the far
// form has no such row.
fn morphed_point(
    blade: Blade,
    tip: vec3<f32>,
    size: vec2<f32>,
    turn: f32,
    twist: f32,
    at: vec2<f32>,
    morph: f32,
) -> QuadPoint {
    var point = quad_point(blade, tip, size, turn, twist, at.x, at.y);
    if at.y <= 0.0 || at.y >= 1.0 || morph <= 0.0 {
        return point;
    }
    let low = quad_point(blade, tip, size, turn, twist, at.x, 0.0);
    let high = quad_point(blade, tip, size, turn, twist, at.x, 1.0);
    point.position = mix(point.position, mix(low.position, high.position, at.y), morph);
    point.center = mix(point.center, mix(low.center, high.center, at.y), morph);
    point.side = mix(point.side, mix(low.side, high.side, at.y), morph);
    point.along = mix(point.along, mix(low.along, high.along, at.y), morph);
    return point;
}
