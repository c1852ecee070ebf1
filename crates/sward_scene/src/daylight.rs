//! Sun and sky by the time of day. Where the sun stands is astronomy, good to a degree; its colour is
//! one of air mass; the sky's colours are a table by the sun's height, chosen by eye.

use crate::{SkySettings, SunSettings};
use glam::Vec3;

/// The time of day at a place of the Earth, which may pass with the scene's time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Daylight {
    /// Solar time at the scene's time 0, hours: at 12 the sun is highest.
    pub time_h: f64,
    /// Hours that pass in a second of the scene.
    pub hours_per_s: f64,
    /// Latitude, degrees, north is positive.
    pub latitude_deg: f32,
    /// Day of the year, from 1.
    pub day_of_year: f32,
    /// Times the light of sun and sky.
    pub strength: f32,
    /// Distance at which haze hides 63 %, metres.
    pub haze_m: f32,
}

/// Irradiance of the sun above the air, in the scene's units.
const ABOVE_AIR: f32 = 3.65;
/// Optical depth of clear air straight up, red, green and blue.
const OPTICAL_DEPTH: Vec3 = Vec3::new(0.10, 0.15, 0.24);
/// Half of the height over which the sun sets, degrees: its disc, with what the air bends.
const SETS_DEG: f32 = 0.6;
/// Reflectance of the land around, which sheds light on downward faces.
const LAND: Vec3 = Vec3::new(0.12, 0.13, 0.07);

/// Colours of the sky with the sun at a height.
struct SkyColors {
    sun_deg: f32,
    zenith: Vec3,
    horizon: Vec3,
    ambient: Vec3,
}

const fn colors(sun_deg: f32, zenith: [f32; 3], horizon: [f32; 3], ambient: [f32; 3]) -> SkyColors {
    SkyColors {
        sun_deg,
        zenith: Vec3::from_array(zenith),
        horizon: Vec3::from_array(horizon),
        ambient: Vec3::from_array(ambient),
    }
}

/// By rising sun: night, the twilights, sunrise, the golden hour, day.
const SKY: [SkyColors; 8] = [
    colors(-18.0, [0.002, 0.003, 0.008], [0.004, 0.005, 0.010], [0.004, 0.006, 0.012]),
    colors(-12.0, [0.003, 0.006, 0.017], [0.010, 0.012, 0.023], [0.006, 0.009, 0.018]),
    colors(-6.0, [0.012, 0.024, 0.066], [0.080, 0.070, 0.090], [0.024, 0.033, 0.060]),
    colors(0.0, [0.060, 0.115, 0.260], [0.450, 0.300, 0.220], [0.130, 0.150, 0.220]),
    colors(4.0, [0.100, 0.185, 0.390], [0.660, 0.470, 0.320], [0.230, 0.270, 0.370]),
    colors(12.0, [0.140, 0.280, 0.570], [0.660, 0.650, 0.640], [0.400, 0.500, 0.660]),
    colors(30.0, [0.160, 0.340, 0.720], [0.620, 0.740, 0.880], [0.550, 0.750, 1.000]),
    colors(70.0, [0.140, 0.320, 0.720], [0.640, 0.770, 0.920], [0.600, 0.800, 1.050]),
];

impl Daylight {
    /// Sun and sky at a time of the scene.
    pub fn at(&self, time_s: f64) -> (SunSettings, SkySettings) {
        let (azimuth_deg, elevation_deg) = self.sun_stands(time_s);
        let irradiance = sunlight(elevation_deg) * self.strength;
        let [zenith, horizon, ambient] = sky(elevation_deg).map(|color| color * self.strength);
        let on_land =
            irradiance * elevation_deg.to_radians().sin().max(0.0) / std::f32::consts::PI + ambient;
        let sun = SunSettings { azimuth_deg, elevation_deg, irradiance };
        let bounce = LAND * on_land;
        (sun, SkySettings { zenith, horizon, ambient, bounce, haze_m: self.haze_m })
    }

    /// Azimuth (0 is north, 90 east) and height over the horizon, degrees.
    fn sun_stands(&self, time_s: f64) -> (f32, f32) {
        let hour = (self.time_h + self.hours_per_s * time_s).rem_euclid(24.0) as f32;
        let (sin_hour, cos_hour) = (15.0 * (hour - 12.0)).to_radians().sin_cos();
        let (sin_lat, cos_lat) = self.latitude_deg.to_radians().sin_cos();
        // Cooper 1969
        let year_deg: f32 = 360.0 / 365.0 * (284.0 + self.day_of_year);
        let (sin_decl, cos_decl) = (23.44 * year_deg.to_radians().sin()).to_radians().sin_cos();
        let east = -cos_decl * sin_hour;
        let north = sin_decl * cos_lat - cos_decl * cos_hour * sin_lat;
        let up = sin_decl * sin_lat + cos_decl * cos_hour * cos_lat;
        (east.atan2(north).to_degrees(), up.clamp(-1.0, 1.0).asin().to_degrees())
    }
}

