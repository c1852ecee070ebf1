// Wind strength (beta) at a place and a time: the sum of the sources.

const TAU: f32 = 6.283185307;
// Beyond this the wind is an error of its source: no blade can tell the difference.
const WIND_LIMIT: f32 = 100.0;

// Bits of the kinds of wind that a pipeline knows: waves with an amplitude, gusts, cosine, and the rare
// ones, those with a place or a map. A breeze that only streams is always known.
override WIND_KINDS: u32 = 15u;

fn has_wind(kind: u32) -> bool {
    return ((WIND_KINDS >> kind) & 1u) == 1u;
}

// Position in the source's own axes, metres: along its direction, and across.
fn wind_axes(source: GpuWindSource, position: vec3<f32>) -> vec2<f32> {
    let across = vec2<f32>(-source.direction.y, source.direction.x);
    return vec2<f32>(dot(position.xz, source.direction), dot(position.xz, across));
}

// Crests that wander and break: noise that travels with them shifts their phase and fades them.
fn wave_strength(source: GpuWindSource, position: vec3<f32>, seconds_ago: f32) -> vec2<f32> {
    if !has_wind(0u) || source.strength.y == 0.0 {
        return source.direction * source.strength.x;
    }
    let at = wind_axes(source, position);
    let travelled = source.phase.x - source.rate * seconds_ago;
    // A cell of the noise is as long and as wide as four crests.
    let cells = source.frequency / TAU;
    let drift = source.phase.y - source.rate / TAU * 0.25 * seconds_ago;
    let noise_at = vec2<f32>(at.x * cells * 0.25 - drift, at.y * cells * 0.25);
    let wander =
        9.0 * noise2(noise_at, source.seed) + 4.0 * noise2(noise_at * 2.0, source.seed + 1u);
    let envelope = 1.2 * smoothstep(-0.5, 0.4, noise2(noise_at * 2.0, source.seed + 2u));
    let turn = (travelled - source.frequency * at.x + wander) / TAU;
    let phase = (turn - floor(turn)) * TAU;
    // Rises three times as fast as it falls: the front of a gust is sharp, its tail is not.
    let profile = sin(phase + 0.5 * sin(phase));
    return source.direction * (source.strength.x + source.strength.y * envelope * profile);
}

// Gusts: two octaves of noise that drift with the wind, twice as long across it.
fn gust_strength(source: GpuWindSource, position: vec3<f32>, seconds_ago: f32) -> vec2<f32> {
    let at = wind_axes(source, position) * source.frequency;
    let drift = source.phase.x - source.rate * source.frequency * seconds_ago;
    let cell = vec2<f32>(at.x - drift, at.y * 0.5);
    let sum = noise2(cell, source.seed) + 0.5 * noise2(cell * 2.0, source.seed + 1u);
    let strength = smoothstep(-0.4, 0.8, sum) * source.strength.x;
    let veer = source.strength.y * 1.6 * noise2(cell, source.seed + 2u);
    let across = vec2<f32>(-source.direction.y, source.direction.x);
    return (source.direction * cos(veer) + across * sin(veer)) * strength;
}

// Wang and Yao's equation 4, with a phase by position.
fn cosine_strength(source: GpuWindSource, position: vec3<f32>, seconds_ago: f32) -> vec2<f32> {
    let along = dot(position.xz, source.direction);
    let turn = (source.phase.x - source.rate * seconds_ago - source.frequency * along) / TAU;
    return source.direction * (source.strength.x * cos((turn - floor(turn)) * TAU));
}

// The wind at `position` (metres) as it was `seconds_ago`, in units of beta.
fn wind_at(position: vec3<f32>, seconds_ago: f32) -> vec3<f32> {
    var level = vec2<f32>(0.0);
    var sum = vec3<f32>(0.0);
    // Drivers that unroll a loop by its uniform bound would make the pipeline anew in each frame
    let count = select(frame.wind_count, 0u, position.x > 3e38);
    for (var i = 0u; i < count; i++) {
        // Each kind reads what it needs, and no more
        switch frame.wind_sources[i].kind {
            case 0u: {
                level += wave_strength(frame.wind_sources[i], position, seconds_ago);
            }
            case 1u: {
                if has_wind(1u) {
                    level += gust_strength(frame.wind_sources[i], position, seconds_ago);
                }
            }
            case 2u: {
                if has_wind(2u) {
                    level += cosine_strength(frame.wind_sources[i], position, seconds_ago);
                }
            }
            case 6u: {
                if has_wind(3u) {
                    level += map_strength(frame.wind_sources[i], position, seconds_ago);
                }
            }
            default: {
                if has_wind(3u) {
                    sum += placed_strength(frame.wind_sources[i], position, seconds_ago);
                }
            }
        }
    }
    sum += vec3<f32>(level.x, 0.0, level.y);
    if !is_finite3(sum) {
        return vec3<f32>(0.0);
    }
    return clamp(sum, vec3<f32>(-WIND_LIMIT), vec3<f32>(WIND_LIMIT));
}
