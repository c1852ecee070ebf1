//! Functions of a shipped shader, asked one by one.

use super::rig::shared;
use crate::gpu::shaders::Shader;
use crate::gpu::test_device::read;
use wgpu::BufferUsages as U;
use wgpu::util::DeviceExt;

/// What an entry is asked: `asked`, an array of these.
pub(super) type Asked = [[f32; 4]; 5];
/// Group, binding and content.
pub(super) type Uniform<'a> = (u32, u32, &'a [u8]);

const ARRAYS: &str = "
@group(3) @binding(0) var<storage, read> asked: array<array<vec4<f32>, 5>>;
@group(3) @binding(1) var<storage, read_write> told: array<vec4<f32>>;
";

/// What an entry tells of each, in `told`. Entries are added to a shader's own source and run with 64
/// threads a group.
pub(super) fn on_gpu(
    (shader, entries, entry): (Shader, &str, &str),
    asked: &[Asked],
    uniforms: &[Uniform],
) -> Vec<[f32; 4]> {
    let (device, queue) = shared();
    let source = [&shader.source(), ARRAYS, entries].concat();
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("test.ask"),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("test.ask"),
        layout: None,
        module: &module,
        entry_point: Some(entry),
        compilation_options: Default::default(),
        cache: None,
    });
    let buffer = |contents: &[u8], usage| {
        let desc = wgpu::util::BufferInitDescriptor { label: None, contents, usage };
        device.create_buffer_init(&desc)
    };
    let places = buffer(bytemuck::cast_slice(asked), U::STORAGE);
    let told = buffer(&vec![0; asked.len() * 16], U::STORAGE | U::COPY_SRC);
    let group = |index: u32, entries: &[(u32, &wgpu::Buffer)]| {
        let entries = entries.iter().map(|(binding, buffer)| wgpu::BindGroupEntry {
            binding: *binding,
            resource: buffer.as_entire_binding(),
        });
        let entries: Vec<_> = entries.collect();
        let layout = &pipeline.get_bind_group_layout(index);
        let desc = wgpu::BindGroupDescriptor { label: None, layout, entries: &entries };
        device.create_bind_group(&desc)
    };
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut pass = encoder.begin_compute_pass(&Default::default());
    pass.set_pipeline(&pipeline);
    for (index, binding, bytes) in uniforms {
        let content = buffer(bytes, U::UNIFORM);
        pass.set_bind_group(*index, &group(*index, &[(*binding, &content)]), &[]);
    }
    pass.set_bind_group(3, &group(3, &[(0, &places), (1, &told)]), &[]);
    pass.dispatch_workgroups(asked.len().div_ceil(64) as u32, 1, 1);
    drop(pass);
    queue.submit([encoder.finish()]);
    read(&device, &queue, &told)
}
