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
    let mut bytes = Vec::new();
    super::read::append(device, queue, buffer, &mut bytes).expect("the buffer is read back");
    bytemuck::pod_collect_to_vec(&bytes)
}
