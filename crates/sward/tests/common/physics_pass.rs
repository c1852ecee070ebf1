//! A small compute pass that runs the shipped WGSL on blades and states given one by one.

use crate::device;
use bytemuck::{Pod, Zeroable};
use sward::Wind;
use sward::frame::collide::primitive::GpuPrimitive;
use sward::frame::physics::twin::{Blade, State, Surroundings};
use wgpu::util::DeviceExt;

const SHADER: &str = concat!(
    include_str!("../../src/shared/frame.wgsl"),
    include_str!("../../src/shared/noise.wgsl"),
    include_str!("../../src/shared/blade.wgsl"),
    include_str!("../../src/shared/curve.wgsl"),
    include_str!("../../src/frame/wind/wind.wgsl"),
    include_str!("../../src/frame/collide/primitive.wgsl"),
    include_str!("../../src/frame/collide/cuboid.wgsl"),
    include_str!("../../src/frame/wind/placed.wgsl"),
    include_str!("../../src/frame/wind/textured.wgsl"),
    include_str!("../../src/frame/collide/contact.wgsl"),
    include_str!("../../src/frame/physics/physics.wgsl"),
    include_str!("../../src/frame/physics/paper.wgsl"),
    include_str!("physics_pass.wgsl"),
);

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct GpuFrame {
    gravity_direction: [f32; 4],
    gravity_center: [f32; 4],
    light: [[f32; 4]; 7],
    dt_s: f32,
    gravity_blend: f32,
    crush_decay: f32,
    physics_model: u32,
    wind_count: u32,
    chunk_count: u32,
    step: u32,
    ticks: u32,
    unused: [u32; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct GpuBlade {
    root: [f32; 3],
    pad0: f32,
    up: [f32; 3],
    pad1: f32,
    facing: [f32; 3],
    height: f32,
    width: f32,
    response: f32,
    droop: f32,
    gust: f32,
    arch: f32,
    species: u32,
    id: u32,
    pad2: u32,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Model {
    Sward,
    Paper,
    /// Not a step: the tip of a blade at rest, to start from.
    Rest,
}

/// One of the twin's blades with numbers that `f32` holds, so that both sides see the same.
pub fn rounded(blade: Blade) -> Blade {
    let f = |x: f64| f64::from(x as f32);
    let v = |x: glam::DVec3| x.as_vec3().as_dvec3();
    Blade {
        root: v(blade.root),
        up: v(blade.up),
        facing: v(blade.facing),
        height: f(blade.height),
        response: f(blade.response),
        droop: f(blade.droop),
        gust: f(blade.gust),
        arch: f(blade.arch),
    }
}

pub struct PhysicsPass {
    device: wgpu::Device,
    queue: wgpu::Queue,
    pipeline: wgpu::ComputePipeline,
    blades: wgpu::Buffer,
    states: wgpu::Buffer,
    count: usize,
}

impl PhysicsPass {
    pub fn new(blades: &[Blade], states: &[State]) -> Self {
        let (device, queue) = device();
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("physics pass"),
            source: wgpu::ShaderSource::Wgsl(SHADER.into()),
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("physics pass"),
            layout: None,
            module: &module,
            entry_point: Some("main"),
            compilation_options: Default::default(),
            cache: None,
        });
        let blades: Vec<GpuBlade> = blades.iter().enumerate().map(gpu_blade).collect();
        let states: Vec<[f32; 4]> =
            states.iter().map(|s| s.tip.as_vec3().extend(s.crush as f32).to_array()).collect();
        let storage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        Self {
            blades: buffer(&device, bytemuck::cast_slice(&blades), storage),
            states: buffer(&device, bytemuck::cast_slice(&states), storage),
            count: blades.len(),
            device,
            queue,
            pipeline,
        }
    }

    /// Advances every blade by its gap. `around.primitives` holds as many for each blade.
    pub fn step(&self, around: &Surroundings, gaps_s: &[f32], model: Model) {
        let storage = wgpu::BufferUsages::STORAGE;
        let mut wind = around.wind.gpu_sources();
        let frame = self.frame(around, wind.len(), model);
        wind.resize(Wind::MAX_SOURCES, Zeroable::zeroed());
        let mut primitives: Vec<_> = around.primitives.iter().map(GpuPrimitive::from).collect();
        primitives.resize(primitives.len().max(1), Zeroable::zeroed());
        // The sources stand at the end of the frame
        let bytes = [bytemuck::bytes_of(&frame), bytemuck::cast_slice(&wind)].concat();
        let frame = buffer(&self.device, &bytes, wgpu::BufferUsages::UNIFORM);
        let primitives = buffer(&self.device, bytemuck::cast_slice(&primitives), storage);
        let gaps = buffer(&self.device, bytemuck::cast_slice(gaps_s), storage);
        let no_maps = self.no_maps();
        let group0 = self.group(0, &[&frame, &primitives], Some(&no_maps));
        let group1 = self.group(1, &[&self.blades, &self.states, &gaps], None);
        let mut encoder = self.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &group0, &[]);
            pass.set_bind_group(1, &group1, &[]);
            pass.dispatch_workgroups(self.count.div_ceil(64) as u32, 1, 1);
        }
        self.queue.submit([encoder.finish()]);
    }

    fn frame(&self, around: &Surroundings, wind_count: usize, model: Model) -> GpuFrame {
        let gravity = &around.gravity;
        GpuFrame {
            gravity_direction: gravity.direction.extend(gravity.strength).to_array(),
            gravity_center: gravity.center.extend(gravity.center_strength).to_array(),
            light: [[0.0; 4]; 7],
            dt_s: around.dt_s as f32,
            gravity_blend: gravity.blend,
            crush_decay: around.crush_decay as f32,
            physics_model: model as u32,
            wind_count: wind_count as u32,
            chunk_count: (around.primitives.len() / self.count) as u32,
            step: 0,
            ticks: 0,
            unused: [0; 4],
        }
    }

    /// Winds with maps have a test of their own.
    fn no_maps(&self) -> wgpu::TextureView {
        let texture = self.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d::default(),
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rg32Float,
            usage: wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        texture.create_view(&Default::default())
    }

    /// Buffers, then a texture.
    fn group(
        &self,
        index: u32,
        buffers: &[&wgpu::Buffer],
        texture: Option<&wgpu::TextureView>,
    ) -> wgpu::BindGroup {
        let mut entries: Vec<_> = buffers
            .iter()
            .enumerate()
            .map(|(i, buffer)| wgpu::BindGroupEntry {
                binding: i as u32,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        entries.extend(texture.map(|view| wgpu::BindGroupEntry {
            binding: buffers.len() as u32,
            resource: wgpu::BindingResource::TextureView(view),
        }));
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.pipeline.get_bind_group_layout(index),
            entries: &entries,
        })
    }

    pub fn states(&self) -> Vec<State> {
        let read = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: self.states.size(),
            usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let mut encoder = self.device.create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(&self.states, 0, &read, 0, self.states.size());
        self.queue.submit([encoder.finish()]);
        read.map_async(wgpu::MapMode::Read, .., |result| result.expect("mapping for reading"));
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("the device finishes");
        let bytes = read.get_mapped_range(..).expect("the buffer is mapped");
        let state = |s: &[f32; 4]| State {
            tip: glam::Vec3::from_slice(s).as_dvec3(),
            crush: f64::from(s[3]),
        };
        bytemuck::cast_slice(&bytes).iter().map(state).collect()
    }
}

fn buffer(device: &wgpu::Device, contents: &[u8], usage: wgpu::BufferUsages) -> wgpu::Buffer {
    device.create_buffer_init(&wgpu::util::BufferInitDescriptor { label: None, contents, usage })
}

fn gpu_blade((id, blade): (usize, &Blade)) -> GpuBlade {
    GpuBlade {
        root: blade.root.as_vec3().to_array(),
        up: blade.up.as_vec3().to_array(),
        facing: blade.facing.as_vec3().to_array(),
        height: blade.height as f32,
        width: 0.01,
        response: blade.response as f32,
        droop: blade.droop as f32,
        gust: blade.gust as f32,
        arch: blade.arch as f32,
        id: id as u32,
        ..Zeroable::zeroed()
    }
}
