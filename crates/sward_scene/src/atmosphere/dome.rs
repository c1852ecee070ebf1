//! The sky as a table: what a picture's background and the harmonics are read from.

use super::{Atmosphere, SkyHarmonics};
use glam::{Vec2, Vec3};
use std::f32::consts::{FRAC_PI_2, PI};

/// Radiance of the sky above the horizon, by azimuth from the sun's and by elevation.
///
/// The sky is alike on both sides of the sun, so columns go from its azimuth to the opposite one. Rows
/// go from the horizon up, denser the nearer they are to it: row `r` stands at `90 (r / (ROWS - 1))^2`
/// degrees.
#[derive(Debug, Clone, PartialEq)]
pub struct Dome {
    /// Horizontal unit direction to the sun, x and z.
    pub toward_sun: Vec2,
    /// Share of the sun's disc, or the moon's, that shows.
    pub disc: f32,
    radiance: Vec<Vec3>,
}

impl Dome {
    /// Azimuths, over half a turn.
    pub const COLUMNS: usize = 97;
    /// Elevations.
    pub const ROWS: usize = 108;

    /// The sky of a sun in this unit direction and of this irradiance above the air, with radiance
    /// added that comes from everywhere.
    pub fn new(atmosphere: &Atmosphere, to_sun: Vec3, above_air: Vec3, night: Vec3) -> Self {
        let height = to_sun.y.clamp(-1.0, 1.0);
        let sun = Vec3::new((1.0 - height * height).max(0.0).sqrt(), height, 0.0);
        let cells = (0..Self::ROWS).flat_map(|r| (0..Self::COLUMNS).map(move |c| (c, r)));
        let radiance = cells.map(|(column, row)| {
            let (around, up) = (azimuth(column as f32), elevation(row as f32));
            let direction = Vec3::new(up.cos() * around.cos(), up.sin(), up.cos() * around.sin());
            atmosphere.radiance(direction, sun) * above_air + night
        });
        let toward_sun = Vec2::new(to_sun.x, to_sun.z).normalize_or(Vec2::X);
        Self { toward_sun, disc: 1.0, radiance: radiance.collect() }
    }

    /// Lays clouds over the sky: 0 none, 1 an even cover, in which the sun does not show. They have
    /// the brightness of the overcast sky of the CIE, a third at the horizon of what it is overhead,
    /// and shed `irradiance` on the ground where they cover all.
    pub fn cover(&mut self, clouds: f32, irradiance: Vec3) {
        // Irradiance of that sky is 7 pi / 9 of its radiance overhead
        let overhead = irradiance * (9.0 / (7.0 * PI));
        for (i, light) in self.radiance.iter_mut().enumerate() {
            let up = elevation((i / Self::COLUMNS) as f32).sin();
            *light = light.lerp(overhead * ((1.0 + 2.0 * up) / 3.0), clouds);
        }
        self.disc *= (1.0 - 4.0 * clouds).max(0.0);
    }

    /// All radiances, row by row from the horizon up.
    pub fn texels(&self) -> &[Vec3] {
        &self.radiance
    }

    /// Radiance in a unit direction; below the horizon, the horizon's.
    pub fn radiance(&self, direction: Vec3) -> Vec3 {
        let level = Vec2::new(direction.x, direction.z).normalize_or(self.toward_sun);
        let around = level.dot(self.toward_sun).clamp(-1.0, 1.0).acos();
        let up = direction.y.clamp(0.0, 1.0).asin();
        let column = around / PI * (Self::COLUMNS - 1) as f32;
        let row = (up / FRAC_PI_2).sqrt() * (Self::ROWS - 1) as f32;
        let (c, r) = ((column as usize).min(Self::COLUMNS - 2), (row as usize).min(Self::ROWS - 2));
        let in_row = |r: usize| {
            let start = r * Self::COLUMNS + c;
            self.radiance[start].lerp(self.radiance[start + 1], column - c as f32)
        };
        in_row(r).lerp(in_row(r + 1), row - r as f32)
    }

    /// Mean radiance of the sky at an elevation over the azimuths within `half_rad` of a horizontal
    /// direction: near the horizon, what haze in a view that way is lit by.
    pub fn horizon(&self, heading: Vec2, half_rad: f32, up_deg: f32) -> Vec3 {
        const ACROSS: usize = 33;
        let heading = heading.normalize_or(self.toward_sun);
        let at = |i: usize| {
            let turn = half_rad * (2.0 * i as f32 / (ACROSS - 1) as f32 - 1.0);
            let level = Vec2::from_angle(turn).rotate(heading);
            self.radiance(Vec3::new(level.x, up_deg.to_radians().tan(), level.y).normalize())
        };
        (0..ACROSS).map(at).sum::<Vec3>() / ACROSS as f32
    }

    /// Calls for each texel and its mirror image with its direction and solid angle.
    fn for_each(&self, mut call: impl FnMut(Vec3, Vec3, f32)) {
        let side = self.toward_sun.perp();
        for (i, light) in self.radiance.iter().enumerate() {
            let (column, row) = (i % Self::COLUMNS, i / Self::COLUMNS);
            let (low, high) = between(row, Self::ROWS, elevation);
            let (left, right) = between(column, Self::COLUMNS, azimuth);
            let solid = (high.sin() - low.sin()) * (right - left);
            let (up, around) = (0.5 * (low + high), azimuth(column as f32));
            for turn in [around, -around] {
                let level = (self.toward_sun * turn.cos() + side * turn.sin()) * up.cos();
                call(Vec3::new(level.x, up.sin(), level.y), *light, solid);
            }
        }
    }

    /// Irradiance that the sky sheds on a surface with this unit normal, summed texel by texel.
    pub fn irradiance(&self, normal: Vec3) -> Vec3 {
        let mut sum = Vec3::ZERO;
        self.for_each(|way, light, solid| sum += light * (way.dot(normal).max(0.0) * solid));
        sum
    }

    /// The sky above, and below it ground of an even radiance.
    pub fn harmonics(&self, ground: Vec3) -> SkyHarmonics {
        let mut harmonics = SkyHarmonics::default();
        self.for_each(|way, light, solid| {
            harmonics.add(way, light * solid);
            harmonics.add(way.with_y(-way.y), ground * solid);
        });
        harmonics
    }
}

fn azimuth(column: f32) -> f32 {
    column / (Dome::COLUMNS - 1) as f32 * PI
}

fn elevation(row: f32) -> f32 {
    let share = row / (Dome::ROWS - 1) as f32;
    share * share * FRAC_PI_2
}

/// Where the cell of a row or column begins and ends: half way to its neighbours.
fn between(index: usize, count: usize, at: fn(f32) -> f32) -> (f32, f32) {
    let index = index as f32;
    (at((index - 0.5).max(0.0)), at((index + 0.5).min((count - 1) as f32)))
}
