//! Debug views: their pipelines are made when one is first asked for.

use super::draw::mesh::Mesh;
use super::draw::pipelines::{DRAWING_FLAGS, Modules, Program, Variant, constants, pipeline};
use super::draw::topology::Topology;
use crate::gpu::bindings::{self, Kind, compute, layout};
use crate::gpu::buffers::{filled, storage};
use crate::gpu::layout::{
    BILLBOARD_BUCKETS, BLADE_BUCKETS, BUCKETS, CLUSTER_BUCKET, MODEL_BUCKET, STRIP_BUCKETS,
};
use crate::gpu::lists::ViewLists;
use crate::gpu::page::Page;
use crate::gpu::shaders::Shader;
use crate::gpu::variants::Variants;
use crate::gpu::view::Known;
use crate::renderer::Layouts;
use crate::{DebugView, Targets, View};
use bytemuck::{Pod, Zeroable};
use wgpu::{BufferUsages, ShaderStages};

/// Most indices of a blade, in vectors of four: `CORNER_STRIDE` of debug.wgsl.
pub(crate) const CORNER_STRIDE: usize = 24;

/// `GpuDebug` of debug.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub(crate) struct GpuDebug {
    pub mode: u32,
    pub reserved_a: u32,
    pub reserved_b: u32,
    pub reserved_c: u32,
    pub palette: [[f32; 4]; 10],
}

/// The pipelines, and what each view shows.
#[derive(Debug)]
pub(crate) struct Debug {
    explain_frame: wgpu::BindGroupLayout,
    explain_layout: wgpu::BindGroupLayout,
    /// Its modules, and pipelines by whether the depth is multisampled.
    explain: [wgpu::ShaderModule; 2],
    explain_made: Variants<(Known, bool)>,
    draw_layout: wgpu::BindGroupLayout,
    targets: Targets,
    /// By what is known of views, and by bucket; of those that a debug view can show.
    pipelines: Vec<(Known, Vec<Option<wgpu::RenderPipeline>>)>,
    indices: Vec<wgpu::Buffer>,
    corners: wgpu::Buffer,
    /// Reasons, by page.
    pub(crate) explained: Vec<wgpu::Buffer>,
    /// Of each view that shows one: what is known of it, and group 3 by page.
    views: Vec<Option<(Known, Vec<wgpu::BindGroup>)>>,
}

fn gpu_debug(view: DebugView) -> GpuDebug {
    let mut gpu = GpuDebug { mode: view.mode(), ..GpuDebug::zeroed() };
    for (slot, (_, [r, g, b])) in gpu.palette.iter_mut().zip(view.colors()) {
        *slot = [*r, *g, *b, 1.0];
    }
    gpu
}

/// Vertex of each index, by bucket of blades.
pub(crate) fn corners() -> Vec<u32> {
    let own = |bucket| {
        let mut list: Vec<u32> =
            Topology::of(bucket).indices().into_iter().map(u32::from).collect();
        list.resize(CORNER_STRIDE * 4, 0);
        list
    };
    (0..BLADE_BUCKETS).flat_map(own).collect()
}

/// The explaining shader for a depth of one sample, and of several.
const EXPLAIN: [Shader; 2] = [Shader::Explain, Shader::ExplainMultisampled];

/// Shader and entry points for each bucket that plants may be in.
fn program(bucket: usize) -> Option<(Shader, &'static str, &'static str)> {
    Some(match bucket {
        0..BLADE_BUCKETS => (Shader::DrawDebug, "vs_debug", "fs_debug"),
        CLUSTER_BUCKET => (Shader::DrawDebugCluster, "vs_debug_cluster", "fs_debug_cluster"),
        _ if STRIP_BUCKETS.contains(&bucket) => {
            (Shader::DrawDebugStrip, "vs_debug_strip", "fs_debug_strip")
        }
        _ if BILLBOARD_BUCKETS.contains(&bucket) => {
            (Shader::DrawDebugBillboard, "vs_debug_quad", "fs_debug_quad")
        }
        MODEL_BUCKET => (Shader::DrawDebugModel, "vs_debug_model", "fs_debug_model"),
        _ => return None,
    })
}

fn draw_pipelines(
    device: &wgpu::Device,
    layouts: &Layouts,
    own: &wgpu::BindGroupLayout,
    (targets, known): (Targets, Known),
) -> Vec<Option<wgpu::RenderPipeline>> {
    let groups = [&layouts.draw_frame, &layouts.draw_field, &layouts.draw, own];
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("sward.debug"),
        bind_group_layouts: &groups.map(Some),
        immediate_size: 0,
    });
    let mut modules = Modules::default();
    let mut make = |bucket| {
        let (shader, vertex, fragment) = program(bucket)?;
        let variant = Variant { known: Some(known), ..Variant::default() };
        let mut constants = constants(bucket, targets, variant);
        if bucket < BLADE_BUCKETS {
            constants.push(("INDICES", Mesh::of(bucket).indices.len() as f64));
        }
        let module = &modules.get(device, shader);
        let program = Program { module, vertex, fragment, masked: false };
        Some(pipeline(device, &layout, targets, program, &constants))
    };
    (0..BUCKETS).map(&mut make).collect()
}

