// A blade as the stages see it, decoded.

struct Blade {
    // v0, metres
    root: vec3<f32>,
    // Unit up
    up: vec3<f32>,
    // Unit facing f, perpendicular to up
    facing: vec3<f32>,
    height: f32,
    // Full width at the root
    width: f32,
    // s, 1/s
    response: f32,
    // gamma
    droop: f32,
    // Multiplies the wind
    gust: f32,
    // kappa
    arch: f32,
    species: u32,
    // Index in the field, the key of its hashes
    id: u32,
}

// The dynamic state.
struct BladeState {
    // (v2 - v0) / height. Its length follows from its direction in the default model
    tip: vec3<f32>,
    // eta, 0..2
    crush: f32,
}
