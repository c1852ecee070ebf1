//! Terrain drawn by its cells: a host's own ground, swept for its camera.

use super::grid::{Grid, Thing};
use super::pipeline;
use super::plan::{GpuSweep, SweepMethod, plan};
use crate::error::above_zero;
use crate::gpu::bindings::{self, Kind};
use crate::gpu::buffers::{filled, storage, uniform, write};
use crate::gpu::layout::GpuView;
use crate::gpu::shaders::Shader;
use crate::gpu::view::{check_view, gpu_view};
use crate::grow::surface::check_shape;
use crate::{Error, Mesh, View};
use glam::{Vec2, Vec3, Vec3Swizzles};
use wgpu::BufferUsages;

/// The ground sweep of one terrain mesh (O section 3): lists, for a view, the triangles of the cells
/// that it may see, for one indirect draw with the host's own vertices and pipeline.
///
/// The terrain is cut into cells of equal size along x and z. Each frame, on the GPU: the four
/// corners in which the ground meets the frustum; the columns of cells from the leftmost to the
/// rightmost; the rows of each inside the quadrilateral, wider by the terrain's relief; prefix sums;
/// the cells in order. Nothing is appended by atomics: the same view gives the same list.
///
/// The corners need a camera whose horizon is level (5 degrees of roll at most), that does not look
/// within 10 degrees of straight down or up, and that is above the lowest ground. For any other
/// every cell is tested against the frustum; [`Sweep::method`] says which it was. No visible cell
/// is left out either way.
///
/// ```no_run
/// # fn host(device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, mesh: &sward::Mesh,
/// #     view: &sward::View, pass: &mut wgpu::RenderPass) -> Result<(), sward::Error> {
/// // Once
/// let mut sweep = sward::Sweep::new(device, mesh, 4.0)?;
/// // Each frame, before the pass
/// sweep.encode(device, encoder, view)?;
/// // In it, with the mesh's vertices bound
/// pass.set_index_buffer(sweep.indices().slice(..), wgpu::IndexFormat::Uint32);
/// pass.draw_indexed_indirect(sweep.indirect(), 0);
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct Sweep {
    grid: Grid,
    sweep_terrain: wgpu::ComputePipeline,
    list_terrain: wgpu::ComputePipeline,
    group: wgpu::BindGroup,
    view: wgpu::Buffer,
    settings: wgpu::Buffer,
    cells: wgpu::Buffer,
    indices: wgpu::Buffer,
    /// Written by the sweep; a buffer cannot be that and a draw's arguments at once.
    arguments: wgpu::Buffer,
    indirect: wgpu::Buffer,
    method: SweepMethod,
}

impl Sweep {
    /// Sorts a mesh's triangles into cells of about `cell_m` metres: smaller cells draw less that is
    /// not seen and cost a little more to sweep. There are at most 1024 columns and as many rows.
    /// The mesh is any that lies about level; its triangles keep their vertices.
    ///
    /// # Errors
    /// [`Error::Mesh`] for a mesh without triangles or with broken ones, [`Error::Setting`] for a cell
    /// that is not above 0, [`Error::Limit`] where the indices do not fit a storage binding.
    pub fn new(device: &wgpu::Device, mesh: &Mesh, cell_m: f32) -> Result<Self, Error> {
        above_zero("sweep.cell_m", cell_m, 1e6)?;
        check_shape(mesh)?;
        check_limit(device, mesh)?;
        let things: Vec<Thing> = mesh.triangles.iter().map(|t| thing(mesh, *t)).collect();
        // The rectangle of the vertices, so that cells lie along a height map's own lines
        let (grid, cells) = Grid::over(mesh_rectangle(mesh), &things, cell_m);
        let by_cell = sorted(mesh, &cells, grid.count());
        Ok(Self::from_cells(device, grid, &by_cell))
    }

    fn from_cells(device: &wgpu::Device, grid: Grid, by_cell: &ByCell) -> Self {
        let view = uniform(device, "sward.sweep.view", size_of::<GpuView>() as u64);
        let settings = uniform(device, "sward.sweep", size_of::<GpuSweep>() as u64);
        let store = |label, words: u64, more| storage(device, label, 4 * words, more);
        let none = BufferUsages::empty();
        let columns = store("sward.sweep.columns", 4 * u64::from(grid.cells.x), none);
        let content = |label, words: &[u32]| {
            filled(device, label, bytemuck::cast_slice(words), BufferUsages::STORAGE)
        };
        let first_triangle = content("sward.sweep.first_triangle", &by_cell.first_triangle);
        let triangles = content("sward.sweep.triangles", &by_cell.indices);
        let words = by_cell.indices.len() as u64;
        let indices = store("sward.sweep.indices", words, BufferUsages::INDEX);
        let cells = store("sward.sweep.cells", 1 + u64::from(grid.count()), none);
        let arguments = store("sward.sweep.arguments", 5, none);
        use Kind::{Read, Uniform, Write};
        let kinds = [Uniform, Uniform, Write, Read, Read, Write, Write, Write];
        let layout = bindings::layout(device, "sward.sweep", wgpu::ShaderStages::COMPUTE, &kinds);
        let bound =
            [&view, &settings, &columns, &first_triangle, &triangles, &indices, &cells, &arguments];
        let module = Shader::SweepTerrain.module(device);
        Self {
            sweep_terrain: pipeline(device, &module, "sweep_terrain", &layout),
            list_terrain: pipeline(device, &module, "list_terrain", &layout),
            group: bindings::buffers(device, "sward.sweep", &layout, &bound),
            indirect: filled(
                device,
                "sward.sweep.indirect",
                bytemuck::cast_slice(&[0_u32; 5]),
                BufferUsages::INDIRECT,
            ),
            grid,
            view,
            settings,
            cells,
            indices,
            arguments,
            method: SweepMethod::EveryCell,
        }
    }

