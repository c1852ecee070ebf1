//! The scene's opaque things, twice: their depth before the grass, which is culled by it, and their
//! colour after, so that ground under the grass is not shaded.

use super::frame::FrameUniform;
use super::grass_look::GrassLook;
use super::meshes::{self, GpuMesh, GpuPlacement, VERTEX_BUFFERS};
use super::movers::Movers;
use super::swept::Swept;
use super::texture::{self, Uploader};
use crate::gpu::{COLOR_FORMAT, DEPTH_FORMAT, Gpu};
use sward::Technique;
use sward::frame::light::SHADE_WGSL;
use sward_scene::Scene;

/// Draws objects, and all that moves.
#[derive(Debug)]
pub(super) struct Opaque {
    depth: wgpu::RenderPipeline,
    color: wgpu::RenderPipeline,
    /// Those that rest.
    objects: Vec<GpuMesh>,
    /// Of those that carry grass, in scenes drawn by strips: the cells that the camera sees.
    swept: Vec<Option<Swept>>,
    moving: Vec<GpuMesh>,
    placed: Vec<Vec<GpuPlacement>>,
}

impl Opaque {
    pub fn new(
        gpu: &Gpu,
        frame: &FrameUniform,
        scene: &Scene,
        movers: &Movers,
        grass: &[GrassLook],
        (samples, technique): (u32, Technique),
    ) -> Self {
        let layout = texture::layout(&gpu.device);
        let uploader = Uploader::new(&gpu.device, &gpu.queue, &layout);
        let resting = (0..scene.objects.len())
            .filter(|&i| scene.objects[i].visible && scene.objects[i].path.is_none());
        let swept = resting.clone().map(|i| Swept::new(gpu, &scene.objects[i], technique));
        let swept = swept.collect();
        let objects = resting
            .map(|i| {
                let object = &scene.objects[i];
                let placement = meshes::object_placement(scene, i);
                let texture = uploader.upload(object.texture.as_ref(), &grass[i]);
                let mesh = meshes::with_normals(&object.mesh);
                GpuMesh::new(&gpu.device, &mesh, &[placement], texture)
            })
            .collect();
        let placed = movers.placements((-scene.warm_up_s).into());
        let things = movers.things(scene).into_iter().zip(&placed);
        let moving = things
            .map(|(thing, placed)| {
                let texture = uploader.upload(thing.texture, &GrassLook::none());
                GpuMesh::new(&gpu.device, &thing.mesh, placed, texture)
            })
            .collect();
        let shaded = scene.light().shade.depth > 0.0;
        let make =
            |colored| pipeline(&gpu.device, &frame.layout, &layout, (samples, shaded), colored);
        Self { depth: make(false), color: make(true), objects, swept, moving, placed }
    }

    /// Moves what moves; says whether anything has moved.
    pub fn place(&mut self, queue: &wgpu::Queue, placements: Vec<Vec<GpuPlacement>>) -> bool {
        let moved = placements != self.placed;
        if moved {
            for (mesh, placed) in self.moving.iter().zip(&placements) {
                mesh.place(queue, placed);
            }
            self.placed = placements;
        }
        moved
    }

    /// Lists what a camera sees of the swept grounds; before their depth is drawn for it.
    pub fn sweep(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        view: &sward::View,
    ) {
        for swept in self.swept.iter_mut().flatten() {
            swept.encode(device, encoder, view);
        }
    }

    /// Fills the depth.
    pub fn draw_depth(&self, pass: &mut wgpu::RenderPass, frame: &FrameUniform) {
        self.draw(pass, frame, &self.depth);
    }

    /// Colours what of it still shows.
    pub fn draw_color(&self, pass: &mut wgpu::RenderPass, frame: &FrameUniform) {
        self.draw(pass, frame, &self.color);
    }

    fn draw(
        &self,
        pass: &mut wgpu::RenderPass,
        frame: &FrameUniform,
        pipeline: &wgpu::RenderPipeline,
    ) {
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &frame.group, &[]);
        for (mesh, swept) in self.objects.iter().zip(&self.swept) {
            pass.set_bind_group(1, &mesh.texture, &[]);
            match swept.as_ref().and_then(Swept::listed) {
                Some(sweep) => mesh.draw_swept(pass, sweep),
                None => mesh.draw(pass),
            }
        }
        for mesh in &self.moving {
            pass.set_bind_group(1, &mesh.texture, &[]);
            mesh.draw(pass);
        }
    }
}

fn pipeline(
    device: &wgpu::Device,
    frame: &wgpu::BindGroupLayout,
    texture: &wgpu::BindGroupLayout,
    (samples, shaded): (u32, bool),
    colored: bool,
) -> wgpu::RenderPipeline {
    let label = "sward.stage.opaque";
    let shader = super::shader(
        device,
        label,
        &[
            SHADE_WGSL,
            sward::canopy::WGSL,
            include_str!("ground.wgsl"),
            include_str!("opaque.wgsl"),
        ],
    );
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(label),
        bind_group_layouts: &[Some(frame), Some(texture)],
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(label),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &shader,
            entry_point: Some("opaque_vertex"),
            compilation_options: Default::default(),
            buffers: &VERTEX_BUFFERS,
        },
        // Both sides are drawn: a Mobius strip has only one.
        primitive: Default::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH_FORMAT,
            depth_write_enabled: Some(!colored),
            depth_compare: Some(wgpu::CompareFunction::LessEqual),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
        fragment: colored.then_some(wgpu::FragmentState {
            module: &shader,
            entry_point: Some("opaque_fragment"),
            compilation_options: wgpu::PipelineCompilationOptions {
                constants: &[("SHADED", f64::from(u8::from(shaded)))],
                ..Default::default()
            },
            targets: &[Some(COLOR_FORMAT.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
