//! Height images: read, smoothed and resampled.

use super::image;
use crate::SceneError;
use ::image::DynamicImage;
use std::path::Path;

/// A grid of heights, 0 (black) to 1 (white); row 0 is the image's top.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Heights {
    pub(crate) columns: usize,
    pub(crate) rows: usize,
    pub(crate) values: Vec<f32>,
}

/// Decodes a grey PNG. The second value is true for 8 bits, which make steps.
pub(crate) fn parse(file: &Path, bytes: &[u8]) -> Result<(Heights, bool), SceneError> {
    let image = image::decode(file, bytes)?;
    if image.color().has_color() {
        let cause = "is a colour image; a height image must be grey, best 16-bit PNG";
        return Err(SceneError::asset(file, cause));
    }
    let coarse = matches!(image, DynamicImage::ImageLuma8(_) | DynamicImage::ImageLumaA8(_));
    let grey = image.into_luma16();
    let (columns, rows) = (grey.width() as usize, grey.height() as usize);
    if columns < 2 || rows < 2 {
        let cause = format!("is {columns} x {rows} pixels; a height image needs at least 2 x 2");
        return Err(SceneError::asset(file, cause));
    }
    let values = grey.into_raw().iter().map(|&v| f32::from(v) / f32::from(u16::MAX)).collect();
    Ok((Heights { columns, rows, values }, coarse))
}

impl Heights {
    /// The stored height, clamped to the rim.
    fn texel(&self, column: isize, row: isize) -> f32 {
        let column = column.clamp(0, self.columns as isize - 1) as usize;
        let row = row.clamp(0, self.rows as isize - 1) as usize;
        self.values.get(row * self.columns + column).copied().unwrap_or(0.0)
    }

    /// The height at (u, v) in 0..=1, rim to rim, by a uniform cubic B-spline: its second
    /// derivative is continuous, so light on the hills shows no facets. It rounds single-texel
    /// peaks off a little.
    pub(crate) fn sample(&self, u: f32, v: f32) -> f32 {
        let (x, y) = (u * (self.columns - 1) as f32, v * (self.rows - 1) as f32);
        let (weights_x, weights_y) = (spline_weights(x.fract()), spline_weights(y.fract()));
        let mut sum = 0.0;
        for (j, wy) in (-1..).zip(weights_y) {
            for (i, wx) in (-1..).zip(weights_x) {
                sum += wx * wy * self.texel(x as isize + i, y as isize + j);
            }
        }
        sum
    }

    /// Blurs with a Gaussian of these radii (standard deviations), texels.
    pub(crate) fn blurred(&self, columns: f32, rows: f32) -> Self {
        let across = self.blurred_along(columns, |x, y, d| (x + d, y));
        across.blurred_along(rows, |x, y, d| (x, y + d))
    }

    fn blurred_along(
        &self,
        radius: f32,
        step: impl Fn(isize, isize, isize) -> (isize, isize),
    ) -> Self {
        if radius < 0.1 {
            return self.clone();
        }
        if radius > WIDEST_KERNEL {
            return self.blurred_widely(radius, step);
        }
        let reach = (3.0 * radius).ceil() as isize;
        let kernel: Vec<f32> =
            (-reach..=reach).map(|d| (-0.5 * (d as f32 / radius).powi(2)).exp()).collect();
        let total: f32 = kernel.iter().sum();
        let mut values = Vec::with_capacity(self.values.len());
        for y in 0..self.rows as isize {
            for x in 0..self.columns as isize {
                let weighted = (-reach..=reach).zip(&kernel).map(|(d, weight)| {
                    let (column, row) = step(x, y, d);
                    weight * self.texel(column, row)
                });
                values.push(weighted.sum::<f32>() / total);
            }
        }
        Self { values, ..*self }
    }

