// A blade's surface by vertex pulling (J section 5): one instance is 64 blades of one bucket.

// Which bucket: level, and pointed (0 to 3) or flat-tipped (4 to 7).
override BUCKET: u32 = 0u;
override SEGMENTS: u32 = 8u;
// Vertices a ring: 2, or 3 with a ridge
override RING: u32 = 2u;
override FLAT_TIP: bool = false;
// Vertices a blade
override VERTICES: u32 = 17u;
// Whether `tints` holds a colour for each blade
override TINTED: bool = false;

@group(1) @binding(4) var<storage, read> dynamics: array<vec2<u32>>;
// The colour of the surface at each root, where TINTED
@group(1) @binding(5) var<storage, read> tints: array<u32>;
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

// 10 bits a channel, square root encoded.
fn unpack_color(bits: u32) -> vec3<f32> {
    let c = vec3<f32>(f32(bits & 0x3ffu), f32((bits >> 10u) & 0x3ffu), f32(bits >> 20u)) / 1023.0;
    return c * c;
}

// `tone` runs from the root's colour, 0, to the tip's, 1.
fn blade_color(blade: Blade, tone: f32) -> vec3<f32> {
    let pick = hash01(blade.id, 21u);
    let other = hash01(blade.id, 22u);
    let colors = species_table[blade.species].colors;
    let root = mix(unpack_color(colors.x), unpack_color(colors.y), other);
    let tip = mix(unpack_color(colors.z), unpack_color(colors.w), pick);
    var color = mix(root, tip, tone);
    if TINTED {
        let own = unpack_color(tints[blade.id - field.first_id]);
        color = mix(color, own * mix(0.8, 1.05, tone), species_table[blade.species].tint);
    }
    return color * (0.85 + 0.3 * other);
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
    // 0 upright, 1 flat
    lean: f32,
    // Place across, 0 to 1
    u: f32,
    // Share of the correction of equation 24
    thin: f32,
    shape: u32,
    // Beyond the end of the list
    hidden: bool,
}

fn blade_point(vertex: u32, instance: u32) -> BladePoint {
    var out: BladePoint;
    let slot = instance * BAND + vertex / VERTICES;
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

    let distance = distance_to(blade.root + blade.up * (0.5 * blade.height));
    let width_px = blade.width * pixels_per_metre(distance);
    var width = blade.width * fade * area_scale(blade.species, BUCKET % 4u, morph);
    if has(CULL_DISTANCE) && !has(CULL_PAPER) {
        width *= widening(keep_share(width_px));
    }
    let thin = select(0.0, 1.0 - clamp((width_px - 1.0) / 2.0, 0.0, 1.0), has(WIDTH_CORRECTION));
    let cut = morphed_section(blade, knee, state.tip, form, corner, ring, morph, thin);
    var normal = cut.normal;
    var position = center + cut.edge * width;
    if RING == 3u {
        // Equation 23, flattening as it turns into the level without a ridge
        let lift = form.x * select(1.0 - morph, 1.0, BUCKET % 4u == 0u) * ring.share;
        position += normal * (width * lift * (0.5 - abs(corner.u - 0.5)));
    }
    if dot(normal, view_ray(position)) > 0.0 {
        normal = -normal;
    }
    out.clip = view.clip_from_world * vec4<f32>(position, 1.0);
    out.position = position;
    out.normal = normal + cut.side * ((corner.u - 0.5) * 1.4 * form.x);
    // Both are quadratic in v, so that `bend` moves them, too, onto the next level's edges
    out.albedo = blade_color(blade, corner.v * (1.5 - 0.5 * corner.v) - 0.5 * ring.bend);
    out.up = blade.up;
    out.root_open = form.z;
    out.u = corner.u;
    out.thin = thin;
    out.shape = u32(form.w);
    // A blade at rest runs so along its curve parameter
    out.height_share = corner.v * (2.0 - corner.v) - ring.bend;
    out.lean = min(length(state.tip - blade.up * dot(state.tip, blade.up)), 1.0);
    return out;
}
