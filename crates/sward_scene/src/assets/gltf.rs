//! glTF 2.0, `.gltf` and `.glb`: meshes of the default scene with their nodes' transforms.

use super::gltf_data::{Data, resolve, split};
use super::{Part, TextureImage, mesh};
use crate::SceneError;
use glam::{Affine3A, Mat4, Vec2, Vec3};
use gltf::Semantic;
use gltf::mesh::Mode;
use std::collections::{BTreeMap, HashSet};
use std::path::Path;
use sward::Mesh;

/// Most vertices of a file, instances counted: nodes that share a mesh could else fill the memory.
const MAX_VERTICES: usize = 50_000_000;

/// Deepest nesting of nodes.
const MAX_DEPTH: usize = 256;

/// Reads a file into one part a material.
pub(crate) fn parse(file: &Path, bytes: &[u8]) -> Result<Vec<Part>, SceneError> {
    let broken = |cause: String| SceneError::asset(file, cause);
    let (json, binary) = split(bytes).map_err(broken)?;
    let root: gltf::json::Root = gltf::json::deserialize::from_slice(json)
        .map_err(|error| broken(format!("broken glTF: {error}; export it again")))?;
    check_root(&root).map_err(broken)?;
    let document = gltf::Document::from_json(root).map_err(|error| broken(invalid(&error)))?;
    let buffers = document
        .buffers()
        .map(|buffer| read_buffer(file, &buffer, binary))
        .collect::<Result<Vec<_>, _>>()?;
    let data = Data { file, buffers };
    let mut walk =
        Walk { data: &data, parts: BTreeMap::new(), seen: HashSet::new(), skipped: 0, vertices: 0 };
    for node in roots(&document) {
        walk.node(&node, Mat4::IDENTITY, 0).map_err(broken)?;
    }
    if walk.parts.is_empty() && walk.skipped > 0 {
        let cause = "has points or lines only; grass and scenes need triangles: export them";
        return Err(broken(cause.into()));
    }
    let mut parts = Vec::with_capacity(walk.parts.len());
    for (index, mesh) in walk.parts {
        parts.push(with_material(&data, &document, index, mesh)?);
    }
    Ok(parts)
}

/// The crate's own message begins with "invalid glTF" and ends each finding with a semicolon.
fn invalid(error: &gltf::Error) -> String {
    let text = error.to_string();
    format!("{}; export it again", text.trim().trim_end_matches(';'))
}

/// What the crate's own check does not ask, or panics on: the version, and accessors of positions
/// that are not there.
fn check_root(root: &gltf::json::Root) -> Result<(), String> {
    let version = &root.asset.version;
    if !version.starts_with("2.") {
        return Err(format!("glTF version {version}; only 2 is read: export as glTF 2.0"));
    }
    let positions = gltf::json::validation::Checked::Valid(Semantic::Positions);
    for (index, mesh) in root.meshes.iter().enumerate() {
        for (number, primitive) in mesh.primitives.iter().enumerate() {
            let accessor = primitive.attributes.get(&positions).map(|accessor| accessor.value());
            let missing = accessor.filter(|&accessor| accessor >= root.accessors.len());
            if let Some(accessor) = missing {
                let count = root.accessors.len();
                return Err(format!(
                    "mesh {index} primitive {number}: accessor {accessor} is out of range: there \
                     are {count}; export it again"
                ));
            }
        }
    }
    Ok(())
}

fn read_buffer(
    file: &Path,
    buffer: &gltf::Buffer,
    binary: Option<&[u8]>,
) -> Result<Vec<u8>, SceneError> {
    let what = format!("buffer {}", buffer.index());
    let bytes = match buffer.source() {
        gltf::buffer::Source::Uri(uri) => resolve(file, uri, &what)?,
        gltf::buffer::Source::Bin => binary.map(<[u8]>::to_vec).ok_or_else(|| {
            SceneError::asset(file, format!("{what}: has no data; export it again"))
        })?,
    };
    if bytes.len() < buffer.length() {
        let cause =
            format!("{what}: {} of {} bytes: it is truncated", bytes.len(), buffer.length());
        return Err(SceneError::asset(file, cause));
    }
    Ok(bytes)
}

