//! Sun and sky by the time of day, or by a preset. Where the sun stands is astronomy, good to a degree;
//! the light is the atmosphere's.

use crate::atmosphere::{ABOVE_AIR, Atmosphere, Dome, LUMINANCE};
use crate::{SkySettings, SunSettings};
use glam::Vec3;
use std::f32::consts::PI;

/// What lights the scene, and the air that the light comes through.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Daylight {
    /// Where the sun, or the moon, stands.
    pub course: Course,
    /// Which of the two it is.
    pub luminary: Luminary,
    /// Optical depth of the air over that of pure air, 1 to 10: 2 to 3 is a clear day, 10 thick haze.
    pub turbidity: f32,
    /// Reflectance of the land around, linear RGB, 0 to 1: it lights the sky, and downward faces.
    pub ground_albedo: Vec3,
    /// Clouds, from 0, none, to 1, an even cover.
    pub clouds: f32,
    /// Times the light of sun and sky.
    pub strength: f32,
    /// Distance at which haze hides 63 %, metres.
    pub haze_m: f32,
    /// Stops by which a picture is brighter than the automatic exposure has it.
    pub brighter_ev: f32,
}

/// Where the sun stands, by the scene's time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Course {
    /// By the time of day at a place of the Earth, which may pass with the scene's time.
    Day {
        /// Solar time at the scene's time 0, hours: at 12 the sun is highest.
        time_h: f64,
        /// Hours that pass in a second of the scene.
        hours_per_s: f64,
        /// Latitude, degrees, north is positive.
        latitude_deg: f32,
        /// Day of the year, from 1.
        day_of_year: f32,
    },
    /// It stands still.
    Still {
        /// Compass direction, degrees: 0 is north (-z), 90 east (+x).
        azimuth_deg: f32,
        /// Height over the horizon, degrees.
        elevation_deg: f32,
    },
}

/// What sheds the light that the air scatters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Luminary {
    /// The sun.
    Sun,
    /// A full moon. It is 1/128 of the sun, not 1/400,000: at its own strength its sky would be below what
    /// half-precision targets resolve. Exposure makes up for either.
    Moon,
}

/// Sun, sky and the sky's table at a time.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneLight {
    /// The sun, or the moon.
    pub sun: SunSettings,
    /// The sky in few numbers.
    pub sky: SkySettings,
    /// The sky as it is drawn; none where the scene sets its colours.
    pub dome: Option<Dome>,
    /// Exposure that suits this light, stops: a sunlit day has about 1.
    pub exposure_ev: f32,
    /// Share of what is seen that is seen without colour, as eyes see by the moon; 0 by day. Only AgX
    /// shows it.
    pub rods: f32,
}

/// Daylight with its air worked out, ready to be asked at any time.
#[derive(Debug, Clone)]
pub struct Heavens {
    day: Daylight,
    air: Atmosphere,
}

/// Colour and strength of the moon's light against the sun's: bluish, as eyes in the dark have it.
const MOON: Vec3 = Vec3::new(0.0070, 0.0079, 0.0090);
/// Radiance of the sky without sun and moon: what the air itself and the stars shed.
const NIGHT: Vec3 = Vec3::new(0.000_4, 0.000_5, 0.000_7);
/// Share of what is seen by the moon that is seen without colour.
const RODS: f32 = 0.6;
/// Share of sun and sky that comes through a cover of clouds (Kasten and Czeplak 1980: a quarter).
const THROUGH_CLOUDS: f32 = 0.25;
/// Colour of clouds: grey, a little cold.
const GREY: Vec3 = Vec3::new(0.96, 1.0, 1.06);
/// Share of the sun's direct light that an even cover of clouds takes.
const CLOUDS_TAKE: f32 = 0.99;
/// Stops that lift grass in a full sun to a picture's middle.
const GRASS_EV: f32 = 1.3;
/// How far exposure follows the light: the dark should stay darker than the day.
const ADAPTS: f32 = 0.9;

impl Heavens {
    /// Works the air out, which takes some 10 ms.
    pub fn new(day: Daylight) -> Self {
        Self { air: Atmosphere::new(day.turbidity, day.ground_albedo), day }
    }

    /// What they are of.
    pub fn daylight(&self) -> &Daylight {
        &self.day
    }

