//! `wind_at` of the shipped shader against its reference, for every kind of source.

use super::rig::shared;
use crate::frame::wind::atlas::WindAtlas;
use crate::gpu::layout::GpuFrame;
use crate::gpu::shaders::Shader;
use crate::gpu::test_device::read;
use crate::shared::noise_twin::hash01;
use crate::{Cosine, Fan, Gusts, Rotor, Vortex, Waves, Wind, WindMap, WindSource, WindTexture};
use glam::{Vec3, vec2, vec3};
use wgpu::util::DeviceExt;

/// Asks `wind_at` at a list of places and times.
const ENTRY: &str = "
@group(3) @binding(0) var<storage, read> asked: array<vec4<f32>>;
@group(3) @binding(1) var<storage, read_write> told: array<vec4<f32>>;

@compute @workgroup_size(64)
fn tell_wind(@builtin(global_invocation_id) thread: vec3<u32>) {
    if thread.x < arrayLength(&asked) {
        let at = asked[thread.x];
        told[thread.x] = vec4<f32>(wind_at(at.xyz, at.w), 0.0);
    }
}
";

fn buffer(device: &wgpu::Device, bytes: &[u8], usage: wgpu::BufferUsages) -> wgpu::Buffer {
    let usage = usage | wgpu::BufferUsages::COPY_SRC;
    let desc = wgpu::util::BufferInitDescriptor { label: None, contents: bytes, usage };
    device.create_buffer_init(&desc)
}

/// The wind of each of `winds` at each place (xyz) and time ago (w), as the GPU works it out.
fn on_gpu(winds: &[Wind], asked: &[[f32; 4]]) -> Vec<Vec<Vec3>> {
    let (device, queue) = shared();
    let source = Shader::Update.source() + ENTRY;
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("test.wind"),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("test.wind"),
        layout: None,
        module: &module,
        entry_point: Some("tell_wind"),
        compilation_options: Default::default(),
        cache: None,
    });
    let group = |index: u32, bindings: &[(u32, wgpu::BindingResource)]| {
        let entries = bindings.iter().map(|(binding, resource)| wgpu::BindGroupEntry {
            binding: *binding,
            resource: resource.clone(),
        });
        let entries: Vec<_> = entries.collect();
        let layout = &pipeline.get_bind_group_layout(index);
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout,
            entries: &entries,
        })
    };
    let (uniform, storage) = (wgpu::BufferUsages::UNIFORM, wgpu::BufferUsages::STORAGE);
    let places = buffer(&device, bytemuck::cast_slice(asked), storage);
    let told = buffer(&device, &vec![0; asked.len() * 16], storage);
    let ask = |wind: &Wind| {
        let sources = wind.gpu_sources();
        let mut frame: GpuFrame = bytemuck::Zeroable::zeroed();
        frame.wind_count = sources.len() as u32;
        frame.wind_sources[..sources.len()].copy_from_slice(&sources);
        let frame = buffer(&device, bytemuck::bytes_of(&frame), uniform);
        let mut encoder = device.create_command_encoder(&Default::default());
        let mut maps = WindAtlas::new(&device);
        maps.write(&device, &mut encoder, &wind.sources);
        let maps = wgpu::BindingResource::TextureView(maps.view());
        let frame = frame.as_entire_binding();
        let lists = [(0, places.as_entire_binding()), (1, told.as_entire_binding())];
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group(0, &[(0, frame), (2, maps)]), &[]);
        pass.set_bind_group(3, &group(3, &lists), &[]);
        pass.dispatch_workgroups(asked.len().div_ceil(64) as u32, 1, 1);
        drop(pass);
        queue.submit([encoder.finish()]);
        let told: Vec<[f32; 4]> = read(&device, &queue, &told);
        told.into_iter().map(|[x, y, z, _]| vec3(x, y, z)).collect()
    };
    winds.iter().map(ask).collect()
}

fn texture(map: WindMap, speed_mps: f32) -> WindSource {
    let (direction, map) = (vec2(-0.4, 1.0), std::sync::Arc::new(map));
    WindSource::Texture(WindTexture { direction, map, speed_mps, size_m: 17.0, strength: 1.3 })
}

