//! Growing all fields of a scene.

use anyhow::{Context, Result};
use sward::Field;
use sward_scene::Scene;

/// Most blades a scene: growing holds about 100 bytes a blade in memory, and a blade's index is 32
/// bits on the GPU.
pub const MAX_BLADES: u64 = 1 << 27;

/// Changes to a scene's fields before they grow.
#[derive(Debug, Clone, Copy, Default)]
pub struct GrowOptions {
    /// Multiplies every density.
    pub density_scale: Option<f32>,
    /// Blades a patch.
    pub patch_size: Option<u32>,
}

/// Grows every field of a scene.
///
/// # Errors
/// What [`Field::grow`] reports, with the field's name.
pub fn grow(scene: &Scene, options: GrowOptions) -> Result<Vec<Field>> {
    let mut left = MAX_BLADES;
    let mut fields = Vec::with_capacity(scene.fields.len());
    for field in &scene.fields {
        let mut desc = field.desc.clone();
        desc.density *= options.density_scale.unwrap_or(1.0);
        desc.patch_size = options.patch_size.unwrap_or(desc.patch_size);
        desc.max_blades = desc.max_blades.min(left);
        let grown = Field::grow(&field.surface, &desc)
            .with_context(|| format!("{}: field '{}'", scene.path.display(), field.name))?;
        left = left.saturating_sub(grown.blades().len() as u64);
        fields.push(grown);
    }
    Ok(fields)
}

/// Blades of all fields.
pub fn blade_count(fields: &[Field]) -> u64 {
    fields.iter().map(|field| field.blades().len() as u64).sum()
}
