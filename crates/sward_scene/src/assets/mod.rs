//! Files that a scene refers to: meshes and images. Every index and every number is checked here.

pub(crate) mod gltf;
mod gltf_data;
#[cfg(test)]
mod gltf_tests;
pub(crate) mod heights;
pub(crate) mod image;
pub(crate) mod mesh;
pub(crate) mod obj;
pub(crate) mod packs;

pub use image::TextureImage;

use crate::SceneError;
use std::path::Path;

/// Largest file read, bytes.
const MAX_FILE: u64 = 1 << 30;

/// A mesh with one material.
#[derive(Debug, Clone, Default)]
pub(crate) struct Part {
    pub(crate) mesh: sward::Mesh,
    /// Linear RGB; `None` where the file sets none.
    pub(crate) base_color: Option<[f32; 3]>,
    pub(crate) roughness: Option<f32>,
    pub(crate) texture: Option<TextureImage>,
}

impl From<sward::Mesh> for Part {
    fn from(mesh: sward::Mesh) -> Self {
        Self { mesh, ..Self::default() }
    }
}

/// Reads a whole file; refuses folders, devices and what would fill the memory.
pub(crate) fn read(file: &Path) -> Result<Vec<u8>, SceneError> {
    let about = std::fs::metadata(file).map_err(|e| SceneError::read(file, &e))?;
    if !about.is_file() {
        return Err(SceneError::Read { file: file.into(), cause: "is not a file".into() });
    }
    if about.len() > MAX_FILE {
        let cause = format!("is {} MiB; at most {} are read", about.len() >> 20, MAX_FILE >> 20);
        return Err(SceneError::Read { file: file.into(), cause });
    }
    std::fs::read(file).map_err(|e| SceneError::read(file, &e))
}

/// Reads a mesh file by its extension.
pub(crate) fn load_mesh(file: &Path) -> Result<Vec<Part>, SceneError> {
    let extension = file.extension().and_then(|e| e.to_str()).unwrap_or("").to_ascii_lowercase();
    let parts = match extension.as_str() {
        "obj" => vec![obj::parse(file, &read(file)?)?.into()],
        "gltf" | "glb" => gltf::parse(file, &read(file)?)?,
        _ => {
            let cause =
                format!("'.{extension}' is no mesh format read here: use .obj, .gltf or .glb");
            return Err(SceneError::asset(file, cause));
        }
    };
    mesh::check(parts.iter().map(|part| &part.mesh))
        .map_err(|cause| SceneError::asset(file, cause))?;
    Ok(parts)
}
