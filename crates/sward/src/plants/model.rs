//! What a model is made of: ribbons along quadratic curves.

use glam::Vec3;

/// Most ribbons of a model.
pub(crate) const MAX_RIBBONS: usize = 64;

/// How the width runs from the root (0) to the tip (1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Outline {
    /// Nearly even.
    Stem,
    /// Even, then a long point.
    Blade,
    /// Widest in the middle, pointed at both ends.
    Leaf,
    /// Narrow at the root, round at the tip.
    Petal,
    /// An ellipse.
    Disc,
    /// Narrow at the root, broad and blunt at the tip.
    Fan,
    /// Teeth on both sides, and a point.
    Toothed,
    /// Broad at both ends, narrow in the middle: two brushes.
    Brushes,
    /// A thread that opens at its end.
    Umbrella,
}

impl Outline {
    /// Share of the full width at `v`.
    pub(crate) fn at(self, v: f32) -> f32 {
        let ellipse =
            |middle: f32, reach: f32| (1.0 - ((v - middle) / reach).powi(2)).max(0.0).sqrt();
        match self {
            Self::Stem => 1.0 - 0.35 * v,
            Self::Blade => (0.7 + 0.6 * v).min(1.0) * (1.0 - v.powi(3)).max(0.0),
            Self::Leaf => {
                (std::f32::consts::PI * v.powf(0.8)).sin().max(0.0).powf(0.8).max(0.1 * (1.0 - v))
            }
            Self::Petal if v < 0.62 => 0.3 + 0.7 * (v / 0.62 * std::f32::consts::FRAC_PI_2).sin(),
            Self::Petal => ellipse(0.62, 0.38),
            Self::Disc => ellipse(0.5, 0.5),
            Self::Fan if v < 0.8 => 0.22 + 0.78 * (v / 0.8).powf(0.8),
            Self::Fan => 0.6 + 0.4 * ellipse(0.8, 0.2),
            Self::Toothed => {
                let tooth = 1.0 - (v * 4.0 + 0.5).fract();
                (1.0 - v.powi(4)) * (0.2 + 0.25 * v + 0.65 * tooth * (0.3 + 0.7 * v))
            }
            Self::Brushes => 0.1 + 0.9 * (2.0 * v - 1.0).abs(),
            Self::Umbrella => 0.06 + 0.94 * ((v - 0.75) / 0.25).max(0.0),
        }
    }
}

/// A strip along a curve. Lengths are in heights of the plant, y is up, the root is at the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ribbon {
    /// The quadratic curve's three points.
    pub(crate) curve: [Vec3; 3],
    /// Across, roughly: made perpendicular to the curve. Not read where it is round.
    pub(crate) side: Vec3,
    /// Full width where it is widest.
    pub(crate) width: f32,
    pub(crate) outline: Outline,
    /// Linear reflectance at the root, the middle and the tip.
    pub(crate) colors: [Vec3; 3],
    /// Stands for something round, such as a stem: it turns its width to whoever looks.
    pub(crate) round: bool,
    /// Share of the light that it keeps from passing through.
    pub(crate) thickness: f32,
}

impl Ribbon {
    /// The curve at `v`.
    pub(crate) fn point(&self, v: f32) -> Vec3 {
        let [a, b, c] = self.curve;
        a.lerp(b, v).lerp(b.lerp(c, v), v)
    }

    /// Unit direction of the curve at `v`.
    pub(crate) fn along(&self, v: f32) -> Vec3 {
        let [a, b, c] = self.curve;
        (b - a).lerp(c - b, v).try_normalize().unwrap_or((c - a).normalize_or(Vec3::Y))
    }

    /// Unit direction across at `v`; `towards` is where the viewer is.
    pub(crate) fn across(&self, v: f32, towards: Vec3) -> Vec3 {
        let along = self.along(v);
        let wish = if self.round { along.cross(towards) } else { self.side };
        let across = (wish - along * along.dot(wish)).try_normalize();
        across.unwrap_or_else(|| along.any_orthonormal_vector())
    }

    /// Full width at `v`.
    pub(crate) fn width_at(&self, v: f32) -> f32 {
        self.width * self.outline.at(v)
    }

    /// Colour at `v`.
    pub(crate) fn color(&self, v: f32) -> Vec3 {
        let [root, middle, tip] = self.colors;
        if v < 0.5 { root.lerp(middle, 2.0 * v) } else { middle.lerp(tip, 2.0 * v - 1.0) }
    }
}

/// One variant of a plant.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Model {
    pub(crate) ribbons: Vec<Ribbon>,
}
