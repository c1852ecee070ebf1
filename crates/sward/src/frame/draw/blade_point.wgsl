// A blade's surface by vertex pulling (J section 5).

override SEGMENTS: u32 = 8u;
// Vertices a ring: 2, or 3 with a ridge
override RING: u32 = 2u;
override FLAT_TIP: bool = false;

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
    // The mean that a thin blade is drawn towards, and how far it differs
    look: vec4<f32>,
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

// Equation 21, in heights: a ring's place on the curve, moved as its level asks.
fn curve_at(up: vec3<f32>, tip: vec3<f32>, knee: vec3<f32>, v: f32, ring: Ring) -> vec3<f32> {
    let a = knee * v;
    let b = mix(knee, tip, v);
    let bend = tip - 2.0 * knee;
    // Across the blade only: along it, every mark on it has its place. One direction for all of it,
    // so that levels agree where they change
    let along = unit_or(tip, up);
    let aside = bend - along * dot(bend, along);
    return mix(a, b, v) + bend * ring.bend - aside * ring.outward;
}

fn blade_point(vertex: u32, instance: u32) -> BladePoint {
    var out: BladePoint;
    let listed = listed_plant(vertex, instance);
    if listed.hidden {
        out.hidden = true;
        return out;
    }
    let morph = listed.morph;
    let fade = listed.fade;
    let blade = unpack_blade(listed.index);
    let state = unpack_state(blade, dynamics[listed.index]);
    let form = page.species[blade.species].form;
    let corner = corner_of(vertex % VERTICES);
    let ring = ring_of(u32(form.w), form.y, corner.v, morph);

    let knee = middle_point(state.tip, blade.up, blade.arch);
    let center = blade.root + curve_at(blade.up, state.tip, knee, corner.v, ring) * blade.height;

    let distance = distance_to(blade.root + blade.up * (0.5 * blade.height));
    let width_px = blade.width * pixels_per_metre(distance);
    var width = blade.width * fade * area_scale(blade.species, BUCKET % 4u, morph);
    var thin = 0.0;
    if has(CULL_DISTANCE) && !has(CULL_PAPER) {
        width *= widening(keep_share(width_px));
    } else if has(WIDTH_CORRECTION) {
        // Equation 24 makes tips as wide as roots, which covers more. Blades that are thinned out are
        // wide enough without
        thin = 1.0 - clamp((width_px - 1.0) / 2.0, 0.0, 1.0);
    }
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
    let enough = enough_share(blade, width_px);
    let tone = corner.v * (1.5 - 0.5 * corner.v) - 0.5 * ring.bend;
    out.albedo = blade_color(blade, depth_among(tone, enough));
    out.up = blade.up;
    out.root_open = form.z;
    out.look = thin_look(listed.index, width_px);
    out.u = corner.u;
    out.thin = thin;
    out.shape = u32(form.w);
    // A blade at rest runs so along its curve parameter
    out.height_share = depth_among(corner.v * (2.0 - corner.v) - ring.bend, enough);
    out.lean = lean_of(blade, state.tip);
    return out;
}
