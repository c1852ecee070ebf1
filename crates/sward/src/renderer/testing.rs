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

    /// Forgets every field.
    pub(crate) fn clear(&mut self) {
        self.pages.clear();
        self.unbaked.clear();
        self.totals = Statistics::default();
    }
}
