//! The pipelines of drawing: one a bucket, in the variants that fields need.

use super::mesh::{Mesh, STRIP_SEGMENTS};
use super::topology::Topology;
use crate::Targets;
use crate::gpu::layout::{
    BILLBOARD_BUCKETS, BLADE_BUCKETS, CLUSTER_BUCKET, MODEL_BUCKET, STRIP_BUCKETS,
};
use crate::gpu::shaders::Shader;

/// What a field needs beyond the plain pipelines. Others do not pay for it: variants are made when
/// the first field that needs them is added.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Variant {
    /// Has a shape with lobes, cut pixel by pixel out of flat-tipped strips.
    pub(crate) lobed: bool,
    /// Has a colour for each blade.
    pub(crate) tinted: bool,
}

/// Shader and entry points of a pipeline.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Program<'a> {
    pub(crate) module: &'a wgpu::ShaderModule,
    pub(crate) vertex: &'a str,
    pub(crate) fragment: &'a str,
    /// Whether alpha decides how many samples of a pixel are covered.
    pub(crate) masked: bool,
}

/// What the pipeline of a bucket of blades is made with.
pub(crate) fn constants(bucket: usize, targets: Targets, tinted: bool) -> Vec<(&'static str, f64)> {
    let topology = Topology::of(bucket);
    vec![
        ("BUCKET", bucket as f64),
        ("SEGMENTS", f64::from(topology.segments)),
        ("RING", f64::from(topology.ring)),
        ("FLAT_TIP", f64::from(u8::from(topology.flat_tip))),
        ("VERTICES", f64::from(topology.vertices())),
        ("TINTED", f64::from(u8::from(tinted))),
        ("SAMPLES", f64::from(targets.samples)),
    ]
}

