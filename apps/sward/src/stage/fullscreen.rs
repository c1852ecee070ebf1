//! Passes of one triangle over the whole target: sky, accumulation, post.

use crate::gpu::DEPTH_FORMAT;

/// What a full-screen pass is made of.
pub(super) struct FullscreenDesc<'a> {
    /// Stem of its shader, and its entry point.
    pub name: &'a str,
    /// WGSL after `frame.wgsl` and `fullscreen.wgsl`.
    pub source: &'a str,
    pub format: wgpu::TextureFormat,
    /// Samples of the target.
    pub samples: u32,
    /// Number of textures in group 1.
    pub inputs: u32,
    /// Whether these are multisampled.
    pub multisampled: bool,
    /// Whether it is drawn only where nothing has been (depth is far).
    pub background: bool,
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
        let inputs = input_layout(device, &label, desc.inputs, desc.multisampled);
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(&label),
            bind_group_layouts: &[Some(frame), Some(&inputs)],
            immediate_size: 0,
        });
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
                compilation_options: Default::default(),
                targets: &[Some(desc.format.into())],
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

    /// Opens a pass of its own over a whole target and draws.
    pub fn run(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        target: &wgpu::TextureView,
        frame: &wgpu::BindGroup,
        inputs: &wgpu::BindGroup,
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: target,
                depth_slice: None,
                resolve_target: None,
                ops: Default::default(),
            })],
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

/// Textures that are read texel by texel, without a sampler.
fn input_layout(
    device: &wgpu::Device,
    label: &str,
    count: u32,
    multisampled: bool,
) -> wgpu::BindGroupLayout {
    let entries: Vec<_> = (0..count)
        .map(|binding| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty: wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: false },
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled,
            },
            count: None,
        })
        .collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some(label),
        entries: &entries,
    })
}
