//! What thins the density: a map, the slope, the height, and what stands in the grass.

use super::obstacles::Obstacles;
use super::surface::{Spot, Surface};
use crate::{DensityMap, Error, FieldDesc};
use glam::{Vec2, Vec4};

/// Decides which roots stay.
#[derive(Debug)]
pub(crate) struct Mask<'a> {
    surface: &'a Surface,
    map: Option<&'a DensityMap>,
    /// Least y of the normal.
    least_up: f32,
    heights_m: (f32, f32),
    obstacles: Obstacles<'a>,
}

impl<'a> Mask<'a> {
    /// # Errors
    /// Where the map needs data that the mesh lacks.
    pub(crate) fn new(surface: &'a Surface, desc: &'a FieldDesc) -> Result<Self, Error> {
        let mesh = surface.mesh();
        let lacks = match desc.density_map {
            Some(DensityMap::Texture { .. }) if mesh.uvs.is_empty() => "texture coordinates",
            Some(DensityMap::VertexColor) if mesh.colors.is_empty() => "vertex colours",
            _ => "",
        };
        if !lacks.is_empty() {
            let cause = format!("the mesh has no {lacks}; add them, or leave the map out");
            return Err(Error::setting("density_map", cause));
        }
        let least_up = if desc.max_slope_deg >= 180.0 {
            f32::NEG_INFINITY
        } else {
            // The tolerance keeps level ground at a limit of 0.
            desc.max_slope_deg.to_radians().cos() - 1e-6
        };
        let map = desc.density_map.as_ref();
        let obstacles = Obstacles::new(&desc.obstacles);
        Ok(Self { surface, map, least_up, heights_m: desc.height_limits_m, obstacles })
    }

    /// Whether a root stays; `chance` is uniform in 0..1.
    pub(crate) fn keeps(&self, spot: &Spot, chance: f32) -> bool {
        spot.normal.y >= self.least_up
            && spot.position.y >= self.heights_m.0
            && spot.position.y <= self.heights_m.1
            && chance < self.density(spot)
            && !self.obstacles.contain(spot.position)
    }

    fn density(&self, spot: &Spot) -> f32 {
        let mesh = self.surface.mesh();
        match self.map {
            None => 1.0,
            Some(DensityMap::VertexColor) => {
                let color: Vec4 =
                    self.surface.interpolate(spot.triangle, spot.weights, &mesh.colors);
                color.x
            }
            Some(DensityMap::Texture { width, height, values }) => {
                let uv: Vec2 = self.surface.interpolate(spot.triangle, spot.weights, &mesh.uvs);
                bilinear(*width, *height, values, uv)
            }
        }
    }
}

/// Samples a map, wrapping; texel (0, 0) is centred at half a texel.
fn bilinear(width: u32, height: u32, values: &[f32], uv: Vec2) -> f32 {
    let size = Vec2::new(width as f32, height as f32);
    // Rounding can make the fraction 1; the wrap below takes that as 0.
    let at = (uv - uv.floor()) * size - 0.5;
    let base = at.floor();
    let t = at - base;
    let texel = |dx: i64, dy: i64| {
        let x = (base.x as i64 + dx).rem_euclid(i64::from(width));
        let y = (base.y as i64 + dy).rem_euclid(i64::from(height));
        values[(y * i64::from(width) + x) as usize]
    };
    let row = |dy| texel(0, dy) * (1.0 - t.x) + texel(1, dy) * t.x;
    row(0) * (1.0 - t.y) + row(1) * t.y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_wrap_and_blend() {
        let values = [0.0, 1.0, 0.5, 0.25];
        let at = |u, v| bilinear(2, 2, &values, Vec2::new(u, v));
        assert_eq!(at(0.25, 0.25), 0.0);
        assert_eq!(at(0.75, 0.25), 1.0);
        assert_eq!(at(0.25, 0.75), 0.5);
        assert_eq!(at(-0.25, 1.25), 1.0);
        assert_eq!(at(0.5, 0.25), 0.5);
        assert_eq!(at(0.0, 0.25), 0.5, "wraps between the last and the first texel");
    }
}