/// A pipeline of the layout.
pub(crate) fn pipeline(
    device: &wgpu::Device,
    layout: &wgpu::PipelineLayout,
    targets: Targets,
    program: Program,
    constants: &[(&str, f64)],
) -> wgpu::RenderPipeline {
    let options = wgpu::PipelineCompilationOptions { constants, ..Default::default() };
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("sward.draw"),
        layout: Some(layout),
        vertex: wgpu::VertexState {
            module: program.module,
            entry_point: Some(program.vertex),
            compilation_options: options.clone(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: targets.depth,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Less),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState {
            count: targets.samples,
            alpha_to_coverage_enabled: program.masked && targets.samples > 1,
            ..Default::default()
        },
        fragment: Some(wgpu::FragmentState {
            module: program.module,
            entry_point: Some(program.fragment),
            compilation_options: options,
            targets: &[Some(targets.color.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// The shader modules of drawing, each made when it is first needed.
#[derive(Debug, Default)]
pub(super) struct Modules(Vec<(Shader, wgpu::ShaderModule)>);

impl Modules {
    pub(super) fn get(&mut self, device: &wgpu::Device, shader: Shader) -> wgpu::ShaderModule {
        if let Some((_, module)) = self.0.iter().find(|(made, _)| *made == shader) {
            return module.clone();
        }
        let module = shader.module(device);
        self.0.push((shader, module.clone()));
        module
    }
}

/// The pipeline of a bucket; none for buckets that no plant is ever in.
pub(super) fn bucket_pipeline(
    device: &wgpu::Device,
    modules: &mut Modules,
    (layout, targets): (&wgpu::PipelineLayout, Targets),
    variant: Variant,
    bucket: usize,
) -> Option<wgpu::RenderPipeline> {
    match bucket {
        0..BLADE_BUCKETS => {
            Some(blade_pipeline(device, modules, (layout, targets), variant, bucket))
        }
        CLUSTER_BUCKET => {
            let module = &modules.get(device, Shader::DrawCluster);
            let program =
                Program { module, vertex: "vs_cluster", fragment: "fs_cluster", masked: false };
            let constants = form_constants(bucket, targets, variant.tinted);
            Some(pipeline(device, layout, targets, program, &constants))
        }
        _ if BILLBOARD_BUCKETS.contains(&bucket) => {
            Some(billboard_pipeline(device, modules, (layout, targets), bucket))
        }
        _ if STRIP_BUCKETS.contains(&bucket) => {
            Some(strip_pipeline(device, modules, (layout, targets), variant, bucket))
        }
        MODEL_BUCKET => Some(model_pipeline(device, modules, (layout, targets))),
        _ => None,
    }
}

/// What the pipeline of a bucket of another form than blades is made with.
pub(crate) fn form_constants(
    bucket: usize,
    targets: Targets,
    tinted: bool,
) -> Vec<(&'static str, f64)> {
    vec![
        ("BUCKET", bucket as f64),
        ("VERTICES", f64::from(Mesh::of(bucket).vertices)),
        ("TINTED", f64::from(u8::from(tinted))),
        ("SAMPLES", f64::from(targets.samples)),
    ]
}

fn model_pipeline(
    device: &wgpu::Device,
    modules: &mut Modules,
    (layout, targets): (&wgpu::PipelineLayout, Targets),
) -> wgpu::RenderPipeline {
    let constants =
        [("BUCKET", MODEL_BUCKET as f64), ("VERTICES", f64::from(Mesh::of(MODEL_BUCKET).vertices))];
    let module = &modules.get(device, Shader::DrawModel);
    let program = Program { module, vertex: "vs_model", fragment: "fs_model", masked: false };
    pipeline(device, layout, targets, program, &constants)
}

fn blade_pipeline(
    device: &wgpu::Device,
    modules: &mut Modules,
    (layout, targets): (&wgpu::PipelineLayout, Targets),
    variant: Variant,
    bucket: usize,
) -> wgpu::RenderPipeline {
    // The first level is near, the others far
    let near = bucket.is_multiple_of(4);
    let lobed = variant.lobed && bucket >= 4;
    let (shader, vertex, fragment) = match (lobed, near) {
        (true, true) => (Shader::DrawLobed, "vs_near_lobed", "fs_near_lobed"),
        (true, false) => (Shader::DrawLobed, "vs_far_lobed", "fs_far_lobed"),
        (false, true) => (Shader::Draw, "vs_near", "fs_near"),
        (false, false) => (Shader::Draw, "vs_far", "fs_far"),
    };
    let constants = constants(bucket, targets, variant.tinted);
    let module = &modules.get(device, shader);
    pipeline(
        device,
        layout,
        targets,
        Program { module, vertex, fragment, masked: false },
        &constants,
    )
}

/// Plants of quads: cut by alpha, with several samples a pixel by how many of them it covers.
fn billboard_pipeline(
    device: &wgpu::Device,
    modules: &mut Modules,
    (layout, targets): (&wgpu::PipelineLayout, Targets),
    bucket: usize,
) -> wgpu::RenderPipeline {
    let constants = [
        ("BUCKET", bucket as f64),
        ("VERTICES", f64::from(Mesh::of(bucket).vertices)),
        ("PIECES", if bucket == BILLBOARD_BUCKETS[0] { 2.0 } else { 1.0 }),
        ("SAMPLES", f64::from(targets.samples)),
    ];
    let module = &modules.get(device, Shader::DrawBillboard);
    let program = Program { module, vertex: "vs_quad", fragment: "fs_quad", masked: true };
    pipeline(device, layout, targets, program, &constants)
}

/// Strips: cut by alpha as plants of quads are.
fn strip_pipeline(
    device: &wgpu::Device,
    modules: &mut Modules,
    (layout, targets): (&wgpu::PipelineLayout, Targets),
    variant: Variant,
    bucket: usize,
) -> wgpu::RenderPipeline {
    let level = bucket - STRIP_BUCKETS[0];
    let constants = [
        ("BUCKET", bucket as f64),
        ("VERTICES", f64::from(Mesh::of(bucket).vertices)),
        ("TINTED", f64::from(u8::from(variant.tinted))),
        ("SEGMENTS", f64::from(STRIP_SEGMENTS[level])),
        ("COARSE", f64::from(STRIP_SEGMENTS[1])),
        ("SAMPLES", f64::from(targets.samples)),
    ];
    let module = &modules.get(device, Shader::DrawStrip);
    let program = Program { module, vertex: "vs_strip", fragment: "fs_strip", masked: true };
    pipeline(device, layout, targets, program, &constants)
}
