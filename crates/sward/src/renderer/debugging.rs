//! Debug views and observers: what follows a view's culling where a host asks for them.

use super::Renderer;
use crate::frame::debug::Debug;
use crate::gpu::buffers;
use crate::gpu::view::gpu_view;
use crate::{Stage, View};

impl Renderer {
    /// Does what a view asks for beyond its lists: a debug view, another camera to look from.
    pub(super) fn finish_view(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        index: usize,
        view: &View,
    ) {
        if view.debug.is_some() && self.debug.is_none() {
            self.debug = Some(Debug::new(device, self.draw.targets));
        }
        if let Some(debug) = &mut self.debug {
            debug.set_view((device, &self.layouts), &self.pages, index, view);
        }
        if view.debug.is_some_and(|debug| debug.shows_all()) {
            self.explain(device, encoder, index, view);
        }
        let Some(observer) = view.observer else { return };
        let seen = View {
            view_from_world: observer.view_from_world,
            clip_from_view: observer.clip_from_view,
            ..*view
        };
        for lists in self.pages.iter().filter_map(|page| page.views.get(index)) {
            let uniform = gpu_view(&seen, lists.capacity);
            buffers::write(device, encoder, &lists.view, bytemuck::bytes_of(&uniform));
        }
    }

    /// Lists every blade anew, with the reasons why it was drawn or not.
    fn explain(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        index: usize,
        view: &View,
    ) {
        let Some(debug) = &self.debug else { return };
        let (depth, multisampled) = self.layouts.depth_group(device, view.opaque_depth);
        let depth = (depth.as_ref().unwrap_or(&self.layouts.no_depth), multisampled);
        for (number, page) in self.pages.iter().enumerate() {
            let Some(lists) = page.views.get(index) else { continue };
            let frame = self.inputs.frame();
            debug.encode_explain(
                (device, &self.layouts),
                encoder,
                frame,
                (number, page, lists),
                depth,
            );
        }
        self.encode_stage(device, encoder, Stage::Compact, index, view);
    }
}
