// Fog by distance: Olofsson and Silven, with a start and a falloff by height of ours.

// Share of a point's light that comes through the fog to the eye. The fog's density falls off
// exponentially with the height, so its sum along the way is known in closed form.
fn fog_clear(world: vec3<f32>) -> f32 {
    let way = world - frame.eye.xyz;
    let distance = length(way);
    let inside = distance - frame.fog_shape.x;
    if inside <= 0.0 || frame.fog.w == 0.0 {
        return 1.0;
    }
    if frame.fog_shape.z == 0.0 {
        return exp(-frame.fog.w * inside);
    }
    // Heights of the two ends of the way through fog, in units of the falloff
    let climb = abs(way.y) * (inside / distance) * frame.fog_shape.z;
    let eye_end = world.y - way.y * (inside / distance);
    let low = (min(world.y, eye_end) - frame.fog_shape.y) * frame.fog_shape.z;
    // (1 - exp(-climb)) / climb, which cancels near 0
    let series = 1.0 - climb * (0.5 - climb / 6.0);
    let mean = select((1.0 - exp(-climb)) / max(climb, 1e-9), series, climb < 0.01);
    return exp(-frame.fog.w * inside * mean * exp(-clamp(low, -60.0, 60.0)));
}
