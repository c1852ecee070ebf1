//! What is worked out once for an air: how much light comes through it, and what light that was
//! scattered more than once adds.

use super::air::{Air, DISC_RAD, GROUND_KM, Ray, TOP_KM};
use glam::DVec3;
use std::f64::consts::PI;
use std::fmt;

/// A grid of colours over the unit square, read between its points.
#[derive(Clone)]
struct Grid {
    columns: usize,
    values: Vec<DVec3>,
}

/// Without its thousands of values, which follow from the air.
impl fmt::Debug for Grid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Grid").field("columns", &self.columns).finish_non_exhaustive()
    }
}

impl Grid {
    fn new(columns: usize, rows: usize, at: impl Fn(f64, f64) -> DVec3) -> Self {
        let share = |i: usize, count: usize| i as f64 / (count - 1) as f64;
        let cells = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
        let values = cells.map(|(x, y)| at(share(x, columns), share(y, rows))).collect();
        Self { columns, values }
    }

    fn read(&self, u: f64, v: f64) -> DVec3 {
        let rows = self.values.len() / self.columns;
        let place = |share: f64, count: usize| {
            let at = share.clamp(0.0, 1.0) * (count - 1) as f64;
            let first = (at as usize).min(count - 2);
            (first, at - first as f64)
        };
        let ((x, along), (y, across)) = (place(u, self.columns), place(v, rows));
        let row = |y: usize| {
            let start = y * self.columns + x;
            self.values[start].lerp(self.values[start + 1], along)
        };
        row(y).lerp(row(y + 1), across)
    }
}

/// Share of light that comes through the air from beyond it (Bruneton and Neyret 2008: distances
/// in place of heights and angles, so that the horizon has its own texels).
#[derive(Debug, Clone)]
pub(super) struct Transmittance(Grid);

/// Kilometres from the ground to the end of the air along the horizon.
fn horizon_km() -> f64 {
    (TOP_KM * TOP_KM - GROUND_KM * GROUND_KM).sqrt()
}

impl Transmittance {
    pub(super) fn new(air: &Air) -> Self {
        const STEPS: u32 = 40;
        Self(Grid::new(128, 48, |u, v| {
            let to_horizon = v * horizon_km();
            let radius = (to_horizon * to_horizon + GROUND_KM * GROUND_KM).sqrt();
            let (least, most) = (TOP_KM - radius, to_horizon + horizon_km());
            let length = (least + u * (most - least)).max(1e-9);
            let up =
                (TOP_KM * TOP_KM - radius * radius - length * length) / (2.0 * radius * length);
            let up = up.clamp(-1.0, 1.0);
            let mut depth = DVec3::ZERO;
            for (t, dt) in steps(length, STEPS) {
                depth += air.at(radius_at(Ray { radius, up }, t) - GROUND_KM).extinction * dt;
            }
            (-depth).exp()
        }))
    }

    /// Of a ray that does not meet the ground.
    fn read(&self, ray: Ray) -> DVec3 {
        let squared = ray.radius * ray.radius - GROUND_KM * GROUND_KM;
        let to_horizon = squared.max(0.0).sqrt();
        let (least, most) = (TOP_KM - ray.radius, to_horizon + horizon_km());
        let u = (ray.to_top() - least) / (most - least).max(1e-9);
        self.0.read(u, to_horizon / horizon_km())
    }

    /// Light that reaches a place from the sun, whose disc the horizon may hide in part.
    pub(super) fn of_sun(&self, radius: f64, sun_up: f64) -> DVec3 {
        let horizon = Ray::horizon(radius);
        let risen = ((sun_up - horizon) / (2.0 * DISC_RAD) + 0.5).clamp(0.0, 1.0);
        if risen == 0.0 {
            return DVec3::ZERO;
        }
        self.read(Ray { radius, up: sun_up.max(horizon) }) * (risen * risen * (3.0 - 2.0 * risen))
    }
}

/// Distance from the Earth's centre `t` along a ray.
pub(super) fn radius_at(ray: Ray, t: f64) -> f64 {
    (ray.radius * ray.radius + t * (t + 2.0 * ray.radius * ray.up)).max(0.0).sqrt()
}

