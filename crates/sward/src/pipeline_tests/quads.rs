//! Bands, corners of quads and the moving shade of the shipped shader, against their references.

use super::ask::{Asked, on_gpu};
use crate::frame::draw::quads_twin::{Plant, quad_of};
use crate::frame::level::bands_twin::{choose, stretch};
use crate::frame::light::shade_twin;
use crate::gpu::layout::{GpuFrame, GpuPage};
use crate::gpu::shaders::Shader;
use crate::gpu::view::gpu_view;
use crate::shared::curve_twin::project_tip;
use crate::shared::noise_twin::hash01;
use crate::{Bands, Shade, View};
use bytemuck::Zeroable;
use glam::camera::rh::proj::directx::perspective_infinite as camera;
use glam::{DVec2, DVec3, Mat4, Vec2, Vec3, dvec2};

/// In no list.
const NO_BUCKET: usize = 15;

const ENTRIES: &str = "
@compute @workgroup_size(64)
fn tell_corners(@builtin(global_invocation_id) thread: vec3<u32>) {
    if thread.x >= arrayLength(&asked) {
        return;
    }
    let at = asked[thread.x];
    var blade: Blade;
    blade.root = at[0].xyz;
    blade.arch = at[0].w;
    blade.up = at[1].xyz;
    blade.facing = at[2].xyz;
    let morph = at[1].w;
    let shape = quad_of(u32(at[2].w), 3u, 1.0, morph);
    let size = vec2<f32>(at[4].x * shape.width, at[4].y);
    let point = morphed_point(blade, at[3].xyz, size, shape.turn, at[3].w, at[4].zw, morph);
    told[thread.x] = vec4<f32>(point.position, 0.0);
}

@compute @workgroup_size(64)
fn tell_bands(@builtin(global_invocation_id) thread: vec3<u32>) {
    if thread.x >= arrayLength(&asked) {
        return;
    }
    let at = asked[thread.x][0];
    var blade: Blade;
    blade.id = thread.x;
    blade.width = 0.3;
    blade.species = u32(at.w);
    var size: Size;
    size.distance = at.x;
    size.keep = at.y;
    let choice = choose_plant(blade, size, Place(0u, 1u, at.z, 1.0));
    told[thread.x] = vec4<f32>(f32(choice.bucket), choice.morph, choice.fade, choice.widened);
}

@compute @workgroup_size(64)
fn tell_shade(@builtin(global_invocation_id) thread: vec3<u32>) {
    if thread.x < arrayLength(&asked) {
        told[thread.x] = vec4<f32>(sun_shade(asked[thread.x][0].xyz));
    }
}
";

fn tell(entry: &str, asked: &[Asked], uniforms: &[(u32, u32, &[u8])]) -> Vec<[f32; 4]> {
    on_gpu((Shader::DrawBillboard, ENTRIES, entry), asked, uniforms)
}

fn draw(i: u32, salt: u32) -> f32 {
    hash01(i, 100 + salt)
}

fn direction(i: u32, salt: u32) -> Vec3 {
    let part = |k| draw(i, salt + k) - 0.5;
    Vec3::new(part(0), part(1), part(2)).normalize()
}

#[test]
fn corners_equal_their_reference() {
    let mut asked: Vec<Asked> = Vec::new();
    let mut expected: Vec<DVec3> = Vec::new();
    for i in 0..2000 {
        let up = if i % 3 == 0 { Vec3::Y } else { direction(i, 1) };
        let facing = up.cross(direction(i, 4)).normalize();
        let lean = up + direction(i, 7) * draw(i, 10) * 1.5;
        let tip = project_tip(lean.as_dvec3(), up.as_dvec3(), facing.as_dvec3(), 0.3).as_vec3();
        let (quad, row) =
            (i % 3, f32::from(i as u8 % 2) * 0.5 + 0.5 * f32::from(i.is_multiple_of(5)));
        let (u, v) = ((i / 3 % 2) as f32, row.min(1.0));
        let (morph, twist) = ([0.0, 0.4, 1.0][(i % 7 % 3) as usize], draw(i, 12) - 0.5);
        let root = direction(i, 13) * 20.0;
        let size = Vec2::new(0.1 + draw(i, 16), 0.1 + draw(i, 17));
        asked.push([
            root.extend(0.3).to_array(),
            up.extend(morph).to_array(),
            facing.extend(quad as f32).to_array(),
            tip.extend(twist).to_array(),
            [size.x, size.y, u, v],
        ]);
        let d = |v: Vec3| v.as_dvec3();
        let (turn, width) = quad_of(quad, 3, 1.0, f64::from(morph));
        let plant = Plant {
            root: d(root),
            up: d(up),
            facing: d(facing),
            tip: d(tip),
            arch: f64::from(0.3_f32),
            size: dvec2(f64::from(size.x) * width, f64::from(size.y)),
            twist: f64::from(twist),
        };
        expected.push(plant.morphed(turn, f64::from(u), f64::from(v), f64::from(morph)));
    }
    for (i, (told, twin)) in tell("tell_corners", &asked, &[]).iter().zip(expected).enumerate() {
        let error = Vec3::from_slice(told).as_dvec3().distance(twin);
        assert!(error < 3e-5, "{i}: {error:e} of {:?}", asked[i]);
    }
}

