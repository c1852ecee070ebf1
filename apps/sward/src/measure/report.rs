//! What one run of a scene measured, and under which circumstances.

use super::Times;
use serde::{Deserialize, Serialize};
use sward::Statistics;
use sward_app::compare::percentile;
use sward_app::gpu::Gpu;
use sward_app::stage::StageOptions;
use sward_scene::Scene;

/// Median and 99th percentile.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Percentiles {
    pub p50: f32,
    pub p99: f32,
}

impl Percentiles {
    fn of(values: &[f32]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f32::total_cmp);
        Self { p50: percentile(&sorted, 0.5), p99: percentile(&sorted, 0.99) }
    }
}

/// Wall clock of whole frames, and of their stages submitted one by one.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Milliseconds {
    pub frame: Percentiles,
    pub physics: Percentiles,
    pub visibility: Percentiles,
    pub draw: Percentiles,
    pub post: Percentiles,
}

/// A blade that fails two tests counts in both.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Culled {
    pub orientation: u64,
    pub frustum: u64,
    pub distance: u64,
    pub occlusion: u64,
}

/// One measurement.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Report {
    pub adapter: String,
    pub driver: String,
    pub backend: String,
    pub scene: String,
    pub size: [u32; 2],
    pub samples: u32,
    pub without: Vec<String>,
    pub patch_size: u32,
    pub blades_total: u64,
    pub patches: u64,
    pub patches_visible: u64,
    pub blades_visible: u64,
    pub blades_drawn: u64,
    /// Of them, single blades by level, from 8 segments to 1.
    #[serde(default)]
    pub drawn_by_level: [u64; 4],
    #[serde(default)]
    pub clusters_drawn: u64,
    pub blades_culled: Culled,
    pub blades_dropped: u64,
    pub spheres_tested: u64,
    #[serde(default)]
    pub patches_crowded: u64,
    pub vertices: u64,
    pub ms: Milliseconds,
    /// How the times were taken.
    pub timing: String,
    /// Without textures, which are the same for any number of blades.
    pub bytes_per_blade: f64,
    /// With them.
    pub gpu_bytes: u64,
    pub grow_s: f64,
}

/// What was measured.
pub struct Measured {
    pub times: Times,
    pub statistics: Statistics,
    /// All, and those that grow with the blades.
    pub gpu_bytes: u64,
    pub blade_bytes: u64,
    pub patch_size: u32,
    pub grow_s: f64,
}

impl Report {
    /// Puts a measurement and its circumstances together.
    pub fn new(
        gpu: &Gpu,
        scene: &Scene,
        options: &StageOptions,
        without: Vec<String>,
        measured: Measured,
    ) -> Self {
        let info = gpu.adapter.get_info();
        let Measured { times, statistics: counted, gpu_bytes, blade_bytes, patch_size, grow_s } =
            measured;
        Self {
            adapter: info.name,
            driver: format!("{} {}", info.driver, info.driver_info).trim().into(),
            backend: info.backend.to_string(),
            scene: scene.name.clone(),
            size: options.size,
            samples: options.samples,
            without,
            patch_size,
            blades_total: counted.blades,
            patches: counted.patches,
            patches_visible: counted.patches_visible,
            blades_visible: counted.blades_visible,
            blades_drawn: counted.blades_drawn,
            drawn_by_level: counted.drawn_by_level,
            clusters_drawn: counted.clusters_drawn,
            blades_culled: Culled {
                orientation: counted.culled_orientation,
                frustum: counted.culled_frustum,
                distance: counted.culled_distance,
                occlusion: counted.culled_occlusion,
            },
            blades_dropped: counted.dropped,
            spheres_tested: counted.spheres_tested,
            patches_crowded: counted.patches_crowded,
            vertices: counted.vertices,
            ms: Milliseconds {
                frame: Percentiles::of(&times.frame),
                physics: Percentiles::of(&times.physics),
                visibility: Percentiles::of(&times.visibility),
                draw: Percentiles::of(&times.draw),
                post: Percentiles::of(&times.post),
            },
            timing: "wall clock, submitted and waited for; no timestamp queries".into(),
            bytes_per_blade: blade_bytes as f64 / counted.blades.max(1) as f64,
            gpu_bytes,
            grow_s,
        }
    }
}
