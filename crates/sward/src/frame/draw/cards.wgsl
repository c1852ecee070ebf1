// Cards that clusters are drawn on: where they lie, and what of them shows. bake/cards.rs has the twins.

// The frame of a card: level towards the eye and to the right of it.
struct Facing {
    toward: vec3<f32>,
    right: vec3<f32>,
    // Of the angle between the ray and the ground
    sine: f32,
}

fn facing_of(up: vec3<f32>, to_eye: vec3<f32>) -> Facing {
    let sine = dot(up, to_eye);
    let level = to_eye - up * sine;
    // From straight above any direction will do
    let toward = unit_or(level, tangent_frame(up).first);
    return Facing(toward, cross(up, toward), sine);
}

// Corners 0 to 3: left and right of the bottom, left and right of the top. `sway`: what moves the
// top, in heights.
fn card_corner(
    corner: u32,
    facing: Facing,
    up: vec3<f32>,
    radius: f32,
    height: f32,
    widened: f32,
    sway: vec3<f32>,
) -> vec3<f32> {
    let side = facing.right * select(-radius * widened, radius * widened, (corner & 1u) == 1u);
    if corner < 2u {
        return side + facing.toward * radius;
    }
    return side - facing.toward * radius + (up + sway) * height;
}

// How high a card stands in the picture, seen from so many times 30 degrees.
fn card_height(elevation: f32) -> f32 {
    let angle = elevation * (1.5707963 / 3.0);
    return page.field.cluster.z * cos(angle) + 2.0 * page.field.cluster.y * sin(angle);
}

// What the cluster covers of it, in metres of its height.
fn card_cover(elevation: f32) -> f32 {
    let low = min(floor(2.0 * elevation), 5.0);
    let i = u32(low);
    return mix(
        canopy.cards[i].w * card_height(0.5 * low),
        canopy.cards[i + 1u].w * card_height(0.5 * low + 0.5),
        2.0 * elevation - low,
    );
}

// Mean of the texels that show of all clusters: by the sine's logarithm up to 30 degrees, then by the
// angle.
fn card_tone(elevation: f32, sine: f32) -> vec3<f32> {
    var tone: vec3<f32>;
    if elevation < 1.0 {
        let row = canopy_row(sine);
        let low = min(u32(row), CANOPY_ROWS - 3u);
        tone = mix(canopy.rows[low].shown.rgb, canopy.rows[low + 1u].shown.rgb, row - f32(low));
    } else {
        let low = min(floor(2.0 * elevation), 5.0);
        let i = u32(low);
        tone = mix(canopy.cards[i].rgb, canopy.cards[i + 1u].rgb, 2.0 * elevation - low);
    }
    return max(tone, vec3<f32>(1e-4));
}

// Rays meet so many blades where hardly any ground shows: more would change nothing.
const HIDING: f32 = 5.0;

// From above, the cluster's blades are spread over so much less of a card than from the side.
const TOGETHER: f32 = 0.85;

// How many times as wide as they are clusters are drawn, where a ray meets so many blades and such a
// share of the clusters has grown. The blades of one stand together and hide each other, so that clusters
// leave more of the ground open.
fn wider(elevation: f32, facing: Facing, sway: vec3<f32>, blades: f32, grown: f32) -> f32 {
    let s = max(facing.sine, 1e-3);
    let share = card_cover(elevation) / card_height(elevation);
    // Clusters are spread evenly: they hide each other less than they would at random places. The first
    // of them stand at random
    let alpha = clamp(share / (1.0 - TOGETHER * s), 1e-3, 0.95) * clamp(grown, 0.01, 1.0);
    let moved = dot(sway, facing.toward) * s;
    let height = card_height(elevation) - page.field.cluster.z * moved;
    let cards = canopy.cards[7].x * 2.0 * page.field.cluster.y * max(height, 1e-3) / s;
    let met = cards * share * -log(1.0 - alpha) / alpha;
    return clamp(min(blades, HIDING) / max(met, 1e-6), 1.0, MOST_WIDER);
}

struct Picture {
    layer: u32,
    // What its alpha is multiplied by
    alpha: f32,
}

// Which picture: one of four places, elevations and sides, the next to the view's or the one after. On
// a card of another elevation than its own it is drawn taller or less tall than it is, and covers as
// much more or less. So each is chosen in proportion to its card's height, which keeps the mean where
// heights and covers run straight between elevations; what is left is put right by alpha.
fn picture_of(id: u32, elevation: f32) -> Picture {
    let below = min(floor(elevation), 2.0);
    let part = elevation - below;
    let high = part * card_height(below + 1.0);
    let above = high / ((1.0 - part) * card_height(below) + high);
    let row = u32(below) + u32(hash01(id, 51u) < above);
    let layer = ((hash_u32(id) & 3u) * 4u + row) * 4u + (hash_u32(id ^ 0x5bd1u) & 3u);
    let drawn = mix(
        card_cover(below) / card_height(below),
        card_cover(below + 1.0) / card_height(below + 1.0),
        above,
    );
    return Picture(layer, card_cover(elevation) / card_height(elevation) / max(drawn, 1e-4));
}
