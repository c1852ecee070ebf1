//! Keys for wind.

use super::PathFile;
use serde::Deserialize;

/// One term of the wind. Strengths are `beta`: 0.4 is a breeze, 1.2 a strong gust; 0..=20.
#[derive(Debug, Clone, Deserialize)]
pub enum WindFile {
    /// A steady breeze with travelling waves on it.
    Waves(WavesFile),
    /// Noise that drifts with the wind.
    Gusts(GustsFile),
    /// A wind that swings to and fro.
    Cosine(CosineFile),
    /// The wash of a helicopter's rotor.
    Rotor(RotorFile),
    /// A whirlwind or tornado.
    Vortex(VortexFile),
    /// A jet of air that widens as a cone.
    Fan(FanFile),
    /// A map of winds that repeats and drifts.
    Texture(WindTextureFile),
}

/// Travelling waves. Its defaults are those of [`sward::Waves`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct WavesFile {
    /// Where the wind blows to, `(x, z)`, any length but 0; default `(1, 0)`.
    pub direction: [f32; 2],
    /// Steady strength; default 0.25.
    pub mean: f32,
    /// Strength of the waves; default 0.35. 0 is a steady wind.
    pub amplitude: f32,
    /// Distance between crests, 0.01..=10000; default 14.
    pub wavelength_m: f32,
    /// Speed of the crests, -100..=100; default 5.
    pub speed_mps: f32,
}

impl Default for WavesFile {
    fn default() -> Self {
        let waves = sward::Waves::default();
        Self {
            direction: waves.direction.into(),
            mean: waves.mean,
            amplitude: waves.amplitude,
            wavelength_m: waves.wavelength_m,
            speed_mps: waves.speed_mps,
        }
    }
}

/// Gusts. Its defaults are those of [`sward::Gusts`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct GustsFile {
    /// Where the gusts drift to, `(x, z)`, any length but 0; default `(1, 0)`.
    pub direction: [f32; 2],
    /// Peak strength; default 0.8.
    pub strength: f32,
    /// Size of a gust, 0.01..=10000; default 12.
    pub size_m: f32,
    /// Drift speed, -100..=100; default 5.
    pub speed_mps: f32,
    /// How much the direction veers inside a gust, 0..=1; default 0.3.
    pub turbulence: f32,
    /// Seed of the noise; default 1.
    pub seed: u32,
}

impl Default for GustsFile {
    fn default() -> Self {
        let gusts = sward::Gusts::default();
        Self {
            direction: gusts.direction.into(),
            strength: gusts.strength,
            size_m: gusts.size_m,
            speed_mps: gusts.speed_mps,
            turbulence: gusts.turbulence,
            seed: gusts.seed,
        }
    }
}

/// A wind that swings. Its defaults are those of [`sward::Cosine`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct CosineFile {
    /// Where it blows to first, `(x, z)`, any length but 0; default `(1, 0)`.
    pub direction: [f32; 2],
    /// Strength at its strongest; default 0.5.
    pub strength: f32,
    /// Seconds of a swing, 0.01..=10000; default 4.
    pub period_s: f32,
    /// Distance after which the swing is the same again, 0.01 or more; default 20. `inf` moves all
    /// in unison.
    pub wavelength_m: f32,
}

impl Default for CosineFile {
    fn default() -> Self {
        let cosine = sward::Cosine::default();
        Self {
            direction: cosine.direction.into(),
            strength: cosine.strength,
            period_s: cosine.period_s,
            wavelength_m: cosine.wavelength_m,
        }
    }
}

/// A rotor's wash. Its defaults are those of [`sward::Rotor`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RotorFile {
    /// The hub of a rotor that rests; default `(0, 4, 0)`.
    pub at: [f32; 3],
    /// Where it flies, in place of `at`; default none.
    pub path: Option<PathFile>,
    /// An object by name: then y is the height above that object.
    pub above: Option<String>,
    /// Radius, 0.01..=1000; default 5.
    pub radius_m: f32,
    /// Strength of the outflow with the rotor close to the grass; default 3.
    pub strength: f32,
    /// Distance from the axis at which it ends, 0.01..=10000; default 40.
    pub range_m: f32,
    /// Downward share, 0..=4; default 0.8.
    pub downwash: f32,
    /// Share that turns with the rotor, -4..=4; default 0.3.
    pub swirl: f32,
    /// Blades, 1..=16; default 2.
    pub blades: u32,
    /// Turns a minute, -10000..=10000; positive is counter-clockwise from above; default 40.
    pub rpm: f32,
    /// How strongly the gusts of the blades show, 0..=1; default 0.5.
    pub pulse: f32,
    /// How fast gusts run outward, 0.01..=1000; default 9.
    pub speed_mps: f32,
    /// Irregular share, 0..=1; default 0.4.
    pub turbulence: f32,
    /// Seed of the turbulence; default 1.
    pub seed: u32,
}

