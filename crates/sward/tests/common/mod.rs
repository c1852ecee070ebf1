//! What the integration tests share: random scenes from a seed, and a device.
#![allow(dead_code, reason = "each test binary uses a part")]

use glam::{DVec3, Vec2, Vec3, dvec3};
use sward::frame::collide::primitive::Primitive;
use sward::frame::physics::twin::{Blade, State, Surroundings};
use sward::shared::noise_twin::hash01;
use sward::{Gravity, Gusts, Sphere, Waves, Wind, WindSource};

/// Draws numbers that depend on a seed alone.
pub struct Draws {
    seed: u32,
    next: u32,
}

impl Draws {
    pub fn new(seed: u32) -> Self {
        Self { seed, next: 0 }
    }
    pub fn between(&mut self, min: f32, max: f32) -> f32 {
        self.next += 1;
        min + (max - min) * hash01(self.seed, self.next)
    }
    pub fn unit(&mut self) -> DVec3 {
        loop {
            let mut side = || f64::from(self.between(-1.0, 1.0));
            let v = dvec3(side(), side(), side());
            if (0.01..1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }
    /// A blade on a slope of up to `tilt` (0 level, large any way up), within 50 m of the origin.
    pub fn blade(&mut self, tilt: f64) -> Blade {
        let up = (DVec3::Y + self.unit() * tilt).normalize();
        let side = self.unit();
        let facing = side.reject_from(up).try_normalize().unwrap_or(up.any_orthonormal_vector());
        // As the GPU holds it.
        let up = up.as_vec3().as_dvec3();
        let facing = facing.as_vec3().as_dvec3();
        let mut number = |min, max| f64::from(self.between(min, max));
        Blade {
            root: dvec3(number(-50.0, 50.0), number(-2.0, 2.0), number(-50.0, 50.0)),
            up,
            facing,
            height: number(0.05, 2.0),
            response: number(3.0, 8.0),
            droop: number(0.3, 0.65),
            gust: number(0.5, 1.0),
            arch: number(0.0, 1.0),
        }
    }
}

/// Waves of mean 0.4 with gusts on them, to about 1.2 in all.
pub fn gusty_wind() -> Wind {
    Wind::new(vec![
        WindSource::Waves(Waves {
            direction: Vec2::new(1.0, 0.3),
            mean: 0.3,
            amplitude: 0.3,
            wavelength_m: 9.0,
            speed_mps: 4.0,
        }),
        WindSource::Gusts(Gusts {
            direction: Vec2::new(0.9, 0.5),
            strength: 0.6,
            size_m: 6.0,
            speed_mps: 5.0,
            turbulence: 0.5,
            seed: 7,
        }),
    ])
    .expect("valid wind")
}

/// Gravity as a field has it by default, and nothing else.
pub fn calm(wind: &Wind, dt_s: f64) -> Surroundings<'_> {
    Surroundings { wind, gravity: Gravity::default(), primitives: &[], crush_decay: 0.25, dt_s }
}

/// An upright blade at rest.
pub fn upright(blade: &Blade) -> State {
    State { tip: blade.up, crush: 0.0 }
}

/// Balls round `blade`, in reach of it or nearly.
pub fn balls_near(draws: &mut Draws, blade: &Blade, count: usize) -> Vec<Primitive> {
    let mut ball = |_| {
        let away = draws.unit() * f64::from(draws.between(0.0, 1.5)) * blade.height;
        let center = (blade.root + blade.up * 0.4 * blade.height + away).as_vec3();
        Sphere { center, radius: draws.between(0.05, 0.9) * blade.height as f32 }.into()
    };
    (0..count).map(&mut ball).collect()
}

/// A capsule, a ball that moved, or a box, in reach of `blade` or nearly.
pub fn thing_near(draws: &mut Draws, blade: &Blade, kind: u32) -> Primitive {
    let h = blade.height as f32;
    let near = |draws: &mut Draws| {
        let away = draws.unit() * f64::from(draws.between(0.0, 1.2)) * blade.height;
        (blade.root + blade.up * 0.4 * blade.height + away).as_vec3()
    };
    let (from, to) = (near(draws), near(draws));
    let radius = draws.between(0.05, 0.5) * h;
    let axis = draws.unit().as_vec3();
    match kind {
        0 => Primitive::Capsule { from, to, radius },
        1 => Primitive::Swept { from, to, radius },
        _ => Primitive::Cuboid {
            center: from,
            half_extents: glam::Vec3::new(
                draws.between(0.1, 1.0),
                draws.between(0.1, 1.0),
                draws.between(0.1, 1.0),
            ) * h,
            rotation: glam::Quat::from_axis_angle(axis, draws.between(0.0, 3.0)),
        },
    }
}

/// The adapter and device that GPU tests run on. Without one they fail: a GPU test that is
/// skipped proves nothing.
pub fn device() -> (wgpu::Device, wgpu::Queue) {
    let instance =
        wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions {
        power_preference: wgpu::PowerPreference::HighPerformance,
        ..Default::default()
    }))
    .expect("these tests need a graphics adapter; Mesa's lavapipe (mesa-vulkan-drivers) will do");
    pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()))
        .expect("the adapter gives a device with default limits")
}

/// A ball rolling by: its way in the step of `dt_s` that ends at a time.
pub fn rolling(start: Vec3, velocity: Vec3, radius: f32, time_s: f64, dt_s: f64) -> Primitive {
    let at = |time_s: f64| start + velocity * time_s as f32;
    Primitive::Swept { from: at(time_s - dt_s), to: at(time_s), radius }
}