impl Debug {
    pub(crate) fn new(device: &wgpu::Device, targets: Targets) -> Self {
        use Kind::{Read, Uniform, Write};
        let compute_layout =
            |kinds: &[Kind]| layout(device, "sward.explain", ShaderStages::COMPUTE, kinds);
        let explain_frame = compute_layout(&[Uniform]);
        let explain_layout = compute_layout(&[Uniform, Write, Read, Read, Write, Write]);
        let stages = ShaderStages::VERTEX_FRAGMENT;
        let draw_layout = layout(device, "sward.debug", stages, &[Uniform, Uniform, Read]);
        let index_buffer = |bucket| {
            let mut list = Mesh::of(bucket).instance_indices();
            if bucket < BLADE_BUCKETS {
                // Their triangles have vertices of their own
                list = (0..list.len() as u16).collect();
            }
            let content = bytemuck::cast_slice(&list);
            filled(device, "sward.debug_indices", content, BufferUsages::INDEX)
        };
        Self {
            explain: EXPLAIN.map(|shader| shader.module(device)),
            explain_made: Variants::default(),
            explain_frame,
            explain_layout,
            draw_layout,
            targets,
            pipelines: Vec::new(),
            indices: (0..BUCKETS).map(index_buffer).collect(),
            corners: filled(
                device,
                "sward.debug_corners",
                bytemuck::cast_slice(&corners()),
                BufferUsages::UNIFORM,
            ),
            explained: Vec::new(),
            views: Vec::new(),
        }
    }

    /// Says what a view shows: a debug view over these pages, or its own look.
    pub(crate) fn set_view(
        &mut self,
        (device, layouts): (&wgpu::Device, &Layouts),
        pages: &[Page],
        index: usize,
        view: &View,
    ) {
        if self.views.len() <= index {
            self.views.resize_with(index + 1, || None);
        }
        let room = |page: &Page| u64::from(page.field.blade_count) * 4;
        let fits = |(page, buffer): (&Page, &wgpu::Buffer)| buffer.size() >= room(page);
        let sized = pages.iter().zip(&self.explained);
        if self.explained.len() != pages.len() || !sized.into_iter().all(fits) {
            let make = |page| storage(device, "sward.explained", room(page), BufferUsages::empty());
            self.explained = pages.iter().map(make).collect();
        }
        let known = Known::of(view).only(DRAWING_FLAGS);
        if view.debug.is_some() && self.pipelines.iter().all(|(made, _)| *made != known) {
            let made = draw_pipelines(device, layouts, &self.draw_layout, (self.targets, known));
            self.pipelines.push((known, made));
        }
        let group = |view| {
            let uniform = gpu_debug(view);
            let content = bytemuck::bytes_of(&uniform);
            let uniform = filled(device, "sward.debug", content, BufferUsages::UNIFORM);
            let bind = |explained: &wgpu::Buffer| {
                let list = [&uniform, &self.corners, explained];
                bindings::buffers(device, "sward.debug", &self.draw_layout, &list)
            };
            (known, self.explained.iter().map(bind).collect())
        };
        self.views[index] = view.debug.map(group);
    }

    /// Lists every blade of a page, with the reasons. The frame's uniform is that of the step.
    pub(crate) fn encode_explain(
        &self,
        (device, layouts): (&wgpu::Device, &Layouts),
        encoder: &mut wgpu::CommandEncoder,
        frame: &wgpu::Buffer,
        (number, page, lists): (usize, &Page, &ViewLists),
        (depth, multisampled): (&wgpu::BindGroup, bool),
    ) {
        let Some(explained) = self.explained.get(number) else { return };
        page.work_on_all(device, encoder);
        let frame = bindings::buffers(device, "sward.explain", &self.explain_frame, &[frame]);
        let own =
            [&lists.view, &page.bands, &page.dynamics, &page.near, &page.decisions, explained];
        let own = bindings::buffers(device, "sward.explain", &self.explain_layout, &own);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some("sward.explain"),
            timestamp_writes: None,
        });
        let depth_layout = if multisampled { &layouts.depth_multisampled } else { &layouts.depth };
        let make = || {
            let groups = [&self.explain_frame, &layouts.field, &self.explain_layout, depth_layout];
            let module = &self.explain[usize::from(multisampled)];
            compute(device, module, "explain", &groups, &lists.known.constants())
        };
        pass.set_pipeline(&self.explain_made.get((lists.known, multisampled), make));
        pass.set_bind_group(0, &frame, &[]);
        pass.set_bind_group(1, &page.group, &[]);
        pass.set_bind_group(2, &own, &[]);
        pass.set_bind_group(3, depth, &[]);
        pass.dispatch_workgroups(page.field.patch_count, page.bands_per_patch(), 1);
    }

    /// Draws a page's blades of a view, if it shows a debug view; says whether it does. Group 0 is
    /// set.
    pub(crate) fn encode(
        &self,
        pass: &mut wgpu::RenderPass,
        (number, page): (usize, &Page),
        view: usize,
    ) -> bool {
        let Some(Some((known, groups))) = self.views.get(view) else { return false };
        let made = self.pipelines.iter().find(|(made, _)| made == known);
        let (Some(lists), Some(own)) = (page.views.get(view), groups.get(number)) else {
            return true;
        };
        pass.set_bind_group(1, &page.draw_group, &[]);
        pass.set_bind_group(2, &lists.lit.draw, &[]);
        pass.set_bind_group(3, own, &[]);
        for bucket in lists.buckets.iter() {
            let Some(pipeline) = made.and_then(|(_, list)| list[bucket].as_ref()) else { continue };
            pass.set_pipeline(pipeline);
            pass.set_index_buffer(self.indices[bucket].slice(..), wgpu::IndexFormat::Uint16);
            pass.draw_indexed_indirect(&lists.indirect, bucket as u64 * 20);
        }
        true
    }
}
