//! What a renderer tells of itself: what it draws, and what it holds.

use super::Renderer;
use crate::Statistics;
use crate::frame::draw::mesh::vertices_by_bucket;
use crate::gpu::pictures;
use crate::gpu::statistics::PageCounts;

impl Renderer {
    /// The newest counts of view 0 that have come back, a frame or more late; never waits.
    pub fn statistics(&mut self, device: &wgpu::Device) -> Option<Statistics> {
        // A poll that finds nothing is no error, and a lost device has nothing to report
        let _ = device.poll(wgpu::PollType::Poll);
        let counted = self.read_back.collect(&vertices_by_bucket())?;
        let Statistics { blades, patches, .. } = self.totals;
        Some(Statistics { blades, patches, ..counted })
    }

    /// Bytes of all buffers that grow with the blades, lists included.
    pub fn blade_bytes(&self) -> u64 {
        self.pages.iter().map(|page| page.bytes() + page.list_bytes()).sum()
    }

    /// Bytes of all that the fields hold on the GPU: [`Self::blade_bytes`], and the textures and light
    /// of plants and clusters, which are the same for any number of blades. Clusters are there once a
    /// view by [`Technique::Continuum`](crate::Technique::Continuum) was culled.
    pub fn gpu_bytes(&self) -> u64 {
        self.blade_bytes() + pictures::bytes(self.pages.iter().map(|page| &page.pictures))
    }

    pub(super) fn record_statistics(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
    ) {
        let counts: Vec<_> = self
            .pages
            .iter()
            .filter_map(|page| {
                let lists = page.views.first()?;
                let (counted, draws) = (&lists.counted, &lists.draws);
                Some(PageCounts { counted, draws, work_size: &page.work_size })
            })
            .collect();
        self.read_back.record(device, encoder, &counts);
    }
}
