//! Ground sweep (Olofsson and Silven 2012, section 3, called O): what a view sees of the ground, found
//! by sweeping the columns of a grid between the corners in which the ground meets the frustum, in
//! place of a test of all there is.
//!
//! Two things are swept: a host's terrain ([`crate::Sweep`]), and the patches of a field, in views by
//! strips: there patch culling asks a patch's cell in place of its own frustum test.

pub(crate) mod grid;
pub(crate) mod patches;
pub mod plan;
pub mod terrain;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod twin;

/// A pipeline whose only group is the stage's.
pub(crate) fn pipeline(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    entry: &str,
    layout: &wgpu::BindGroupLayout,
) -> wgpu::ComputePipeline {
    let label = format!("sward.{entry}");
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(&label),
        bind_group_layouts: &[None, None, Some(layout)],
        immediate_size: 0,
    });
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(&label),
        layout: Some(&layout),
        module,
        entry_point: Some(entry),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    })
}
