// What the forms other than blades read beside the blades' data: pictures and the wind's mark.

@group(1) @binding(6) var cluster_color: texture_2d_array<f32>;
@group(1) @binding(7) var cluster_shape: texture_2d_array<f32>;
@group(1) @binding(8) var plant_color: texture_2d_array<f32>;
@group(1) @binding(9) var plant_normal: texture_2d_array<f32>;
@group(1) @binding(10) var picture_sampler: sampler;
@group(1) @binding(11) var<storage, read> bands: array<GpuBand>;