    /// Whether the light changes with the time.
    pub fn moves(&self) -> bool {
        matches!(self.day.course, Course::Day { hours_per_s, .. } if hours_per_s != 0.0)
    }

    /// Sun and sky at a time of the scene, which takes some 10 ms.
    pub fn at(&self, time_s: f64) -> SceneLight {
        let Daylight { course, luminary, strength, clouds, haze_m, brighter_ev, .. } = self.day;
        let (azimuth_deg, elevation_deg) = course.at(time_s);
        let share = match luminary {
            Luminary::Sun => Vec3::ONE,
            Luminary::Moon => MOON,
        };
        let above_air = share * (ABOVE_AIR * strength);
        let direct = self.air.sunlight(elevation_deg) * above_air;
        let mut sun = SunSettings { azimuth_deg, elevation_deg, irradiance: direct };
        let up = sun.to_sun().y.max(0.0);
        let mut dome = Dome::new(&self.air, sun.to_sun(), above_air, NIGHT * strength);
        if clouds > 0.0 {
            let fallen = luminance(dome.irradiance(Vec3::Y) + direct * up);
            dome.cover(clouds, GREY * (fallen * THROUGH_CLOUDS));
            sun.irradiance *= 1.0 - CLOUDS_TAKE * clouds;
        }
        let fallen = dome.irradiance(Vec3::Y);
        let bounce = self.air.ground_albedo() * (sun.irradiance * up + fallen) / PI;
        let harmonics = dome.harmonics(bounce);
        let sky = SkySettings {
            zenith: dome.radiance(Vec3::Y),
            horizon: dome.horizon(dome.toward_sun, PI, 0.5),
            ambient: harmonics.irradiance(Vec3::Y) / PI,
            bounce: harmonics.irradiance(Vec3::NEG_Y) / PI,
            haze_m,
        };
        let exposure_ev = exposure(sun.irradiance * up.max(0.25) + fallen) + brighter_ev;
        let rods = if luminary == Luminary::Moon { RODS } else { 0.0 };
        SceneLight { sun, sky, dome: Some(dome), exposure_ev, rods }
    }
}

/// Stops that suit an irradiance. A white ground under a high sun has a radiance near 1; grass sends back
/// a tenth, and should lie at middle grey.
fn exposure(irradiance: Vec3) -> f32 {
    (GRASS_EV - ADAPTS * (luminance(irradiance) / PI).max(1e-9).log2()).clamp(-9.0, 9.0)
}

fn luminance(color: Vec3) -> f32 {
    color.dot(LUMINANCE)
}

impl Course {
    /// Azimuth (0 is north, 90 east) and height over the horizon, degrees.
    pub fn at(&self, time_s: f64) -> (f32, f32) {
        match *self {
            Self::Still { azimuth_deg, elevation_deg } => (azimuth_deg, elevation_deg),
            Self::Day { time_h, hours_per_s, latitude_deg, day_of_year } => {
                let hour = (time_h + hours_per_s * time_s).rem_euclid(24.0) as f32;
                stands(hour, latitude_deg, day_of_year)
            }
        }
    }
}

