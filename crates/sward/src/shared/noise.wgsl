// Integer hashes and 2-D gradient noise: no trigonometry, so that every device agrees.

// Lattice period of `noise2`, cells: what drifts may wrap at without a jump.
const NOISE_PERIOD: u32 = 256u;

// PCG output permutation of one linear congruential step.
fn hash_u32(value: u32) -> u32 {
    let state = value * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

// Uniform in 0..1 (1 excluded) for an id; each salt is an independent draw.
fn hash01(id: u32, salt: u32) -> f32 {
    return f32(hash_u32(id ^ hash_u32(salt)) >> 8u) / 16777216.0;
}

// Contribution of the lattice corner `cell`: its gradient, of components in -1..1, times `offset`.
fn noise_corner(cell: vec2<i32>, seed: u32, offset: vec2<f32>) -> f32 {
    let wrapped = vec2<u32>(cell) & vec2<u32>(NOISE_PERIOD - 1u);
    let bits = hash_u32(wrapped.x + hash_u32(wrapped.y + hash_u32(seed)));
    let gradient = vec2<f32>(f32(bits & 0xffffu), f32(bits >> 16u)) / 32767.5 - vec2<f32>(1.0);
    return dot(gradient, offset);
}

// Gradient noise in -1..1, twice differentiable, of period NOISE_PERIOD on both axes.
fn noise2(at: vec2<f32>, seed: u32) -> f32 {
    let base = floor(at);
    let cell = vec2<i32>(base);
    let f = at - base;
    let u = f * f * f * (f * (f * 6.0 - vec2<f32>(15.0)) + vec2<f32>(10.0));
    let n00 = noise_corner(cell, seed, f);
    let n10 = noise_corner(cell + vec2<i32>(1, 0), seed, f - vec2<f32>(1.0, 0.0));
    let n01 = noise_corner(cell + vec2<i32>(0, 1), seed, f - vec2<f32>(0.0, 1.0));
    let n11 = noise_corner(cell + vec2<i32>(1, 1), seed, f - vec2<f32>(1.0, 1.0));
    return mix(mix(n00, n10, u.x), mix(n01, n11, u.x), u.y);
}
