//! Objects: the opaque things of a scene.

mod collide;
pub(crate) mod generate;
pub(crate) mod ground;
mod place;
pub(crate) mod random;
mod shapes;

pub use collide::ColliderPiece;
pub(crate) use collide::MOST_SHAPES;
pub(crate) use place::{Placed, find};

use crate::TextureImage;

/// An opaque thing: it hides blades, may carry grass, and is drawn when visible.
#[derive(Debug, Clone)]
pub struct Object {
    /// Its name, for messages.
    pub name: String,
    /// Its mesh in world space, transforms applied; normals, UVs and colours where there are any.
    pub mesh: sward::Mesh,
    /// Linear RGB reflectance; the mesh's vertex colours and the texture multiply it.
    pub base_color: [f32; 3],
    /// Roughness, 0 (mirror) to 1 (chalk).
    pub roughness: f32,
    /// Whether it is drawn. One that is not neither hides blades.
    pub visible: bool,
    /// Whether a field grows on it, so that its colour may take [`crate::GroundSettings`].
    pub carries_grass: bool,
    /// Its area, square metres.
    pub area_m2: f64,
    /// Triangles of its file or shape that were left out because they have no area.
    pub dropped_triangles: usize,
    /// Base colour texture, through the mesh's UVs, wrapping, row 0 at v = 0.
    pub texture: Option<TextureImage>,
    /// How it pushes grass aside, one piece a copy; none where it does not. Of an object with
    /// several materials, the first part has the pieces of the whole.
    pub collider: Vec<ColliderPiece>,
    /// Where it moves; its mesh then is in its own space.
    pub path: Option<crate::Path>,
}
