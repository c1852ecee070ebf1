//! Views by strips sweep the ground for their patches, where the field lies about level.

use super::Renderer;
use crate::frame::sweep::grid::Grid;
use crate::frame::sweep::patches::SweepStage;
use crate::gpu::layout::GpuView;
use crate::gpu::lists::ViewLists;
use crate::gpu::page::Page;
use crate::gpu::view::GROUND_SWEPT;
use crate::{Technique, View};

/// The grid that a view sweeps.
fn swept<'a>(page: &'a Page, view: &View) -> Option<&'a Grid> {
    let by_frustum = view.culling.frustum && !view.culling.paper;
    page.grid.as_ref().filter(|_| by_frustum && view.technique == Technique::Strips)
}

impl Renderer {
    /// Settings of a sweep, where the view makes one of this page; it says so in its flags.
    pub(super) fn prepare_sweep(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        (page, index): (usize, usize),
        view: &View,
        uniform: &mut GpuView,
    ) {
        let page = &self.pages[page];
        let Some(grid) = swept(page, view) else { return };
        uniform.flags |= GROUND_SWEPT;
        page.views[index].sweep.prepare(device, encoder, grid, view);
        self.sweep.get_or_insert_with(|| SweepStage::new(device, &self.layouts));
    }

    /// Sweeps a page, before its patches are culled.
    pub(super) fn encode_sweep(
        &self,
        pass: &mut wgpu::ComputePass,
        page: &Page,
        lists: &ViewLists,
        view: &View,
    ) {
        if let (Some(stage), Some(grid)) = (&self.sweep, swept(page, view)) {
            stage.encode(pass, grid, &lists.sweep);
        }
    }
}
