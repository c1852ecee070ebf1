//! What shows of a field from an elevation, each blade hiding what is behind it: a stand of it,
//! repeated without end, is looked at.

use super::Triangle;
use super::raster::Window;
use super::stand::Posed;
use glam::{Vec2, Vec3};

/// Elevations: their sines double, from 1/32 to 1.
pub(crate) const ROWS: usize = 6;

/// A place that shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Shown {
    /// On the eye's side: x to the right, y up, z level towards the eye.
    pub normal: Vec3,
    /// Linear reflectance.
    pub albedo: Vec3,
    /// 0 root, 1 tip.
    pub height_share: f32,
    /// How far its blade leans: 0 upright, 1 flat.
    pub lean: f32,
}

/// What shows from one elevation.
#[derive(Debug, Clone, Default)]
pub(crate) struct Cover {
    /// Places, evenly over what is hidden of the ground.
    pub shown: Vec<Shown>,
    /// Samples in all.
    pub samples: usize,
}

/// Sine of a row's elevation.
pub(crate) fn sine(row: usize) -> f32 {
    0.5_f32.powi((ROWS - 1 - row.min(ROWS - 1)) as i32)
}

/// A level direction towards the eye, and what a picture from an elevation has as its right and up.
pub(crate) fn axes(azimuth: f32, sine: f32) -> [Vec3; 3] {
    let toward = Vec3::new(azimuth.sin(), 0.0, azimuth.cos());
    let cosine = (1.0 - sine * sine).max(0.0).sqrt();
    [toward, Vec3::Y.cross(toward), Vec3::Y * cosine - toward * sine]
}

/// Highest point and farthest one from the middle, of triangles.
fn extent(triangles: &[Triangle]) -> (f32, f32) {
    let points = triangles.iter().flatten().map(|corner| corner.position);
    points.fold((0.0, 0.0), |(high, far), p| {
        (f32::max(high, p.y), f32::max(far, Vec2::new(p.x, p.z).length()))
    })
}

/// Looks at a stand that repeats after so many metres, from an elevation and a side, with so many
/// samples a side.
pub(crate) fn look(posed: &Posed, period: Vec2, azimuth: f32, row: usize, grid: u32) -> Cover {
    let sine = sine(row);
    let [toward, right, up] = axes(azimuth, sine);
    let half = 0.5 * period.min_element();
    let (high, far) = extent(&posed.triangles);
    // Rays pass over this much of the ground from the top of the grass on
    let over = high * (1.0 - sine * sine).max(0.0).sqrt() / sine;
    let slack = far + half;
    let reach = over + slack;
    let cells = (Vec2::splat(reach) / period).ceil().as_ivec2();
    let mut copies: Vec<Vec3> = (-cells.x..=cells.x)
        .flat_map(|x| (-cells.y..=cells.y).map(move |z| (x, z)))
        .map(|(x, z)| Vec3::new(x as f32 * period.x, 0.0, z as f32 * period.y))
        .filter(|at| {
            let ahead = at.dot(toward);
            at.dot(right).abs() < slack && ahead > -slack && ahead < over + slack
        })
        .collect();
    copies.sort_by(|a, b| b.dot(toward).total_cmp(&a.dot(toward)));
    let window = Window {
        center: Vec3::ZERO,
        right,
        up,
        half: Vec2::new(half, half * sine),
        size: [grid; 2],
        samples: 1,
    };
    let seen = window.see_copies(&posed.triangles, &copies);
    let shown = seen.surfaces().map(|(triangle, s)| Shown {
        normal: Vec3::new(s.normal.dot(right), s.normal.y, s.normal.dot(toward)),
        albedo: s.albedo,
        height_share: s.height_share,
        lean: posed.leans.get(triangle).copied().unwrap_or(0.0),
    });
    Cover { shown: shown.collect(), samples: (grid * grid) as usize }
}

impl Cover {
    /// Both.
    pub(crate) fn with(mut self, other: Self) -> Self {
        self.shown.extend(other.shown);
        self.samples += other.samples;
        self
    }

    /// Share of the ground that shows.
    pub(crate) fn open(&self) -> f32 {
        1.0 - self.shown.len() as f32 / self.samples.max(1) as f32
    }
}
