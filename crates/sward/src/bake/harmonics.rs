//! How much light all that shows of a canopy sends to the eye, for a sun anywhere: spherical
//! harmonics to the fourth degree, which are sums and can be mixed.
//!
//! What a surface of normal n reflects goes with the positive part of n.l, what passes through it with
//! that of -n.l, and what it mirrors with the twelfth power of n.h (see light.wgsl). Summed over all that
//! shows, each is a function on the sphere that changes slowly.

use super::cover::Shown;
use crate::gpu::layout::GpuLook;
use crate::shared::noise_twin::smoothstep;
use glam::{Vec3, Vec4};

/// Functions that do not change where x changes its sign; the first 9 of even degree.
pub(crate) const EVEN: usize = 15;
/// Those that change their sign with it; the first 6 of even degree.
pub(crate) const ODD: usize = 10;

/// Share of the sky that the canopy lets through to a height in it: the twin of `canopy_open` in
/// light.wgsl.
pub(crate) fn canopy_open(height_share: f32, root_open: f32) -> f32 {
    let t = height_share.clamp(0.0, 1.0);
    root_open + (1.0 - root_open) * (t * (1.6 - 0.6 * t))
}

/// How much darker a place is for its depth in the canopy: between the sun's light, which goes by
/// the square of what is open, and the sky's, which goes by itself.
pub(crate) fn depth_shade(height_share: f32, root_open: f32) -> f32 {
    canopy_open(height_share, root_open).powf(1.6)
}

/// The functions without their factors, as canopy.wgsl has them: those even in x, then those odd.
pub(crate) fn basis(d: Vec3) -> [f32; EVEN + ODD] {
    let Vec3 { x, y, z } = d;
    let (x2, y2, z2) = (x * x, y * y, z * z);
    [
        1.0,
        y * z,
        3.0 * z2 - 1.0,
        x2 - y2,
        y * z * (3.0 * x2 - y2),
        y * z * (7.0 * z2 - 3.0),
        35.0 * z2 * z2 - 30.0 * z2 + 3.0,
        (x2 - y2) * (7.0 * z2 - 1.0),
        x2 * x2 - 6.0 * x2 * y2 + y2 * y2,
        y,
        z,
        y * (3.0 * x2 - y2),
        y * (5.0 * z2 - 1.0),
        z * (5.0 * z2 - 3.0),
        z * (x2 - y2),
        x * y,
        x * z,
        x * y * (x2 - y2),
        x * y * (7.0 * z2 - 1.0),
        x * z * (7.0 * z2 - 3.0),
        x * z * (x2 - 3.0 * y2),
        x,
        x * y * z,
        x * (5.0 * z2 - 1.0),
        x * (x2 - 3.0 * y2),
    ]
}

/// Degree of each, and the square of what makes it one of an orthonormal base, times pi.
const FACTORS: [(usize, f32); EVEN + ODD] = [
    (0, 1.0 / 4.0),
    (2, 15.0 / 4.0),
    (2, 5.0 / 16.0),
    (2, 15.0 / 16.0),
    (4, 315.0 / 32.0),
    (4, 45.0 / 32.0),
    (4, 9.0 / 256.0),
    (4, 45.0 / 64.0),
    (4, 315.0 / 256.0),
    (1, 3.0 / 4.0),
    (1, 3.0 / 4.0),
    (3, 35.0 / 32.0),
    (3, 21.0 / 32.0),
    (3, 7.0 / 16.0),
    (3, 105.0 / 16.0),
    (2, 15.0 / 4.0),
    (2, 15.0 / 4.0),
    (4, 315.0 / 16.0),
    (4, 45.0 / 16.0),
    (4, 45.0 / 32.0),
    (4, 315.0 / 32.0),
    (1, 3.0 / 4.0),
    (3, 105.0 / 4.0),
    (3, 21.0 / 32.0),
    (3, 35.0 / 32.0),
];

/// By degree, over 2 pi: integral over the sphere of a lobe times the Legendre polynomial. The positive part of
/// the cosine, and its twelfth power.
const COSINE: [f32; 5] = [1.0 / 2.0, 1.0 / 3.0, 1.0 / 8.0, 0.0, -1.0 / 48.0];
const GLOSS: [f32; 5] = [1.0 / 13.0, 1.0 / 14.0, 4.0 / 65.0, 11.0 / 224.0, 8.0 / 221.0];

/// What shows, summed up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Look {
    /// Places.
    pub count: f32,
    /// Of what reaches the eye of the sun's light: rgb by the cosine, w mirrored.
    pub waves: [Vec4; EVEN + ODD],
    /// Albedo in the sky's light.
    pub around: Vec3,
    /// The same, times how far the normal points up.
    pub tilt: Vec3,
    /// How much of the sky is mirrored by what lies flat.
    pub sheen: f32,
    /// Albedo in the canopy's shade, see `depth_shade`.
    pub tone: Vec3,
    /// Height share.
    pub height: f32,
}

impl Default for Look {
    fn default() -> Self {
        Self {
            count: 0.0,
            waves: [Vec4::ZERO; EVEN + ODD],
            around: Vec3::ZERO,
            tilt: Vec3::ZERO,
            sheen: 0.0,
            tone: Vec3::ZERO,
            height: 0.0,
        }
    }
}

impl Look {
    /// Of all that shows, in the shade of a canopy.
    pub(crate) fn of(shown: &[Shown], root_open: f32) -> Self {
        let mut look = Self::default();
        for place in shown {
            look.add(place, root_open);
        }
        look
    }

    /// The twin of what `shade_blade` does.
    fn add(&mut self, place: &Shown, root_open: f32) {
        let over = smoothstep(0.15, 0.75, f64::from(place.lean)) as f32;
        let share = place.height_share + (1.0 - place.height_share) * 0.7 * over;
        let open = canopy_open(share, root_open);
        let sunlit = (place.albedo * (open * open)).extend(open * open);
        for (wave, value) in self.waves.iter_mut().zip(basis(place.normal)) {
            *wave += sunlit * value;
        }
        self.count += 1.0;
        self.around += place.albedo * open;
        self.tilt += place.albedo * (open * place.normal.y);
        self.sheen += over * open;
        self.tone += place.albedo * depth_shade(place.height_share, root_open);
        self.height += place.height_share;
    }

    /// The mean of what shows, with the factors of the functions and the lobes; `open` is the share of the
    /// ground that shows. And the functions that are odd in x.
    pub(crate) fn mean(&self, open: f32) -> (GpuLook, [[f32; 4]; ODD]) {
        let each = 1.0 / self.count.max(1e-9);
        let wave = |i: usize| {
            let (degree, square) = FACTORS[i];
            let lobes = Vec3::splat(COSINE[degree]).extend(GLOSS[degree]);
            (self.waves[i] * lobes * (2.0 * square * each)).to_array()
        };
        let look = GpuLook {
            waves: std::array::from_fn(wave),
            around: (self.around * each).extend(open).to_array(),
            tilt: (self.tilt * each).extend(self.sheen * each).to_array(),
        };
        (look, std::array::from_fn(|i| wave(EVEN + i)))
    }
}
