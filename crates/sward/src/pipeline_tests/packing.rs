//! The quantised forms of a blade and of its state, by the shipped WGSL and by its reference.

use super::decoded::{Decoded, decode, facing_of, states};
use super::rig::Rig;
use super::scenes::{Draws, breeze, field_of, random_blade, random_states, species};
use crate::frame::physics::twin::State;
use crate::gpu::bindings::{self, Kind, compute, layout};
use crate::gpu::buffers;
use crate::gpu::quantize::{pack_blade, patch_cube, unpack_blade};
use crate::gpu::shaders::Shader;
use crate::gpu::state_twin::{CRUSH_STEP, unpack_state};
use crate::grow::Blade;
use crate::{Field, Frame, PhysicsModel};
use bytemuck::{Pod, Zeroable};
use glam::{Vec3, Vec4};
use proptest::prelude::*;

const ENTRY: &str = "
struct TestBlade {
    root: vec3<f32>, height: f32,
    up: vec3<f32>, width: f32,
    facing: vec3<f32>, response: f32,
    droop: f32, gust: f32, arch: f32, species: f32,
}
@group(2) @binding(0) var<storage, read_write> test_blades: array<TestBlade>;
@group(2) @binding(1) var<storage, read_write> test_states: array<vec4<f32>>;
@group(2) @binding(2) var<storage, read_write> test_bits: array<vec2<u32>>;

@compute @workgroup_size(64)
fn test_packing(@builtin(global_invocation_id) thread: vec3<u32>) {
    let i = thread.x;
    if i >= page.field.blade_count {
        return;
    }
    let b = unpack_blade(i);
    test_blades[i] = TestBlade(b.root, b.height, b.up, b.width, b.facing, b.response,
        b.droop, b.gust, b.arch, f32(b.species));
    let bits = pack_state(b, BladeState(test_states[i].xyz, test_states[i].w));
    test_bits[i] = bits;
    let state = unpack_state(b, bits);
    test_states[i] = vec4<f32>(state.tip, state.crush);
}
";

#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
struct TestBlade {
    root: Vec3,
    height: f32,
    up: Vec3,
    width: f32,
    facing: Vec3,
    response: f32,
    droop: f32,
    gust: f32,
    arch: f32,
    species: f32,
}

struct Passed {
    blades: Vec<TestBlade>,
    states: Vec<State>,
    bits: Vec<[u32; 2]>,
}

/// Lets the shipped source unpack every blade, and pack and unpack these states.
fn pass(rig: &mut Rig, states: &[State], model: PhysicsModel) -> Passed {
    let wind = breeze();
    rig.simulate(&Frame { physics: model, ..Frame::new(0.01, &wind) });
    let device = rig.device.clone();
    let visibility = wgpu::ShaderStages::COMPUTE;
    let own = layout(&device, "test", visibility, &[Kind::Write, Kind::Write, Kind::Write]);
    let source = Shader::Update.source() + ENTRY;
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("test.packing"),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    });
    let layouts = rig.renderer.layouts();
    let groups = [&layouts.frame, &layouts.field, &own];
    let pipeline = compute(&device, &module, "test_packing", &groups, &[]);
    let count = states.len() as u64;
    let store = |bytes| buffers::storage(&device, "test", bytes, wgpu::BufferUsages::empty());
    let (blades, bits) = (store(count * size_of::<TestBlade>() as u64), store(count * 8));
    let content: Vec<Vec4> =
        states.iter().map(|s| s.tip.as_vec3().extend(s.crush as f32)).collect();
    let usage = wgpu::BufferUsages::STORAGE;
    let in_out = buffers::filled(&device, "test", bytemuck::cast_slice(&content), usage);
    let group = bindings::buffers(&device, "test", &own, &[&blades, &in_out, &bits]);
    rig.submit(|renderer, _, encoder| {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, renderer.frame_group(), &[]);
        pass.set_bind_group(1, &renderer.pages()[0].group, &[]);
        pass.set_bind_group(2, &group, &[]);
        pass.dispatch_workgroups(count.div_ceil(64) as u32, 1, 1);
    });
    let state = |s: &Vec4| State { tip: s.truncate().as_dvec3(), crush: s.w.into() };
    Passed {
        blades: rig.read(&blades),
        states: rig.read(&in_out).iter().map(state).collect(),
        bits: rig.read(&bits),
    }
}

/// Blades any way up, many of them near straight down, near the horizon or exactly upright.
fn any_way_up(seed: u32, count: u32) -> Field {
    let (mut draws, species) = (Draws::new(seed), species());
    let blades: Vec<_> = (0..count)
        .map(|i| {
            let up = match i % 5 {
                0 => draws.unit(),
                1 => Vec3::NEG_Y + draws.unit() * draws.between(0.0, 1.2),
                2 => draws.unit() * Vec3::new(1.0, 1e-4, 1.0),
                3 => Vec3::NEG_Y,
                _ => Vec3::Y,
            };
            let blade = random_blade(&mut draws, &species, 3.0);
            Blade { up: up.normalize_or(Vec3::Y), ..blade }
        })
        .collect();
    field_of(species, &blades, 256)
}

