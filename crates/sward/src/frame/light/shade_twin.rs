//! The reference of shade.wgsl.

use crate::shared::noise_twin::{noise2, smoothstep};
use glam::{DVec2, DVec3};

/// Share of the sun kept away: `pattern` is depth, cells a metre, height.
pub(crate) fn shade_pattern(place: DVec3, to_sun: DVec3, pattern: [f64; 3], offset: DVec2) -> f64 {
    let [depth, frequency, height] = pattern;
    let along = (height - place.y) / to_sun.y.max(0.1);
    let level = |v: DVec3| DVec2::new(v.x, v.z);
    let cell = (level(place) + level(to_sun) * along) * frequency - offset;
    let sum = noise2(cell, 71) + 0.5 * noise2(cell * 2.0, 72) + 0.25 * noise2(cell * 4.0, 73);
    depth * smoothstep(-0.2, 0.3, sum)
}
