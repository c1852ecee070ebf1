//! Fog, blur weights, the Gaussian and AgX in f64, which tests compare the shaders with.

use glam::{DMat3, DVec2, DVec3};

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

/// AgX: a screen's linear light, from matrices by rows and a sigmoid that is found by its conditions and
/// not by the shader's constants.
pub fn agx(light: DVec3) -> DVec3 {
    let inset = [[0.8424, 0.0784, 0.0792], [0.0423, 0.8785, 0.0792], [0.0424, 0.0784, 0.8792]];
    let inset = DMat3::from_cols_array_2d(&inset).transpose();
    let stops = |x: f64| ((x.max(1e-10) / 0.18).log2() + 10.0) / 16.5;
    let look = (inset * light).map(|x| sigmoid(stops(x).clamp(0.0, 1.0)).powf(1.3));
    let grey = look.dot(DVec3::new(0.2126, 0.7152, 0.0722));
    let shown = inset.inverse() * (grey + (look - grey) * 1.25);
    shown.map(|x| x.max(0.0).powf(2.2))
}

/// From (0, 0) over (10/16.5, 1/2), with slope 2, to (1, 1): toe of power 3, shoulder of power 3.25.
fn sigmoid(x: f64) -> f64 {
    let pivot = 10.0 / 16.5;
    let (sign, from, width, power) =
        if x < pivot { (-1.0, pivot - x, pivot, 3.0) } else { (1.0, x - pivot, 1.0 - pivot, 3.25) };
    // How far the bent line of slope 2 goes at most
    let most = ((2.0 * width).powf(-power) * ((2.0 * width / 0.5_f64).powf(power) - 1.0))
        .powf(-1.0 / power);
    let straight: f64 = 2.0 * from / most;
    0.5 + sign * most * straight / (1.0 + straight.powf(power)).powf(1.0 / power)
}

/// sRGB's encoding.
pub fn srgb(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { linear * 12.92 } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}
