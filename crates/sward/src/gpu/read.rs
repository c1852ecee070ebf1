//! Buffers back from the device, with a wait.

use crate::Error;

/// Appends what a buffer holds after all submitted work.
pub fn append(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    buffer: &wgpu::Buffer,
    target: &mut Vec<u8>,
) -> Result<(), Error> {
    let lost = |cause: &dyn std::fmt::Display| {
        Error::state(format!("cannot be read back from the device: {cause}"))
    };
    let staging = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("sward.read"),
        size: buffer.size(),
        usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_buffer_to_buffer(buffer, 0, &staging, 0, buffer.size());
    queue.submit([encoder.finish()]);
    let (sender, receiver) = std::sync::mpsc::channel();
    staging.map_async(wgpu::MapMode::Read, .., move |result| {
        // Nobody listens where the wait below failed
        let _ = sender.send(result);
    });
    device.poll(wgpu::PollType::wait_indefinitely()).map_err(|error| lost(&error))?;
    // Another thread that polls may be the one that calls back
    let mapped = receiver.recv().map_err(|error| lost(&error))?;
    mapped.map_err(|error| lost(&error))?;
    let view = staging.get_mapped_range(..).map_err(|error| lost(&error))?;
    target.extend_from_slice(&view);
    Ok(())
}
