// The values of a strip, in every stage that needs them.

// A strip's values where its species has another near form, as `Strip::default`
const PLAIN_STRIP: vec4<f32> = vec4<f32>(1.0471976, 0.2, 0.35, 70.0);

// Fold in radians, sway, orange, pixels of few rings.
fn strip_values(kind: u32) -> vec4<f32> {
    return select(
        PLAIN_STRIP,
        page.species[kind].look_values,
        page.species[kind].look.x == FORM_STRIP,
    );
}
