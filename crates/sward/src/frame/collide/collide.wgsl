// Colliders near each patch: one thread a patch. Primitives come in chunks of 64 that are near each
// other, with a box; a patch lists the chunks that it meets, with a bit for each member.

// A patch's list: slots of resting chunks and of all, 8 bits each; the first chunk that found no
// place; then a chunk and its two words of bits a slot
@group(2) @binding(0) var<storage, read_write> near: array<u32>;
@group(2) @binding(1) var<storage, read_write> work: array<vec2<u32>>;
@group(2) @binding(2) var<storage, read_write> work_size: array<atomic<u32>, 12>;

struct Bounds {
    low: vec3<f32>,
    high: vec3<f32>,
}

struct Ball {
    center: vec3<f32>,
    radius: f32,
}

fn bounds_of(primitive: GpuPrimitive) -> Bounds {
    if kind_of(primitive) == CUBOID {
        let cuboid = cuboid_of(primitive);
        let reach = abs(turned(cuboid.turn, vec3<f32>(cuboid.half.x, 0.0, 0.0)))
            + abs(turned(cuboid.turn, vec3<f32>(0.0, cuboid.half.y, 0.0)))
            + abs(turned(cuboid.turn, vec3<f32>(0.0, 0.0, cuboid.half.z)));
        return Bounds(cuboid.center - reach, cuboid.center + reach);
    }
    let round = round_of(primitive);
    return Bounds(min(round.start, round.end) - round.radius, max(round.start, round.end) + round.radius);
}

fn ball_of(primitive: GpuPrimitive) -> Ball {
    if kind_of(primitive) == CUBOID {
        let cuboid = cuboid_of(primitive);
        return Ball(cuboid.center, length(cuboid.half));
    }
    let round = round_of(primitive);
    return Ball((round.start + round.end) * 0.5, distance(round.start, round.end) * 0.5 + round.radius);
}

fn overlap(a: Bounds, b: Bounds) -> bool {
    return all(a.low <= b.high) && all(b.low <= a.high);
}

fn meets(primitive: GpuPrimitive, reach: Bounds) -> bool {
    if !overlap(bounds_of(primitive), reach) {
        return false;
    }
    let ball = ball_of(primitive);
    return to_box_squared(ball.center, reach.low, reach.high) < ball.radius * ball.radius;
}

// Bits of the members of a chunk that the box meets.
fn members_near(chunk: u32, reach: Bounds) -> vec2<u32> {
    let header = chunk * CHUNK_STRIDE;
    let entry = primitives[header];
    var bits = vec2<u32>(0u);
    if !overlap(Bounds(bitcast<vec3<f32>>(entry.a.xyz), bitcast<vec3<f32>>(entry.b.xyz)), reach) {
        return bits;
    }
    for (var i = 0u; i < entry.a.w; i++) {
        if meets(primitives[header + 1u + i], reach) {
            let bit = 1u << (i & 31u);
            bits |= select(vec2<u32>(bit, 0u), vec2<u32>(0u, bit), i >= 32u);
        }
    }
    return bits;
}

@compute @workgroup_size(64)
fn collide(@builtin(global_invocation_id) thread: vec3<u32>) {
    let index = thread.x;
    if index >= page.field.patch_count {
        return;
    }
    let list = index * NEAR_STRIDE;
    let reach = Bounds(patches[index].reach_min, patches[index].reach_max);
    var chunk = 0u;
    var resting_slots = 0u;
    var rest = frame.chunk_count;
    if frame.keep_resting != 0u {
        chunk = frame.resting_chunks;
        resting_slots = near[list] & 0xffu;
        // What found no place then has none now
        rest = select(rest, near[list + 1u], near[list + 1u] < frame.resting_chunks);
    }
    var slots = resting_slots;
    var moving = false;
    for (; chunk < frame.chunk_count; chunk++) {
        let bits = members_near(chunk, reach);
        if (bits.x | bits.y) == 0u {
            continue;
        }
        moving |= chunk >= frame.resting_chunks;
        if slots == NEAR_SLOTS {
            rest = min(rest, chunk);
        }
        if rest < frame.chunk_count {
            continue;
        }
        let slot = list + 2u + 3u * slots;
        near[slot] = chunk;
        near[slot + 1u] = bits.x;
        near[slot + 2u] = bits.y;
        slots++;
        resting_slots += u32(chunk < frame.resting_chunks);
    }
    near[list] = resting_slots | (slots << 8u);
    near[list + 1u] = rest;
    // What rests wakes no one
    if moving {
        let count = patch_blades(index);
        let groups = (count + BAND - 1u) / BAND;
        let slot = atomicAdd(&work_size[BAND_GROUPS], groups);
        for (var b = 0u; b < groups; b++) {
            work[slot + b] = work_entry(index, false, count, b);
        }
    }
    if rest < frame.chunk_count {
        atomicAdd(&work_size[PATCHES_CROWDED], 1u);
    }
}
