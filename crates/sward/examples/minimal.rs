//! A host's whole program: a device, a field, two seconds of wind, and blades in its own pass.
use glam::camera::rh::{proj::directx::perspective, view::look_at_mat4};
use glam::{UVec2, Vec2, Vec3};
use sward::*;
use wgpu::{InstanceDescriptor, LoadOp, Operations, StoreOp};

fn target(device: &wgpu::Device, format: wgpu::TextureFormat) -> wgpu::TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: 640, height: 360, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    });
    texture.create_view(&Default::default())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let instance = wgpu::Instance::new(InstanceDescriptor::new_without_display_handle_from_env());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default()))?;
    let (device, queue) = pollster::block_on(adapter.request_device(&Default::default()))?;
    let targets = Targets::single_sampled(wgpu::TextureFormat::Rgba16Float);
    let (color, depth) = (target(&device, targets.color), target(&device, targets.depth));
    let surface = Surface::new(Mesh::plane(Vec2::splat(20.0), UVec2::ONE)?)?;
    let field = Field::grow(&surface, &FieldDesc { density: 300.0, ..Default::default() })?;
    let mut renderer = Renderer::new(&device, targets)?;
    renderer.add_field(&device, &field)?;
    let mut wind = Wind::new(vec![WindSource::Gusts(Gusts::default())])?;
    let eye = look_at_mat4(Vec3::new(0.0, 1.6, 9.0), Vec3::ZERO, Vec3::Y);
    let view = View::new(eye, perspective(1.0, 16.0 / 9.0, 0.1, 200.0), [640, 360]);
    for _ in 0..120 {
        wind.advance(1.0 / 60.0);
        let frame = Frame::new(1.0 / 60.0, &wind);
        let mut encoder = device.create_command_encoder(&Default::default());
        renderer.simulate(&device, &mut encoder, &frame)?;
        renderer.cull(&device, &mut encoder, &[view])?;
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &color,
                depth_slice: None,
                resolve_target: None,
                ops: Operations::default(),
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &depth,
                depth_ops: Some(Operations { load: LoadOp::Clear(1.0), store: StoreOp::Store }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        renderer.draw(&mut pass, 0);
        drop(pass);
        queue.submit([encoder.finish()]);
    }
    println!("{:#?}", renderer.statistics(&device));
    Ok(())
}
