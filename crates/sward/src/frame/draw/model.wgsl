// Modelled plants: the near form of plants of quads. A point of a ribbon a vertex, from a table, bent
// along the plant's curve; lit at each pixel as blades are.

// A row a variant of a kind; plants/mesh.rs has every bit
@group(1) @binding(11) var plant_models: texture_2d<u32>;

const MODEL_RANGE: f32 = 1.25;
// Thicknesses lie within 0..5, and a word's half has been scaled by the range of places
const THICKNESS_RANGE: f32 = 5.0 / MODEL_RANGE;

struct ModelPoint {
    // Widths across and forwards, heights upwards
    place: vec3<f32>,
    // Its normal; the direction of the ribbon where it is round
    direction: vec3<f32>,
    // Half of the width of a round ribbon, in widths of the plant, signed by side; 0 where it is flat
    half: f32,
    albedo: vec3<f32>,
    // As a surface's
    blocked: f32,
}

fn unpack_model_point(bits: vec4<u32>) -> ModelPoint {
    let xy = unpack2x16snorm(bits.x) * MODEL_RANGE;
    let z_half = unpack2x16snorm(bits.y) * MODEL_RANGE;
    let is_round = ((bits.z >> 30u) & 1u) == 1u;
    return ModelPoint(
        vec3<f32>(xy, z_half.x),
        oct_decode(unpack2x16snorm(bits.w)),
        select(0.0, z_half.y, is_round),
        unpack_color(bits.z & 0x3fffffffu),
        // Round ones are as thick as a blade; of the others the thickness stands for the width
        select(1.0 - 2.0 / (1.0 + z_half.y * THICKNESS_RANGE), 0.0, is_round),
    );
}

struct ModelVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) normal: vec3<f32>,
    @location(1) @interpolate(perspective, centroid) albedo: vec3<f32>,
    @location(2) @interpolate(perspective, centroid) position: vec3<f32>,
    // Share of the height, light that the plant keeps away
    @location(3) @interpolate(perspective, centroid) place: vec2<f32>,
    @location(4) @interpolate(flat) up: vec3<f32>,
    // Light at the roots, lean, what the ribbon blocks
    @location(5) @interpolate(flat) looks: vec3<f32>,
}

// A direction of the plant's own axes, turned about up, then by the shortest turn from up to along.
fn turned_over(blade: Blade, along: vec3<f32>, turn: vec2<f32>, own: vec3<f32>) -> vec3<f32> {
    let right = cross(blade.up, blade.facing);
    let x = right * turn.x - blade.facing * turn.y;
    let z = right * turn.y + blade.facing * turn.x;
    let level = x * own.x + z * own.z;
    let over = max(1.0 + dot(blade.up, along), 1e-3);
    let leaned = level - (blade.up + along) * (dot(level, along) / over);
    return leaned + along * own.y;
}

// A place about the middle line, in the plant's own level axes, laid onto the quad that faces the eye, of
// which the picture shows the plant from that side. Half way between two quads it goes from one to the
// other, so that it never jumps.
fn laid_on_quads(own: vec2<f32>, to_eye: vec2<f32>, quads: u32, angle: f32) -> vec2<f32> {
    var sum = vec2<f32>(0.0);
    var weights = 1e-6;
    for (var quad = 0u; quad < quads; quad++) {
        let turn = f32(quad) * angle;
        let side = vec2<f32>(cos(turn), -sin(turn));
        let facing = abs(dot(to_eye, vec2<f32>(sin(turn), cos(turn))));
        let weight = pow(facing, 16.0);
        sum += side * (dot(own, side) * weight);
        weights += weight;
    }
    return sum / weights;
}

// Of a plant so far over, with its width and height.
struct Bent {
    tip: vec3<f32>,
    size: vec2<f32>,
    // Of its top, radians
    twist: f32,
}

// From the root: a place about the middle line, at a share of the height.
fn bent_place(blade: Blade, bent: Bent, share: f32, level: vec2<f32>) -> vec3<f32> {
    let spine = spine_at(blade, bent.tip, share);
    let angle = bent.twist * clamp(share, 0.0, 1.0);
    let turn = vec2<f32>(cos(angle), sin(angle));
    let offset = turned_over(blade, spine.along, turn, vec3<f32>(level.x, 0.0, level.y));
    return spine.center * bent.size.y + offset * bent.size.x;
}

