//! `sward info`: the graphics adapter.

use anyhow::Result;
use std::io::Write;
use sward_app::gpu::Gpu;

const EXAMPLES: &str = "\
Examples:
  sward info
  WGPU_ADAPTER_NAME=llvmpipe sward info";

/// Show the graphics adapter, its limits and features, as they are used
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {}

/// Prints them.
pub fn run(_: Args) -> Result<()> {
    let gpu = Gpu::headless()?;
    let info = gpu.adapter.get_info();
    let limits = gpu.device.limits();
    let counts = gpu.sample_counts();
    let counts = counts.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
    let mut table = crate::table::Table::default();
    table.row(["adapter", &info.name]);
    table.row(["kind", &format!("{:?}", info.device_type)]);
    table.row(["driver", &format!("{} {}", info.driver, info.driver_info)]);
    table.row(["backend", &info.backend.to_string()]);
    table.row(["samples a pixel", &counts]);
    let limits: [(&str, u64); 7] = [
        ("max_texture_dimension_2d", limits.max_texture_dimension_2d.into()),
        ("max_buffer_size", limits.max_buffer_size),
        ("max_storage_buffer_binding_size", limits.max_storage_buffer_binding_size),
        (
            "max_storage_buffers_per_shader_stage",
            limits.max_storage_buffers_per_shader_stage.into(),
        ),
        ("max_bind_groups", limits.max_bind_groups.into()),
        (
            "max_compute_invocations_per_workgroup",
            limits.max_compute_invocations_per_workgroup.into(),
        ),
        (
            "max_compute_workgroups_per_dimension",
            limits.max_compute_workgroups_per_dimension.into(),
        ),
    ];
    for (name, value) in limits {
        table.row([name, &crate::table::thousands(value)]);
    }
    let features: Vec<_> = gpu.device.features().iter_names().map(|(name, _)| name).collect();
    table.row(["features used", if features.is_empty() { "none" } else { "" }]);
    let mut out = std::io::stdout();
    write!(out, "{table}")?;
    for feature in features {
        writeln!(out, "  {feature}")?;
    }
    Ok(())
}
