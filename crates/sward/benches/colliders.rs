//! What colliders cost, in turns, so that a busy machine slows all alike: physics (colliders near
//! patches, then blades) of a field that a view sees whole, in milliseconds, the least of all turns
//! and their median; and the host's time to order and send them.
//!
//! `cargo bench -p sward --bench colliders`

use glam::camera::rh::{proj::directx::perspective, view::look_at_mat4};
use glam::{UVec2, Vec2, Vec3};
use std::time::Instant;
use sward::{
    Collider, ColliderShape, Field, FieldDesc, Frame, Gusts, Mesh, Pose, Renderer, Sphere, Stage,
    Surface, Targets, View, Wind, WindSource,
};

const SIDE_M: f32 = 40.0;
const BLADES: f32 = 4e5;
const TURNS: usize = 15;

struct Host {
    device: wgpu::Device,
    queue: wgpu::Queue,
    renderer: Renderer,
    wind: Wind,
}

impl Host {
    fn new() -> Self {
        let instance =
            wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
        let adapter = pollster::block_on(instance.request_adapter(&Default::default()))
            .expect("benches need a graphics adapter");
        let (device, queue) = pollster::block_on(adapter.request_device(&Default::default()))
            .expect("the adapter gives a device");
        let mesh = Mesh::plane(Vec2::splat(SIDE_M), UVec2::ONE).expect("a plane");
        let surface = Surface::new(mesh).expect("it has area");
        let desc = FieldDesc { density: BLADES / (SIDE_M * SIDE_M), ..Default::default() };
        let field = Field::grow(&surface, &desc).expect("it grows");
        let targets = Targets::single_sampled(wgpu::TextureFormat::Rgba16Float);
        let mut renderer = Renderer::new(&device, targets).expect("the limits suffice");
        renderer.add_field(&device, &field).expect("it fits");
        let wind = Wind::new(vec![WindSource::Gusts(Gusts::default())]).expect("valid wind");
        Self { device, queue, renderer, wind }
    }

    /// Milliseconds of a step: of the host, and in all.
    fn step(&mut self, colliders: &[Collider]) -> [f64; 2] {
        let eye = look_at_mat4(Vec3::new(0.0, 30.0, 45.0), Vec3::ZERO, Vec3::Y);
        let view = View::new(eye, perspective(1.2, 1.0, 0.1, 300.0), [2048, 2048]);
        self.wind.advance(1.0 / 60.0);
        let frame = Frame { colliders, ..Frame::new(1.0 / 60.0, &self.wind) };
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let start = Instant::now();
        self.renderer.simulate(&self.device, &mut encoder, &frame).expect("a valid frame");
        let host_ms = start.elapsed().as_secs_f64() * 1e3;
        self.renderer.prepare_view(&self.device, &mut encoder, 0, &view).expect("a camera");
        for stage in [Stage::PatchCull, Stage::Physics] {
            self.renderer.encode_stage(&self.device, &mut encoder, stage, 0, &view);
        }
        self.queue.submit([encoder.finish()]);
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("the work ends");
        [host_ms, start.elapsed().as_secs_f64() * 1e3]
    }
}

/// A number of -1 to 1 that depends on its index.
fn scattered(index: usize, step: f32) -> f32 {
    (index as f32 * step).fract() * 2.0 - 1.0
}

/// Balls that move; the first `low` of them in the grass, the others above it.
fn balls(count: usize, low: usize) -> Vec<Collider<'static>> {
    let ball = |i: usize| {
        let up = if i < low { 0.15 } else { 2.0 + 20.0 * scattered(i, 0.271_3).abs() };
        let place =
            Vec3::new(scattered(i, 0.618_034), 0.0, scattered(i, 0.754_878)) * 0.48 * SIDE_M;
        let center = place + Vec3::Y * up;
        let last_pose = Some(Pose::at(center + Vec3::X * 0.02));
        Collider { last_pose, ..Collider::ball(Sphere { center, radius: 0.2 }) }
    };
    (0..count).map(ball).collect()
}

/// A thing of 1,000 balls about 2 m large.
fn packed() -> Vec<Sphere> {
    let ball = |i: usize| {
        let place = Vec3::new(scattered(i, 0.618), scattered(i, 0.754), scattered(i, 0.569));
        Sphere {
            center: place.clamp_length_max(1.0),
            radius: 0.05 + 0.1 * (1.0 - place.length()).max(0.0),
        }
    };
    (0..1000).map(ball).collect()
}

fn main() {
    let mut host = Host::new();
    let thing = packed();
    let shape = ColliderShape::Spheres(&thing);
    let pose = Pose::at(Vec3::new(1.0, 0.6, 4.0));
    let rests = Collider::resting(shape, pose);
    let moves = Collider { last_pose: Some(Pose::at(pose.translation + Vec3::X * 0.02)), ..rests };
    let two = balls(2, 2);
    let scenes = [
        ("none", vec![]),
        ("200 in grass", balls(200, 200)),
        ("10,000, 200 in grass", balls(10_000, 200)),
        ("2", two.clone()),
        ("2, and 1,000 that rest", [&[rests][..], &two].concat()),
        ("2, and 1,000 that move", [&[moves][..], &two].concat()),
    ];
    let mut times = vec![Vec::new(); scenes.len()];
    for turn in 0..TURNS + 2 {
        for ((_, colliders), times) in scenes.iter().zip(&mut times) {
            // What rests is listed in the first of them
            host.step(colliders);
            let measured = host.step(colliders);
            if turn >= 2 {
                times.push(measured);
            }
        }
    }
    println!("{:24} {:>8} {:>8} {:>8}", "colliders", "least", "median", "host");
    for ((name, _), times) in scenes.iter().zip(&times) {
        let column = |i: usize| {
            let mut column: Vec<f64> = times.iter().map(|t| t[i]).collect();
            column.sort_by(f64::total_cmp);
            column
        };
        let (host, all) = (column(0), column(1));
        println!("{name:24} {:8.2} {:8.2} {:8.2}", all[0], all[TURNS / 2], host[0]);
    }
}
