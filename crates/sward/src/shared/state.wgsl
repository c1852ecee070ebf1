// The dynamic state in 8 bytes. The direction of the tip is kept in the blade's own frame, where
// the upper half space suffices: a tip is never under its root plane.

// A power of two, so that what is unpacked packs to the same bits.
const CRUSH_STEP: f32 = 1.0 / 32768.0;

fn to_local(blade: Blade, v: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(dot(v, cross(blade.up, blade.facing)), dot(v, blade.up), dot(v, blade.facing));
}

fn to_world(blade: Blade, v: vec3<f32>) -> vec3<f32> {
    return cross(blade.up, blade.facing) * v.x + blade.up * v.y + blade.facing * v.z;
}

// Upper half octahedron, turned by 45 degrees so that it fills the square.
fn half_oct_encode(v: vec3<f32>) -> vec2<f32> {
    let p = v.xz / max(abs(v.x) + max(v.y, 0.0) + abs(v.z), 1e-12);
    return vec2<f32>(p.x + p.y, p.x - p.y);
}

fn half_oct_decode(e: vec2<f32>) -> vec3<f32> {
    let p = vec2<f32>(e.x + e.y, e.x - e.y) * 0.5;
    return normalize(vec3<f32>(p.x, max(1.0 - abs(p.x) - abs(p.y), 0.0), p.y));
}

fn to_bits(x: f32, half_range: f32) -> u32 {
    return u32(i32(round(clamp(x, -1.0, 1.0) * half_range)) + i32(half_range));
}

// A frame takes some dozen steps off the crush. Rounded the same way each frame, the error would
// add up; so the place where it is rounded changes from frame to frame, evenly.
fn crush_bits(crush: f32) -> u32 {
    let x = clamp(crush / CRUSH_STEP, 0.0, 65535.0);
    let whole = floor(x);
    let threshold = f32((frame.step * 2654435769u) >> 8u) / 16777216.0;
    return u32(whole) + select(0u, 1u, x - whole > threshold);
}

fn pack_state(blade: Blade, state: BladeState) -> vec2<u32> {
    let crush = crush_bits(state.crush);
    let length = sqrt(dot(state.tip, state.tip));
    var v = to_local(blade, state.tip);
    if !(length > 1e-6) {
        v = vec3<f32>(0.0, 0.0, 1.0);
    }
    let e = half_oct_encode(v);
    if is_paper_model() {
        // 17 + 17 bits direction, 14 bits length up to 1.25 heights, 16 bits crush
        let x = to_bits(e.x, 65535.0);
        let y = to_bits(e.y, 65535.0);
        let l = u32(round(clamp(length / 1.25, 0.0, 1.0) * 16383.0));
        return vec2<u32>(x | (y << 17u), (y >> 15u) | (l << 2u) | (crush << 16u));
    }
    // 24 + 24 bits direction, 16 bits crush
    let x = to_bits(e.x, 8388607.0);
    let y = to_bits(e.y, 8388607.0);
    return vec2<u32>(x | ((crush & 0xffu) << 24u), y | ((crush >> 8u) << 24u));
}

fn unpack_state(blade: Blade, bits: vec2<u32>) -> BladeState {
    var state: BladeState;
    if is_paper_model() {
        let x = bits.x & 0x1ffffu;
        let y = (bits.x >> 17u) | ((bits.y & 3u) << 15u);
        let e = vec2<f32>(f32(x), f32(y)) / 65535.0 - 1.0;
        let l = f32((bits.y >> 2u) & 0x3fffu) * (1.25 / 16383.0);
        state.tip = to_world(blade, half_oct_decode(e)) * l;
        state.crush = f32(bits.y >> 16u) * CRUSH_STEP;
        return state;
    }
    let e = (vec2<f32>(vec2<i32>(bits & vec2<u32>(0xffffffu))) - 8388607.0) / 8388607.0;
    let v = half_oct_decode(e);
    let lean = sqrt(v.x * v.x + v.z * v.z);
    state.tip = to_world(blade, v) * reach(v.y, lean, blade.arch);
    state.crush = f32((bits.x >> 24u) | ((bits.y >> 24u) << 8u)) * CRUSH_STEP;
    return state;
}
