//! Blades that take the colour of what they grow on.

use crate::Error;
use crate::grow::surface::Mesh;

/// An image of reflectances.
#[derive(Debug, Clone, PartialEq)]
pub struct ColorImage {
    /// Width, texels, 1 or more.
    pub width: u32,
    /// Height, texels, 1 or more.
    pub height: u32,
    /// Row-major linear RGB, 0..=1; row 0 is v = 0.
    pub texels: Vec<[f32; 3]>,
}

/// Where a field's blades take their colours from: fur that shows its model's own texture. Each
/// blade takes one colour, that of the surface at its root, when it grows; so it costs 4 bytes a
/// blade, and nothing where there is no map. J colours its fur so.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ColorMap {
    /// Sampled through the mesh's UVs, wrapping, bilinear.
    Texture(ColorImage),
    /// The mesh's vertex colours.
    VertexColor,
    /// A mesh of several materials: each triangle takes the image of its first vertex, sampled as
    /// [`ColorMap::Texture`], times the mesh's vertex colours where it has some.
    Materials {
        /// One image a material; a plain colour is an image of one texel, and needs no UVs.
        images: Vec<ColorImage>,
        /// Index of each vertex's image.
        of_vertex: Vec<u32>,
    },
}

fn bad(cause: String) -> Error {
    Error::setting("color_map", cause)
}

impl ColorImage {
    /// Whether it is one colour.
    pub(crate) fn is_plain(&self) -> bool {
        self.texels.len() == 1
    }

    fn check(&self) -> Result<(), Error> {
        let texels = u64::from(self.width) * u64::from(self.height);
        if texels == 0 || texels != self.texels.len() as u64 {
            let Self { width, height, .. } = self;
            return Err(bad(format!("{width} x {height} texels, but {}", self.texels.len())));
        }
        let within = |c: &[f32; 3]| c.iter().all(|x| (0.0..=1.0).contains(x));
        match self.texels.iter().position(|texel| !within(texel)) {
            None => Ok(()),
            Some(i) => Err(bad(format!("texel {i} is {:?}; use 0 to 1", self.texels[i]))),
        }
    }
}

impl ColorMap {
    /// Checks the values.
    pub(crate) fn check(&self) -> Result<(), Error> {
        match self {
            Self::Texture(image) => image.check(),
            Self::VertexColor => Ok(()),
            Self::Materials { images, of_vertex } => {
                images.iter().try_for_each(ColorImage::check)?;
                match of_vertex.iter().find(|&&m| m as usize >= images.len()) {
                    None => Ok(()),
                    Some(m) => Err(bad(format!("image {m} of {}, counted from 0", images.len()))),
                }
            }
        }
    }

    /// Checks that a mesh has what the map needs.
    pub(crate) fn check_mesh(&self, mesh: &Mesh) -> Result<(), Error> {
        let lacks = |what: &str| {
            Err(bad(format!("the mesh has no {what}; add them, or leave the map out")))
        };
        match self {
            Self::Texture(image) if mesh.uvs.is_empty() && !image.is_plain() => {
                lacks("texture coordinates")
            }
            Self::VertexColor if mesh.colors.is_empty() => lacks("vertex colours"),
            Self::Materials { images, .. }
                if mesh.uvs.is_empty() && !images.iter().all(ColorImage::is_plain) =>
            {
                lacks("texture coordinates")
            }
            Self::Materials { of_vertex, .. } if of_vertex.len() != mesh.positions.len() => {
                let (given, all) = (of_vertex.len(), mesh.positions.len());
                Err(bad(format!("{given} vertices have an image, of {all}; give each one")))
            }
            _ => Ok(()),
        }
    }
}
