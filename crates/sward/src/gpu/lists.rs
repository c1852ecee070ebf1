//! What one view lists of a page.

use super::bindings;
use super::buckets::Buckets;
use super::buffers::{storage, uniform};
use super::layout::{BUCKETS, GpuDraw, GpuView};
use super::page::Page;
use super::view::Known;
use crate::frame::compact::SCAN_BLADE_INDICES_BYTES;
use crate::frame::cull::blocks::Seen;
use crate::frame::draw::pipelines::Variant;
use crate::frame::sweep::patches::PatchSweep;
use crate::renderer::Layouts;
use wgpu::BufferUsages;

/// The draw list of one view.
#[derive(Debug)]
pub struct ViewLists {
    /// Most entries.
    pub capacity: u32,
    /// Which of them plants may be in.
    pub buckets: Buckets,
    /// Which pipelines draw them.
    pub variant: Variant,
    /// What its pipelines are made for.
    pub known: Known,
    /// Which blocks of the page it may see.
    pub seen: Seen,
    /// `GpuView`.
    pub view: wgpu::Buffer,
    /// Range of each bucket.
    pub draws: wgpu::Buffer,
    /// Arguments of each bucket's draw.
    pub indirect: wgpu::Buffer,
    /// Failed tests.
    pub counted: wgpu::Buffer,
    /// The list.
    pub list: wgpu::Buffer,
    /// Group 2 of patch culling.
    pub cull: wgpu::BindGroup,
    /// Group 2 of the update.
    pub update: wgpu::BindGroup,
    /// Groups that hold what was baked of the field.
    pub lit: Lit,
    pub(super) lights: wgpu::Buffer,
    /// Group 2 of the scan.
    pub scan: wgpu::BindGroup,
    /// Group 2 of compaction.
    pub compact: wgpu::BindGroup,
    /// What the view's sweep writes.
    pub sweep: PatchSweep,
    pub(super) bytes: u64,
}

/// Group 2 of what lights plants.
#[derive(Debug)]
pub struct Lit {
    /// Of the patches' mean light.
    pub patch_light: wgpu::BindGroup,
    /// Of drawing.
    pub draw: wgpu::BindGroup,
}

impl ViewLists {
    /// Of a page that the view cannot see: nothing is run or drawn.
    pub fn count_nothing(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.clear_buffer(&self.counted, 0, None);
        encoder.clear_buffer(&self.draws, 0, None);
        encoder.clear_buffer(&self.indirect, 0, None);
    }
}

impl Page {
    /// Makes sure that view `index` has lists of `capacity` entries.
    pub fn ensure_view(
        &mut self,
        device: &wgpu::Device,
        layouts: &Layouts,
        index: usize,
        capacity: u32,
        blade_indices: &wgpu::Buffer,
    ) {
        if self.views.get(index).is_some_and(|v| v.capacity == capacity) {
            return;
        }
        let lists = self.view_lists(device, layouts, capacity, blade_indices);
        if index < self.views.len() {
            self.views[index] = lists;
        } else {
            self.views.push(lists);
        }
    }

    fn lit_groups(
        &self,
        device: &wgpu::Device,
        layouts: &Layouts,
        [view, list, draws, lights, seen]: [&wgpu::Buffer; 5],
    ) -> Lit {
        let canopy = &self.pictures.canopy;
        let patch_light = [view, &self.bands, canopy, lights, seen];
        let draw = [view, list, draws, lights, canopy];
        let bind = |label, layout, list| bindings::buffers(device, label, layout, list);
        Lit {
            patch_light: bind("sward.patch_light", &layouts.patch_light, &patch_light),
            draw: bind("sward.draw", &layouts.draw, &draw),
        }
    }

    /// Binds what was baked of the field to all lists.
    pub(super) fn bind_baked(&mut self, device: &wgpu::Device, layouts: &Layouts) {
        for index in 0..self.views.len() {
            let ViewLists { view, list, draws, lights, seen, .. } = &self.views[index];
            let buffers = [view, list, draws, lights, &seen.numbers];
            self.views[index].lit = self.lit_groups(device, layouts, buffers);
        }
    }

    fn view_lists(
        &self,
        device: &wgpu::Device,
        layouts: &Layouts,
        capacity: u32,
        blade_indices: &wgpu::Buffer,
    ) -> ViewLists {
        debug_assert_eq!(blade_indices.size(), SCAN_BLADE_INDICES_BYTES);
        let store = |label, bytes, more| storage(device, label, bytes, more);
        let none = BufferUsages::empty();
        let view = uniform(device, "sward.view", size_of::<GpuView>() as u64);
        let list = store("sward.list", u64::from(capacity) * 4, none);
        let draws_bytes = (BUCKETS * size_of::<GpuDraw>()) as u64;
        let draws = store("sward.draws", draws_bytes, BufferUsages::UNIFORM);
        let lights = store("sward.patch_lights", u64::from(self.field.patch_count) * 16, none);
        let indirect = store("sward.indirect", BUCKETS as u64 * 20, BufferUsages::INDIRECT);
        let counted = store("sward.counted", 32, none);
        let seen = Seen::new(device);
        let bind =
            |label, layout, list: &[&wgpu::Buffer]| bindings::buffers(device, label, layout, list);
        let sweep = PatchSweep::new(device, layouts, self.grid.as_ref(), &view);
        let update = [&view, &self.bands, &self.work, &self.dynamics, &self.near, &self.decisions];
        let scan = [
            &view,
            &self.bands,
            &self.blocks,
            &draws,
            &indirect,
            &counted,
            blade_indices,
            &seen.numbers,
        ];
        let compact = [&view, &self.bands, &self.blocks, &self.work, &self.decisions, &list];
        ViewLists {
            capacity,
            buckets: Buckets::default(),
            variant: self.variant,
            known: Known::default(),
            cull: bind(
                "sward.cull",
                &layouts.cull,
                &[&view, &self.bands, &self.work, &self.work_size, &sweep.columns, &seen.numbers],
            ),
            sweep,
            update: bind("sward.update", &layouts.update, &update),
            scan: bind("sward.scan", &layouts.scan, &scan),
            compact: bind("sward.compact", &layouts.compact, &compact),
            bytes: list.size() + lights.size(),
            lit: self.lit_groups(device, layouts, [&view, &list, &draws, &lights, &seen.numbers]),
            lights,
            seen,
            list,
            view,
            draws,
            indirect,
            counted,
        }
    }
}
