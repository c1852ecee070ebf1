//! Meshes of the scene's opaque things on the GPU.

use super::frame::CameraMatrices;
use super::parts::{self, Part, Which};
use bytemuck::{Pod, Zeroable};
use glam::{Quat, Vec2, Vec3};
use sward::{ColorRange, Mesh};
use sward_scene::Scene;
use wgpu::util::DeviceExt;

#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
struct GpuVertex {
    position: Vec3,
    normal: Vec3,
    uv: Vec2,
    color: [f32; 4],
}

/// Where a mesh stands and what it is made of.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(super) struct GpuPlacement {
    pub position: Vec3,
    pub scale: f32,
    /// A quaternion.
    pub rotation: [f32; 4],
    pub color: [f32; 3],
    pub roughness: f32,
    /// RGB and share of the grass on it; a share below 0 means none.
    pub grass: [f32; 4],
    /// RGB of every other stripe along the longitudes, and how many there are; 0 means none.
    pub stripe: [f32; 4],
}

/// On a thing that carries none.
pub(super) const NO_GRASS: [f32; 4] = [0.0, 0.0, 0.0, -1.0];
/// Of one colour.
pub(super) const NO_STRIPES: [f32; 4] = [0.0; 4];
/// Pairs of stripes round a ball.
pub(super) const STRIPES: f32 = 3.0;

/// Vertex buffers of the opaque pass.
pub(super) const VERTEX_BUFFERS: [Option<wgpu::VertexBufferLayout<'static>>; 2] = [
    Some(wgpu::VertexBufferLayout {
        array_stride: size_of::<GpuVertex>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &wgpu::vertex_attr_array![
            0 => Float32x3, 1 => Float32x3, 2 => Float32x2, 3 => Float32x4
        ],
    }),
    Some(wgpu::VertexBufferLayout {
        array_stride: size_of::<GpuPlacement>() as u64,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![4 => Float32x4, 5 => Float32x4, 6 => Float32x4, 7 => Float32x4, 8 => Float32x4
        ],
    }),
];

/// A mesh with the places where it stands.
#[derive(Debug)]
pub(super) struct GpuMesh {
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    index_count: u32,
    /// Of a mesh that rests where it was made.
    parts: Vec<Part>,
    placements: wgpu::Buffer,
    placement_count: u32,
    pub texture: wgpu::BindGroup,
}