    /// Three running means, which come near a Gaussian and cost the same for any radius.
    fn blurred_widely(
        &self,
        radius: f32,
        step: impl Fn(isize, isize, isize) -> (isize, isize),
    ) -> Self {
        let (columns, rows) = (self.columns as isize, self.rows as isize);
        // A mean over 2 r + 1 texels has the variance r (r + 1) / 3; beyond the image nothing is new.
        let reach = ((radius * radius + 0.25).sqrt() - 0.5).round() as isize;
        let reach = reach.min(columns.max(rows));
        let down = step(0, 0, 1) == (0, 1);
        let (lines, length) = if down { (columns, rows) } else { (rows, columns) };
        let mut blurred = self.clone();
        let mut line = vec![0.0; length as usize];
        for _ in 0..3 {
            for i in 0..lines {
                let place = |along: isize| if down { (i, along) } else { (along, i) };
                let texel = |along: isize| {
                    let (column, row) = place(along);
                    f64::from(blurred.texel(column, row))
                };
                let mut sum: f64 = (-reach..=reach).map(texel).sum();
                for (along, mean) in (0..).zip(&mut line) {
                    *mean = (sum / (2 * reach + 1) as f64) as f32;
                    sum += texel(along + reach + 1) - texel(along - reach);
                }
                for (along, &mean) in (0..).zip(&line) {
                    let (column, row) = place(along);
                    if let Some(value) = blurred.values.get_mut((row * columns + column) as usize) {
                        *value = mean;
                    }
                }
            }
        }
        blurred
    }
}

/// Largest radius that is blurred by a kernel, texels.
const WIDEST_KERNEL: f32 = 24.0;

fn spline_weights(t: f32) -> [f32; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [
        (1.0 - 3.0 * t + 3.0 * t2 - t3) / 6.0,
        (4.0 - 6.0 * t2 + 3.0 * t3) / 6.0,
        (1.0 + 3.0 * t + 3.0 * t2 - 3.0 * t3) / 6.0,
        t3 / 6.0,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ramp() -> Heights {
        let values = (0..20).map(|i| (i % 5) as f32 / 4.0).collect();
        Heights { columns: 5, rows: 4, values }
    }

    #[test]
    fn a_ramp_stays_a_ramp_inside() {
        for u in [0.3, 0.5, 0.62] {
            assert!((ramp().sample(u, 0.4) - u).abs() < 1e-5);
        }
    }

    #[test]
    fn a_level_map_stays_level_when_blurred_and_sampled() {
        let level = Heights { columns: 3, rows: 3, values: vec![0.25; 9] }.blurred(2.0, 5.0);
        for (u, v) in [(0.0, 0.0), (1.0, 1.0), (0.31, 0.77)] {
            assert!((level.sample(u, v) - 0.25).abs() < 1e-6);
        }
    }

    #[test]
    fn a_wide_blur_is_near_a_gaussian_and_ends() {
        let mut peak = Heights { columns: 401, rows: 3, values: vec![0.0; 3 * 401] };
        (0..3).for_each(|row| peak.values[row * 401 + 200] = 1.0);
        let blurred = peak.blurred(30.0, 0.0);
        for away in [0, 15, 30, 60] {
            let gaussian = (-0.5 * (away as f32 / 30.0).powi(2)).exp() / (30.0 * 2.5066);
            let value = blurred.values[401 + 200 + away];
            assert!((value - gaussian).abs() < 0.0012, "{away}: {value} against {gaussian}");
        }
        let flat = peak.blurred(1e9, 1e9);
        assert!(flat.values.iter().all(|v| (0.0..0.01).contains(v)));
    }

    #[test]
    fn blur_flattens_and_keeps_the_mean() {
        let mut peak = Heights { columns: 41, rows: 41, values: vec![0.0; 41 * 41] };
        peak.values[20 * 41 + 20] = 1.0;
        let blurred = peak.blurred(2.0, 2.0);
        assert!((blurred.values.iter().sum::<f32>() - 1.0).abs() < 1e-3);
        assert!(blurred.values.iter().all(|&v| v < 0.05));
    }
}
