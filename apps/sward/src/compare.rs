//! Comparison of pictures by FLIP (Andersson et al. 2020).

use anyhow::{Result, bail};
use image::RgbImage;
use serde::Serialize;

/// Pixels a degree of sight: a 0.7 m wide 4K screen at 0.7 m, as FLIP's authors recommend.
pub const PIXELS_PER_DEGREE: f32 = 67.0;

/// FLIP of two pictures; 0 is no visible difference, 1 the largest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Flip {
    /// Mean over all pixels.
    pub mean: f32,
    /// 99th percentile of the pixels.
    pub p99: f32,
    /// Largest.
    pub max: f32,
}

/// Compares a picture with a reference.
///
/// # Errors
/// Where their sizes differ.
pub fn flip(reference: &RgbImage, test: &RgbImage) -> Result<Flip> {
    Ok(summary(flip_map(reference, test)?))
}

/// The error of each pixel, row by row.
///
/// # Errors
/// Where the sizes differ.
pub fn flip_map(reference: &RgbImage, test: &RgbImage) -> Result<Vec<f32>> {
    if reference.dimensions() != test.dimensions() {
        let ((w0, h0), (w1, h1)) = (reference.dimensions(), test.dimensions());
        bail!("the pictures differ in size: {w0}x{h0} and {w1}x{h1}");
    }
    let (width, height) = reference.dimensions();
    let load = |image: &RgbImage| nv_flip::FlipImageRgb8::with_data(width, height, image.as_raw());
    Ok(nv_flip::flip(load(reference), load(test), PIXELS_PER_DEGREE).to_vec())
}

/// What the errors of some pixels come to; all 0 for none.
pub fn summary(mut errors: Vec<f32>) -> Flip {
    errors.sort_by(f32::total_cmp);
    let mean = errors.iter().map(|&e| f64::from(e)).sum::<f64>() / errors.len().max(1) as f64;
    Flip {
        mean: mean as f32,
        p99: percentile(&errors, 0.99),
        max: errors.last().copied().unwrap_or(0.0),
    }
}

/// The value at a share (0..=1) of an ascending list; 0 for an empty one.
pub fn percentile(sorted: &[f32], share: f64) -> f32 {
    let last = sorted.len().saturating_sub(1);
    sorted.get((last as f64 * share).round() as usize).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_pictures_differ_by_nothing_and_others_by_something() {
        let gray = RgbImage::from_pixel(32, 32, image::Rgb([90, 90, 90]));
        assert_eq!(flip(&gray, &gray).unwrap(), Flip { mean: 0.0, p99: 0.0, max: 0.0 });
        let mut other = gray.clone();
        other.put_pixel(5, 5, image::Rgb([255, 0, 0]));
        let result = flip(&gray, &other).unwrap();
        assert!(result.max > 0.3 && result.mean < 0.05, "{result:?}");
        assert!(flip(&gray, &RgbImage::new(32, 31)).is_err());
    }

    #[test]
    fn percentile_takes_the_nearest_rank() {
        let values: Vec<f32> = (0..=100).map(|i| i as f32).collect();
        assert_eq!(percentile(&values, 0.99), 99.0);
        assert_eq!(percentile(&values, 0.5), 50.0);
        assert_eq!(percentile(&[], 0.5), 0.0);
    }
}
