// What the forms other than blades read beside the blades' data: pictures and the wind's mark.

@group(1) @binding(5) var cluster_color: texture_2d_array<f32>;
@group(1) @binding(6) var cluster_shape: texture_2d_array<f32>;
@group(1) @binding(7) var plant_color: texture_2d_array<f32>;
@group(1) @binding(8) var plant_normal: texture_2d_array<f32>;
@group(1) @binding(9) var picture_sampler: sampler;
@group(1) @binding(10) var<storage, read> bands: array<GpuBand>;

// Alpha at an outline as wide as a pixel, of a picture of which so much shows: with one sample a pixel it
// is tested, with several it decides how many are covered. Derivatives are taken.
fn outline_alpha(alpha: f32, shown: f32) -> f32 {
    return clamp((alpha * shown - 0.5) / max(fwidth(alpha), 1e-3) + 0.5, 0.0, 1.0);
}

// What covers less than this does not show.
fn least_alpha() -> f32 {
    return select(0.5, 0.03, SAMPLES > 1u);
}
