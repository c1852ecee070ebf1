// Background: a gradient, brighter and warmer round the sun. Not physical, only pleasant.

fn sky_radiance(direction: vec3<f32>) -> vec3<f32> {
    let height = max(direction.y, 0.0);
    let gradient = mix(frame.zenith.rgb, frame.horizon.rgb, pow(1.0 - height, 3.5));
    // Below the horizon the ground's light dims the haze.
    let below = smoothstep(0.0, 0.5, -direction.y);
    let base = gradient * mix(1.0, 0.62, below);
    let toward = max(dot(direction, frame.to_sun.xyz), 0.0);
    let glow = 0.05 * pow(toward, 6.0) + 0.16 * pow(toward, 90.0) + 3.0 * pow(toward, 4000.0);
    return base + frame.sun.rgb * glow * (1.0 - below);
}
