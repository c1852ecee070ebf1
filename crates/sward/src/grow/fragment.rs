//! Fragments: triangles cut into four by their edges' midpoints, again and again.

use super::random::Draws;
use glam::Vec2;

/// A part of a triangle, similar to it: the point at local (b, c) has the barycentric weights
/// `origin + scale * (b, c)` of the triangle's second and third corner. A fragment that is turned
/// round has a negative scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fragment {
    origin: Vec2,
    scale: f32,
}

impl Fragment {
    pub(crate) const WHOLE: Self = Self { origin: Vec2::ZERO, scale: 1.0 };

    /// One of the four parts; neighbours in the numbering touch, but for the last two.
    pub(crate) fn child(self, which: u32) -> Self {
        let half = self.scale * 0.5;
        match which {
            0 => Self { origin: self.origin, scale: half },
            1 => Self { origin: self.origin + half, scale: -half },
            2 => Self { origin: self.origin + Vec2::new(half, 0.0), scale: half },
            _ => Self { origin: self.origin + Vec2::new(0.0, half), scale: half },
        }
    }

    /// The part that holds the share `t` (0..1) of the area, `levels` cuts deep. As equal steps of
    /// `t` sweep equal areas, evenly spaced `t` give evenly spread parts.
    pub(crate) fn at(t: f64, levels: u32) -> Self {
        let digits = (t * (1u64 << (2 * levels)) as f64) as u64;
        (0..levels).rev().fold(Self::WHOLE, |f, level| f.child((digits >> (2 * level)) as u32 & 3))
    }

    /// A uniform point: barycentric weights by the square-root map.
    pub(crate) fn point(self, draws: &mut Draws) -> Vec2 {
        let root = draws.unit().sqrt();
        let along = draws.unit();
        self.origin + self.scale * root * Vec2::new(1.0 - along, along)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grow::random::{Purpose, Stream};

    #[test]
    fn points_are_uniform_at_any_depth() {
        let stream = Stream::new(1, Purpose::Single);
        for levels in [0, 1, 4] {
            // The four children of the whole, told apart by the weights themselves.
            let mut counts = [0u32; 4];
            for i in 0..40_000 {
                let mut draws = stream.at(i);
                let p = Fragment::at(draws.unit_f64(), levels).point(&mut draws);
                assert!(p.x >= 0.0 && p.y >= 0.0 && p.x + p.y <= 1.0 + 1e-6, "{p}");
                let cell = if p.x > 0.5 {
                    0
                } else if p.y > 0.5 {
                    1
                } else if p.x + p.y < 0.5 {
                    2
                } else {
                    3
                };
                counts[cell] += 1;
            }
            assert!(counts.iter().all(|&c| (9700..10_300).contains(&c)), "{levels}: {counts:?}");
        }
    }
}
