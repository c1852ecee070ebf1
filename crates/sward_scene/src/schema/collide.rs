//! Keys for how objects push grass aside.

use serde::Deserialize;

/// How an object pushes grass aside. No root of a field grows inside it, unless it moves or the
/// field grows on it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Deserialize)]
pub enum CollideFile {
    /// As what it is made from asks for: mesh files as `Packed()`, rocks with fewer spheres, trees
    /// with their trunks, balls as `Sphere`. Where all copies would have more than 1,000,000 spheres,
    /// each has fewer, and a note says how many. Not at all: what carries grass, is not visible, or is
    /// a sheet.
    #[default]
    Auto,
    /// Not at all.
    None,
    /// Its bounding box, which turns with it.
    Box,
    /// The ball about its bounding box's middle that holds it.
    Sphere,
    /// A capsule along its bounding box's longest side that holds it; of a tree, its trunk.
    Capsule,
    /// Spheres that fill its mesh. A hole is closed as if by a film: an open bowl is full to its rim.
    Packed(PackedFile),
}

/// Spheres that fill a mesh, kept in a file beside the mesh file once they are found.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct PackedFile {
    /// How many at most, 1..=65536; default 1000: more follow the shape more closely. All copies
    /// together have at most 1,000,000.
    pub spheres: u32,
    /// How far one may bulge over the surface, as a share of the mesh's diagonal, 0..=0.1; default
    /// 0.001. More covers thin parts with fewer spheres.
    pub bulge: f32,
}

impl Default for PackedFile {
    fn default() -> Self {
        let sward::PackDesc { spheres, bulge } = sward::PackDesc::default();
        Self { spheres, bulge }
    }
}