impl Default for RotorFile {
    fn default() -> Self {
        let rotor = sward::Rotor::default();
        Self {
            at: rotor.position.into(),
            path: None,
            above: None,
            radius_m: rotor.radius_m,
            strength: rotor.strength,
            range_m: rotor.range_m,
            downwash: rotor.downwash,
            swirl: rotor.swirl,
            blades: rotor.blades,
            rpm: rotor.rpm,
            pulse: rotor.pulse,
            speed_mps: rotor.speed_mps,
            turbulence: rotor.turbulence,
            seed: rotor.seed,
        }
    }
}

/// A whirlwind. Its defaults are those of [`sward::Vortex`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct VortexFile {
    /// A point of the axis of one that rests; its height does not matter; default `(0, 0, 0)`.
    pub at: [f32; 3],
    /// Where it walks, in place of `at`; default none.
    pub path: Option<PathFile>,
    /// Radius of the core, 0.01..=1000; default 4.
    pub radius_m: f32,
    /// Strength of the round part at the core's radius; default 4.
    pub strength: f32,
    /// Distance from the axis at which it ends, 0.01..=10000; default 40.
    pub range_m: f32,
    /// Inward share, -4..=4; default 0.5.
    pub inflow: f32,
    /// Upward share on the axis, -4..=4; default 0.5.
    pub updraft: f32,
    /// Turns clockwise seen from above; default false.
    pub clockwise: bool,
    /// How fast gusts are carried round, 0.01..=1000; default 12.
    pub speed_mps: f32,
    /// Irregular share, 0..=1; default 0.4.
    pub turbulence: f32,
    /// Seed of the turbulence; default 1.
    pub seed: u32,
}

impl Default for VortexFile {
    fn default() -> Self {
        let vortex = sward::Vortex::default();
        Self {
            at: vortex.position.into(),
            path: None,
            radius_m: vortex.radius_m,
            strength: vortex.strength,
            range_m: vortex.range_m,
            inflow: vortex.inflow,
            updraft: vortex.updraft,
            clockwise: vortex.clockwise,
            speed_mps: vortex.speed_mps,
            turbulence: vortex.turbulence,
            seed: vortex.seed,
        }
    }
}

/// A fan. Its defaults are those of [`sward::Fan`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct FanFile {
    /// Middle of a fan that rests; default `(0, 0.6, 0)`.
    pub at: [f32; 3],
    /// Where it moves, in place of `at`; the turns of its keys turn `direction`; default none.
    pub path: Option<PathFile>,
    /// An object by name: then y is the height above that object.
    pub above: Option<String>,
    /// Where it blows to, `(x, y, z)`, any length but 0; default `(1, 0, 0)`.
    pub direction: [f32; 3],
    /// Radius of the fan, 0.01..=1000; default 0.5.
    pub radius_m: f32,
    /// Angle between the axis and the cone's edge, 0.1..=80; default 15.
    pub half_angle_deg: f32,
    /// Strength at the fan; default 3.
    pub strength: f32,
    /// Distance at which it ends, 0.01..=10000; default 12.
    pub range_m: f32,
    /// How fast gusts run along it, 0..=1000; default 6.
    pub speed_mps: f32,
    /// Irregular share, 0..=1; default 0.3.
    pub turbulence: f32,
    /// Seed of the turbulence; default 1.
    pub seed: u32,
}

impl Default for FanFile {
    fn default() -> Self {
        let fan = sward::Fan::default();
        Self {
            at: fan.position.into(),
            path: None,
            above: None,
            direction: fan.direction.into(),
            radius_m: fan.radius_m,
            half_angle_deg: fan.half_angle_deg,
            strength: fan.strength,
            range_m: fan.range_m,
            speed_mps: fan.speed_mps,
            turbulence: fan.turbulence,
            seed: fan.seed,
        }
    }
}

/// A map of winds. Its defaults are those of [`sward::WindTexture`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct WindTextureFile {
    /// PNG or JPEG, at most 2048 a side, whose columns run along the direction; it repeats. Grey: the
    /// strength along the direction, black none. Colour: red along it, green across it (to the right
    /// seen from above), the middle of each none. Default: noise.
    pub file: Option<String>,
    /// Of noise: gusts along each side of a tile, 1..=64; default 4. Not with `file`.
    pub gusts: Option<u32>,
    /// Of noise: its seed; default 1. Not with `file`.
    pub seed: Option<u32>,
    /// Where it drifts to, `(x, z)`, any length but 0; default `(1, 0)`.
    pub direction: [f32; 2],
    /// Strength of white; default 0.9.
    pub strength: f32,
    /// Length of a tile along the direction, 0.01..=100000; default 40.
    pub size_m: f32,
    /// Drift, -100..=100; default 5.
    pub speed_mps: f32,
}

impl Default for WindTextureFile {
    fn default() -> Self {
        Self {
            file: None,
            gusts: None,
            seed: None,
            direction: [1.0, 0.0],
            strength: 0.9,
            size_m: 40.0,
            speed_mps: 5.0,
        }
    }
}
