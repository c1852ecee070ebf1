//! Functions of a shipped shader, asked one by one.

use super::rig::shared;
use crate::gpu::shaders::Shader;
use crate::gpu::test_device::read;
use glam::Vec4;
use wgpu::BufferUsages as U;
use wgpu::util::DeviceExt;

/// An entry point added to a shader's own source, and what it is made with.
pub(super) struct Entry<'a> {
    pub source: String,
    pub name: &'a str,
    pub constants: &'a [(&'a str, f64)],
}

/// Group, binding, usage and content of a buffer.
pub(super) type Given<'a> = (u32, u32, U, &'a [u8]);

/// Runs so many groups of an entry point, which uses all that it is given and writes `count` vectors
/// to the buffer at `told`, a group and a binding.
pub(super) fn run(
    entry: &Entry,
    given: &[Given],
    (told, count): ((u32, u32), usize),
    groups: u32,
) -> Vec<Vec4> {
    let (device, queue) = shared();
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("test.ask"),
        source: wgpu::ShaderSource::Wgsl(entry.source.as_str().into()),
    });
    let constants = entry.constants;
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("test.ask"),
        layout: None,
        module: &module,
        entry_point: Some(entry.name),
        compilation_options: wgpu::PipelineCompilationOptions { constants, ..Default::default() },
        cache: None,
    });
    let empty = vec![0; count * 16];
    let all = [given, &[(told.0, told.1, U::STORAGE | U::COPY_SRC, &empty[..])]].concat();
    let buffer = |(group, binding, usage, contents): Given| {
        let desc = wgpu::util::BufferInitDescriptor { label: None, contents, usage };
        (group, binding, device.create_buffer_init(&desc))
    };
    let buffers: Vec<_> = all.into_iter().map(buffer).collect();
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut pass = encoder.begin_compute_pass(&Default::default());
    pass.set_pipeline(&pipeline);
    for index in 0..4 {
        let own = buffers.iter().filter(|(group, ..)| *group == index);
        let own = own.map(|(_, binding, buffer)| wgpu::BindGroupEntry {
            binding: *binding,
            resource: buffer.as_entire_binding(),
        });
        let entries: Vec<_> = own.collect();
        if !entries.is_empty() {
            // An automatic layout has what the entry point uses
            let layout = &pipeline.get_bind_group_layout(index);
            let desc = wgpu::BindGroupDescriptor { label: None, layout, entries: &entries };
            pass.set_bind_group(index, &device.create_bind_group(&desc), &[]);
        }
    }
    pass.dispatch_workgroups(groups, 1, 1);
    drop(pass);
    queue.submit([encoder.finish()]);
    let (.., told) = &buffers[buffers.len() - 1];
    read(&device, &queue, told)
}

/// What an entry is asked: `asked`, an array of these.
pub(super) type Asked = [[f32; 4]; 5];

const ARRAYS: &str = "
@group(3) @binding(0) var<storage, read> asked: array<array<vec4<f32>, 5>>;
@group(3) @binding(1) var<storage, read_write> told: array<vec4<f32>>;
";

/// What an entry of 64 threads a group tells of each, in `told`. Uniforms are given by group, binding
/// and content.
pub(super) fn on_gpu(
    (shader, entries, name): (Shader, &str, &str),
    asked: &[Asked],
    uniforms: &[(u32, u32, &[u8])],
) -> Vec<[f32; 4]> {
    let source = [&shader.source(), ARRAYS, entries].concat();
    let entry = Entry { source, name, constants: &[] };
    let mut given: Vec<Given> = uniforms
        .iter()
        .map(|(group, binding, bytes)| (*group, *binding, U::UNIFORM, *bytes))
        .collect();
    given.push((3, 0, U::STORAGE, bytemuck::cast_slice(asked)));
    let told = run(&entry, &given, ((3, 1), asked.len()), asked.len().div_ceil(64) as u32);
    told.into_iter().map(|v| v.to_array()).collect()
}
