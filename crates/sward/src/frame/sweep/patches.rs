//! The patches of a page on a grid: in views by strips the sweep finds those that a view may see.

use super::grid::{Grid, Thing};
use super::plan::{GpuSweep, plan};
use crate::View;
use crate::gpu::bindings;
use crate::gpu::buffers::{storage, uniform, write};
use crate::gpu::shaders::Shader;
use crate::grow::Patch;
use crate::renderer::Layouts;
use glam::{Vec2, Vec3Swizzles};
use wgpu::BufferUsages;

/// Cell of a patch that is on no grid.
pub(crate) const NO_CELL: u32 = u32::MAX;

/// A grid with about one patch a cell, and the cell of each: column in the upper half word, row in
/// the lower. None for patches that do not lie about level: a sweep would find nearly all of them.
pub(crate) fn patch_grid(patches: &[Patch]) -> Option<(Grid, Vec<u32>)> {
    let thing = |patch: &Patch| Thing {
        place: 0.5 * (patch.root_min + patch.root_max).xz(),
        low: patch.reach_min,
        high: patch.reach_max,
    };
    let things: Vec<Thing> = patches.iter().map(thing).collect();
    let fold = |f: fn(Vec2, Vec2) -> Vec2| things.iter().map(|t| t.place).reduce(f);
    let (min, max) = (fold(Vec2::min)?, fold(Vec2::max)?);
    let size = (max - min).max(Vec2::splat(1e-3));
    let cell_m = (size.x * size.y / patches.len() as f32).sqrt().max(1e-3);
    let (grid, cells) = Grid::over((min, max), &things, cell_m);
    let rows = grid.cells.y;
    let packed = cells.iter().map(|cell| ((cell / rows) << 16) | (cell % rows)).collect();
    grid.is_flat().then_some((grid, packed))
}

/// What one view's sweep of a page writes.
#[derive(Debug)]
pub(crate) struct PatchSweep {
    settings: wgpu::Buffer,
    /// First row and rows of each column; the patch culling stage reads it.
    pub columns: wgpu::Buffer,
    group: wgpu::BindGroup,
}

impl PatchSweep {
    pub(crate) fn new(
        device: &wgpu::Device,
        layouts: &Layouts,
        grid: Option<&Grid>,
        view: &wgpu::Buffer,
    ) -> Self {
        let settings = uniform(device, "sward.sweep", size_of::<GpuSweep>() as u64);
        let columns = grid.map_or(1, |grid| grid.cells.x);
        let columns =
            storage(device, "sward.columns", u64::from(columns) * 8, BufferUsages::empty());
        let bound = [view, &settings, &columns];
        let group = bindings::buffers(device, "sward.sweep", &layouts.sweep, &bound);
        Self { settings, columns, group }
    }

    /// Writes how a view sweeps the grid.
    pub(crate) fn prepare(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        grid: &Grid,
        view: &View,
    ) {
        write(device, encoder, &self.settings, bytemuck::bytes_of(&plan(grid, view)));
    }
}

/// The stage before patch culling.
#[derive(Debug)]
pub(crate) struct SweepStage {
    pipeline: wgpu::ComputePipeline,
}

impl SweepStage {
    pub(crate) fn new(device: &wgpu::Device, layouts: &Layouts) -> Self {
        let module = Shader::SweepColumns.module(device);
        Self { pipeline: super::pipeline(device, &module, "sweep_columns", &layouts.sweep) }
    }

    /// One thread a column.
    pub(crate) fn encode(&self, pass: &mut wgpu::ComputePass, grid: &Grid, own: &PatchSweep) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(2, &own.group, &[]);
        pass.dispatch_workgroups(grid.cells.x.div_ceil(64), 1, 1);
    }
}
