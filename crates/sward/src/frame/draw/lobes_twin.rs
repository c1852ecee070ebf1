//! lobes.wgsl on the CPU: what is baked, and the reference of tests.

const STALK: f64 = 0.1;
const LOBE_WAVES: f64 = 4.8;
const LOBE_SKEW: f64 = 0.8;
const LOBE_NOTCH: f64 = 0.25;
#[cfg(test)]
const LOBE_SLANT: f64 = 0.08;

/// Lobes of the outline, from the stalk to the tip.
#[cfg(test)]
pub(crate) const LOBES: usize = 5;

/// Share of the width at a share of the length, before the lobes hang back.
pub(crate) fn leaf_width(along: f64) -> f64 {
    use std::f64::consts::{FRAC_PI_2, TAU};
    let t = ((along - STALK) / (1.0 - STALK)).clamp(0.0, 1.0);
    let phase = TAU * LOBE_WAVES * t;
    let wave = 0.5 - 0.5 * (phase + LOBE_SKEW * phase.sin()).cos();
    let grown = (FRAC_PI_2 * (1.25 * t).min(1.0)).sin();
    let lobed = STALK + (1.0 - STALK) * grown * (LOBE_NOTCH + (1.0 - LOBE_NOTCH) * wave);
    let end = ((along - 0.9) / 0.1).clamp(0.0, 1.0);
    lobed * (1.0 - end * end).sqrt()
}

/// How far inside the outline a point is, in half widths: at a share of the length, and so far from
/// the middle line in half widths.
#[cfg(test)]
pub(crate) fn leaf_inside(along: f64, side: f64) -> f64 {
    let slant = LOBE_SLANT * side * (8.0 * (1.0 - along)).clamp(0.0, 1.0);
    leaf_width(along + slant) - side
}

/// Local maxima of a silhouette's widths, root to tip: a maximum counts where the width falls by
/// `least` on both sides of it before it is passed.
#[cfg(test)]
pub(crate) fn maxima(widths: &[f64], least: f64) -> usize {
    let (mut count, mut high, mut low) = (0, f64::NEG_INFINITY, f64::INFINITY);
    let mut rising = true;
    for &width in widths.iter().chain(&[0.0]) {
        high = high.max(width);
        low = low.min(width);
        if rising && width < high - least {
            (count, rising, low) = (count + 1, false, width);
        } else if !rising && width > low + least {
            (rising, high) = (true, width);
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Width of the outline at a share of the length, of the full width.
    fn width(along: f64) -> f64 {
        let steps = 2000;
        let inside = |i: &u32| leaf_inside(along, (f64::from(*i) + 0.5) / f64::from(steps)) > 0.0;
        (0..steps).filter(inside).count() as f64 / f64::from(steps)
    }

    #[test]
    fn the_outline_has_a_stalk_lobes_and_a_blunt_end() {
        let widths: Vec<_> = (0..=500).map(|i| width(f64::from(i) / 500.0)).collect();
        assert_eq!(maxima(&widths, 0.05), LOBES);
        let widest = widths.iter().copied().fold(0.0, f64::max);
        assert!((0.9..=1.0).contains(&widest), "{widest}");
        assert!(widths.iter().all(|w| (0.0..=1.0).contains(w)));
        assert!(widths[..40].iter().all(|w| *w <= STALK + 1e-3), "the stalk is narrow");
        assert!(widths[495] > 0.25 && widths[500] < 1e-3, "the end is blunt: {}", widths[495]);
        let area = widths.iter().sum::<f64>() / 501.0;
        assert!((0.4..0.6).contains(&area), "{area}");
    }

    /// Outside the middle a lobe begins nearer to the root than it does inside.
    #[test]
    fn lobes_hang_back_towards_the_root() {
        let starts = |side: f64| {
            let inside = |i: u32| leaf_inside(f64::from(i) / 4000.0, side) > 0.0;
            (1..4000).filter(|&i| inside(i) && !inside(i - 1)).rev().collect::<Vec<_>>()
        };
        // From the tip: the lobes that are wide enough for both
        let (out, amid) = (starts(0.9), starts(0.4));
        assert!(out.len() >= 2 && amid.len() >= 2, "{out:?} {amid:?}");
        assert!(out.iter().zip(&amid).take(2).all(|(out, amid)| out < amid), "{out:?} {amid:?}");
    }
}
