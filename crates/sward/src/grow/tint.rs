//! The colour of a surface at a blade's root.

use super::surface::{Spot, Surface};
use super::texels::bilinear;
use crate::gpu::quantize::pack_color;
use crate::{ColorImage, ColorMap, Error, FieldDesc};
use glam::{Vec2, Vec3, Vec4};

/// Looks colours up, where the field has a colour map.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tint<'a> {
    surface: &'a Surface,
    map: Option<&'a ColorMap>,
}

impl<'a> Tint<'a> {
    /// # Errors
    /// Where the map needs data that the mesh lacks.
    pub(crate) fn new(surface: &'a Surface, desc: &'a FieldDesc) -> Result<Self, Error> {
        let map = desc.color_map.as_ref();
        map.map_or(Ok(()), |map| map.check_mesh(surface.mesh()))?;
        Ok(Self { surface, map })
    }

    /// The colour at a place, packed; 0 without a map.
    pub(crate) fn at(&self, spot: &Spot) -> u32 {
        let color = match self.map {
            None => return 0,
            Some(ColorMap::VertexColor) => self.vertex_color(spot),
            Some(ColorMap::Texture(image)) => self.texel(spot, image),
            Some(ColorMap::Materials { images, of_vertex }) => {
                let first = self.surface.mesh().triangles[spot.triangle as usize][0];
                let image = &images[of_vertex[first as usize] as usize];
                self.texel(spot, image) * self.vertex_color(spot)
            }
        };
        pack_color(color.to_array())
    }

    /// White where the mesh has none.
    fn vertex_color(&self, spot: &Spot) -> Vec3 {
        let colors = &self.surface.mesh().colors;
        if colors.is_empty() {
            return Vec3::ONE;
        }
        let color: Vec4 = self.surface.interpolate(spot.triangle, spot.weights, colors);
        color.truncate()
    }

    fn texel(&self, spot: &Spot, image: &ColorImage) -> Vec3 {
        if image.is_plain() {
            return image.texels[0].into();
        }
        let uvs = &self.surface.mesh().uvs;
        let uv: Vec2 = self.surface.interpolate(spot.triangle, spot.weights, uvs);
        bilinear(image.width, image.height, uv, |i| Vec3::from(image.texels[i]))
    }
}
