//! Growing all fields of a scene.

use anyhow::{Context, Result, bail};
use sward::{Field, FieldDesc, Renderer};
use sward_scene::{Scene, SceneField};

/// Memory that growing and holding a blade takes at its peak, measured, a graphics adapter that
/// shares the memory included.
const BYTES_PER_BLADE: u64 = 110;

/// Changes to a scene's fields before they grow.
#[derive(Debug, Clone, Copy, Default)]
pub struct GrowOptions {
    /// Multiplies every density and count.
    pub density_scale: Option<f64>,
    /// Blades a patch.
    pub patch_size: Option<u32>,
}

/// Grows every field of a scene. Whether all fit the adapter's limits and the memory is known
/// before the first one grows.
///
/// # Errors
/// What [`Renderer::check_blades`] and [`Field::grow`] report, with the field's name; or where the
/// memory does not suffice.
pub fn grow(scene: &Scene, limits: &wgpu::Limits, options: GrowOptions) -> Result<Vec<Field>> {
    let descs: Vec<_> = scene.fields.iter().map(|field| described(field, options)).collect();
    let about = |field: &SceneField| format!("{}: field '{}'", scene.path.display(), field.name);
    let mut planned = 0_u64;
    for (field, desc) in scene.fields.iter().zip(&descs) {
        let blades = desc.planned_blades(&field.surface);
        Renderer::check_blades(limits, desc.patch_size, blades).with_context(|| about(field))?;
        planned = planned.saturating_add(blades);
    }
    check_memory(planned, available_memory())
        .with_context(|| format!("{}", scene.path.display()))?;
    let fields = scene.fields.iter().zip(&descs);
    let grow = |(field, desc): (&SceneField, &FieldDesc)| {
        Field::grow(&field.surface, desc).with_context(|| about(field))
    };
    fields.map(grow).collect()
}

fn described(field: &SceneField, options: GrowOptions) -> FieldDesc {
    let mut desc = field.desc.clone();
    if let Some(scale) = options.density_scale {
        desc.density = (f64::from(desc.density) * scale) as f32;
        desc.count = desc.count.map(|count| (count as f64 * scale).round().max(1.0) as u64);
    }
    desc.patch_size = options.patch_size.unwrap_or(desc.patch_size);
    desc
}

fn check_memory(blades: u64, available: Option<u64>) -> Result<()> {
    let needed = blades.saturating_mul(BYTES_PER_BLADE);
    match available {
        Some(available) if needed > available => bail!(
            "{blades} blades need about {} MiB of memory, {} are free: {} blades fit; lower the \
             densities or counts",
            needed >> 20,
            available >> 20,
            available / BYTES_PER_BLADE
        ),
        _ => Ok(()),
    }
}

/// Bytes that can be had without swapping; `None` where the system does not say.
fn available_memory() -> Option<u64> {
    let about = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = about.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    line.trim().strip_suffix(" kB")?.parse::<u64>().ok()?.checked_mul(1024)
}

/// Blades of all fields.
pub fn blade_count(fields: &[Field]) -> u64 {
    fields.iter().map(|field| field.blades().len() as u64).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn memory_that_does_not_suffice_says_how_many_fit() {
        assert!(check_memory(u64::MAX, None).is_ok());
        assert!(check_memory(1000, Some(110_000)).is_ok());
        let error = check_memory(1001, Some(110_000)).unwrap_err().to_string();
        assert!(error.contains("1000 blades fit"), "{error}");
    }

    #[test]
    fn a_scale_holds_for_densities_and_counts() {
        let text = "(fields: [(on: Plane(), density: 9), (on: Plane(), count: 700)])";
        let scene = sward_scene::parse(text, Path::new("s.ron")).unwrap();
        let options = GrowOptions { density_scale: Some(0.5), patch_size: Some(128) };
        let fields = grow(&scene, &wgpu::Limits::defaults(), options).unwrap();
        let blades: Vec<_> = fields.iter().map(|field| field.blades().len()).collect();
        assert_eq!(blades, [1800, 350]);
        assert!(fields.iter().all(|field| field.patch_size() == 128));
    }

    #[test]
    fn too_many_blades_are_refused_before_the_first_field_grows() {
        let text =
            "(fields: [(on: Plane(), count: 60000000), (name: \"b\", on: Plane(), count: 4e9)])"
                .replace("4e9", "4000000000");
        let scene = sward_scene::parse(&text, Path::new("s.ron")).unwrap();
        let start = std::time::Instant::now();
        let error = grow(&scene, &wgpu::Limits::defaults(), GrowOptions::default()).unwrap_err();
        let error = format!("{error:#}");
        assert!(start.elapsed().as_secs_f64() < 0.5, "grew first");
        for part in ["s.ron: field 'b': ", "67104768 blades fit", "max_storage_buffer_binding_size"]
        {
            assert!(error.contains(part), "{error}");
        }
    }
}