/// Middles and lengths of steps along a way, short ones first: near air is dense.
pub(super) fn steps(length: f64, count: u32) -> impl Iterator<Item = (f64, f64)> {
    let end = move |i: u32| {
        let share = f64::from(i) / f64::from(count);
        length * share * share
    };
    (0..count).map(move |i| {
        let (from, to) = (end(i), end(i + 1));
        (0.5 * (from + to), to - from)
    })
}

/// Light of all orders of scattering beyond the first, by height and sun, for a sun of irradiance 1
/// (Hillaire, section 5.5).
#[derive(Debug, Clone)]
pub(super) struct Multiple(Grid);

impl Multiple {
    pub(super) fn new(air: &Air, sunlight: &Transmittance, albedo: DVec3) -> Self {
        Self(Grid::new(40, 20, |u, v| {
            let across = 2.0 * u - 1.0;
            let sun_up = across * across.abs();
            let radius = GROUND_KM + (v * v * (TOP_KM - GROUND_KM)).clamp(0.001, 99.9);
            let (second, again) = orders(air, sunlight, albedo, radius, sun_up);
            // Each order is that share of the one before: their sum is a geometric series
            second / (DVec3::ONE - again)
        }))
    }

    /// Radiance that comes from everywhere, as a mean.
    pub(super) fn read(&self, radius: f64, sun_up: f64) -> DVec3 {
        let across = sun_up.abs().sqrt().copysign(sun_up);
        let height = ((radius - GROUND_KM) / (TOP_KM - GROUND_KM)).max(0.0);
        self.0.read(0.5 * across + 0.5, height.sqrt())
    }
}

/// Mean radiance of the second order at a place, and the share of even light round it that comes
/// there again.
fn orders(
    air: &Air,
    sunlight: &Transmittance,
    albedo: DVec3,
    radius: f64,
    sun_up: f64,
) -> (DVec3, DVec3) {
    const WAYS: u32 = 64;
    const STEPS: u32 = 16;
    let sun = DVec3::new((1.0 - sun_up * sun_up).max(0.0).sqrt(), sun_up, 0.0);
    let (mut second, mut again) = (DVec3::ZERO, DVec3::ZERO);
    for way in 0..WAYS {
        let direction = even_direction(way, WAYS);
        let ray = Ray { radius, up: direction.y };
        let ground = ray.to_ground();
        let mut through = DVec3::ONE;
        for (t, dt) in steps(ground.unwrap_or_else(|| ray.to_top()), STEPS) {
            let place = DVec3::Y * radius + direction * t;
            let far = place.length();
            let mixture = air.at(far - GROUND_KM);
            let passed = (-mixture.extinction * dt).exp();
            let scattered = through * (mixture.rayleigh + mixture.mie) * kept(&mixture, passed);
            second += scattered * sunlight.of_sun(far, place.dot(sun) / far) / (4.0 * PI);
            again += scattered;
            through *= passed;
        }
        if let Some(t) = ground {
            let up = (DVec3::Y * radius + direction * t).normalize();
            let lit = sunlight.of_sun(GROUND_KM, up.dot(sun)) * up.dot(sun).max(0.0);
            second += through * albedo * lit / PI;
        }
    }
    (second / f64::from(WAYS), (again / f64::from(WAYS)).min(DVec3::splat(0.99)))
}

/// Kilometres of a step that count: the sum of what is left along it.
pub(super) fn kept(mixture: &super::air::Mixture, passed: DVec3) -> DVec3 {
    (DVec3::ONE - passed) / mixture.extinction.max(DVec3::splat(1e-12))
}

/// Directions spread evenly over the sphere, by the golden angle.
fn even_direction(index: u32, count: u32) -> DVec3 {
    let y = 1.0 - (2.0 * f64::from(index) + 1.0) / f64::from(count);
    let round = f64::from(index) * PI * (3.0 - 5.0_f64.sqrt());
    let level = (1.0 - y * y).sqrt();
    DVec3::new(level * round.cos(), y, level * round.sin())
}
