//! The shipped shaders on small made-up pictures, against their twins and by what must hold.

use super::depth_of_field::{DepthOfField, lens};
use super::twin::{self, Fog};
use super::{Position, fogged};
use crate::gpu::Gpu;
use crate::stage::frame::{CameraMatrices, FrameUniform};
use crate::stage::reference::Crop;
use crate::stage::targets::Targets;
use crate::stage::{StageOptions, readback};
use glam::{DMat4, DVec3, DVec4, Vec3, Vec4};
use std::path::Path;
use sward::Light;
use wgpu::util::{DeviceExt, TextureDataOrder};

/// Looks along -z, somewhat down, from (1, 6, 2).
const SCENE: &str = "fields: [(on: Plane())], \
                     cameras: [(eye: (1, 6, 2), target: (1, 5, -3), vertical_fov_deg: 50)],";

pub(super) struct Rig {
    pub(super) gpu: Gpu,
    pub(super) frame: FrameUniform,
    pub(super) options: StageOptions,
    camera: CameraMatrices,
}

impl Rig {
    pub(super) fn new(keys: &str, size: [u32; 2], samples: u32) -> Self {
        let gpu = Gpu::headless().unwrap();
        let text = format!("({SCENE} {keys})");
        let scene = sward_scene::parse(&text, Path::new("test.ron")).unwrap();
        let options = StageOptions::new(&scene, None, size, samples).unwrap();
        let mut frame = FrameUniform::new(&gpu.device, &options);
        frame.set_light(&Light::default(), &scene.sky);
        let camera = CameraMatrices::new(&options.camera, size, Crop::whole(size));
        frame.write(&gpu.queue, camera, 1.0);
        Self { gpu, frame, options, camera }
    }

    /// Positions of a target that is of one depth.
    fn positions(&self, depth: f32) -> Vec<Vec4> {
        let device = &self.gpu.device;
        let targets = Targets::new(device, self.options.size, self.options.samples);
        let position = Position::new(device, &self.frame, self.options.size, self.options.samples);
        let mut encoder = device.create_command_encoder(&Default::default());
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &targets.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(depth),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        position.run(device, &mut encoder, &self.frame, &targets.depth);
        self.gpu.queue.submit([encoder.finish()]);
        readback::floats(&self.gpu, position.target()).unwrap()
    }

    pub(super) fn texture(&self, texels: &[Vec4]) -> wgpu::TextureView {
        let [width, height] = self.options.size;
        let descriptor = wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Float,
            usage: wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        };
        let data = bytemuck::cast_slice(texels);
        let (device, queue) = (&self.gpu.device, &self.gpu.queue);
        let texture =
            device.create_texture_with_data(queue, &descriptor, TextureDataOrder::LayerMajor, data);
        texture.create_view(&Default::default())
    }

    /// What `pass` makes of a colour and a place for each pixel.
    fn filtered(
        &self,
        pixel: impl Fn(u32, u32) -> (f32, Vec4),
        pass: impl FnOnce(&mut wgpu::CommandEncoder, [&wgpu::TextureView; 2]) -> wgpu::Texture,
    ) -> Vec<f32> {
        let [width, height] = self.options.size;
        let pixels: Vec<_> = (0..width * height).map(|i| pixel(i % width, i / width)).collect();
        let color: Vec<_> = pixels.iter().map(|p| Vec3::splat(p.0).extend(1.0)).collect();
        let place: Vec<_> = pixels.iter().map(|p| p.1).collect();
        let inputs = [self.texture(&color), self.texture(&place)];
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        let filled = pass(&mut encoder, [&inputs[0], &inputs[1]]);
        self.gpu.queue.submit([encoder.finish()]);
        let bytes = readback::bytes(&self.gpu, &filled, 8).unwrap();
        bytes.chunks_exact(8).map(|texel| half(u16::from_le_bytes([texel[0], texel[1]]))).collect()
    }

    fn through_lens(&self, pixel: impl Fn(u32, u32) -> (f32, Vec4)) -> Vec<f32> {
        let device = &self.gpu.device;
        let lens = DepthOfField::new(device, &self.frame, self.options.size);
        self.filtered(pixel, |encoder, inputs| {
            lens.run(device, encoder, &self.frame, inputs).texture().clone()
        })
    }

    /// A place at a depth along the line of sight; which one does not matter to a lens.
    fn at_depth(&self, depth_m: f32) -> Vec4 {
        let world = self.camera.view_from_world.inverse();
        world.transform_point3(Vec3::NEG_Z * depth_m).extend(1.0)
    }
}

