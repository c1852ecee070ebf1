//! Keys for light, gravity and culling.

use super::Color;
use serde::Deserialize;

/// The sun.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SunFile {
    /// Where it stands, degrees: 0 is -z (north), 90 is +x (east), any value; default 215.
    pub azimuth_deg: f32,
    /// Height over the horizon, -90..=90; default 38. Lower is warmer in colour by hand only.
    pub elevation_deg: f32,
    /// Colour; default a warm white.
    pub color: Color,
    /// Irradiance, 0..=100; default 3.1.
    pub strength: f32,
}

impl Default for SunFile {
    fn default() -> Self {
        Self {
            azimuth_deg: 215.0,
            elevation_deg: 38.0,
            color: Color([1.0, 0.9, 0.74]),
            strength: 3.1,
        }
    }
}

/// Sky and haze.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SkyFile {
    /// Background overhead; default a clear blue.
    pub zenith: Color,
    /// Background at the horizon, and the colour of haze; default a pale blue.
    pub horizon: Color,
    /// Light on upward faces.
    pub ambient: Color,
    /// Light on downward faces.
    pub bounce: Color,
    /// Times `zenith`, `horizon`, `ambient` and `bounce`, 0..=100; default 1.
    pub strength: f32,
    /// Distance at which haze hides 63 %, above 0; default `inf`, clear air.
    pub haze_m: f32,
}

impl Default for SkyFile {
    fn default() -> Self {
        Self {
            zenith: Color([0.16, 0.34, 0.72]),
            horizon: Color([0.62, 0.74, 0.88]),
            ambient: Color([0.55, 0.75, 1.0]),
            bounce: Color([0.16, 0.17, 0.10]),
            strength: 1.0,
            haze_m: f32::INFINITY,
        }
    }
}

/// Sun and sky by the time of day, in place of `sun` and `sky`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct DaylightFile {
    /// Solar time at the scene's time 0, hours, 0..=24; default 10. At 12 the sun is highest.
    pub time_h: f64,
    /// Hours that pass in a second of the scene, -24..=24; default 0: the sun stands still.
    pub hours_per_s: f64,
    /// Latitude, -90..=90, north is positive; default 48.
    pub latitude_deg: f32,
    /// Day of the year, 1..=366; default 172, the northern midsummer.
    pub day_of_year: f32,
    /// Optical depth of the air over that of pure air, 1..=10; default 2.5, a clear day. Higher
    /// whitens the sky and reddens the low sun.
    pub turbidity: f32,
    /// Reflectance of the land around; default that of grassland. It lights the sky and downward
    /// faces.
    pub ground_albedo: Color,
    /// Times the light of sun and sky, 0..=100; default 1.
    pub strength: f32,
    /// Distance at which haze hides 63 %, above 0; default `inf`, clear air.
    pub haze_m: f32,
}

impl Default for DaylightFile {
    fn default() -> Self {
        Self {
            time_h: 10.0,
            hours_per_s: 0.0,
            latitude_deg: 48.0,
            day_of_year: 172.0,
            turbidity: 2.5,
            ground_albedo: Color([0.12, 0.13, 0.07]),
            strength: 1.0,
            haze_m: f32::INFINITY,
        }
    }
}

/// How light becomes a picture's colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum ToneFile {
    /// Khronos PBR Neutral: colours stay as they are up to a shoulder.
    Neutral,
    /// AgX: a film's curve, in which bright colours go to white.
    Agx,
}

/// Look of bare ground.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct GroundFile {
    /// Colour of objects that carry grass and set none; default a dark soil.
    pub soil: Color,
    /// How far that ground takes the grass's mean colour, 0..=1; default 0.7. Higher hides where
    /// blades thin out, lower shows soil between them.
    pub grass_tint: f32,
}

impl Default for GroundFile {
    fn default() -> Self {
        Self { soil: Color([0.055, 0.043, 0.028]), grass_tint: 0.7 }
    }
}

/// Gravity: a direction, a centre, and the blend between them (J equations 4 to 6).
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct GravityFile {
    /// Direction, any length but 0; default `(0, -1, 0)`.
    pub direction: [f32; 3],
    /// Strength of the direction, 0..=10; default 1, what a species' droop means.
    pub strength: f32,
    /// Centre; default `(0, 0, 0)`.
    pub center: [f32; 3],
    /// Strength of the centre, -10..=10; default 1.
    pub center_strength: f32,
    /// Blend, 0..=1: 0 (default) is the direction alone, 1 the centre alone.
    pub blend: f32,
}

impl Default for GravityFile {
    fn default() -> Self {
        Self {
            direction: [0.0, -1.0, 0.0],
            strength: 1.0,
            center: [0.0; 3],
            center_strength: 1.0,
            blend: 0.0,
        }
    }
}

/// Physical model.
#[derive(Debug, Clone, Copy, Default, Deserialize)]
pub enum PhysicsFile {
    /// Exact step, length by projection, scale-free species.
    #[default]
    Sward,
    /// Equations 1 to 16 of J, with the errata.
    Paper,
}

/// Which forms plants are drawn in.
#[derive(Debug, Clone, Copy, Default, Deserialize)]
pub enum TechniqueFile {
    /// Curved blades, thinned with distance.
    Blades,
    /// Textured strips.
    Strips,
    /// Modelled plants, then textured quads, in three bands.
    Billboards,
    /// Each species in its near form, then clusters, then ground.
    #[default]
    Continuum,
}

/// Which tests cull blades.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct CullingFile {
    /// Outside the view; default true.
    pub frustum: bool,
    /// Thinned by projected size; default true.
    pub distance: bool,
    /// Seen edge-on; default true.
    pub orientation: bool,
    /// Hidden by opaque objects; default true.
    pub occlusion: bool,
    /// The paper's own tests; default false.
    pub paper: bool,
    /// Farthest blade, above 0; default `inf`.
    pub max_distance_m: f32,
}

impl Default for CullingFile {
    fn default() -> Self {
        Self {
            frustum: true,
            distance: true,
            orientation: true,
            occlusion: true,
            paper: false,
            max_distance_m: f32::INFINITY,
        }
    }
}
