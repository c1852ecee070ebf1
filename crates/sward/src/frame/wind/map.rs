//! Maps of wind: a tile of winds that repeats over the ground and drifts with the wind.

use crate::Error;
use crate::shared::noise_twin::{hash_u32, smoothstep};
use glam::{DVec2, dvec2};

/// A tile of winds, for [`crate::WindTexture`]: it repeats, so its left edge should go on from its
/// right one and its top from its bottom.
#[derive(Clone, PartialEq)]
pub struct WindMap {
    width: u32,
    height: u32,
    /// Row by row: along the source's direction, and across it.
    winds: Vec<[f32; 2]>,
}

impl WindMap {
    /// Longest side, texels.
    pub const MAX_SIDE: u32 = 2048;

    /// A map of `width` x `height` winds, row by row: each along the source's direction and across it
    /// (to the right of it, seen from above), -1..=1, times the source's strength. Columns run along the
    /// direction, rows across it.
    ///
    /// # Errors
    /// [`Error::Setting`] where a side is 0 or above [`WindMap::MAX_SIDE`], where the count of winds is
    /// another, or where one is out of its range.
    pub fn new(width: u32, height: u32, winds: Vec<[f32; 2]>) -> Result<Self, Error> {
        let sides = 1..=Self::MAX_SIDE;
        if !sides.contains(&width) || !sides.contains(&height) {
            let cause = format!("{width} x {height} texels; sides must be 1 to {}", Self::MAX_SIDE);
            return Err(Error::setting("wind_map", cause));
        }
        if winds.len() as u64 != u64::from(width) * u64::from(height) {
            let cause = format!("{width} x {height} texels, but {} winds", winds.len());
            return Err(Error::setting("wind_map", cause));
        }
        let bad = |wind: &[f32; 2]| wind.iter().any(|part| !(-1.0..=1.0).contains(part));
        if let Some(at) = winds.iter().position(bad) {
            let cause = format!("wind {at} is {:?}; use -1 to 1", winds[at]);
            return Err(Error::setting("wind_map", cause));
        }
        Ok(Self { width, height, winds })
    }

    /// A map of noise, 256 x 256: gusts of several sizes that veer, `gusts` (1..=64) of the largest along
    /// each side. Same seed, same map.
    pub fn noise(gusts: u32, seed: u32) -> Self {
        const SIDE: u32 = 256;
        let cells = gusts.clamp(1, 64);
        let winds = (0..SIDE * SIDE).map(|i| {
            let at = dvec2(f64::from(i % SIDE), f64::from(i / SIDE)) / f64::from(SIDE);
            let octave = |octave: u32, salt: u32| {
                let cells = cells << octave;
                tile_noise(at * f64::from(cells), cells, seed.wrapping_add(salt + octave))
            };
            let gust = octave(0, 0) + 0.5 * octave(1, 0) + 0.3 * octave(2, 0);
            let veer = octave(0, 16) + 0.5 * octave(1, 16);
            let strength = smoothstep(-0.4, 0.7, gust);
            [strength, (strength * veer).clamp(-1.0, 1.0)].map(|part| part as f32)
        });
        Self { width: SIDE, height: SIDE, winds: winds.collect() }
    }

    /// Width, texels: along the wind.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height, texels: across the wind.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The winds, row by row.
    pub fn winds(&self) -> &[[f32; 2]] {
        &self.winds
    }

    /// The wind at a place in texels, straight between their middles, repeating.
    pub(super) fn at(&self, place: DVec2) -> DVec2 {
        let base = (place - 0.5).floor();
        let t = place - 0.5 - base;
        let texel = |x: i64, y: i64| {
            let column = (base.x as i64 + x).rem_euclid(i64::from(self.width)) as usize;
            let row = (base.y as i64 + y).rem_euclid(i64::from(self.height)) as usize;
            let [along, across] = self.winds[row * self.width as usize + column];
            dvec2(f64::from(along), f64::from(across))
        };
        let near = texel(0, 0).lerp(texel(1, 0), t.x);
        near.lerp(texel(0, 1).lerp(texel(1, 1), t.x), t.y)
    }
}

/// Sizes and a number that stands for the winds, of which there are too many to print.
impl std::fmt::Debug for WindMap {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let print = crate::gpu::fingerprint::of(bytemuck::cast_slice(&self.winds));
        write!(f, "WindMap({} x {}, {print:016x})", self.width, self.height)
    }
}

/// Gradient noise, about -1..=1, that repeats after `period` cells.
fn tile_noise(at: DVec2, period: u32, seed: u32) -> f64 {
    let base = at.floor();
    let f = at - base;
    let corner = |x: u32, y: u32| {
        let cell = [(base.x as u32 + x) % period, (base.y as u32 + y) % period];
        let bits = hash_u32(cell[0].wrapping_add(hash_u32(cell[1].wrapping_add(hash_u32(seed)))));
        let angle = f64::from(bits) / f64::from(u32::MAX) * std::f64::consts::TAU;
        1.4 * DVec2::from_angle(angle).dot(f - dvec2(f64::from(x), f64::from(y)))
    };
    let fade = |t: f64| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
    let near = mix(corner(0, 0), corner(1, 0), fade(f.x));
    mix(near, mix(corner(0, 1), corner(1, 1), fade(f.x)), fade(f.y))
}
