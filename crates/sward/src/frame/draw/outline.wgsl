// The outline of a blade (J equations 22 and 24), and how it turns into the next level's.

// A dandelion's number among the shapes: its pixels are cut by lobes.wgsl.
const LOBED: u32 = 4u;

// Share of the width left at v: t(1, v) - t(0, v) of equation 22.
fn outline(shape: u32, tip: f32, v: f32) -> f32 {
    switch shape {
        case 0u, LOBED: { return 1.0; }
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
    // How far it lies outside the curve, likewise: see `outward`
    outward: f32,
}

// Straight pieces between points of a curve all lie inside it: a blade of two would look a pixel
// shorter and less bent than it is. So inner rings lie so far outside that their mean is right.
fn outward(segments: f32, ring: f32) -> f32 {
    if segments < 2.0 || ring < 0.5 || ring > segments - 0.5 {
        return 0.0;
    }
    return 1.0 / (6.0 * segments * (segments - 1.0));
}

fn ring_of(shape: u32, tip: f32, v: f32, morph: f32) -> Ring {
    let share = outline(shape, tip, v);
    let ring = u32(round(v * f32(SEGMENTS)));
    let pieces = f32(SEGMENTS);
    let own = outward(pieces, f32(ring));
    if (ring & 1u) == 0u {
        return Ring(0.0, share, mix(own, outward(0.5 * pieces, 0.5 * f32(ring)), morph));
    }
    let below = outward(0.5 * pieces, 0.5 * f32(ring) - 0.5);
    let above = outward(0.5 * pieces, 0.5 * f32(ring) + 0.5);
    let step = 1.0 / pieces;
    let chord = 0.5 * (outline(shape, tip, v - step) + outline(shape, tip, min(v + step, 1.0)));
    let beyond = mix(own, 0.5 * (below + above), morph);
    return Ring(morph * step * step, mix(share, chord, morph), beyond);
}

// A cut across the blade at v.
struct Section {
    // From the middle line to the vertex, in full widths
    edge: vec3<f32>,
    side: vec3<f32>,
    normal: vec3<f32>,
}

fn section(
    blade: Blade,
    knee: vec3<f32>,
    tip: vec3<f32>,
    form: vec4<f32>,
    v: f32,
    u: f32,
    thin: f32,
) -> Section {
    // Equation 21: b - a
    let along = unit_or(knee * (1.0 - 2.0 * v) + tip * v, blade.up);
    let flat_side = cross(blade.up, blade.facing);
    let side = unit_or(flat_side - along * dot(flat_side, along), flat_side);
    let shape = u32(form.w);
    let t = across(shape, outline(shape, form.y, v), select(u, 0.5, v == 1.0 && !FLAT_TIP), thin);
    return Section(side * (t - 0.5), side, cross(side, along));
}

// The same, with the rings that the next level lacks moved onto its edges.
fn morphed_section(
    blade: Blade,
    knee: vec3<f32>,
    tip: vec3<f32>,
    form: vec4<f32>,
    corner: Corner,
    ring: Ring,
    morph: f32,
    thin: f32,
) -> Section {
    var own = section(blade, knee, tip, form, corner.v, corner.u, thin);
    if SEGMENTS > 1u && ring.bend > 0.0 {
        let step = 1.0 / f32(SEGMENTS);
        // The next level has no middle line where this is the last with a ridge: its quads are cut
        // along the diagonal, onto which the middle moves
        let middle = RING == 3u && BUCKET % 4u == 1u && corner.u == 0.5;
        let low_u = select(corner.u, 1.0, middle);
        let high_u = select(corner.u, 0.0, middle);
        let low = section(blade, knee, tip, form, corner.v - step, low_u, thin);
        let high = section(blade, knee, tip, form, corner.v + step, high_u, thin);
        own.edge = mix(own.edge, 0.5 * (low.edge + high.edge), morph);
        own.side = mix(own.side, 0.5 * (low.side + high.side), morph);
        own.normal = mix(own.normal, 0.5 * (low.normal + high.normal), morph);
    }
    return own;
}

fn area_scale(kind: u32, level: u32, morph: f32) -> f32 {
    let own = page.species[kind].area_scale[level];
    return mix(own, page.species[kind].area_scale[min(level + 1u, 3u)], morph);
}