fn stands(hour: f32, latitude_deg: f32, day_of_year: f32) -> (f32, f32) {
    let (sin_hour, cos_hour) = (15.0 * (hour - 12.0)).to_radians().sin_cos();
    let (sin_lat, cos_lat) = latitude_deg.to_radians().sin_cos();
    // Cooper 1969
    let year_deg: f32 = 360.0 / 365.0 * (284.0 + day_of_year);
    let (sin_decl, cos_decl) = (23.44 * year_deg.to_radians().sin()).to_radians().sin_cos();
    let east = -cos_decl * sin_hour;
    let north = sin_decl * cos_lat - cos_decl * cos_hour * sin_lat;
    let up = sin_decl * sin_lat + cos_decl * cos_hour * cos_lat;
    (east.atan2(north).to_degrees(), up.clamp(-1.0, 1.0).asin().to_degrees())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Copy)]
    struct Place {
        time_h: f64,
        hours_per_s: f64,
        latitude_deg: f32,
        day_of_year: f32,
    }

    const MIDSUMMER: Place =
        Place { time_h: 12.0, hours_per_s: 0.0, latitude_deg: 48.0, day_of_year: 172.0 };

    fn course(place: Place) -> Course {
        let Place { time_h, hours_per_s, latitude_deg, day_of_year } = place;
        Course::Day { time_h, hours_per_s, latitude_deg, day_of_year }
    }

    fn stands(place: Place) -> (f32, f32) {
        course(place).at(0.0)
    }

    fn heavens(course: Course, luminary: Luminary, clouds: f32) -> Heavens {
        let day = Daylight {
            course,
            luminary,
            turbidity: 2.5,
            ground_albedo: Vec3::new(0.12, 0.13, 0.07),
            clouds,
            strength: 1.0,
            haze_m: f32::INFINITY,
            brighter_ev: 0.0,
        };
        Heavens::new(day)
    }

    fn light(course: Course, luminary: Luminary, clouds: f32) -> SceneLight {
        heavens(course, luminary, clouds).at(0.0)
    }

    fn still(elevation_deg: f32) -> Course {
        Course::Still { azimuth_deg: 120.0, elevation_deg }
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
        close(stands(Place { time_h: 0.0, ..MIDSUMMER }), (0.0, -18.56));
        close(stands(Place { latitude_deg: -48.0, ..MIDSUMMER }), (0.0, 18.56));
        // On the equinox it rises in the east at 6 and sets in the west at 18, everywhere
        for latitude_deg in [-60.0, 0.0, 35.0] {
            let equinox = Place { latitude_deg, day_of_year: 81.0, ..MIDSUMMER };
            close(stands(Place { time_h: 6.0, ..equinox }), (90.0, 0.0));
            close(stands(Place { time_h: 18.0, ..equinox }), (270.0, 0.0));
        }
        // It does not set on the pole in summer
        let pole = Place { latitude_deg: 90.0, time_h: 3.0, ..MIDSUMMER };
        assert!((stands(pole).1 - 23.44).abs() < 0.1);
    }

    #[test]
    fn hours_pass_with_the_scene_and_wrap() {
        let day = Place { time_h: 22.0, hours_per_s: 2.0, ..MIDSUMMER };
        let noon = course(Place { time_h: 12.0, ..MIDSUMMER }).at(3.0);
        assert_eq!(course(day).at(7.0), noon);
        assert_eq!(course(day).at(-5.0), noon);
        let back = Place { hours_per_s: -2.0, ..day };
        assert_eq!(course(back).at(5.0), noon);
    }

    /// Heights in steps: light rises with the sun, and nothing jumps or is not finite.
    #[test]
    fn light_changes_smoothly_and_rises_with_the_sun() {
        let mut heavens = heavens(still(-30.0), Luminary::Sun, 0.0);
        let mut last = heavens.at(0.0);
        assert_eq!(last.sun.irradiance, Vec3::ZERO);
        for degree in -29..=90 {
            heavens.day.course = still(degree as f32);
            let now = heavens.at(0.0);
            let (sun, before) = (now.sun.irradiance, last.sun.irradiance);
            assert!(sun.is_finite() && sun.cmpge(before - 1e-6).all(), "{degree}: {before} {sun}");
            assert!((sun - before).max_element() < 0.35, "{degree}: {before} {sun}");
            assert!(now.exposure_ev <= last.exposure_ev + 0.05, "{degree}: {}", now.exposure_ev);
            for (now, before) in
                [(now.sky.zenith, last.sky.zenith), (now.sky.ambient, last.sky.ambient)]
            {
                let ratio = now / before;
                let smooth = ratio.min_element() > 0.9 && ratio.max_element() < 3.0;
                assert!(now.min_element() > 0.0 && smooth, "{degree}: {before} {now}");
            }
            last = now;
        }
    }

    #[test]
    fn the_moon_is_dim_and_clouds_take_the_sun() {
        let [day, night] = [Luminary::Sun, Luminary::Moon].map(|of| light(still(35.0), of, 0.0));
        let dark = night.sun.irradiance / day.sun.irradiance;
        assert!(dark.max_element() < 0.011 && dark.min_element() > 0.004, "{dark}");
        assert!(night.exposure_ev > day.exposure_ev + 4.0 && (0.0..2.5).contains(&day.exposure_ev));
        let covered = light(still(35.0), Luminary::Sun, 1.0);
        assert!(covered.sun.irradiance.max_element() < 0.05);
        assert!(covered.sky.ambient.y > 0.1 && covered.dome.is_some_and(|dome| dome.disc == 0.0));
    }
}
