//! Passes of one triangle over the whole target: sky, accumulation, post.

use crate::gpu::DEPTH_FORMAT;

/// What a full-screen pass is made of.
#[derive(Debug, Clone, Copy)]
pub(super) struct FullscreenDesc<'a> {
    /// Stem of its shader, and its entry point.
    pub name: &'a str,
    /// WGSL after `frame.wgsl` and `fullscreen.wgsl`.
    pub source: &'a str,
    /// Of its targets.
    pub formats: &'a [wgpu::TextureFormat],
    /// Samples of the targets.
    pub samples: u32,
    /// Textures in group 1.
    pub inputs: &'a [Input],
    /// Values of the shader's overrides.
    pub constants: &'a [(&'a str, f64)],
    /// Whether it is drawn only where nothing has been (depth is far).
    pub background: bool,
}

/// A texture that is read texel by texel, without a sampler.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Input {
    Color,
    /// All samples of a multisampled colour.
    Samples,
    Depth {
        multisampled: bool,
    },
}

/// A pipeline over the whole screen.
#[derive(Debug)]
pub(super) struct Fullscreen {
    pipeline: wgpu::RenderPipeline,
    inputs: wgpu::BindGroupLayout,
}

impl Fullscreen {
    pub fn new(
        device: &wgpu::Device,
        frame: &wgpu::BindGroupLayout,
        desc: &FullscreenDesc,
    ) -> Self {
        let label = format!("sward.stage.{}", desc.name);
        let shader = super::shader(device, &label, &[include_str!("fullscreen.wgsl"), desc.source]);
        let inputs = input_layout(device, &label, desc.inputs);
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(&label),
            bind_group_layouts: &[Some(frame), Some(&inputs)],
            immediate_size: 0,
        });
        let targets: Vec<_> = desc.formats.iter().map(|&format| Some(format.into())).collect();
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(&label),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &shader,
                entry_point: Some("fullscreen"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: Default::default(),
            depth_stencil: desc.background.then(background_depth),
            multisample: wgpu::MultisampleState { count: desc.samples, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: &shader,
                entry_point: Some(desc.name),
                compilation_options: wgpu::PipelineCompilationOptions {
                    constants: desc.constants,
                    ..Default::default()
                },
                targets: &targets,
            }),
            multiview_mask: None,
            cache: None,
        });
        Self { pipeline, inputs }
    }

    /// Group 1 of the pass.
    pub fn bind(&self, device: &wgpu::Device, views: &[&wgpu::TextureView]) -> wgpu::BindGroup {
        let entries: Vec<_> = (0..)
            .zip(views)
            .map(|(binding, view)| wgpu::BindGroupEntry {
                binding,
                resource: wgpu::BindingResource::TextureView(view),
            })
            .collect();
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.inputs,
            entries: &entries,
        })
    }

    /// Draws into a pass that has been opened.
    pub fn draw(
        &self,
        pass: &mut wgpu::RenderPass,
        frame: &wgpu::BindGroup,
        inputs: &wgpu::BindGroup,
    ) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, inputs, &[]);
        pass.draw(0..3, 0..1);
    }

    /// Opens a pass of its own over whole targets and draws.
    pub fn run<'a>(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        targets: &[&'a wgpu::TextureView],
        frame: &wgpu::BindGroup,
        inputs: &wgpu::BindGroup,
    ) {
        let attachment = |view: &&'a wgpu::TextureView| {
            Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target: None,
                ops: Default::default(),
            })
        };
        let attachments: Vec<_> = targets.iter().map(attachment).collect();
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &attachments,
            ..Default::default()
        });
        self.draw(&mut pass, frame, inputs);
    }
}

fn background_depth() -> wgpu::DepthStencilState {
    wgpu::DepthStencilState {
        format: DEPTH_FORMAT,
        depth_write_enabled: Some(false),
        depth_compare: Some(wgpu::CompareFunction::LessEqual),
        stencil: Default::default(),
        bias: Default::default(),
    }
}

fn input_layout(device: &wgpu::Device, label: &str, inputs: &[Input]) -> wgpu::BindGroupLayout {
    use wgpu::TextureSampleType as Sample;
    let entries: Vec<_> = (0..)
        .zip(inputs)
        .map(|(binding, input)| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty: wgpu::BindingType::Texture {
                sample_type: match input {
                    Input::Color | Input::Samples => Sample::Float { filterable: false },
                    Input::Depth { .. } => Sample::Depth,
                },
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: matches!(input, Input::Samples | Input::Depth { multisampled: true }),
            },
            count: None,
        })
        .collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some(label),
        entries: &entries,
    })
}
