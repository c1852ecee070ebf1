//! Every limit of the adapter is checked before it is met.

use super::layout::{BAND, MAX_PAGES, PAGE_BLADES};
use crate::Error;

fn at_least(what: &str, limit: &'static str, needed: u64, available: u64) -> Result<(), Error> {
    if available >= needed {
        return Ok(());
    }
    Err(Error::Limit {
        what: what.into(),
        limit,
        needed,
        available,
        remedy: "request the device with wgpu::Limits::default()".into(),
    })
}

/// What the pipelines need, all of it within `wgpu::Limits::default()`.
pub fn check_device(limits: &wgpu::Limits) -> Result<(), Error> {
    let compute = "blade update";
    at_least(
        compute,
        "max_storage_buffers_per_shader_stage",
        8,
        limits.max_storage_buffers_per_shader_stage.into(),
    )?;
    at_least(
        "scan",
        "max_compute_invocations_per_workgroup",
        256,
        limits.max_compute_invocations_per_workgroup.into(),
    )?;
    at_least(
        "scan",
        "max_compute_workgroup_size_x",
        256,
        limits.max_compute_workgroup_size_x.into(),
    )?;
    at_least(compute, "max_bind_groups", 4, limits.max_bind_groups.into())?;
    at_least(
        "species table",
        "max_uniform_buffer_binding_size",
        super::page::SPECIES_TABLE_BYTES,
        limits.max_uniform_buffer_binding_size,
    )
}

/// Bytes of a blade in the largest buffer of a page.
const BYTES: u64 = 16;

/// Blades of one page: what one storage binding and one dispatch hold, in whole patches.
pub fn page_blades(limits: &wgpu::Limits, patch_size: u32) -> u64 {
    let bytes = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
    let groups = u64::from(limits.max_compute_workgroups_per_dimension);
    let size = u64::from(patch_size.max(1));
    // One workgroup a band
    let blades = PAGE_BLADES.min(bytes / BYTES).min(groups * u64::from(BAND));
    (blades / size).max(1) * size
}

/// Checks that a field fits, and names what it does not fit.
///
/// # Errors
/// [`Error::Limit`] with how many blades fit.
pub fn check_blades(limits: &wgpu::Limits, patch_size: u32, count: u64) -> Result<(), Error> {
    let most = max_blades(limits, patch_size);
    if count <= most {
        return Ok(());
    }
    let patches = count.div_ceil(MAX_PAGES).div_ceil(u64::from(patch_size.max(1)));
    let blades = patches.saturating_mul(u64::from(patch_size));
    let bands = blades.div_ceil(BAND.into());
    let needed_bytes = blades.saturating_mul(BYTES);
    let bytes = limits.max_storage_buffer_binding_size;
    let groups = u64::from(limits.max_compute_workgroups_per_dimension);
    let candidates = [
        ("max_storage_buffer_binding_size", needed_bytes, bytes),
        ("max_buffer_size", needed_bytes, limits.max_buffer_size),
        ("max_compute_workgroups_per_dimension", bands, groups),
        ("a draw list's range of indices", blades, PAGE_BLADES),
    ];
    let passed = candidates.into_iter().find(|(_, needed, available)| needed > available);
    let (limit, needed, available) = passed.unwrap_or(candidates[0]);
    Err(Error::Limit {
        what: format!("a field of {count} blades"),
        limit,
        needed,
        available,
        remedy: format!("{most} blades fit: lower the density"),
    })
}

/// Most blades that a field may have on a device: 16 pages of up to 4 million blades, fewer where
/// `max_storage_buffer_binding_size` holds fewer (16 bytes a blade).
pub fn max_blades(limits: &wgpu::Limits, patch_size: u32) -> u64 {
    page_blades(limits, patch_size) * MAX_PAGES
}
