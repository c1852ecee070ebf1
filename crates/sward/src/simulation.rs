//! What one step of the simulation needs: time, wind, colliders, gravity, light.

use crate::error::within;
use crate::frame::wind::Wind;
use crate::shared::noise_twin::NOISE_PERIOD;
use crate::{Collider, Error};
use glam::{DVec2, Vec3};

/// A sphere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// Centre, metres.
    pub center: Vec3,
    /// Radius, metres, above 0.
    pub radius: f32,
}

/// Which physical model moves the blades.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PhysicsModel {
    /// Exact step, length by projection, scale-free species.
    #[default]
    Sward,
    /// Equations 1 to 16 of J with the errata, for comparison. Two things are ours in this model
    /// too: species are free of scale (a blade of height h and response s feels gravity `droop s h`
    /// and wind `beta s h`), and wind broadside on a blade acts up to twice as much as wind along
    /// its width.
    Paper,
}

/// Gravity (J equations 4 to 6): a direction, a centre, and the blend between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gravity {
    /// Unit direction of the uniform part.
    pub direction: Vec3,
    /// Its strength; 1 is what a species' droop means.
    pub strength: f32,
    /// Centre that the other part pulls to.
    pub center: Vec3,
    /// Strength of that part.
    pub center_strength: f32,
    /// Blend: 0 is the direction alone, 1 the centre alone.
    pub blend: f32,
}

impl Default for Gravity {
    fn default() -> Self {
        Self {
            direction: Vec3::NEG_Y,
            strength: 1.0,
            center: Vec3::ZERO,
            center_strength: 1.0,
            blend: 0.0,
        }
    }
}

/// Sun and sky for the built-in shading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// Unit direction from the ground to the sun.
    pub to_sun: Vec3,
    /// Sun's irradiance, linear RGB.
    pub sun: Vec3,
    /// Sky light from above.
    pub sky: Vec3,
    /// Light from the ground, below.
    pub ground: Vec3,
    /// Colour that distance fades to.
    pub haze: Vec3,
    /// Share of the light lost to haze a metre; 0 is clear air, 0.002 a summer's day.
    pub haze_per_m: f32,
    /// What moves between the field and the sun.
    pub shade: Shade,
}

/// A pattern of shade that lies over the field, as of clouds or of the crowns of trees, and is cast along
/// the sun's rays: its shadows move with the sun through the day, and with `offset_m`. Plants, clusters of
/// them and a host's ground (see [`crate::frame::light::SHADE_WGSL`]) lie in the same shade.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shade {
    /// Share of the sun kept away where it is darkest, 0..=1; 0 is a clear sky, and costs nothing.
    pub depth: f32,
    /// Size of its patches, metres, 0.01..=100000.
    pub size_m: f32,
    /// Its height in the world, metres, within 100 km. The higher, the farther its shadows move with
    /// the sun.
    pub height_m: f32,
    /// How far it has drifted, x and z, metres; the host moves it.
    pub offset_m: DVec2,
}

impl Default for Shade {
    /// None; were it there, of patches of 12 m at 40 m.
    fn default() -> Self {
        Self { depth: 0.0, size_m: 12.0, height_m: 40.0, offset_m: DVec2::ZERO }
    }
}

impl Shade {
    pub(crate) fn check(&self) -> Result<(), Error> {
        within("light.shade.depth", self.depth, 0.0, 1.0)?;
        within("light.shade.size_m", self.size_m, 0.01, 1e5)?;
        within("light.shade.height_m", self.height_m, -1e5, 1e5)?;
        if self.offset_m.is_finite() {
            return Ok(());
        }
        Err(Error::setting("light.shade.offset_m", "must be finite"))
    }

    /// What `shade_pattern` of [`crate::frame::light::SHADE_WGSL`] takes: the pattern, and its offset.
    pub fn pattern(&self) -> ([f32; 4], [f32; 2]) {
        let pattern = [self.depth, self.size_m.recip(), self.height_m, 0.0];
        (pattern, self.cells().as_vec2().to_array())
    }

    /// The drift in cells of its noise, within the noise's period.
    fn cells(&self) -> DVec2 {
        let cells = self.offset_m / f64::from(self.size_m);
        cells.map(|c| c.rem_euclid(f64::from(NOISE_PERIOD)))
    }
}

impl Default for Light {
    fn default() -> Self {
        Self {
            to_sun: Vec3::new(0.45, 0.55, -0.7).normalize(),
            sun: Vec3::new(3.1, 2.8, 2.3),
            sky: Vec3::new(0.55, 0.75, 1.05),
            ground: Vec3::new(0.16, 0.17, 0.10),
            haze: Vec3::new(0.62, 0.74, 0.86),
            haze_per_m: 0.0,
            shade: Shade::default(),
        }
    }
}

/// What happens in one step of the simulation.
#[derive(Debug, Clone)]
pub struct Frame<'a> {
    /// Seconds since the last step; clamped to 0..=10, and 0 where it is not a number.
    pub dt_s: f32,
    /// The wind, already advanced by the host.
    pub wind: &'a Wind,
    /// What pushes blades aside; see [`Collider`] for what is left out.
    pub colliders: &'a [Collider<'a>],
    /// Gravity.
    pub gravity: Gravity,
    /// Light for drawing.
    pub light: Light,
    /// Physical model.
    pub physics: PhysicsModel,
}

impl<'a> Frame<'a> {
    /// A step with the defaults: no colliders, plain gravity, a clear day.
    pub fn new(dt_s: f32, wind: &'a Wind) -> Self {
        Self {
            dt_s,
            wind,
            colliders: &[],
            gravity: Gravity::default(),
            light: Light::default(),
            physics: PhysicsModel::default(),
        }
    }
}
