// What moves over a field between it and the sun: clouds, or the crowns of trees.

// Share of the sun kept away at a place. `pattern`: how much at its darkest, cells of noise a metre,
// height in metres; `offset`: how far the pattern has drifted, cells. It lies at its height and is cast
// along the sun's rays, so its shadows also move with the sun.
fn shade_pattern(place: vec3<f32>, to_sun: vec3<f32>, pattern: vec4<f32>, offset: vec2<f32>) -> f32 {
    if pattern.x <= 0.0 {
        return 0.0;
    }
    // A sun on the horizon would cast without end
    let along = (pattern.z - place.y) / max(to_sun.y, 0.1);
    let cell = (place.xz + to_sun.xz * along) * pattern.y - offset;
    let sum = noise2(cell, 71u) + 0.5 * noise2(cell * 2.0, 72u) + 0.25 * noise2(cell * 4.0, 73u);
    return pattern.x * smoothstep(-0.2, 0.3, sum);
}
