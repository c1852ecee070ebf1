// AgX, after Troy Sobotka: a picture as film has it. Bright colours go to white on the way up, and hues
// do not skew at the edges of what a screen shows.

// Moves primaries inward, so that no colour is so pure that one channel alone must carry it; rows sum
// to 1, so that grey stays grey. A column a line.
const AGX_INSET = mat3x3<f32>(
    vec3(0.8424, 0.0423, 0.0424),
    vec3(0.0784, 0.8785, 0.0784),
    vec3(0.0792, 0.0792, 0.8792),
);
// Its inverse
const AGX_OUTSET = mat3x3<f32>(
    vec3(1.196988, -0.052856, -0.053012),
    vec3(-0.097988, 1.151856, -0.097988),
    vec3(-0.099, -0.099, 1.151),
);
// Stops from black to white, and those of them that lie below middle grey
const AGX_STOPS = 16.5;
const AGX_BELOW = 10.0;
const AGX_GREY = 0.18;
// Of the look: contrast about middle grey's own place, and saturation
const AGX_CONTRAST = 1.3;
const AGX_SATURATION = 1.25;

// A sigmoid through (10/16.5, 1/2) with slope 2: from there to 0 as far as `u` is 1 the distance `a u`,
// bent by the power p so that it ends at 1/2.
fn agx_curve(x: vec3<f32>) -> vec3<f32> {
    const PIVOT = AGX_BELOW / AGX_STOPS;
    let toe = max(PIVOT - x, vec3(0.0)) / PIVOT;
    let shoulder = max(x - PIVOT, vec3(0.0)) / (1.0 - PIVOT);
    let down = toe * (2.0 * PIVOT) / pow(1.0 + 13.247155 * pow(toe, vec3(3.0)), vec3(1.0 / 3.0));
    let bent = pow(1.0 + 3.3836973 * pow(shoulder, vec3(3.25)), vec3(1.0 / 3.25));
    return 0.5 - down + shoulder * (2.0 * (1.0 - PIVOT)) / bent;
}

// From light to a screen's linear light.
fn tone_map_agx(light: vec3<f32>) -> vec3<f32> {
    let inset = max(AGX_INSET * light, vec3(1e-10));
    let stops = log2(inset / AGX_GREY) + AGX_BELOW;
    let curved = agx_curve(clamp(stops / AGX_STOPS, vec3(0.0), vec3(1.0)));
    let look = pow(curved, vec3(AGX_CONTRAST));
    let grey = dot(look, vec3(0.2126, 0.7152, 0.0722));
    let shown = AGX_OUTSET * (grey + (look - grey) * AGX_SATURATION);
    return pow(max(shown, vec3(0.0)), vec3(2.2));
}