fn small(i: u32) -> [f32; 2] {
    [hash01(i, 1), hash01(i, 2) - 0.5]
}

/// Two of each kind, with unequal settings, some of them moving.
fn sources() -> Vec<WindSource> {
    let at = vec3(3.0, 6.0, -2.0);
    let velocity = vec3(2.0, -0.5, 1.5);
    let fan = Fan { velocity, direction: vec3(1.0, -0.1, 0.2), radius_m: 2.0, ..Fan::default() };
    let (level, seed) = (vec2(1.0, 0.3), 9);
    vec![
        WindSource::Waves(Waves { direction: level, ..Waves::default() }),
        WindSource::Gusts(Gusts { direction: level, ..Gusts::default() }),
        WindSource::Cosine(Cosine { direction: level, ..Cosine::default() }),
        WindSource::Cosine(Cosine { wavelength_m: f32::INFINITY, ..Cosine::default() }),
        WindSource::Rotor(Rotor { position: at, velocity, ..Rotor::default() }),
        WindSource::Rotor(Rotor { rpm: -90.0, blades: 5, pulse: 0.9, seed, ..Rotor::default() }),
        WindSource::Vortex(Vortex { position: at, velocity, clockwise: true, ..Vortex::default() }),
        WindSource::Vortex(Vortex { radius_m: 0.5, turbulence: 1.0, seed, ..Vortex::default() }),
        WindSource::Fan(Fan { position: vec3(-9.0, 2.0, 0.0), range_m: 40.0, ..fan }),
        WindSource::Fan(Fan { direction: Vec3::NEG_Y, turbulence: 0.0, ..Fan::default() }),
        texture(WindMap::noise(3, 5), -4.0),
        // As narrow as can be, and of another size: the rows of the second map come after the first's
        texture(WindMap::new(3, 5, (0..15).map(small).collect()).expect("a map"), 3.0),
    ]
}

/// Places round the sources, their very middles among them, now, a frame ago and long ago.
fn asked() -> Vec<[f32; 4]> {
    let mut asked = vec![];
    for ago in [0.0, 0.016, 2.0, 30.0] {
        asked.push([3.0, 6.0, -2.0, ago]);
        asked.push([0.0, 4.0, 0.0, ago]);
        asked.push([0.0, 0.0, 0.0, ago]);
        asked.push([0.0, 0.6, 0.0, ago]);
        asked.push([1e6, -1e6, 1e6, ago]);
    }
    for i in 0..3000 {
        let draw = |salt, reach: f32| (hash01(i, salt) - 0.5) * 2.0 * reach;
        let reach = if i % 2 == 0 { 4.0 } else { 50.0 };
        let ago = if i % 3 == 0 { 0.0 } else { 12.0 * hash01(i, 4).powi(3) };
        asked.push([draw(1, reach), draw(2, 3.0), draw(3, reach), ago]);
    }
    asked
}

#[test]
fn every_kind_equals_its_reference() {
    let mut winds: Vec<Wind> = sources().into_iter().map(|s| Wind::new(vec![s]).unwrap()).collect();
    winds.push(Wind::new(sources()).unwrap());
    winds.iter_mut().for_each(|wind| wind.advance(1234.5));
    let asked = asked();
    for (wind, told) in winds.iter().zip(on_gpu(&winds, &asked)) {
        let (mut worst, mut peak) = (0.0_f32, 0.0_f32);
        for (&[x, y, z, ago], gpu) in asked.iter().zip(told) {
            let cpu = wind.strength_at(vec3(x, y, z), ago);
            let difference = cpu.distance(gpu);
            assert!(difference.is_finite(), "{x} {y} {z} {ago}: {gpu}");
            // There f32 itself has no more than 6 cm.
            let far = x > 1e5;
            let difference = if far { 0.0 } else { difference };
            (worst, peak) = (worst.max(difference), peak.max(cpu.length()));
        }
        println!("{:.40}: worst {worst:.1e} of {peak:.2}", format!("{:?}", wind.sources));
        assert!(peak > 0.3, "{:?} is felt nowhere", wind.sources);
        assert!(worst < 5e-4, "{:?}: {worst}", wind.sources);
    }
}
