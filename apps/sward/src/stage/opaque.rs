//! The scene's opaque things, twice: their depth before the grass, which is culled by it, and their
//! colour after, so that ground under the grass is not shaded.

use super::frame::FrameUniform;
use super::grass_look::GrassLook;
use super::meshes::{self, GpuMesh, GpuPlacement, VERTEX_BUFFERS};
use super::movers::Movers;
use super::parts::Which;
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
    /// Of what shows no grass in the place of grass, and of ground that may.
    color: [wgpu::RenderPipeline; 2],
    /// Those that rest, and the look of the grass on them.
    objects: Vec<(GpuMesh, GrassLook)>,
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
                (GpuMesh::resting(&gpu.device, mesh, placement, texture), grass[i])
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
        let color = [false, true].map(|canopy| make(Some(canopy)));
        Self { depth: make(None), color, objects, swept, moving, placed }
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
        pass.set_pipeline(&self.depth);
        self.draw(pass, frame, Which::All);
    }

    /// Colours what of it still shows.
    pub fn draw_color(&self, pass: &mut wgpu::RenderPass, frame: &FrameUniform) {
        for (pipeline, which) in self.color.iter().zip([Which::Near, Which::Far]) {
            pass.set_pipeline(pipeline);
            self.draw(pass, frame, which);
        }
    }

    fn draw(&self, pass: &mut wgpu::RenderPass, frame: &FrameUniform, which: Which) {
        pass.set_bind_group(0, &frame.group, &[]);
        for ((mesh, grass), swept) in self.objects.iter().zip(&self.swept) {
            pass.set_bind_group(1, &mesh.texture, &[]);
            let shows_from_m = grass.shows_from_m(frame.focal_px());
            match swept.as_ref().and_then(Swept::listed) {
                // What is swept shows no grass: its technique ends nowhere
                Some(sweep) if which != Which::Far => mesh.draw_swept(pass, sweep),
                Some(_) => {}
                None => mesh.draw_parts(pass, &mesh.seen(frame.camera(), which, shows_from_m)),
            }
        }
        for mesh in self.moving.iter().filter(|_| which != Which::Far) {
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
    // Whether it may show the look of grass; none for the depth alone
    colored: Option<bool>,
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
    let on = |x: bool| f64::from(u8::from(x));
    let constants = [("SHADED", on(shaded)), ("CANOPY", on(colored == Some(true)))];
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
            depth_write_enabled: Some(colored.is_none()),
            depth_compare: Some(wgpu::CompareFunction::LessEqual),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
        fragment: colored.is_some().then_some(wgpu::FragmentState {
            module: &shader,
            entry_point: Some("opaque_fragment"),
            compilation_options: wgpu::PipelineCompilationOptions {
                constants: &constants,
                ..Default::default()
            },
            targets: &[Some(COLOR_FORMAT.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
