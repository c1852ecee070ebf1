//! The sweep against brute force and against its reference, on random cameras.

use super::grid::Grid;
use super::plan::{SweepMethod, plan};
use super::terrain::Sweep;
use super::twin::{Swept, listed};
use crate::gpu::test_device;
use crate::grow::random::{Purpose, Stream};
use crate::grow::terrain::NoiseTerrain;
use crate::{Mesh, View};
use glam::camera::rh::proj::directx::{orthographic, perspective, perspective_infinite};
use glam::{EulerRot, Mat4, Quat, Vec3};
use std::f32::consts::TAU;

fn hills() -> Mesh {
    let terrain = NoiseTerrain { size_m: 120.0, resolution: 60, ..NoiseTerrain::default() };
    Mesh::terrain(terrain).expect("valid terrain")
}

/// A camera anywhere over, in or under the hills; most with a level horizon.
fn random_view(seed: u64) -> View<'static> {
    let mut draws = Stream::new(77, Purpose::Terrain).at(seed);
    let mut between = |low: f32, high: f32| low + (high - low) * draws.unit();
    let eye = Vec3::new(between(-80.0, 80.0), between(-3.0, 40.0), between(-80.0, 80.0));
    let pitch = between(-1.5, 0.6);
    let roll = if seed.is_multiple_of(5) { between(-3.0, 3.0) } else { between(-0.02, 0.02) };
    let turn = Quat::from_euler(EulerRot::YXZ, between(0.0, TAU), pitch, roll);
    let (fov, aspect, near) = (between(0.3, 1.9), between(0.5, 2.5), between(0.05, 1.0));
    let far = between(10.0, 400.0);
    let clip = match seed % 7 {
        0 => perspective_infinite(fov, aspect, near),
        1 => orthographic(-20.0 * aspect, 20.0 * aspect, -15.0, 15.0, near, far),
        _ => perspective(fov, aspect, near, far),
    };
    let world = Mat4::from_rotation_translation(turn, eye);
    View::new(world.inverse(), clip, [320, 200])
}

#[derive(Debug, Default)]
struct Tally {
    cameras: usize,
    by_corners: usize,
    visible: usize,
    extra_by_corners: usize,
    extra_by_test: usize,
}

fn compare(grid: &Grid, view: &View, listed: &[u32], tally: &mut Tally) {
    let settings = plan(grid, view);
    let swept = Swept::new(settings, view);
    let mut next = listed.iter().copied().peekable();
    let mut extra = 0;
    for cell in 0..grid.count() {
        let is_listed = next.next_if_eq(&cell).is_some();
        let (column, row) = (cell / grid.cells.y, cell % grid.cells.y);
        let is_visible = swept.truly_meets(column, row, 1e-6);
        assert!(is_listed || !is_visible, "cell {column}, {row} is missed: {view:?} {settings:?}");
        tally.visible += usize::from(is_visible);
        extra += usize::from(is_listed && !is_visible);
    }
    assert_eq!(next.next(), None, "the list is not in order");
    tally.cameras += 1;
    match settings.method() {
        SweepMethod::Corners => {
            tally.by_corners += 1;
            tally.extra_by_corners += extra;
        }
        SweepMethod::EveryCell => tally.extra_by_test += extra,
    }
}

/// No visible cell is missed; those listed beside are counted.
#[test]
fn no_visible_cell_is_missed() {
    let (device, _) = test_device::device();
    let sweep = Sweep::new(&device, &hills(), 4.0).expect("hills");
    let mut tally = Tally::default();
    for seed in 0..300 {
        let view = random_view(seed);
        let swept = Swept::new(plan(sweep.grid(), &view), &view);
        compare(sweep.grid(), &view, &listed(sweep.grid(), &swept), &mut tally);
    }
    println!("{tally:?}");
    assert!(tally.by_corners > 200 && tally.cameras - tally.by_corners > 50, "{tally:?}");
    let extra = tally.extra_by_corners + tally.extra_by_test;
    assert!(extra * 100 < tally.visible, "{tally:?}");
}

fn listed_by_gpu(
    (device, queue): &(wgpu::Device, wgpu::Queue),
    sweep: &mut Sweep,
    view: &View,
) -> Vec<u32> {
    let mut encoder = device.create_command_encoder(&Default::default());
    sweep.encode(device, &mut encoder, view).expect("a camera");
    queue.submit([encoder.finish()]);
    let words: Vec<u32> = test_device::read(device, queue, sweep.cells());
    words[1..=words[0] as usize].to_vec()
}

