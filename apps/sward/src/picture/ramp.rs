//! Colours for numbers: a ramp whose lightness rises evenly, so that equal steps look equal, also
//! in grey and to the colour-blind. Ours, made in OKLCh (Björn Ottosson, 2020).

use super::Color;

/// Colour of a value in 0..=1: from a deep violet over blue and green to a light yellow. Values
/// outside are taken as the nearer end, and what is no number as 0.
pub fn ramp(value: f32) -> Color {
    let t = if value.is_nan() { 0.0 } else { value.clamp(0.0, 1.0) };
    // Hue turns one way, evenly enough that its steps add to those of the lightness.
    let hue_deg = 305.0 - 200.0 * t;
    let chroma = 0.105 + 0.06 * t;
    oklch(0.22 + 0.71 * t, chroma, hue_deg)
}

/// sRGB of lightness 0..=1, chroma (0 grey, 0.15 strong) and hue (degrees: 30 red, 110 yellow, 140
/// green, 260 blue). What no screen can show is brought in by lowering the chroma.
pub fn oklch(lightness: f32, chroma: f32, hue_deg: f32) -> Color {
    let (sin, cos) = hue_deg.to_radians().sin_cos();
    let mut chroma = chroma.max(0.0);
    loop {
        let linear = linear_srgb([lightness, chroma * cos, chroma * sin]);
        let shown = linear.iter().all(|c| (-1e-4..=1.0001).contains(c));
        if shown || chroma < 1e-3 {
            return linear.map(encode);
        }
        chroma *= 0.97;
    }
}

fn linear_srgb([l, a, b]: [f32; 3]) -> [f32; 3] {
    let cubed = [
        l + 0.396_337_78 * a + 0.215_803_76 * b,
        l - 0.105_561_346 * a - 0.063_854_17 * b,
        l - 0.089_484_18 * a - 1.291_485_5 * b,
    ]
    .map(|c| c * c * c);
    let row = |m: [f32; 3]| m[0] * cubed[0] + m[1] * cubed[1] + m[2] * cubed[2];
    [
        row([4.076_741_7, -3.307_711_6, 0.230_969_94]),
        row([-1.268_438, 2.609_757_4, -0.341_319_4]),
        row([-0.004_196_086_3, -0.703_418_6, 1.707_614_7]),
    ]
}

fn encode(linear: f32) -> u8 {
    let c = linear.clamp(0.0, 1.0);
    let encoded = if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 };
    (encoded * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance as lightness (CIE L*).
    fn lightness(color: Color) -> f32 {
        let linear = color.map(|c| {
            let c = f32::from(c) / 255.0;
            if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        });
        let y = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
        116.0 * y.cbrt() - 16.0
    }

    #[test]
    fn equal_steps_are_equally_lighter() {
        let steps: Vec<f32> = (0..=20).map(|i| lightness(ramp(i as f32 / 20.0))).collect();
        let rises: Vec<f32> = steps.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(rises.iter().all(|rise| (2.0..6.5).contains(rise)), "{rises:?}");
        assert!(steps[0] < 22.0 && steps[20] > 88.0, "{steps:?}");
    }

    #[test]
    fn anything_is_a_color() {
        assert_eq!(ramp(f32::NAN), ramp(0.0));
        assert_eq!(ramp(-3.0), ramp(0.0));
        assert_eq!(ramp(f32::INFINITY), ramp(1.0));
        assert_eq!(oklch(1.0, 0.0, 0.0), [255; 3]);
        assert_eq!(oklch(0.0, 9.0, 77.0), [0; 3]);
        let [r, g, b] = oklch(0.63, 0.25, 29.0);
        assert!(r > 240 && g < 40 && b < 40, "{r} {g} {b}");
    }
}
