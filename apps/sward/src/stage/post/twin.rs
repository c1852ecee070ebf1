//! Fog, blur weights and the Gaussian in f64, which tests compare the shaders with.

use glam::{DVec2, DVec3};

/// Fog: a share a metre, where it starts, at which height it is that dense, over which it thins.
#[derive(Debug, Clone, Copy)]
pub struct Fog {
    pub density_per_m: f64,
    pub start_m: f64,
    pub base_m: f64,
    pub falloff_m: f64,
}

impl Fog {
    /// Share of light that comes through, by adding up the density along the way.
    pub fn clear(&self, eye: DVec3, world: DVec3) -> f64 {
        const STEPS: u32 = 20_000;
        let way = world - eye;
        let (distance, inside) = (way.length(), way.length() - self.start_m);
        if inside <= 0.0 {
            return 1.0;
        }
        let density = |share: f64| {
            let y = eye.y + way.y / distance * (self.start_m + share * inside);
            self.density_per_m * (-(y - self.base_m) / self.falloff_m).exp()
        };
        let sum: f64 = (0..STEPS).map(|i| density((f64::from(i) + 0.5) / f64::from(STEPS))).sum();
        (-sum / f64::from(STEPS) * inside).exp()
    }
}

/// Variance of the blur of a thin lens along each axis: that of the disc that a point at `depth`
/// makes of a lens of this opening, seen in pixels of which `px_per_m` are a metre in focus.
pub fn blur_variance(focus: f64, opening: f64, px_per_m: f64, depth: f64) -> f64 {
    // By similar triangles: the cone from the opening to the point, cut by the plane in focus
    let disc_m = opening * (1.0 - focus / depth).abs();
    let radius_px = 0.5 * disc_m * px_per_m;
    // A uniform disc's, along one axis
    radius_px * radius_px / 4.0
}

/// A Gaussian's weights by distance from its middle, cut at 2.5 deviations, that sum to one.
pub fn gaussian(sigma: f64) -> Vec<f64> {
    let reach = (2.5 * sigma).ceil() as i64;
    let weight = |i: i64| (-0.5 * (i as f64 / sigma).powi(2)).exp();
    let sum: f64 = (-reach..=reach).map(weight).sum();
    (0..=reach).map(|i| weight(i) / sum).collect()
}

/// Mean and variance of the light of a picture's row.
pub fn moments(row: &[f64]) -> DVec2 {
    let total: f64 = row.iter().sum();
    let mean = row.iter().enumerate().map(|(x, v)| x as f64 * v).sum::<f64>() / total;
    let spread = |(x, v): (usize, &f64)| (x as f64 - mean).powi(2) * v;
    DVec2::new(mean, row.iter().enumerate().map(spread).sum::<f64>() / total)
}
