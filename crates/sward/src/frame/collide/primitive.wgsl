// What colliders are made of; the layout is documented in collide/primitive.rs.

const CAPSULE: u32 = 0u;
const SWEPT: u32 = 1u;
const CUBOID: u32 = 2u;

// A segment with a radius.
struct Round {
    start: vec3<f32>,
    end: vec3<f32>,
    radius: f32,
}

struct Cuboid {
    center: vec3<f32>,
    half: vec3<f32>,
    // World from its own axes, a unit quaternion
    turn: vec4<f32>,
}

fn kind_of(primitive: GpuPrimitive) -> u32 {
    return primitive.b.w & 3u;
}

fn round_of(primitive: GpuPrimitive) -> Round {
    let a = bitcast<vec4<f32>>(primitive.a);
    return Round(a.xyz, bitcast<vec3<f32>>(primitive.b.xyz), a.w);
}

fn turn_of(high: u32, low: u32) -> vec4<f32> {
    let steps = vec3<u32>((high >> 10u) & 0xfffffu, ((high & 0x3ffu) << 10u) | (low >> 22u),
        (low >> 2u) & 0xfffffu);
    let c = (vec3<f32>(steps) - 524287.0) * (0.70710678 / 524287.0);
    let d = sqrt(max(1.0 - dot(c, c), 0.0));
    switch high >> 30u {
        case 0u: { return vec4<f32>(d, c.x, c.y, c.z); }
        case 1u: { return vec4<f32>(c.z, d, c.x, c.y); }
        case 2u: { return vec4<f32>(c.y, c.z, d, c.x); }
        default: { return vec4<f32>(c.x, c.y, c.z, d); }
    }
}

fn cuboid_of(primitive: GpuPrimitive) -> Cuboid {
    let a = bitcast<vec4<f32>>(primitive.a);
    let half = vec3<f32>(a.w, bitcast<vec2<f32>>(primitive.b.xy));
    return Cuboid(a.xyz, half, turn_of(primitive.b.z, primitive.b.w));
}

fn turned(turn: vec4<f32>, v: vec3<f32>) -> vec3<f32> {
    return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v);
}

fn unturned(turn: vec4<f32>, v: vec3<f32>) -> vec3<f32> {
    return turned(vec4<f32>(-turn.xyz, turn.w), v);
}

// Square of the distance from a point to a segment.
fn to_axis_squared(point: vec3<f32>, round: Round) -> f32 {
    let axis = round.end - round.start;
    let along = clamp(dot(point - round.start, axis) / max(dot(axis, axis), 1e-12), 0.0, 1.0);
    let apart = point - (round.start + axis * along);
    return dot(apart, apart);
}

// Square of the distance from a point to a box along the axes.
fn to_box_squared(point: vec3<f32>, low: vec3<f32>, high: vec3<f32>) -> f32 {
    let apart = point - clamp(point, low, high);
    return dot(apart, apart);
}

// Whether a primitive may touch a ball.
fn meets_ball(primitive: GpuPrimitive, center: vec3<f32>, radius: f32) -> bool {
    if kind_of(primitive) == CUBOID {
        let cuboid = cuboid_of(primitive);
        let local = unturned(cuboid.turn, center - cuboid.center);
        return to_box_squared(local, -cuboid.half, cuboid.half) < radius * radius;
    }
    let round = round_of(primitive);
    let reach = round.radius + radius;
    return to_axis_squared(center, round) < reach * reach;
}
