//! What thins the density: a map, the slope, the height, and what stands in the grass.

use super::obstacles::Obstacles;
use super::surface::{Spot, Surface};
use super::texels::bilinear;
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
                bilinear(*width, *height, uv, |i| values[i])
            }
        }
    }
}
