// Where grass ends: its look passes to the ground.

// Heights of the grass in pixels between which that happens.
const CANOPY_END_PX: vec2<f32> = vec2<f32>(1.0, 0.35);

// Share of the plants of this height in pixels, times detail, that the ground shows in their place.
fn canopy_gone(height_px: f32) -> f32 {
    let t = (CANOPY_END_PX.x - height_px) / (CANOPY_END_PX.x - CANOPY_END_PX.y);
    return clamp(t, 0.0, 1.0);
}

// Share of the ground that shows the grass's look where so much of the grass is gone, and all of it
// would hide `coverage`: what is left hides its part, the ground shows the rest of what is hidden.
fn canopy_on_ground(coverage: f32, gone: f32) -> f32 {
    return 1.0 - pow(max(1.0 - coverage, 1e-6), gone);
}
