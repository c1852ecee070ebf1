//! The sky by physics, after Hillaire 2020, "A Scalable and Production Ready Sky and Atmosphere
//! Rendering Technique": molecules, aerosols by turbidity, ozone, light that is scattered once along
//! the ray and any number of times by a closed series, and ground that sends light back up.
//!
//! Units are the scenes': irradiance and radiance in linear RGB for which the sun above the air has
//! [`ABOVE_AIR`] in each channel. That is not watts: a scene's `sun` of strength 3.1 is about what is
//! left of it at the ground on a clear day. What a white ground sends back under it has a radiance
//! near 1.
//!
//! Nothing here is random or asks a clock: the same settings give the same light.

mod air;
mod dome;
mod harmonics;
mod tables;
#[cfg(test)]
mod tests;

pub use dome::Dome;
pub use harmonics::SkyHarmonics;

use air::{Air, GROUND_KM, Ray};
use glam::{DVec3, Vec3};
use tables::{Multiple, Transmittance};

/// Irradiance of the sun above the air, in the scenes' units.
pub const ABOVE_AIR: f32 = 3.65;
/// Weights of linear RGB in luminance.
pub const LUMINANCE: Vec3 = Vec3::new(0.2126, 0.7152, 0.0722);
/// Height of whoever looks over the ground, kilometres.
const EYE_KM: f64 = 0.02;

/// Air and ground, ready to be asked for the light of any sun. Making one takes some 10 ms.
#[derive(Debug, Clone)]
pub struct Atmosphere {
    air: Air,
    sunlight: Transmittance,
    multiple: Multiple,
    ground_albedo: Vec3,
}

impl Atmosphere {
    /// `turbidity` from 1, pure air, over 2 to 3, a clear day, to 10, thick haze; outside it is
    /// clamped. `ground_albedo` is the reflectance of the land around, 0 to 1.
    pub fn new(turbidity: f32, ground_albedo: Vec3) -> Self {
        // What is no number becomes pure air
        let turbidity = if turbidity.is_nan() { 1.0 } else { turbidity.clamp(1.0, 10.0) };
        let air = Air::new(f64::from(turbidity));
        let ground_albedo = ground_albedo.max(Vec3::ZERO).min(Vec3::ONE);
        let sunlight = Transmittance::new(&air);
        let multiple = Multiple::new(&air, &sunlight, ground_albedo.as_dvec3());
        Self { air, sunlight, multiple, ground_albedo }
    }

    /// Reflectance of the land around.
    pub fn ground_albedo(&self) -> Vec3 {
        self.ground_albedo
    }

    /// Share of the sun's light above the air that reaches the ground, by colour; the sun stands at
    /// this height in degrees. 0 once all of its disc has set.
    pub fn sunlight(&self, elevation_deg: f32) -> Vec3 {
        let up = f64::from(elevation_deg).to_radians().sin();
        self.sunlight.of_sun(GROUND_KM + 1e-3, up).as_vec3()
    }

    /// Radiance of the sky in a direction for a sun of irradiance 1 above the air. Both are unit
    /// vectors, y is up; directions below the horizon are taken for the horizon's own. The sun's disc
    /// is not part of it.
    pub fn radiance(&self, direction: Vec3, to_sun: Vec3) -> Vec3 {
        const STEPS: u32 = 24;
        let level = direction.as_dvec3().with_y(f64::from(direction.y.max(0.0)));
        let (way, sun) = (level.normalize_or(DVec3::Y), to_sun.as_dvec3().normalize_or(DVec3::Y));
        let cos = way.dot(sun).clamp(-1.0, 1.0);
        let phases = (air::rayleigh_phase(cos), air::mie_phase(cos));
        let radius = GROUND_KM + EYE_KM;
        let (mut light, mut through) = (DVec3::ZERO, DVec3::ONE);
        for (t, dt) in tables::steps(Ray { radius, up: way.y }.to_top(), STEPS) {
            let place = DVec3::Y * radius + way * t;
            let far = place.length();
            let sun_up = place.dot(sun) / far;
            let mixture = self.air.at(far - GROUND_KM);
            let once = mixture.rayleigh * phases.0 + mixture.mie * phases.1;
            let arriving = once * self.sunlight.of_sun(far, sun_up)
                + (mixture.rayleigh + mixture.mie) * self.multiple.read(far, sun_up);
            let passed = (-mixture.extinction * dt).exp();
            light += through * arriving * tables::kept(&mixture, passed);
            through *= passed;
        }
        light.as_vec3()
    }
}