    /// Lists what a view may see; before the pass that draws it.
    ///
    /// # Errors
    /// [`Error::Setting`] for a view that is no camera.
    pub fn encode(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        view: &View,
    ) -> Result<(), Error> {
        check_view(view)?;
        let settings = plan(&self.grid, view);
        self.method = settings.method();
        write(device, encoder, &self.view, bytemuck::bytes_of(&gpu_view(view, 0)));
        write(device, encoder, &self.settings, bytemuck::bytes_of(&settings));
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some("sward.sweep"),
            timestamp_writes: None,
        });
        pass.set_bind_group(2, &self.group, &[]);
        pass.set_pipeline(&self.sweep_terrain);
        pass.dispatch_workgroups(1, 1, 1);
        pass.set_pipeline(&self.list_terrain);
        pass.dispatch_workgroups(self.grid.cells.x, 1, 1);
        drop(pass);
        encoder.copy_buffer_to_buffer(&self.arguments, 0, &self.indirect, 0, 20);
        Ok(())
    }

    /// 32-bit indices of the listed triangles, cell by cell.
    pub fn indices(&self) -> &wgpu::Buffer {
        &self.indices
    }

    /// Arguments of one `draw_indexed_indirect`.
    pub fn indirect(&self) -> &wgpu::Buffer {
        &self.indirect
    }

    /// How many cells are listed, then their numbers in rising order, 32 bits each: column times
    /// rows plus row. It may be copied from, to be read back.
    pub fn cells(&self) -> &wgpu::Buffer {
        &self.cells
    }

    /// How the last view was swept.
    pub fn method(&self) -> SweepMethod {
        self.method
    }

    #[cfg(test)]
    pub(crate) fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Columns, along x, and rows, along z.
    pub fn size(&self) -> [u32; 2] {
        self.grid.cells.to_array()
    }

    /// Lowest and highest (x, z) of a cell, metres.
    pub fn rectangle(&self, cell: u32) -> (Vec2, Vec2) {
        self.grid.rectangle(cell)
    }

    /// Box of the whole terrain, metres.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        self.grid.bounds()
    }
}

fn check_limit(device: &wgpu::Device, mesh: &Mesh) -> Result<(), Error> {
    let limits = device.limits();
    let available = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
    let needed = mesh.triangles.len() as u64 * 12;
    if needed <= available {
        return Ok(());
    }
    Err(Error::Limit {
        what: format!("a sweep of {} triangles", mesh.triangles.len()),
        limit: "max_storage_buffer_binding_size",
        needed,
        available,
        remedy: "cut the terrain into several meshes".into(),
    })
}

fn thing(mesh: &Mesh, triangle: [u32; 3]) -> Thing {
    let [a, b, c] = triangle.map(|v| mesh.positions[v as usize]);
    Thing { place: (a + b + c).xz() / 3.0, low: a.min(b).min(c), high: a.max(b).max(c) }
}

fn mesh_rectangle(mesh: &Mesh) -> (Vec2, Vec2) {
    let fold =
        |f: fn(Vec2, Vec2) -> Vec2, from| mesh.positions.iter().map(|p| p.xz()).fold(from, f);
    (fold(Vec2::min, Vec2::INFINITY), fold(Vec2::max, Vec2::NEG_INFINITY))
}

/// The triangles of a mesh, cell by cell.
struct ByCell {
    /// Triangles before each cell, and one more: all.
    first_triangle: Vec<u32>,
    indices: Vec<u32>,
}

/// By counting: triangles of a cell stay in the mesh's order.
fn sorted(mesh: &Mesh, cells: &[u32], count: u32) -> ByCell {
    let mut first_triangle = vec![0_u32; count as usize + 1];
    for cell in cells {
        first_triangle[*cell as usize + 1] += 1;
    }
    for i in 1..first_triangle.len() {
        first_triangle[i] += first_triangle[i - 1];
    }
    let mut next = first_triangle.clone();
    let mut indices = vec![0_u32; 3 * mesh.triangles.len()];
    for (triangle, cell) in mesh.triangles.iter().zip(cells) {
        let at = 3 * next[*cell as usize] as usize;
        indices[at..at + 3].copy_from_slice(triangle);
        next[*cell as usize] += 1;
    }
    ByCell { first_triangle, indices }
}
