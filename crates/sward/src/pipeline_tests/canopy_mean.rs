//! The canopy's light and cover against fields whose blades are all drawn.

use super::canopy::of_canopy;
use super::rig::{Gpu, shared};
use super::targets::Target;
use crate::bake::cover::sine;
use crate::gpu::test_device;
use crate::{
    Canopy, Culling, Field, FieldDesc, Frame, Light, Mesh, Range, Renderer, Shape, Species,
    Surface, Targets, Technique, Tufts, View, Waves, Wind, WindSource,
};
use glam::camera::rh::{proj::directx::orthographic, view::look_at_mat4};
use glam::{UVec2, Vec2, Vec3};

/// Pixels a side of what is looked at, and metres of ground.
const PIXELS: u32 = 256;
const WINDOW_M: f32 = 6.0;

/// A field, and who draws it.
struct Drawn {
    gpu: Gpu,
    renderer: Renderer,
    field: Field,
}

/// What shows: mean radiance of the grass, and its share of the picture.
#[derive(Debug, Clone, Copy)]
struct Seen {
    radiance: Vec3,
    coverage: f32,
}

fn steady(mean: f32) -> Wind {
    let waves = Waves { mean, amplitude: 0.0, ..Waves::default() };
    Wind::new(vec![WindSource::Waves(waves)]).expect("valid wind")
}

impl Drawn {
    fn new(side_m: f32, desc: &FieldDesc) -> Self {
        let mesh = Mesh::plane(Vec2::splat(side_m), UVec2::ONE).expect("a plane");
        let surface = Surface::new(mesh).expect("a surface");
        let field = Field::grow(&surface, desc).expect("a field");
        let gpu = shared();
        let targets = Targets::single_sampled(wgpu::TextureFormat::Rgba32Float);
        let mut renderer = Renderer::new(&gpu.0, targets).expect("the device has the limits");
        renderer.add_field(&gpu.0, &field).expect("the field fits");
        Self { gpu, renderer, field }
    }

    /// Lets the wind blow until blades stand still in it.
    fn blow(&mut self, wind: &Wind) {
        for _ in 0..12 {
            self.step(&Frame::new(0.5, wind), &[]);
        }
    }

    fn step(&mut self, frame: &Frame, views: &[View]) {
        let (device, queue) = &self.gpu;
        let mut encoder = device.create_command_encoder(&Default::default());
        self.renderer.simulate(device, &mut encoder, frame).expect("valid frame");
        self.renderer.cull(device, &mut encoder, views).expect("valid views");
        queue.submit([encoder.finish()]);
    }

    /// From that direction, in parallel, every blade with all its segments.
    fn see(&mut self, frame: &Frame, to_eye: Vec3) -> Seen {
        let half = 0.5 * WINDOW_M;
        let up = if to_eye.y > 0.999 { Vec3::X } else { Vec3::Y };
        let view_from_world = look_at_mat4(to_eye * 50.0, Vec3::ZERO, up);
        let high = half * to_eye.y;
        let clip = orthographic(-half, half, -high, high, 0.1, 100.0);
        let culling = Culling { frustum: true, ..super::scenes::no_culling() };
        let view = View {
            culling,
            technique: Technique::Blades,
            level: Some(0),
            width_correction: false,
            ..View::new(view_from_world, clip, [PIXELS; 2])
        };
        self.step(frame, &[view]);
        let picture = self.draw();
        let shown = picture.iter().filter(|p| p[3] > 0.0);
        let (sum, count) = shown.fold((Vec3::ZERO, 0.0_f32), |(sum, n), p| {
            (sum + Vec3::new(p[0], p[1], p[2]), n + 1.0)
        });
        Seen { radiance: sum / count, coverage: count / picture.len() as f32 }
    }

    fn draw(&mut self) -> Vec<[f32; 4]> {
        let (device, queue) = &self.gpu;
        let target = Target::new(device, [PIXELS; 2], wgpu::TextureFormat::Rgba32Float);
        let mut encoder = device.create_command_encoder(&Default::default());
        target.record(&mut encoder, |pass| self.renderer.draw(pass, 0));
        queue.submit([encoder.finish()]);
        test_device::read(device, queue, &target.out)
    }
}

