// Wind of maps: tiles of winds that repeat and drift.

// The maps of all sources, one below the other; red is along the direction, green across it
@group(0) @binding(2) var wind_maps: texture_2d<f32>;

// The remainder of a division, in 0 to `period`, also where x is far from it.
fn wrap_texel(x: f32, period: f32) -> f32 {
    let turn = x / period;
    return (turn - floor(turn)) * period;
}

fn map_texel(source: GpuWindSource, texel: vec2<u32>) -> vec2<f32> {
    return textureLoad(wind_maps, texel + vec2<u32>(0u, source.map_row), 0).xy;
}

// A map that drifts along its direction, straight between the middles of its texels.
fn map_strength(source: GpuWindSource, position: vec3<f32>, seconds_ago: f32) -> vec2<f32> {
    let size = vec2<u32>(source.map_size & 0xffffu, source.map_size >> 16u);
    let drift = source.phase.x - source.rate * source.frequency * seconds_ago;
    let at = wind_axes(source, position) * source.frequency - vec2<f32>(drift + 0.5, 0.5);
    let place = vec2<f32>(wrap_texel(at.x, f32(size.x)), wrap_texel(at.y, f32(size.y)));
    let t = fract(place);
    let low = vec2<u32>(place) % size;
    let high = (low + vec2<u32>(1u)) % size;
    let near = mix(map_texel(source, low), map_texel(source, vec2<u32>(high.x, low.y)), t.x);
    let far = mix(map_texel(source, vec2<u32>(low.x, high.y)), map_texel(source, high), t.x);
    let wind = mix(near, far, t.y) * source.strength.x;
    let across = vec2<f32>(-source.direction.y, source.direction.x);
    return source.direction * wind.x + across * wind.y;
}
