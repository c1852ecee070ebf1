//! A device for tests. A test that needs one fails loudly without it.

/// The first adapter's device, with default limits.
pub(crate) fn device() -> (wgpu::Device, wgpu::Queue) {
    with_limits(wgpu::Limits::default())
}

/// The first adapter's device, with these limits.
pub(crate) fn with_limits(required_limits: wgpu::Limits) -> (wgpu::Device, wgpu::Queue) {
    let instance =
        wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter = pollster::block_on(
        instance.request_adapter(&wgpu::RequestAdapterOptions::default()),
    )
    .expect(
        "these tests need a GPU adapter; on Debian or Ubuntu: apt-get install mesa-vulkan-drivers",
    );
    let descriptor = wgpu::DeviceDescriptor { required_limits, ..Default::default() };
    pollster::block_on(adapter.request_device(&descriptor)).expect("the adapter has the limits")
}

/// What a buffer holds, after all submitted work.
pub(crate) fn read<T: bytemuck::Pod>(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    buffer: &wgpu::Buffer,
) -> Vec<T> {
    let staging = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("test.read"),
        size: buffer.size(),
        usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_buffer_to_buffer(buffer, 0, &staging, 0, buffer.size());
    queue.submit([encoder.finish()]);
    staging.map_async(wgpu::MapMode::Read, .., |result| result.expect("the buffer maps"));
    device.poll(wgpu::PollType::wait_indefinitely()).expect("the work ends");
    let view = staging.get_mapped_range(..).expect("the buffer is mapped");
    bytemuck::pod_collect_to_vec(&view[..])
}
