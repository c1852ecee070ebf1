// What every stage of a frame reads: group 0.

struct GpuFrame {
    // xyz unit direction, w strength (J equation 4: D)
    gravity_direction: vec4<f32>,
    // xyz centre in metres, w strength (J equation 4: C)
    gravity_center: vec4<f32>,
    // xyz unit direction from the ground to the sun
    to_sun: vec4<f32>,
    sun: vec4<f32>,
    sky: vec4<f32>,
    // rgb light from below, w unused
    ground: vec4<f32>,
    // rgb colour that distance fades to, w share lost a metre
    haze: vec4<f32>,
    // Sinusoid that strips sway on: xy wind in the xz plane at its crest, z phase now in radians
    sway: vec4<f32>,
    // Moving shade: how much of the sun at its darkest, cells of noise a metre, height in metres
    shade: vec4<f32>,
    // Seconds of this step
    dt_s: f32,
    // Blend between gravity's direction (0) and centre (1)
    gravity_blend: f32,
    // Crush lost a second without contact
    crush_decay: f32,
    // 0 sward, 1 paper
    physics_model: u32,
    wind_count: u32,
    // Chunks of 64 primitives, those that rest first
    chunk_count: u32,
    // Number of this step
    step: u32,
    // Time of this step in 1/16384 s, wrapping
    ticks: u32,
    // Of them, those that rest
    resting_chunks: u32,
    // Not 0 where those that rest are as they were, and patches keep what they know of them
    keep_resting: u32,
    // How far the shade has drifted, cells
    shade_x: f32,
    shade_y: f32,
    // The first `wind_count` of them
    wind_sources: array<GpuWindSource, 64>,
}

// The model, where a pipeline is made for one; 2: as the frame says.
override MODEL: u32 = 2u;

fn is_paper_model() -> bool {
    if MODEL < 2u {
        return MODEL == 1u;
    }
    return frame.physics_model == 1u;
}

// Part of a collider, or the box of a chunk: see collide/primitive.rs and collide/chunks.rs.
struct GpuPrimitive {
    a: vec4<u32>,
    b: vec4<u32>,
}

// Entries of a chunk: its box, then up to 64 primitives
const CHUNK_STRIDE: u32 = 65u;

struct GpuWindSource {
    // 0 waves, 1 gusts, 2 cosine, 3 rotor, 4 vortex, 5 fan, 6 texture
    kind: u32,
    seed: u32,
    // Unit direction in the xz plane; fan: across its axis
    direction: vec2<f32>,
    // Waves: mean, amplitude; gusts: strength, turbulence; others: strength
    strength: vec2<f32>,
    // Waves, cosine: radians a metre; texture: texels a metre; others: cells of noise a metre
    frequency: f32,
    // Waves, cosine: radians a second; gusts, fan, texture: metres a second; rotor, vortex: turns of their
    // noise a second
    rate: f32,
    // Waves: phase now, radians in 0..2 pi, and drift of their noise, cells; gusts, fan: drift now,
    // cells; texture: drift now, texels; cosine: phase; rotor, vortex: phase of the spokes, turns of their noise
    phase: vec2<f32>,
    // Metres
    radius: f32,
    range: f32,
    position: vec3<f32>,
    // Of rotors, vortices, fans
    turbulence: f32,
    // Metres a second
    velocity: vec3<f32>,
    // Fan: how much wider the cone is a metre
    spread: f32,
    // Rotor, vortex: outward, around and upward as shares of the strength; fan: unit axis
    flow: vec3<f32>,
    // Rotor, vortex: metres that gusts are carried before they are drawn anew
    carried: f32,
    // Rotor: arms of its spiral, their radians a second and a metre outward, and how strong they are
    spokes: u32,
    spoke_rate: f32,
    spoke_wind: f32,
    pulse: f32,
    // Texture: the first row of its map among all maps, and its width and height, 16 bits each
    map_row: u32,
    map_size: u32,
    reserved: vec2<u32>,
}

@group(0) @binding(0) var<uniform> frame: GpuFrame;
@group(0) @binding(1) var<storage, read> primitives: array<GpuPrimitive>;
