// Wind of sources that have a place: rotors, vortices, fans.

// Of a moving source's past, so many seconds are told from its present velocity.
const WIND_PAST_S: f32 = 4.0;
const ROTOR: u32 = 3u;
const FAN: u32 = 5u;

// From where the source was then to `position`, metres.
fn from_source(source: GpuWindSource, position: vec3<f32>, seconds_ago: f32) -> vec3<f32> {
    return position - source.position + source.velocity * min(seconds_ago, WIND_PAST_S);
}

// Noise that the flow carries along by `carried` metres, then draws anew: two layers by turns.
fn carried_noise(source: GpuWindSource, at: vec2<f32>, carried: vec2<f32>, seconds_ago: f32)
    -> vec2<f32> {
    var sum = vec2<f32>(0.0);
    var squares = 0.0;
    for (var layer = 0u; layer < 2u; layer++) {
        let turn = source.phase.y - source.rate * seconds_ago + 0.5 * f32(layer);
        let whole = floor(turn);
        let share = turn - whole;
        let drawn = u32(i32(whole)) & (NOISE_PERIOD - 1u);
        let seed = source.seed + 4u * drawn + 2u * layer;
        let cell = (at - carried * (share - 0.5)) * source.frequency;
        let weight = 1.0 - abs(2.0 * share - 1.0);
        sum += weight * vec2<f32>(noise2(cell, seed), noise2(cell, seed + 1u));
        squares += weight * weight;
    }
    return sum / sqrt(squares);
}

// cos(spokes * angle - phase), without an angle: there is none in the middle.
fn spoke_wave(source: GpuWindSource, at: vec2<f32>, seconds_ago: f32, wander: f32) -> f32 {
    let distance = length(at);
    let unit = vec2<f32>(at.x, -at.y) / max(distance, 1e-4);
    var power = vec2<f32>(1.0, 0.0);
    for (var i = 0u; i < source.spokes; i++) {
        power = vec2<f32>(power.x * unit.x - power.y * unit.y, power.x * unit.y + power.y * unit.x);
    }
    let turned = source.phase.x - source.spoke_rate * seconds_ago;
    let turn = (turned - source.spoke_wind * distance + wander) / TAU;
    let phase = (turn - floor(turn)) * TAU;
    return dot(power, vec2<f32>(cos(phase), sin(phase)));
}

// A rotor's wash or a vortex.
fn whirl_strength(source: GpuWindSource, position: vec3<f32>, seconds_ago: f32) -> vec3<f32> {
    let hub_to = from_source(source, position, seconds_ago);
    let at = hub_to.xz;
    let reach = dot(at, at) / (source.range * source.range);
    if reach >= 1.0 {
        return vec3<f32>(0.0);
    }
    var strength = source.strength.x * (1.0 - reach) * (1.0 - reach);
    var radius = source.radius;
    if source.kind == ROTOR {
        // Deeper below, the wash is wider and weaker.
        let depth = max(-hub_to.y / source.radius, 0.0);
        strength *= smoothstep(0.0, 0.3, depth) / (1.0 + depth * depth / 16.0);
        radius *= 1.0 + 0.15 * depth;
    }
    let s = at / radius;
    let core = 1.0 / (1.0 + dot(s, s));
    // As long as 0 in the middle, 1 at one radius, and falling as 1/s.
    let radial = s * (2.0 * core);
    let around = vec2<f32>(radial.y, -radial.x);
    let flow = radial * source.flow.x + around * source.flow.y;
    let speed = length(radial);
    var gusts = vec2<f32>(0.0);
    if source.turbulence != 0.0 {
        gusts = carried_noise(source, at, flow * source.carried, seconds_ago);
    }
    var spokes = 0.0;
    if source.pulse != 0.0 {
        spokes = source.pulse * speed * spoke_wave(source, at, seconds_ago, 3.0 * gusts.x);
    }
    // Where air comes down or goes up, it is the most irregular
    let shaken =
        gusts * (2.0 * source.turbulence * (speed + core * (1.0 + 2.0 * abs(source.flow.z))));
    let level = flow * (1.0 + spokes) + shaken;
    let upward =
        source.flow.z * core * core * (1.0 + spokes + 2.0 * source.turbulence * gusts.y);
    return vec3<f32>(level.x, upward, level.y) * strength;
}

// A jet that widens.
fn fan_strength(source: GpuWindSource, position: vec3<f32>, seconds_ago: f32) -> vec3<f32> {
    let fan_to = from_source(source, position, seconds_ago);
    let axis = source.flow;
    let along = dot(fan_to, axis);
    let reach = along / source.range;
    let across = fan_to - axis * along;
    let width = source.radius + along * source.spread;
    let off = dot(across, across) / (width * width);
    if along <= 0.0 || reach >= 1.0 || off >= 1.0 {
        return vec3<f32>(0.0);
    }
    let ends = (1.0 - reach * reach) * (1.0 - off);
    let start = smoothstep(0.0, 0.5 * source.radius, along);
    var strength = source.strength.x * start * ends * ends * source.radius / width;
    // Away from the tip of the cone.
    var direction = normalize(axis * width + across * source.spread);
    if source.turbulence != 0.0 {
        let side = source.direction;
        let drift = source.phase.x - source.rate * source.frequency * seconds_ago;
        let lateral = dot(fan_to.xz, side) * source.frequency;
        let cell = vec2<f32>(along * source.frequency - drift, lateral);
        strength *= 1.0 + 1.5 * source.turbulence * noise2(cell, source.seed);
        let veer = source.turbulence * noise2(cell, source.seed + 1u);
        direction += vec3<f32>(side.x, 0.0, side.y) * veer;
    }
    return direction * strength;
}

fn placed_strength(source: GpuWindSource, position: vec3<f32>, seconds_ago: f32) -> vec3<f32> {
    if source.kind == FAN {
        return fan_strength(source, position, seconds_ago);
    }
    return whirl_strength(source, position, seconds_ago);
}