/// The shader's lists: no visible cell missed, the reference's but for cells at an edge, and the
/// triangles of those cells and no others.
#[test]
fn the_shader_sweeps_as_its_reference() {
    let gpu = test_device::device();
    let mesh = hills();
    let mut sweep = Sweep::new(&gpu.0, &mesh, 4.0).expect("hills");
    let (mut tally, mut all, mut other) = (Tally::default(), 0, 0);
    for seed in 0..70 {
        let view = random_view(seed);
        let own = listed_by_gpu(&gpu, &mut sweep, &view);
        compare(sweep.grid(), &view, &own, &mut tally);
        let swept = Swept::new(plan(sweep.grid(), &view), &view);
        let expected = listed(sweep.grid(), &swept);
        all += expected.len();
        other += expected.iter().filter(|cell| own.binary_search(cell).is_err()).count();
        other += own.iter().filter(|cell| expected.binary_search(cell).is_err()).count();
        if seed.is_multiple_of(10) {
            compare_triangles(&gpu, &mesh, &sweep, &own);
        }
    }
    println!("{tally:?}; {other} of {all} cells differ from the reference");
    assert!(all > 5_000 && other * 500 <= all, "{other} of {all}");
}

fn compare_triangles(
    (device, queue): &(wgpu::Device, wgpu::Queue),
    mesh: &Mesh,
    sweep: &Sweep,
    cells: &[u32],
) {
    let arguments: Vec<u32> = test_device::read(device, queue, sweep.indirect());
    let mut indices: Vec<u32> = test_device::read(device, queue, sweep.indices());
    indices.truncate(arguments[0] as usize);
    assert_eq!(arguments[1..], [1, 0, 0, 0]);
    let mut drawn: Vec<[u32; 3]> = indices.chunks(3).map(|t| [t[0], t[1], t[2]]).collect();
    let in_cells = |triangle: &[u32; 3]| {
        let center = triangle.map(|v| mesh.positions[v as usize]).iter().sum::<Vec3>() / 3.0;
        cells.iter().any(|cell| {
            let (low, high) = sweep.rectangle(*cell);
            (low.x..high.x).contains(&center.x) && (low.y..high.y).contains(&center.z)
        })
    };
    let mut expected: Vec<_> = mesh.triangles.iter().copied().filter(in_cells).collect();
    drawn.sort_unstable();
    expected.sort_unstable();
    assert_eq!(drawn, expected);
}

/// Roll, a look straight down and a camera under the ground take the fallback by themselves.
#[test]
fn cameras_that_corners_do_not_serve_are_tested_cell_by_cell() {
    let (device, _) = test_device::device();
    let sweep = Sweep::new(&device, &hills(), 4.0).expect("hills");
    let clip = perspective(0.9, 1.5, 0.1, 200.0);
    let method = |height: f32, pitch: f32, roll: f32| {
        let turn = Quat::from_euler(EulerRot::YXZ, 0.4, pitch, roll);
        let world = Mat4::from_rotation_translation(turn, Vec3::new(0.0, height, 0.0));
        plan(sweep.grid(), &View::new(world.inverse(), clip, [300, 200])).method()
    };
    assert_eq!(method(20.0, -0.3, 0.0), SweepMethod::Corners);
    assert_eq!(method(20.0, 0.0, 0.0), SweepMethod::Corners);
    assert_eq!(method(20.0, -1.3, 0.05), SweepMethod::Corners);
    assert_eq!(method(20.0, -0.3, 0.2), SweepMethod::EveryCell);
    assert_eq!(method(20.0, -0.3, 3.1), SweepMethod::EveryCell);
    assert_eq!(method(20.0, -1.55, 0.0), SweepMethod::EveryCell);
    assert_eq!(method(20.0, 1.55, 0.0), SweepMethod::EveryCell);
    assert_eq!(method(-30.0, -0.3, 0.0), SweepMethod::EveryCell);
}

#[test]
fn bad_terrain_is_an_error() {
    let (device, _) = test_device::device();
    let message = |mesh: &Mesh, cell_m| {
        Sweep::new(&device, mesh, cell_m).map(|_| ()).expect_err("bad input").to_string()
    };
    assert!(message(&hills(), 0.0).contains("sweep.cell_m"));
    assert!(message(&hills(), f32::NAN).contains("sweep.cell_m"));
    assert!(message(&Mesh::default(), 4.0).contains("empty"));
}