#[test]
fn bands_equal_their_reference() {
    let bands = Bands { near_m: 4.0, middle_m: 20.0, far_m: 70.0, ..Bands::default() };
    let detail = 1.3;
    let matrices = (Mat4::IDENTITY, camera(1.0, 1.0, 0.1));
    let view = View { bands, detail, ..View::new(matrices.0, matrices.1, [64, 64]) };
    let uniform = gpu_view(&view, 1);
    let mut page = GpuPage::zeroed();
    page.species[1].look[3] = 0x103;
    let asked: Vec<Asked> = (0..4000)
        .map(|i| {
            let keep = if i % 2 == 0 { 1e6 } else { 0.3 + draw(i, 2) };
            let place = [90.0 * draw(i, 1) * draw(i, 4), keep, draw(i, 3), (i / 2 % 2) as f32];
            [place, [0.0; 4], [0.0; 4], [0.0; 4], [0.0; 4]]
        })
        .collect();
    let uniforms: [(u32, u32, &[u8]); 2] =
        [(1, 0, bytemuck::bytes_of(&page)), (2, 0, bytemuck::bytes_of(&uniform))];
    let mut seen = [0; 16];
    for (i, told) in (0..).zip(tell("tell_bands", &asked, &uniforms)) {
        let [distance, keep, rank, modelled] = asked[i as usize][0];
        let stretch = stretch(&bands, detail, i);
        let twin = choose(&bands, stretch, (distance, keep, rank), modelled == 1.0);
        let bucket = twin.bucket.unwrap_or(NO_BUCKET);
        seen[bucket] += 1;
        // A plant may stand on the very edge of a band
        if told[0] as usize != bucket {
            let nudged =
                |by: f32| choose(&bands, stretch, (distance * by, keep, rank), modelled == 1.0);
            let beside = [0.9999, 1.0001].map(|by| nudged(by).bucket.unwrap_or(NO_BUCKET));
            assert!(beside.contains(&(told[0] as usize)), "{i}: {told:?} {twin:?}");
            continue;
        }
        for (gpu, cpu) in told[1..].iter().zip([twin.morph, twin.fade, twin.widened]) {
            assert!((gpu - cpu).abs() < 1e-3 * cpu.abs().max(1.0), "{i}: {told:?} {twin:?}");
        }
    }
    assert!([11, 12, 13, 15].iter().all(|bucket| seen[*bucket] > 50), "{seen:?}");
}

#[test]
fn shade_equals_its_reference_and_moves_with_the_sun() {
    let asked: Vec<Asked> = (0..2000)
        .map(|i| {
            let place = Vec3::new(draw(i, 1) - 0.5, 0.1 * draw(i, 2), draw(i, 3) - 0.5) * 200.0;
            [place.extend(0.0).to_array(), [0.0; 4], [0.0; 4], [0.0; 4], [0.0; 4]]
        })
        .collect();
    let shade = Shade { depth: 0.7, offset_m: DVec2::new(1e7, -3.0), ..Shade::default() };
    let (pattern, offset) = shade.pattern();
    let told = |to_sun: Vec3| {
        let mut frame: GpuFrame = Zeroable::zeroed();
        frame.to_sun = to_sun.extend(0.0).to_array();
        (frame.shade, frame.shade_x, frame.shade_y) = (pattern, offset[0], offset[1]);
        tell("tell_shade", &asked, &[(0, 0, bytemuck::bytes_of(&frame))])
    };
    let (morning, noon) =
        (Vec3::new(0.8, 0.4, 0.1).normalize(), Vec3::new(0.1, 1.0, 0.3).normalize());
    let (at_morning, at_noon) = (told(morning), told(noon));
    let (mut dark, mut moved) = (0, 0);
    for (i, (one, other)) in at_morning.iter().zip(&at_noon).enumerate() {
        let place = Vec3::from_slice(&asked[i][0]).as_dvec3();
        let [depth, frequency, height, _] = pattern.map(f64::from);
        let offset = dvec2(f64::from(offset[0]), f64::from(offset[1]));
        let parts = [depth, frequency, height];
        let twin = shade_twin::shade_pattern(place, morning.as_dvec3(), parts, offset);
        assert!((f64::from(one[0]) - twin).abs() < 2e-3, "{i}: {} {twin}", one[0]);
        dark += usize::from(one[0] > 0.35);
        moved += usize::from((one[0] - other[0]).abs() > 0.2);
    }
    assert!((300..1700).contains(&dark), "in places it is dark, in others not: {dark}");
    assert!(moved > 500, "shadows move with the sun: {moved}");
}