/// A half-precision number of no less than 2^-14, or 0.
fn half(bits: u16) -> f32 {
    let exponent = i32::from(bits >> 10 & 31) - 15;
    let fraction = f32::from(bits & 1023) / 1024.0;
    if exponent == -15 {
        fraction * 2_f32.powi(-14)
    } else {
        (1.0 + fraction) * 2_f32.powi(exponent)
    }
}

const FOGS: [(&str, Fog); 3] = [
    (
        "fog: (density_per_m: 0.02)",
        Fog { density_per_m: 0.02, start_m: 0.0, base_m: 0.0, falloff_m: f64::INFINITY },
    ),
    (
        "fog: (density_per_m: 0.1, start_m: 4, base_m: 3, falloff_m: 2)",
        Fog { density_per_m: 0.1, start_m: 4.0, base_m: 3.0, falloff_m: 2.0 },
    ),
    (
        "fog: (density_per_m: 0.01, start_m: 20, base_m: 5, falloff_m: 400)",
        Fog { density_per_m: 0.01, start_m: 20.0, base_m: 5.0, falloff_m: 400.0 },
    ),
];

/// Positions are where the camera's matrices put them, and fog what adding up its density gives.
#[test]
fn positions_and_fog_equal_their_twins() {
    let size = [12, 9];
    for ((keys, fog), samples) in FOGS.into_iter().zip([1, 4, 1]) {
        let rig = Rig::new(keys, size, samples);
        let matrix = |m: glam::Mat4| DMat4::from_cols_array(&m.to_cols_array().map(f64::from));
        let CameraMatrices { view_from_world, clip_from_view } = rig.camera;
        let world = (matrix(clip_from_view) * matrix(view_from_world)).inverse();
        let eye = DVec3::from(rig.options.camera.eye);
        let mut cleared = Vec::new();
        for depth in [0.95_f32, 0.98, 0.995, 0.998] {
            for (i, texel) in (0..).zip(rig.positions(depth)) {
                let at = DVec3::new(f64::from(i % size[0]), f64::from(i / size[0]), 0.0) + 0.5;
                let (x, y) = (at.x / f64::from(size[0]), at.y / f64::from(size[1]));
                let ndc = DVec4::new(x * 2.0 - 1.0, 1.0 - y * 2.0, f64::from(depth), 1.0);
                let clip = world * ndc;
                let (place, expected) = (texel.truncate().as_dvec3(), clip.truncate() / clip.w);
                let off = place.distance(expected) / expected.distance(eye);
                assert!(off < 2e-3, "{keys}, {depth}, pixel {i}: {place} is not {expected}");
                let expected = fog.clear(eye, place);
                let clear = f64::from(texel.w);
                assert!((clear - expected).abs() < 2e-4, "{keys}, {i}: {clear}, not {expected}");
                cleared.push(clear);
            }
        }
        let (least, most) = cleared.iter().fold((1.0, 0.0), |(l, m), &c| (c.min(l), c.max(m)));
        assert!(most - least > 0.05, "{keys}: {least} to {most} tests nothing");
    }
}

#[test]
fn the_sky_is_far_and_clear() {
    let rig = Rig::new("fog: (density_per_m: 10)", [4, 3], 4);
    for texel in rig.positions(1.0) {
        assert!(texel.w == 1.0 && texel.truncate().length() > 9e8, "{texel}");
    }
}

#[test]
fn fog_covers_what_does_not_come_through() {
    let rig = Rig::new("fog: (color: (0.5, 0.5, 0.5))", [8, 2], 1);
    let device = &rig.gpu.device;
    let clear = |x: u32| x as f32 / 7.0;
    let fogged = fogged(device, &rig.frame, rig.options.size);
    let picture = rig.filtered(
        |x, _| (2.0, Vec4::ZERO.with_w(clear(x))),
        |encoder, inputs| fogged.run(device, encoder, &rig.frame, &inputs).texture().clone(),
    );
    for (x, light) in (0..8).zip(picture) {
        assert!((light - (0.5 + 1.5 * clear(x))).abs() < 2e-3, "{x}: {light}");
    }
}

const LENS: &str = "depth_of_field: (focus_m: 4, aperture_mm: 120)";
const SIZE: [u32; 2] = [80, 256];