// The same on the quads, which have a row at the bottom, the middle and the top.
fn place_on_quads(blade: Blade, bent: Bent, share: f32, own: vec2<f32>, look: vec2<f32>) -> vec3<f32> {
    let ray = -view_ray(blade.root);
    let right = cross(blade.up, blade.facing);
    let angle = bent.twist * clamp(share, 0.0, 1.0);
    let x = dot(ray, right * cos(angle) - blade.facing * sin(angle));
    let z = dot(ray, right * sin(angle) + blade.facing * cos(angle));
    let to_eye = vec2<f32>(x, z) / max(length(vec2<f32>(x, z)), 1e-4);
    let level = laid_on_quads(own, to_eye, u32(look.x), look.y);
    let row = select(0.0, 0.5, share > 0.5);
    let low = bent_place(blade, bent, row, level);
    let high = bent_place(blade, bent, row + 0.5, level);
    return mix(low, high, 2.0 * (share - row));
}

fn model_vertex(vertex: u32, instance: u32) -> ModelVertex {
    var out: ModelVertex;
    out.clip = HIDDEN;
    let listed = listed_plant(vertex, instance);
    if listed.hidden {
        return out;
    }
    let kind = (blades[listed.index].y >> 16u) & 0xffu;
    let look = page.species[kind].look;
    let id = page.field.first_id + listed.index;
    let texel = vec2<u32>(vertex % VERTICES, look.y / PICTURE_VIEWS + variant_of(look, id));
    let bits = textureLoad(plant_models, texel, 0);
    // Rows are filled up with zeros, which no direction is
    if all(bits == vec4<u32>(0u)) {
        return out;
    }
    let own = unpack_model_point(bits);
    let blade = unpack_blade(listed.index);
    let state = unpack_state(blade, dynamics[listed.index]);
    let values = page.species[kind].look_values;
    let size = vec2<f32>(blade.width, blade.height) * listed.fade;
    let spine = spine_at(blade, state.tip, own.place.y);
    // Wind from the side turns the plant
    let bent = Bent(state.tip, size, values.y * dot(state.tip, cross(blade.up, blade.facing)));
    let angle = bent.twist * clamp(own.place.y, 0.0, 1.0);
    let turn = vec2<f32>(cos(angle), sin(angle));
    let level = vec3<f32>(own.place.x, 0.0, own.place.z);
    let offset = turned_over(blade, spine.along, turn, level) * size.x;
    var position = blade.root + spine.center * size.y + offset;
    if listed.morph > 0.0 {
        let quads = vec2<f32>(f32(look.w & 0xffu), values.x);
        let laid = place_on_quads(blade, bent, own.place.y, own.place.xz, quads);
        position = mix(position, blade.root + laid, listed.morph);
    }
    let direction = turned_over(blade, spine.along, turn, own.direction);
    let ray = view_ray(position);
    var normal = select(direction, -direction, dot(direction, ray) > 0.0);
    if own.half != 0.0 {
        // A round ribbon turns its width to the eye
        let side = unit_or(cross(ray, direction), blade.facing);
        position += side * (own.half * size.x);
        normal = cross(side, direction);
        normal = select(normal, -normal, dot(normal, ray) > 0.0) + side * (0.9 * sign(own.half));
    }
    let lean = lean_of(blade, state.tip);
    out.clip = view.clip_from_world * vec4<f32>(position, 1.0);
    out.normal = normal;
    out.albedo = own.albedo * plant_tone(id, lean, values.z);
    out.position = position;
    let share = clamp(own.place.y, 0.0, 1.0);
    out.place = vec2<f32>(share, absorbed_within(offset, blade.up, size, share, values.w));
    out.up = blade.up;
    out.looks = vec3<f32>(page.species[kind].form.z, lean, own.blocked);
    return out;
}

@vertex
fn vs_model(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> ModelVertex {
    return model_vertex(vertex, instance);
}

@fragment
fn fs_model(in: ModelVertex) -> @location(0) vec4<f32> {
    var surface: BladeSurface;
    surface.albedo = in.albedo;
    surface.normal = unit_or(in.normal, in.up);
    surface.up = in.up;
    surface.height_share = in.place.x;
    surface.root_open = in.looks.x;
    surface.lean = in.looks.y;
    surface.shaded = sun_shade(in.position);
    surface.absorbed = in.place.y;
    surface.blocked = in.looks.z;
    let lit = with_haze(shade_blade(surface, -view_ray(in.position)), distance_to(in.position));
    return vec4<f32>(max(lit, vec3<f32>(0.0)), 1.0);
}