/// The default species of such heights and widths.
fn kind(height_m: [f32; 2], width_m: [f32; 2]) -> Species {
    let range = |[min, max]: [f32; 2]| Range::new(min, max);
    Species { height_m: range(height_m), width_m: range(width_m), ..Species::default() }
}

fn dense() -> FieldDesc {
    let tall = Species {
        shape: Shape::TriangleTip { tip: 0.5 },
        ridge: 1.0,
        ..kind([0.33, 0.63], [0.025, 0.035])
    };
    // Of reference.ron at a quarter of its size
    FieldDesc { density: 250.0, species: vec![tall], upright: 1.0, ..Default::default() }
}

fn sparse() -> FieldDesc {
    let low = kind([0.3, 0.42], [0.03, 0.04]);
    FieldDesc { density: 36.0, species: vec![low], ..Default::default() }
}

fn tufted() -> FieldDesc {
    let tall = Species { share: 5.0, arch: 0.35, ..kind([0.45, 0.85], [0.026, 0.042]) };
    let fine = Species {
        share: 6.0,
        shape: Shape::Triangle,
        response: Range::new(4.5, 7.5),
        ..kind([0.22, 0.4], [0.024, 0.036])
    };
    let dry = Species {
        share: 1.2,
        shape: Shape::Triangle,
        droop: Range::new(0.3, 0.4),
        root_color: crate::ColorRange { from: [0.1, 0.09, 0.03], to: [0.14, 0.11, 0.04] },
        tip_color: crate::ColorRange { from: [0.5, 0.4, 0.17], to: [0.62, 0.47, 0.22] },
        ..kind([0.6, 1.0], [0.01, 0.016])
    };
    let tufts = Some(Tufts { share: 0.35, radius_m: 0.9, spread_m: 0.2 });
    let species = vec![tall, fine, dry];
    FieldDesc { density: 64.0, species, tufts, ..Default::default() }
}

const SUNS: [(Vec3, &str); 3] = [
    (Vec3::new(0.3, 1.0, 0.2), "high"),
    (Vec3::new(0.8, 0.4, 0.3), "low, behind"),
    (Vec3::new(-0.5, 0.35, -0.8), "low, before"),
];

fn luminance(color: Vec3) -> f32 {
    color.dot(Vec3::new(0.2126, 0.7152, 0.0722))
}

/// A field's canopy in a steady wind against the field: how far light is off, as a share, and cover.
fn off(drawn: &mut Drawn, canopy: &Canopy, strength: f32, row: usize, sun: Vec3) -> [f32; 2] {
    let wind = steady(strength);
    let s = sine(row);
    let c = (1.0 - s * s).sqrt();
    let to_eye = Vec3::new(0.6 * c, s, 0.8 * c);
    let light = Light { to_sun: sun.normalize(), ..Light::default() };
    let seen = drawn.see(&Frame { light, ..Frame::new(0.0, &wind) }, to_eye);
    let found = of_canopy(canopy, &light, to_eye, canopy.sway(Vec3::X * strength));
    let light = luminance(found.truncate()) / luminance(seen.radiance) - 1.0;
    [light, found.w - seen.coverage]
}

/// Dense, sparse and tufted, at rest and in wind, from low and from above, for suns high and low, before
/// the eye and behind it.
#[test]
fn canopy_shows_what_a_field_does() {
    let mut all = Vec::new();
    for (name, desc, side) in
        [("dense", dense(), 30.0), ("sparse", sparse(), 30.0), ("tufted", tufted(), 40.0)]
    {
        let mut drawn = Drawn::new(side, &desc);
        let canopy = drawn.field.canopy();
        for strength in [0.0, 0.7] {
            drawn.blow(&steady(strength));
            for (row, (sun, sun_name)) in
                [1, 3, 5].into_iter().flat_map(|row| SUNS.map(|sun| (row, sun)))
            {
                let [light, cover] = off(&mut drawn, &canopy, strength, row, sun);
                println!("{name}, wind {strength}, row {row}, {sun_name}: {light:.3} {cover:.3}");
                assert!(light.abs() < 0.05 && cover.abs() < 0.05);
                all.push(light.abs());
            }
        }
    }
    let mean = all.iter().sum::<f32>() / all.len() as f32;
    assert!(mean < 0.02, "{mean}");
}