/// A line of light spreads, at every distance before and behind the focus, by the variance of the
/// lens's disc; no light is lost.
#[test]
fn blur_has_the_variance_of_the_lens() {
    let rig = Rig::new(LENS, SIZE, 1);
    let focal = f64::from(rig.camera.clip_from_view.y_axis.y);
    let px_per_m = 0.5 * f64::from(SIZE[1]) * focal / 4.0;
    let mut most: f64 = 0.0;
    for depth in [2.6, 3.2, 4.0, 4.6, 6.0, 12.0, 1e9] {
        let place = rig.at_depth(depth);
        let picture = rig.through_lens(|x, _| (if x == 40 { 8.0 } else { 0.0 }, place));
        let row: Vec<_> = picture[100 * 80..101 * 80].iter().map(|&v| f64::from(v)).collect();
        assert!((row.iter().sum::<f64>() - 8.0).abs() < 0.1, "{depth}");
        let got = twin::moments(&row);
        let expected = twin::blur_variance(4.0, 0.12, px_per_m, f64::from(depth));
        // Tails are cut at 2.5 deviations, and a copy blurs by a pixel at least
        let off = (got.y - expected).abs();
        assert!(off <= 0.12 * expected + 0.1, "{depth}: {got} {expected}");
        assert!((got.x - 40.0).abs() < 0.6, "{depth}: {got}");
        most = most.max(expected);
    }
    assert!(most > 4.0, "{most}");
}

/// The wider copy alone is the twin's Gaussian.
#[test]
fn the_nearer_copy_is_a_gaussian() {
    let rig = Rig::new(LENS, SIZE, 1);
    let focal = rig.camera.clip_from_view.y_axis.y;
    let [.., sigma] = lens(rig.options.depth_of_field, focal, SIZE[1] as f32);
    let place = rig.at_depth(0.5);
    let picture = rig.through_lens(|x, _| (if x < 40 { 0.0 } else { 1.0 }, place));
    let weights = twin::gaussian(f64::from(sigma));
    for x in 10..70_usize {
        let below = |edge: f64| {
            let weight = |i: i64| weights.get(i.unsigned_abs() as usize).copied().unwrap_or(0.0);
            (-60..=60).filter(|i| (x as f64 + *i as f64) < edge).map(weight).sum::<f64>()
        };
        let expected = 1.0 - below(40.0);
        let light = f64::from(picture[120 * 80 + x]);
        assert!((light - expected).abs() < 0.015, "{x}: {light}, not {expected}");
    }
}

#[test]
fn what_is_in_focus_stays_to_the_bit() {
    let light = |x: u32, y: u32| ((x * 7 + y * 13) % 32) as f32 / 16.0;
    for (keys, depth) in [(LENS, 4.0), ("depth_of_field: (aperture_mm: 0)", 50.0)] {
        let rig = Rig::new(keys, [31, 17], 1);
        // All pixels at one depth have the plane's own distance, rounded: put the focus there
        let place = rig.at_depth(depth);
        let picture = rig.through_lens(|x, y| (light(x, y), place));
        let off = (0..).zip(&picture).map(|(i, v)| (v - light(i % 31, i / 31)).abs());
        let off = off.fold(0.0, f32::max);
        assert!(off <= if depth == 4.0 { 1e-3 } else { 0.0 }, "{keys}: {off}");
        let even = rig.through_lens(|x, y| (0.5, rig.at_depth(1.0 + (x * y) as f32)));
        assert!(even.iter().all(|v| (v - 0.5).abs() < 1e-3), "an even picture stays");
    }
}

/// Bright and in focus on the left, dark and far on the right: no light comes over. Bright and near
/// on the left, dark and in focus on the right: it spreads, and falls off without a step.
#[test]
fn only_what_is_near_spreads_over_its_edge() {
    let rig = Rig::new(LENS, SIZE, 1);
    let halves = |left: f32, right: f32| {
        let (left, right) = (rig.at_depth(left), rig.at_depth(right));
        let picture = rig.through_lens(|x, _| if x < 40 { (1.0, left) } else { (0.1, right) });
        picture[120 * 80..121 * 80].to_vec()
    };
    let sharp = halves(4.0, 1e9);
    let over = sharp[40..].iter().fold(0.0_f32, |most, v| most.max(v - 0.1));
    let lost = sharp[..40].iter().fold(0.0_f32, |most, v| most.max(1.0 - v));
    assert!(over < 2e-3 && lost < 2e-3, "{over} {lost}");
    let near = halves(2.0, 4.0);
    assert!(near[41] > 0.2 && near[78] < 0.11 && near[20] > 0.98, "{near:?}");
    let step = near.windows(2).map(|pair| (pair[0] - pair[1]).abs()).fold(0.0, f32::max);
    assert!(step < 0.25, "{step}: {near:?}");
}
