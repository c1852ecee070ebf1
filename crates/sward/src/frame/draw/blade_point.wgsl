// A blade's surface by vertex pulling (J section 5): one instance is 64 blades of one bucket.

// Which bucket: level, and pointed (0 to 3) or flat-tipped (4 to 7).
override BUCKET: u32 = 0u;
override SEGMENTS: u32 = 8u;
// Vertices a ring: 2, or 3 with a ridge
override RING: u32 = 2u;
override FLAT_TIP: bool = false;
// Vertices a blade
override VERTICES: u32 = 17u;

struct GpuDraw {
    start: u32,
    count: u32,
    dropped: u32,
    reserved: u32,
}

@group(1) @binding(4) var<storage, read> dynamics: array<vec2<u32>>;
@group(2) @binding(1) var<storage, read> list: array<u32>;
@group(2) @binding(2) var<storage, read> draws: array<GpuDraw, 8>;

struct Corner {
    // Along the blade, 0 root to 1 tip
    v: f32,
    // Across it, 0 to 1
    u: f32,
}

fn corner_of(vertex: u32) -> Corner {
    let ring = vertex / RING;
    let v = f32(ring) / f32(SEGMENTS);
    if ring == SEGMENTS && !FLAT_TIP {
        return Corner(1.0, 0.5);
    }
    return Corner(v, f32(vertex % RING) / f32(RING - 1u));
}

// Share of the width left at v: t(1, v) - t(0, v) of equation 22.
fn outline(shape: u32, tip: f32, v: f32) -> f32 {
    switch shape {
        case 0u: { return 1.0; }
        case 1u: { return 1.0 - v; }
        case 2u: { return 1.0 - v * v; }
        default: { return 1.0 - max(v - tip, 0.0) / (1.0 - tip); }
    }
}

// Equation 22 with the width correction of 24: place across the full width, 0 to 1.
fn across(shape: u32, share: f32, u: f32, thin: f32) -> f32 {
    let t = select(0.5 + (u - 0.5) * share, u * share, shape == 2u);
    return mix(t, u, thin);
}

// Rings that the next level lacks move onto its edges as the blade turns into it.
struct Ring {
    // Curve parameter's odd part: how far to move along the second difference
    bend: f32,
    share: f32,
}

fn ring_of(shape: u32, tip: f32, v: f32, morph: f32) -> Ring {
    let share = outline(shape, tip, v);
    let ring = u32(round(v * f32(SEGMENTS)));
    if (ring & 1u) == 0u {
        return Ring(0.0, share);
    }
    let step = 1.0 / f32(SEGMENTS);
    let chord = 0.5 * (outline(shape, tip, v - step) + outline(shape, tip, min(v + step, 1.0)));
    return Ring(morph * step * step, mix(share, chord, morph));
}

fn area_scale(kind: u32, level: u32, morph: f32) -> f32 {
    let own = species_table[kind].area_scale[level];
    return mix(own, species_table[kind].area_scale[min(level + 1u, 3u)], morph);
}

// 10 bits a channel, square root encoded.
fn unpack_color(bits: u32) -> vec3<f32> {
    let c = vec3<f32>(f32(bits & 0x3ffu), f32((bits >> 10u) & 0x3ffu), f32(bits >> 20u)) / 1023.0;
    return c * c;
}

fn blade_color(blade: Blade, v: f32) -> vec3<f32> {
    let pick = hash01(blade.id, 21u);
    let other = hash01(blade.id, 22u);
    let colors = species_table[blade.species].colors;
    let root = mix(unpack_color(colors.x), unpack_color(colors.y), other);
    let tip = mix(unpack_color(colors.z), unpack_color(colors.w), pick);
    return mix(root, tip, v * (1.5 - 0.5 * v)) * (0.85 + 0.3 * other);
}

// A point of a blade's surface.
struct BladePoint {
    clip: vec4<f32>,
    position: vec3<f32>,
    // Rounded across the width, on the eye's side
    normal: vec3<f32>,
    albedo: vec3<f32>,
    up: vec3<f32>,
    height_share: f32,
    root_open: f32,
    // Beyond the end of the list
    hidden: bool,
}

fn blade_point(vertex: u32, instance: u32) -> BladePoint {
    var out: BladePoint;
    let slot = instance * 64u + vertex / VERTICES;
    if slot >= draws[BUCKET].count {
        out.hidden = true;
        return out;
    }
    let entry = list[draws[BUCKET].start + slot];
    let index = entry & 0x3fffffu;
    let morph = f32((entry >> 22u) & 31u) / 31.0;
    let fade = f32(entry >> 27u) / 31.0;
    let blade = unpack_blade(index);
    let state = unpack_state(blade, dynamics[index]);
    let form = species_table[blade.species].form;
    let corner = corner_of(vertex % VERTICES);
    let ring = ring_of(u32(form.w), form.y, corner.v, morph);

    // Equation 21, in heights
    let knee = middle_point(state.tip, blade.up, blade.arch);
    let a = knee * corner.v;
    let b = mix(knee, state.tip, corner.v);
    let bend = state.tip - 2.0 * knee;
    let center = blade.root + (mix(a, b, corner.v) + bend * ring.bend) * blade.height;
    let along = unit_or(b - a, blade.up);
    let flat_side = cross(blade.up, blade.facing);
    let side = unit_or(flat_side - along * dot(flat_side, along), flat_side);
    var normal = cross(side, along);

    let distance = distance_to(blade.root + blade.up * (0.5 * blade.height));
    let width_px = blade.width * pixels_per_metre(distance);
    var width = blade.width * fade * area_scale(blade.species, BUCKET % 4u, morph);
    if has(CULL_DISTANCE) && !has(CULL_PAPER) {
        width *= widening(keep_share(width_px));
    }
    let thin = select(0.0, 1.0 - clamp((width_px - 1.0) / 2.0, 0.0, 1.0), has(WIDTH_CORRECTION));
    let t = across(u32(form.w), ring.share, corner.u, thin);
    var position = center + side * ((t - 0.5) * width);
    if RING == 3u {
        // Equation 23, flattening as it turns into the level without a ridge
        let lift = form.x * select(1.0 - morph, 1.0, BUCKET % 4u == 0u) * ring.share;
        position += normal * (width * lift * (0.5 - abs(corner.u - 0.5)));
    }
    if dot(normal, view.eye.xyz - position) < 0.0 {
        normal = -normal;
    }
    out.clip = view.clip_from_world * vec4<f32>(position, 1.0);
    out.position = position;
    out.normal = normal + side * ((corner.u - 0.5) * 1.4 * form.x);
    out.albedo = blade_color(blade, corner.v);
    out.up = blade.up;
    out.root_open = form.z;
    // A blade at rest runs so along its curve parameter. One that lies over its neighbours is in the
    // light along its length: so a gust shows as it passes
    let at_rest = corner.v * (2.0 - corner.v);
    let flat_tip = state.tip - blade.up * dot(state.tip, blade.up);
    out.height_share = at_rest + (1.0 - at_rest) * 0.7 * min(dot(flat_tip, flat_tip), 1.0);
    return out;
}
