//! The bind group layouts: 0 frame, 1 field, 2 stage, 3 the host's depth.

use crate::gpu::bindings::{self, Kind, layout};
use wgpu::{BindGroupLayout, ShaderStages};

/// Every layout of the pipelines.
#[derive(Debug)]
pub(crate) struct Layouts {
    pub(crate) frame: BindGroupLayout,
    pub(crate) draw_frame: BindGroupLayout,
    pub(crate) field: BindGroupLayout,
    pub(crate) draw_field: BindGroupLayout,
    pub(crate) collide: BindGroupLayout,
    pub(crate) cull: BindGroupLayout,
    pub(crate) update: BindGroupLayout,
    pub(crate) patch_light: BindGroupLayout,
    pub(crate) scan: BindGroupLayout,
    pub(crate) sweep: BindGroupLayout,
    pub(crate) compact: BindGroupLayout,
    pub(crate) draw: BindGroupLayout,
    pub(crate) depth: BindGroupLayout,
    pub(crate) depth_multisampled: BindGroupLayout,
    /// Stands in where a view has no depth; never read.
    pub(crate) no_depth: wgpu::BindGroup,
    /// Stand in where a field has none.
    pub(crate) no_pictures: crate::gpu::pictures::Pictures,
}

fn empty_depth(device: &wgpu::Device) -> wgpu::TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("sward.no_depth"),
        size: wgpu::Extent3d::default(),
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Depth32Float,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

impl Layouts {
    pub(crate) fn new(device: &wgpu::Device) -> Self {
        use Kind::{Depth, Pictures, Read, Sampler, Texels, Uniform, Words, Write};
        let compute =
            |label: &str, kinds: &[Kind]| layout(device, label, ShaderStages::COMPUTE, kinds);
        let draw = |label: &str, kinds: &[Kind]| {
            layout(device, label, ShaderStages::VERTEX_FRAGMENT, kinds)
        };
        let depth = compute("sward.depth", &[Depth { multisampled: false }]);
        let nothing = empty_depth(device);
        let resource = wgpu::BindingResource::TextureView(&nothing);
        Self {
            frame: compute("sward.frame", &[Uniform, Read, Texels]),
            draw_frame: draw("sward.draw_frame", &[Uniform]),
            field: compute("sward.field", &[Uniform, Read, Read]),
            draw_field: layout(
                device,
                "sward.draw_field",
                ShaderStages::VERTEX_FRAGMENT,
                &[
                    Uniform, Read, Read, Read, Read, Pictures, Pictures, Pictures, Pictures,
                    Sampler, Read, Words,
                ],
            ),
            collide: compute("sward.collide", &[Write, Write, Write]),
            cull: compute("sward.cull", &[Uniform, Write, Write, Write, Read, Uniform]),
            sweep: compute("sward.sweep", &[Uniform, Uniform, Write]),
            update: compute("sward.update", &[Uniform, Write, Read, Write, Read, Write]),
            patch_light: compute("sward.patch_light", &[Uniform, Read, Uniform, Write, Uniform]),
            scan: compute(
                "sward.scan",
                &[Uniform, Write, Write, Write, Write, Write, Uniform, Uniform],
            ),
            compact: compute("sward.compact", &[Uniform, Read, Read, Read, Read, Write]),
            draw: draw("sward.draw", &[Uniform, Read, Uniform, Read, Uniform]),
            depth_multisampled: compute("sward.depth", &[Depth { multisampled: true }]),
            no_depth: bindings::group(device, "sward.no_depth", &depth, &[resource]),
            depth,
            no_pictures: crate::gpu::pictures::Pictures::none(device),
        }
    }

    /// Group 3 for the host's depth, and whether it is multisampled.
    pub(crate) fn depth_group(
        &self,
        device: &wgpu::Device,
        depth: Option<&wgpu::TextureView>,
    ) -> (Option<wgpu::BindGroup>, bool) {
        let Some(view) = depth else { return (None, false) };
        let multisampled = view.texture().sample_count() > 1;
        let layout = if multisampled { &self.depth_multisampled } else { &self.depth };
        let resource = wgpu::BindingResource::TextureView(view);
        (Some(bindings::group(device, "sward.depth", layout, &[resource])), multisampled)
    }
}