/// The nodes of the default scene, else of the first; without scenes, those that are no children.
fn roots(document: &gltf::Document) -> Vec<gltf::Node<'_>> {
    if let Some(scene) = document.default_scene().or_else(|| document.scenes().next()) {
        return scene.nodes().collect();
    }
    let children: HashSet<usize> = document
        .nodes()
        .flat_map(|node| node.children().map(|c| c.index()).collect::<Vec<_>>())
        .collect();
    document.nodes().filter(|node| !children.contains(&node.index())).collect()
}

struct Walk<'a> {
    data: &'a Data<'a>,
    /// World-space meshes by material.
    parts: BTreeMap<Option<usize>, Mesh>,
    /// A node has one parent: one that is met again means a loop.
    seen: HashSet<usize>,
    skipped: usize,
    vertices: usize,
}

impl Walk<'_> {
    fn node(&mut self, node: &gltf::Node, parent: Mat4, depth: usize) -> Result<(), String> {
        if !self.seen.insert(node.index()) || depth > MAX_DEPTH {
            return Err(format!("node {}: nodes form a loop or nest too deep", node.index()));
        }
        let world_from_node = parent * Mat4::from_cols_array_2d(&node.transform().matrix());
        if !world_from_node.is_finite() {
            return Err(format!("node {}: its transform is not finite", node.index()));
        }
        if let Some(gltf_mesh) = node.mesh() {
            for primitive in gltf_mesh.primitives() {
                let place = format!("mesh {} primitive {}", gltf_mesh.index(), primitive.index());
                let Some(mut mesh) =
                    self.primitive(&primitive).map_err(|e| format!("{place}: {e}"))?
                else {
                    self.skipped += 1;
                    continue;
                };
                mesh::check_numbers(&mesh).map_err(|e| format!("{place}: {e}"))?;
                mesh::transform(&mut mesh, Affine3A::from_mat4(world_from_node));
                let part = self.parts.entry(primitive.material().index()).or_default();
                mesh::append(part, &mesh);
                self.vertices += mesh.positions.len();
                if self.vertices > MAX_VERTICES {
                    return Err(format!("more than {MAX_VERTICES} vertices; simplify the model"));
                }
            }
        }
        node.children().try_for_each(|child| self.node(&child, world_from_node, depth + 1))
    }

    /// `None` for points and lines.
    fn primitive(&self, primitive: &gltf::Primitive) -> Result<Option<Mesh>, String> {
        if matches!(primitive.mode(), Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip)
        {
            return Ok(None);
        }
        let positions = primitive
            .get(&Semantic::Positions)
            .ok_or("it has no POSITION attribute; export it with its geometry")?;
        let rows = self.data.rows::<3>(&positions, 0.0)?;
        let vector = |row: &[f64; 3]| Vec3::from(row.map(|c| c as f32));
        let mut mesh = Mesh { positions: rows.iter().map(vector).collect(), ..Mesh::default() };
        if let Some(normals) = primitive.get(&Semantic::Normals) {
            mesh.normals = self.data.rows::<3>(&normals, 0.0)?.iter().map(vector).collect();
        }
        if let Some(colors) = primitive.get(&Semantic::Colors(0)) {
            let rows = self.data.rows::<4>(&colors, 1.0)?;
            let clamped = |c: f64| if c.is_finite() { c.clamp(0.0, 1.0) as f32 } else { 1.0 };
            mesh.colors = rows.iter().map(|row| row.map(clamped)).collect();
        }
        let set = primitive
            .material()
            .pbr_metallic_roughness()
            .base_color_texture()
            .map_or(0, |texture| texture.tex_coord());
        if let Some(uvs) = primitive.get(&Semantic::TexCoords(set)) {
            let rows = self.data.rows::<2>(&uvs, 0.0)?;
            mesh.uvs = rows.iter().map(|row| Vec2::from(row.map(|c| c as f32))).collect();
        }
        let count = mesh.positions.len();
        let indices = match primitive.indices() {
            Some(accessor) => {
                let rows = self.data.rows::<1>(&accessor, 0.0)?;
                rows.iter().map(|[index]| *index as u32).collect()
            }
            None => (0..count as u32).collect::<Vec<_>>(),
        };
        mesh.triangles = triangles(&indices, primitive.mode());
        drop_short_attributes(&mut mesh);
        Ok(Some(mesh))
    }
}

