// Modelled plants: the near form of plants of quads. A point of a ribbon a vertex, from a table, bent
// along the plant's curve; lit at each pixel as blades are.

// A row a variant of a kind; plants/mesh.rs has every bit
@group(1) @binding(13) var plant_models: texture_2d<u32>;

const MODEL_RANGE: f32 = 1.25;
const MODEL_SALT: u32 = 41u;
// Layers of a variant's pictures
const MODEL_VIEWS: u32 = 3u;

struct ModelPoint {
    // Widths across and forwards, heights upwards
    place: vec3<f32>,
    // Its normal; the direction of the ribbon where it is round
    direction: vec3<f32>,
    // Half of the width of a round ribbon, in widths of the plant, signed by side; 0 where it is flat
    half: f32,
    albedo: vec3<f32>,
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
    );
}

fn model_row(look: vec4<u32>, id: u32) -> u32 {
    let variants = max(look.z / MODEL_VIEWS, 1u);
    let own = min(u32(hash01(id, MODEL_SALT) * f32(variants)), variants - 1u);
    return look.y / MODEL_VIEWS + own;
}

// Where the plant's middle line is at a share of its height, in heights, and which way it runs there.
struct Spine {
    center: vec3<f32>,
    along: vec3<f32>,
}

fn spine_at(blade: Blade, tip: vec3<f32>, share: f32) -> Spine {
    let knee = middle_point(tip, blade.up, blade.arch);
    // Upright, the curve is at 2v - v v of its height
    let v = 1.0 - sqrt(clamp(1.0 - share, 0.0, 1.0));
    let a = knee * v;
    let b = mix(knee, tip, v);
    let along = unit_or(b - a, blade.up);
    // What lies under the root goes straight down
    return Spine(mix(a, b, v) + along * min(share, 0.0), along);
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

@vertex
fn vs_model(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> NearVertex {
    var out: NearVertex;
    out.clip = HIDDEN;
    let listed = listed_plant(vertex, instance);
    if listed.hidden {
        return out;
    }
    let kind = (blades[listed.index].y >> 16u) & 0xffu;
    let look = species_table[kind].look;
    let id = field.first_id + listed.index;
    let texel = vec2<u32>(vertex % VERTICES, model_row(look, id));
    let bits = textureLoad(plant_models, texel, 0);
    // Rows are filled up with zeros, which no direction is
    if all(bits == vec4<u32>(0u)) {
        return out;
    }
    let own = unpack_model_point(bits);
    let blade = unpack_blade(listed.index);
    let state = unpack_state(blade, dynamics[listed.index]);
    let values = species_table[kind].look_values;
    let size = vec2<f32>(blade.width, blade.height) * listed.fade;
    let spine = spine_at(blade, state.tip, own.place.y);
    // Wind from the side turns the plant
    let twist = values.y * dot(state.tip, cross(blade.up, blade.facing)) * clamp(own.place.y, 0.0, 1.0);
    let turn = vec2<f32>(cos(twist), sin(twist));
    let level = vec3<f32>(own.place.x, 0.0, own.place.z);
    let offset = turned_over(blade, spine.along, turn, level) * size.x;
    var position = blade.root + spine.center * size.y + offset;
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
    let lean = min(length(state.tip - blade.up * dot(state.tip, blade.up)), 1.0);
    let tone = (0.85 + 0.3 * hash01(id, 22u)) * (1.0 + values.z * (lean - 0.1));
    out.clip = view.clip_from_world * vec4<f32>(position, 1.0);
    out.normal = normal;
    out.albedo = own.albedo * tone;
    out.position = position;
    out.height_share = clamp(own.place.y, 0.0, 1.0);
    out.up = blade.up;
    out.root_open = species_table[kind].form.z;
    out.lean = lean;
    return out;
}
