//! What only tests look at.

use super::{Layouts, Renderer};
use crate::Statistics;
use crate::gpu::page::Page;

impl Renderer {
    pub(crate) fn pages(&self) -> &[Page] {
        &self.pages
    }

    pub(crate) fn layouts(&self) -> &Layouts {
        &self.layouts
    }

    pub(crate) fn frame_group(&self) -> &wgpu::BindGroup {
        self.inputs.group()
    }

    pub(crate) fn counts_in_flight(&self) -> bool {
        self.read_back.in_flight()
    }

    pub(crate) fn explained(&self, page: usize) -> Option<&wgpu::Buffer> {
        self.debug.as_ref()?.explained.get(page)
    }

    /// Has a view run every block, whether it may see it or not.
    pub(crate) fn see_every_block(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        view: usize,
    ) {
        for page in &mut self.pages {
            let all = (0..page.block_count()).collect();
            page.views[view].seen.set(device, encoder, all);
        }
    }

    /// Forgets every field.
    pub(crate) fn clear(&mut self) {
        self.pages.clear();
        self.unbaked.clear();
        self.totals = Statistics::default();
    }
}
