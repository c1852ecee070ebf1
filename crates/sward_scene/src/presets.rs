//! Lights by name.

use crate::daylight::{Course, Daylight, Luminary};
use crate::schema::DaylightFile;
use glam::Vec3;

/// A light with a name: a height of the sun, an air, an exposure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LightPreset {
    /// The sun has just risen, in clear air.
    Dawn,
    /// A high sun.
    Noon,
    /// A low warm sun in light haze.
    GoldenHour,
    /// An even cover of clouds: no shadows.
    Overcast,
    /// A full moon.
    Moonlit,
}

impl LightPreset {
    /// All, by the time of day.
    pub const ALL: [Self; 5] =
        [Self::Dawn, Self::Noon, Self::GoldenHour, Self::Overcast, Self::Moonlit];

    /// Its name, as commands have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Dawn => "dawn",
            Self::Noon => "noon",
            Self::GoldenHour => "golden-hour",
            Self::Overcast => "overcast",
            Self::Moonlit => "moonlit",
        }
    }

    /// The light for a scene whose sun stands in this direction, which it keeps: its pictures are
    /// composed for that.
    pub fn daylight(self, azimuth_deg: f32, haze_m: f32) -> Daylight {
        let (elevation_deg, turbidity, brighter_ev) = match self {
            Self::Dawn => (3.8, 1.6, -0.3),
            Self::Noon => (58.0, 1.6, -0.1),
            Self::GoldenHour => (8.0, 2.2, -0.2),
            Self::Overcast => (45.0, 3.0, -0.6),
            Self::Moonlit => (34.0, 1.6, -1.8),
        };
        let moon = self == Self::Moonlit;
        let albedo = DaylightFile::default().ground_albedo.0;
        Daylight {
            course: Course::Still { azimuth_deg, elevation_deg },
            luminary: if moon { Luminary::Moon } else { Luminary::Sun },
            turbidity,
            ground_albedo: Vec3::from(albedo),
            clouds: if self == Self::Overcast { 1.0 } else { 0.0 },
            strength: 1.0,
            haze_m,
            brighter_ev,
        }
    }
}