#[test]
fn the_shader_unpacks_blades_as_the_reference() {
    let mut rig = Rig::new(any_way_up(1, 2000));
    let expected = decode(&rig.field);
    let rest: Vec<_> = expected.iter().map(|b| State { tip: b.physics.up, crush: 0.0 }).collect();
    let passed = pass(&mut rig, &rest, PhysicsModel::Sward);
    for (gpu, Decoded { blade, physics, .. }) in passed.blades.iter().zip(&expected) {
        assert!(gpu.root.distance(blade.root) < 1e-6, "{gpu:?} {blade:?}");
        assert!(gpu.up.distance(blade.up) < 1e-6, "{gpu:?} {blade:?}");
        assert!(gpu.facing.distance(facing_of(blade)) < 5e-6, "{gpu:?} {blade:?}");
        assert!(gpu.facing.dot(gpu.up).abs() < 5e-6, "{gpu:?}");
        let near = |a: f32, b: f64| (f64::from(a) - b).abs() < 1e-6 * b.abs().max(1.0);
        assert!(near(gpu.height, physics.height) && near(gpu.width, blade.width.into()));
        assert!(near(gpu.response, physics.response) && near(gpu.droop, physics.droop));
        assert!(near(gpu.gust, physics.gust) && near(gpu.arch, physics.arch));
        assert_eq!(gpu.species, f32::from(blade.species));
    }
}

#[test]
fn the_shader_packs_states_as_the_reference() {
    let mut rig = Rig::new(any_way_up(2, 2000));
    let blades = decode(&rig.field);
    for (model, tip_bound) in [(PhysicsModel::Sward, 1e-6), (PhysicsModel::Paper, 8e-5)] {
        let start = states(&blades, &random_states(7, &blades, model), model);
        // Off the grid of what can be packed
        let turned: Vec<_> = start
            .iter()
            .map(|s| State { tip: s.tip * 0.97, crush: (s.crush * 0.77).min(1.9) })
            .collect();
        let start = if model == PhysicsModel::Paper { turned } else { start };
        let passed = pass(&mut rig, &start, model);
        for (i, blade) in blades.iter().enumerate() {
            let own = unpack_state(&blade.physics, passed.bits[i], model);
            let gpu = passed.states[i];
            assert!(own.tip.distance(gpu.tip) < 1e-6, "{model:?}: {own:?} {gpu:?}");
            assert!((own.crush - gpu.crush).abs() < 1e-6, "{model:?}: {own:?} {gpu:?}");
            let start = start[i];
            assert!(start.tip.distance(gpu.tip) < tip_bound, "{model:?}: {start:?} {gpu:?}");
            // Up or down, by turns
            assert!((start.crush - gpu.crush).abs() < CRUSH_STEP, "{model:?}: {start:?} {gpu:?}");
        }
        // A still blade creeps by the rounding of its frame alone: in 8 frames by less than what
        // a crushed blade recovers in a hundredth of one
        let mut last = passed.states.clone();
        for _ in 0..8 {
            last = pass(&mut rig, &last, model).states;
        }
        for (then, now) in passed.states.iter().zip(&last) {
            assert!(then.tip.distance(now.tip) < 5e-6, "{model:?}: {then:?} {now:?}");
            assert_eq!(then.crush, now.crush, "{model:?}");
        }
    }
}

/// The blade with axes that are unit and square in f64 too. Decoded in f32 they are not quite, and a
/// tip on its root plane may then lie under it, where no state can be.
fn exact_frame(blade: &crate::frame::physics::twin::Blade) -> crate::frame::physics::twin::Blade {
    let up = blade.up.normalize();
    let facing = (blade.facing - up * blade.facing.dot(up)).normalize();
    crate::frame::physics::twin::Blade { up, facing, ..*blade }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// The precision that gpu/layout.rs states.
    #[test]
    fn a_packed_blade_is_near_its_original(seed in any::<u32>()) {
        let field = any_way_up(seed, 320);
        for patch in field.patches() {
            let (_, edge) = patch_cube(patch);
            let own = patch.first as usize..(patch.first + patch.count) as usize;
            for blade in &field.blades()[own] {
                let kind = &field.species()[usize::from(blade.species)];
                let back = unpack_blade(pack_blade(blade, patch, kind), patch, field.species());
                let off = (back.root - blade.root).abs().max_element();
                prop_assert!(off <= 0.51 * edge / 65535.0 + 1e-6, "root {off} of {edge}");
                let up = back.up.cross(blade.up).length().asin().to_degrees();
                prop_assert!(up < 0.004 && back.up.dot(blade.up) > 0.0, "up {up} degrees");
                let turn = facing_of(&back).distance(facing_of(blade)).to_degrees();
                prop_assert!(turn < 0.09, "facing {turn} degrees, up {}", blade.up);
                let within = |a: f32, b: f32, range: crate::Range, steps: f32| {
                    (a - b).abs() <= 0.51 * (range.max - range.min) / steps + 1e-6
                };
                prop_assert!(within(back.height, blade.height, kind.height_m, 4095.0));
                prop_assert!(within(back.width, blade.width, kind.width_m, 255.0));
                prop_assert!(within(back.response, blade.response, kind.response, 255.0));
                prop_assert_eq!(back.species, blade.species);
            }
        }
    }

    #[test]
    fn a_packed_state_is_near_its_original(seed in any::<u32>()) {
        let blades = decode(&any_way_up(seed, 64));
        let mut draws = Draws::new(seed ^ 0x5a5a);
        for (model, bound) in [(PhysicsModel::Sward, 1e-6), (PhysicsModel::Paper, 6e-5)] {
            for b in &blades.iter().map(|b| exact_frame(&b.physics)).collect::<Vec<_>>() {
                let lean = draws.unit().as_dvec3() * 1.4;
                let tip =
                    crate::shared::curve_twin::project_tip(b.up + lean, b.up, b.facing, b.arch);
                let state = State { tip, crush: draws.between(0.0, 1.999).into() };
                let bits = crate::gpu::state_twin::pack_state(b, state, model);
                let back = unpack_state(b, bits, model);
                let off = back.tip.distance(tip);
                prop_assert!(off < bound, "{:?}: {}", model, off);
                prop_assert!((back.crush - state.crush).abs() <= 0.51 * CRUSH_STEP);
            }
        }
    }
}
