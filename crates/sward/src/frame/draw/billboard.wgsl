// Plants as textured quads about their up direction (Wang and Yao): 11 with all quads, of two pieces
// each, which turns into 12 with half of them, of one.

// Pieces of a quad from bottom to top
override PIECES: u32 = 2u;

struct QuadVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) place: vec2<f32>,
    @location(1) @interpolate(perspective, centroid) position: vec3<f32>,
    @location(2) @interpolate(perspective, centroid) side: vec3<f32>,
    @location(3) @interpolate(perspective, centroid) along: vec3<f32>,
    // From the plant's middle line
    @location(4) @interpolate(perspective, centroid) offset: vec3<f32>,
    @location(5) @interpolate(flat) up: vec3<f32>,
    // Light at the roots, lean, tone, absorption
    @location(6) @interpolate(flat) looks: vec4<f32>,
    // Width and height, metres; how far it may be turned from the eye, as cosines: gone, and whole
    @location(7) @interpolate(flat) size: vec4<f32>,
    @location(8) @interpolate(flat) layer: u32,
}

// Quads turned away from the eye go: seen edge-on one is a line that no plant has, and one that is turned
// less shows heads and leaves where those of the quad that faces the eye are not. Where quads are spread
// evenly one always faces it, and the one that comes shows before the one that turns away is gone.
fn facing_range(quads: u32, is_even: bool) -> vec2<f32> {
    if quads < 2u || !is_even {
        return vec2<f32>(0.1, 0.3);
    }
    let step = 3.14159265 / f32(quads);
    return vec2<f32>(0.9 * cos(step), cos(step * 0.667));
}

fn quad_fade(quads: u32, angle: f32, morph: f32) -> vec2<f32> {
    let is_even = abs(f32(quads) * angle - 3.14159265) < 0.1;
    return mix(facing_range(quads, is_even), facing_range(far_quads(quads), true), morph);
}

// How much of a quad is left that lies so to the eye.
fn facing_share(face: vec3<f32>, up: vec3<f32>, to_eye: vec3<f32>, gone_whole: vec2<f32>) -> f32 {
    // Seen from above all quads are turned away, and none goes
    let level = to_eye - up * dot(to_eye, up);
    let low = length(level);
    let turned = smoothstep(gone_whole.x, gone_whole.y, abs(dot(face, level)) / max(low, 1e-4));
    return mix(1.0, turned, smoothstep(0.25, 0.6, low));
}

fn quad_vertex(vertex: u32, instance: u32) -> QuadVertex {
    var out: QuadVertex;
    out.clip = HIDDEN;
    let listed = listed_plant(vertex, instance);
    if listed.hidden {
        return out;
    }
    let kind = (blades[listed.index].y >> 16u) & 0xffu;
    let look = page.species[kind].look;
    let quads = look.w & 0xffu;
    let corner = vertex % VERTICES;
    let quad = corner / (2u * (PIECES + 1u));
    let row = (corner / 2u) % (PIECES + 1u);
    let morph = select(listed.morph, 1.0, BUCKET == FAR_BILLBOARD_BUCKET);
    if quad >= select(quads, far_quads(quads), BUCKET == FAR_BILLBOARD_BUCKET) {
        return out;
    }
    let blade = unpack_blade(listed.index);
    let state = unpack_state(blade, dynamics[listed.index]);
    let values = page.species[kind].look_values;
    let shape = quad_of(quad, quads, values.x, morph);
    let distance = distance_to(blade.root + blade.up * (0.5 * blade.height));
    let share = band_keep(distance, band_stretch(blade.id), plant_keep(blade.width, distance));
    let grown = listed.fade * mix(1.0, view.far_size, morph);
    let size = vec2<f32>(blade.width * listed.fade * widening(share), blade.height * grown);
    let at = vec2<f32>(f32(corner % 2u), f32(row) / f32(PIECES));
    // Wind from the side turns the plant
    let twist = values.y * dot(state.tip, cross(blade.up, blade.facing));
    let wide = vec2<f32>(size.x * shape.width, size.y);
    let point = morphed_point(blade, state.tip, wide, shape.turn, twist, at, morph);
    let lean = lean_of(blade, state.tip);
    out.clip = view.clip_from_world * vec4<f32>(point.position, 1.0);
    out.place = at;
    out.position = point.position;
    out.side = point.side;
    out.along = point.along;
    out.offset = point.position - point.center;
    out.up = blade.up;
    let tone = plant_tone(blade.id, lean, values.z);
    out.looks = vec4<f32>(page.species[kind].form.z, lean, tone, values.w);
    out.size = vec4<f32>(size, quad_fade(quads, values.x, morph));
    out.layer = quad_layer(look, blade.id, quad);
    return out;
}

@vertex
fn vs_quad(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> QuadVertex {
    return quad_vertex(vertex, instance);
}

@fragment
fn fs_quad(in: QuadVertex, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    let uv = vec2<f32>(in.place.x, 1.0 - in.place.y);
    let color = textureSample(plant_color, picture_sampler, uv, in.layer);
    let shape = textureSample(plant_normal, picture_sampler, uv, in.layer);
    let to_eye = -view_ray(in.position);
    let face = unit_or(cross(in.side, in.along), in.up);
    let facing_eye = dot(face, to_eye);
    let alpha = outline_alpha(color.a, facing_share(face, in.up, to_eye, in.size.zw));
    if alpha < least_alpha() {
        discard;
    }
    let n = shape.xyz * 2.0 - 1.0;
    let toward = face * select(-1.0, 1.0, facing_eye >= 0.0);
    var surface: BladeSurface;
    surface.albedo = color.rgb * color.rgb * in.looks.z;
    surface.normal = unit_or(in.side * n.x + in.along * n.y + toward * n.z, toward);
    surface.up = in.up;
    surface.height_share = in.place.y;
    surface.root_open = in.looks.x;
    surface.lean = in.looks.y;
    surface.shaded = sun_shade(in.position);
    surface.absorbed =
        absorbed_within(in.offset, in.up, in.size.xy, in.place.y, in.looks.w);
    surface.blocked = 1.0 - 2.0 * shape.a;
    let lit = with_haze(shade_blade(surface, to_eye), distance_to(in.position));
    return vec4<f32>(max(lit, vec3<f32>(0.0)), alpha);
}