/// Irradiance of the sun at a height, after the air that its light passes: redder the lower.
fn sunlight(elevation_deg: f32) -> Vec3 {
    let height = elevation_deg.max(-SETS_DEG);
    // Kasten and Young 1989: how many times the air overhead it passes
    let air = (height.to_radians().sin() + 0.505_72 * (height + 6.079_95).powf(-1.636_4)).recip();
    let risen = ((elevation_deg + SETS_DEG) / (2.0 * SETS_DEG)).clamp(0.0, 1.0);
    let share = risen * risen * (3.0 - 2.0 * risen);
    (-OPTICAL_DEPTH * air).exp() * (ABOVE_AIR * share)
}

/// Zenith, horizon and ambient. Between the table's heights by ratio: twilight spans thousands.
fn sky(elevation_deg: f32) -> [Vec3; 3] {
    let next = SKY.iter().position(|row| row.sun_deg > elevation_deg).unwrap_or(SKY.len());
    let (low, high) = (&SKY[next.saturating_sub(1)], &SKY[next.min(SKY.len() - 1)]);
    let span = (high.sun_deg - low.sun_deg).max(1e-3);
    let share = ((elevation_deg - low.sun_deg) / span).clamp(0.0, 1.0);
    let mix = |a: Vec3, b: Vec3| a.powf(1.0 - share) * b.powf(share);
    [mix(low.zenith, high.zenith), mix(low.horizon, high.horizon), mix(low.ambient, high.ambient)]
}

#[cfg(test)]
mod tests {
    use super::*;

    const MIDSUMMER: Daylight = Daylight {
        time_h: 12.0,
        hours_per_s: 0.0,
        latitude_deg: 48.0,
        day_of_year: 172.0,
        strength: 1.0,
        haze_m: f32::INFINITY,
    };

    fn stands(day: Daylight) -> (f32, f32) {
        day.sun_stands(0.0)
    }

    #[test]
    fn the_sun_stands_where_almanacs_have_it() {
        let close = |(azimuth, height): (f32, f32), expected: (f32, f32)| {
            let turned = (azimuth - expected.0 + 180.0).rem_euclid(360.0) - 180.0;
            let near = turned.abs() < 1.0 && (height - expected.1).abs() < 0.7;
            assert!(near, "({azimuth}, {height}) is not {expected:?}");
        };
        // 90 - latitude + 23.44 at noon in the south, as much below at midnight
        close(stands(MIDSUMMER), (180.0, 65.44));
        close(stands(Daylight { time_h: 0.0, ..MIDSUMMER }), (0.0, -18.56));
        close(stands(Daylight { latitude_deg: -48.0, ..MIDSUMMER }), (0.0, 18.56));
        // On the equinox it rises in the east at 6 and sets in the west at 18, everywhere
        for latitude_deg in [-60.0, 0.0, 35.0] {
            let equinox = Daylight { latitude_deg, day_of_year: 81.0, ..MIDSUMMER };
            close(stands(Daylight { time_h: 6.0, ..equinox }), (90.0, 0.0));
            close(stands(Daylight { time_h: 18.0, ..equinox }), (270.0, 0.0));
        }
        // It does not set on the pole in summer
        let pole = Daylight { latitude_deg: 90.0, time_h: 3.0, ..MIDSUMMER };
        assert!((stands(pole).1 - 23.44).abs() < 0.1);
    }

    #[test]
    fn hours_pass_with_the_scene_and_wrap() {
        let day = Daylight { time_h: 22.0, hours_per_s: 2.0, ..MIDSUMMER };
        assert_eq!(day.at(7.0), Daylight { time_h: 12.0, ..MIDSUMMER }.at(3.0));
        assert_eq!(day.at(-5.0), day.at(7.0));
        let back = Daylight { hours_per_s: -2.0, ..day };
        assert_eq!(back.at(5.0), Daylight { time_h: 12.0, ..MIDSUMMER }.at(0.0));
    }

    /// Heights in small steps: light rises with the sun, and nothing jumps or is not finite.
    #[test]
    fn light_changes_smoothly_and_rises_with_the_sun() {
        let at = |tenth: i32| {
            let height = tenth as f32 * 0.1;
            (sunlight(height), sky(height))
        };
        let (mut last, mut last_sky) = at(-900);
        assert_eq!(last, Vec3::ZERO);
        for tenth in -899..=900 {
            let (sun, sky) = at(tenth);
            assert!(sun.is_finite() && sun.cmpge(last).all(), "{tenth}: {last} {sun}");
            assert!((sun - last).max_element() < 0.06, "{tenth}: {last} {sun}");
            for (now, before) in sky.into_iter().zip(last_sky) {
                let ratio = now / before;
                assert!(ratio.min_element() > 0.9 && ratio.max_element() < 1.1, "{tenth}");
            }
            (last, last_sky) = (sun, sky);
        }
        let (low, high) = (sunlight(4.0), sunlight(50.0));
        assert!(low.z / low.x < 0.3 && high.z / high.x > 0.75, "low suns are red: {low} {high}");
    }
}