impl GpuMesh {
    /// `mesh` must have normals.
    pub fn new(
        device: &wgpu::Device,
        mesh: &Mesh,
        placements: &[GpuPlacement],
        texture: wgpu::BindGroup,
    ) -> Self {
        let vertices: Vec<_> = (0..mesh.positions.len())
            .map(|i| GpuVertex {
                position: mesh.positions[i],
                normal: mesh.normals.get(i).copied().unwrap_or(Vec3::Y),
                uv: mesh.uvs.get(i).copied().unwrap_or(Vec2::ZERO),
                color: mesh.colors.get(i).copied().unwrap_or([1.0; 4]),
            })
            .collect();
        let buffer = |contents: &[u8], usage| {
            device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some("sward.stage.mesh"),
                contents,
                usage,
            })
        };
        use wgpu::BufferUsages as U;
        Self {
            vertices: buffer(bytemuck::cast_slice(&vertices), U::VERTEX),
            indices: buffer(bytemuck::cast_slice(&mesh.triangles), U::INDEX),
            index_count: mesh.triangles.len() as u32 * 3,
            parts: Vec::new(),
            placements: buffer(bytemuck::cast_slice(placements), U::VERTEX | U::COPY_DST),
            placement_count: placements.len() as u32,
            texture,
        }
    }

    /// The same in parts, for one that rests where it was made.
    pub fn resting(
        device: &wgpu::Device,
        mut mesh: Mesh,
        placement: GpuPlacement,
        texture: wgpu::BindGroup,
    ) -> Self {
        let parts = parts::parts(&mesh.positions, &mut mesh.triangles);
        Self { parts, ..Self::new(device, &mesh, &[placement], texture) }
    }

    /// Draws those of its parts that a camera sees.
    pub fn draw_parts(&self, pass: &mut wgpu::RenderPass, runs: &[std::ops::Range<u32>]) {
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_vertex_buffer(1, self.placements.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        for run in runs {
            pass.draw_indexed(run.clone(), 0, 0..1);
        }
    }

    /// The parts that a camera sees.
    pub fn seen(
        &self,
        camera: CameraMatrices,
        which: Which,
        stands_in_m: f32,
    ) -> Vec<std::ops::Range<u32>> {
        parts::seen(&self.parts, camera, which, stands_in_m)
    }

    /// Moves the instances; as many as there were.
    pub fn place(&self, queue: &wgpu::Queue, placements: &[GpuPlacement]) {
        if !placements.is_empty() {
            queue.write_buffer(&self.placements, 0, bytemuck::cast_slice(placements));
        }
    }

    /// Draws the cells that a sweep lists; of meshes with one placement.
    pub fn draw_swept(&self, pass: &mut wgpu::RenderPass, sweep: &sward::Sweep) {
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_vertex_buffer(1, self.placements.slice(..));
        pass.set_index_buffer(sweep.indices().slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed_indirect(sweep.indirect(), 0);
    }

    pub fn draw(&self, pass: &mut wgpu::RenderPass) {
        if self.placement_count == 0 {
            return;
        }
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_vertex_buffer(1, self.placements.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.index_count, 0, 0..self.placement_count);
    }
}

/// The mesh of an object, normals made where it has none.
pub(super) fn with_normals(mesh: &Mesh) -> Mesh {
    let mut mesh = mesh.clone();
    if mesh.normals.len() == mesh.positions.len() {
        return mesh;
    }
    let mut normals = vec![Vec3::ZERO; mesh.positions.len()];
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| mesh.positions[i as usize]);
        let weighted = (b - a).cross(c - a);
        triangle.iter().for_each(|&i| normals[i as usize] += weighted);
    }
    mesh.normals = normals.into_iter().map(|n| n.normalize_or(Vec3::Y)).collect();
    mesh
}

/// Place and material of an object; ground takes the mean colour of the grass that grows on it.
pub(super) fn object_placement(scene: &Scene, index: usize) -> GpuPlacement {
    let object = &scene.objects[index];
    let mut grass = NO_GRASS;
    if object.carries_grass {
        let [r, g, b] = mean_grass_color(scene, index);
        grass = [r, g, b, scene.ground.grass_tint * (1.0 - surface_share(scene, index))];
    }
    GpuPlacement {
        position: Vec3::ZERO,
        scale: 1.0,
        rotation: Quat::IDENTITY.to_array(),
        stripe: NO_STRIPES,
        color: object.base_color,
        roughness: object.roughness,
        grass,
    }
}

/// How far the grass on an object has the object's own colours, which its ground so shows.
fn surface_share(scene: &Scene, object: usize) -> f32 {
    let fields = scene.fields.iter().filter(|f| f.object == object && f.desc.color_map.is_some());
    fields.map(|f| f.desc.color_mix).fold(0.0, f32::max)
}

/// How bright a canopy is beside a flat ground of its colour: blades shade each other.
const CANOPY_SHADE: f32 = 0.6;

/// Mean over the species of the fields on an object, by the area of their blades. Tips count for
/// two thirds: they hide the roots.
fn mean_grass_color(scene: &Scene, object: usize) -> [f32; 3] {
    let mut sum = Vec3::ZERO;
    let mut area = 0.0_f32;
    for species in scene.fields.iter().filter(|f| f.object == object).flat_map(|f| &f.desc.species)
    {
        let mean = |range: &ColorRange| (Vec3::from(range.from) + Vec3::from(range.to)) * 0.5;
        let color = mean(&species.root_color).lerp(mean(&species.tip_color), 2.0 / 3.0);
        let own = species.share * species.height_m.at(0.5) * species.width_m.at(0.5);
        sum += color * own;
        area += own;
    }
    (sum * CANOPY_SHADE / area.max(f32::MIN_POSITIVE)).into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn missing_normals_are_made() {
        let mesh = Mesh {
            positions: vec![Vec3::ZERO, Vec3::Z, Vec3::X],
            triangles: vec![[0, 1, 2]],
            ..Default::default()
        };
        assert_eq!(with_normals(&mesh).normals, vec![Vec3::Y; 3]);
    }
}
