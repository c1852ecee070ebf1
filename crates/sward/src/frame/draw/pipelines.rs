//! The pipelines of drawing: one a bucket, in the variants that fields need.

use super::mesh::{Mesh, STRIP_SEGMENTS};
use super::topology::Topology;
use crate::Targets;
use crate::gpu::layout::{
    BILLBOARD_BUCKETS, BLADE_BUCKETS, CLUSTER_BUCKET, MODEL_BUCKET, STRIP_BUCKETS,
};
use crate::gpu::shaders::Shader;
use crate::gpu::view::{DISTANCE, Known, PAPER, WIDTH_CORRECTION};

/// Flags of a view that drawing asks for.
pub(crate) const DRAWING_FLAGS: u32 = DISTANCE | PAPER | WIDTH_CORRECTION;

/// What a field and a view need beyond the plain pipelines. Others do not pay for it: variants are made
/// when they are first needed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Variant {
    /// Has a shape with lobes, cut pixel by pixel out of flat-tipped strips.
    pub(crate) lobed: bool,
    /// Has a colour for each blade.
    pub(crate) tinted: bool,
    /// Lies in moving shade.
    pub(crate) shaded: bool,
    /// Keeps J's state.
    pub(crate) paper: bool,
    /// Seen so; with the flags that drawing asks for.
    pub(crate) known: Option<Known>,
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

/// What the pipeline of a bucket is made with.
pub(crate) fn constants(
    bucket: usize,
    targets: Targets,
    variant: Variant,
) -> Vec<(&'static str, f64)> {
    let own = match bucket {
        0..BLADE_BUCKETS => {
            let topology = Topology::of(bucket);
            vec![
                ("SEGMENTS", f64::from(topology.segments)),
                ("RING", f64::from(topology.ring)),
                ("FLAT_TIP", f64::from(u8::from(topology.flat_tip))),
            ]
        }
        _ if BILLBOARD_BUCKETS.contains(&bucket) => {
            vec![("PIECES", if bucket == BILLBOARD_BUCKETS[0] { 2.0 } else { 1.0 })]
        }
        _ if STRIP_BUCKETS.contains(&bucket) => {
            let level = bucket - STRIP_BUCKETS[0];
            vec![
                ("SEGMENTS", f64::from(STRIP_SEGMENTS[level])),
                ("COARSE", f64::from(STRIP_SEGMENTS[1])),
            ]
        }
        _ => Vec::new(),
    };
    let all = [
        ("BUCKET", bucket as f64),
        ("VERTICES", f64::from(Mesh::of(bucket).vertices)),
        ("TINTED", f64::from(u8::from(variant.tinted))),
        ("SHADED", f64::from(u8::from(variant.shaded))),
        ("SAMPLES", f64::from(targets.samples)),
    ];
    // Where it is not known, the shader asks the view
    let known = variant.known.map(|known| {
        let [technique, flags] = known.constants();
        [technique, flags, ("MODEL", f64::from(u8::from(variant.paper)))]
    });
    [&all[..], &own, known.as_slice().as_flattened()].concat()
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
pub(crate) struct Modules(Vec<(Shader, wgpu::ShaderModule)>);

impl Modules {
    pub(crate) fn get(&mut self, device: &wgpu::Device, shader: Shader) -> wgpu::ShaderModule {
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
    let (shader, vertex, fragment, masked) = match bucket {
        0..BLADE_BUCKETS => blade_program(variant, bucket),
        CLUSTER_BUCKET if targets.samples == 1 => {
            (Shader::DrawCluster, "vs_cluster", "fs_cluster_single", false)
        }
        CLUSTER_BUCKET => (Shader::DrawCluster, "vs_cluster", "fs_cluster", false),
        // Cut by alpha, with several samples a pixel by how many of them it covers
        _ if BILLBOARD_BUCKETS.contains(&bucket) => {
            (Shader::DrawBillboard, "vs_quad", "fs_quad", true)
        }
        _ if STRIP_BUCKETS.contains(&bucket) => (Shader::DrawStrip, "vs_strip", "fs_strip", true),
        MODEL_BUCKET => (Shader::DrawModel, "vs_model", "fs_model", false),
        _ => return None,
    };
    let module = &modules.get(device, shader);
    let program = Program { module, vertex, fragment, masked };
    Some(pipeline(device, layout, targets, program, &constants(bucket, targets, variant)))
}

fn blade_program(variant: Variant, bucket: usize) -> (Shader, &'static str, &'static str, bool) {
    // The first level is near, the others far
    let near = bucket.is_multiple_of(4);
    let lobed = variant.lobed && bucket >= 4;
    match (lobed, near) {
        (true, true) => (Shader::DrawLobed, "vs_near_lobed", "fs_near_lobed", false),
        (true, false) => (Shader::DrawLobed, "vs_far_lobed", "fs_far_lobed", false),
        (false, true) => (Shader::Draw, "vs_near", "fs_near", false),
        (false, false) => (Shader::Draw, "vs_far", "fs_far", false),
    }
}