fn triangles(indices: &[u32], mode: Mode) -> Vec<[u32; 3]> {
    match mode {
        Mode::TriangleStrip => {
            let windows = indices.windows(3).enumerate();
            let turned = windows.filter_map(|(i, window)| match *window {
                [a, b, c] if i % 2 == 0 => Some([a, b, c]),
                [a, b, c] => Some([b, a, c]),
                _ => None,
            });
            turned.collect()
        }
        Mode::TriangleFan => {
            let first = indices.first().copied().unwrap_or(0);
            let rim = indices.iter().skip(1).zip(indices.iter().skip(2));
            rim.map(|(&b, &c)| [first, b, c]).collect()
        }
        _ => indices.chunks_exact(3).filter_map(|c| c.try_into().ok()).collect(),
    }
}

fn drop_short_attributes(mesh: &mut Mesh) {
    let count = mesh.positions.len();
    if mesh.colors.len() != count {
        mesh.colors.clear();
    }
    if mesh.uvs.len() != count || !mesh.uvs.iter().all(|uv| uv.is_finite()) {
        mesh.uvs.clear();
    }
    mesh::drop_broken_normals(mesh);
}

fn with_material(
    data: &Data,
    document: &gltf::Document,
    index: Option<usize>,
    mesh: Mesh,
) -> Result<Part, SceneError> {
    let Some(material) = index.and_then(|index| document.materials().nth(index)) else {
        return Ok(mesh.into());
    };
    let surface = material.pbr_metallic_roughness();
    let [r, g, b, _] = surface.base_color_factor();
    let unit = |c: f32| if c.is_finite() { c.clamp(0.0, 1.0) } else { 1.0 };
    let texture = match surface.base_color_texture() {
        Some(info) if !mesh.uvs.is_empty() => {
            Some(read_image(data, document, info.texture().source().index())?)
        }
        _ => None,
    };
    Ok(Part {
        mesh,
        base_color: Some([r, g, b].map(unit)),
        roughness: Some(unit(surface.roughness_factor())),
        texture,
    })
}

fn read_image(
    data: &Data,
    document: &gltf::Document,
    index: usize,
) -> Result<TextureImage, SceneError> {
    let what = format!("image {index}");
    let broken = |cause: &str| SceneError::asset(data.file, format!("{what}: {cause}"));
    let at = |error: SceneError| match error {
        SceneError::Asset { cause, .. } => broken(&cause),
        other => other,
    };
    // The crate's own `source` panics where an image names neither a file nor a media type.
    let image = document.as_json().images.get(index).ok_or_else(|| broken("is not there"))?;
    if let Some(uri) = &image.uri {
        let bytes = resolve(data.file, uri, &what)?;
        return super::image::texture(data.file, &bytes).map_err(at);
    }
    let view = image.buffer_view.and_then(|view| document.views().nth(view.value()));
    let view = view.ok_or_else(|| broken("names no file and no buffer view"))?;
    let bytes = data.view(&view, 0).map_err(|cause| broken(&cause))?;
    super::image::texture(data.file, bytes).map_err(at)
}
