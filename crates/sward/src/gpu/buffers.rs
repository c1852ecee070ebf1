//! Buffers: creation with a running total of bytes, and writes that keep the encoder's order.

use wgpu::BufferUsages;
use wgpu::util::DeviceExt;

/// Storage that only shaders write.
pub fn storage(device: &wgpu::Device, label: &str, bytes: u64, more: BufferUsages) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: bytes.max(16),
        usage: BufferUsages::STORAGE | BufferUsages::COPY_DST | BufferUsages::COPY_SRC | more,
        mapped_at_creation: false,
    })
}

/// A buffer with content.
pub fn filled(
    device: &wgpu::Device,
    label: &str,
    content: &[u8],
    usage: BufferUsages,
) -> wgpu::Buffer {
    device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some(label),
        contents: content,
        usage: usage | BufferUsages::COPY_DST | BufferUsages::COPY_SRC,
    })
}

/// An empty uniform buffer.
pub fn uniform(device: &wgpu::Device, label: &str, bytes: u64) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: bytes,
        usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

/// Writes at this point of the encoder. `Queue::write_buffer` would act before all of it, so that
/// of two steps encoded together both would see the second one's values.
pub fn write(
    device: &wgpu::Device,
    encoder: &mut wgpu::CommandEncoder,
    target: &wgpu::Buffer,
    content: &[u8],
) {
    write_at(device, encoder, target, 0, content);
}

/// [`write()`] from an offset on.
pub fn write_at(
    device: &wgpu::Device,
    encoder: &mut wgpu::CommandEncoder,
    target: &wgpu::Buffer,
    offset: u64,
    content: &[u8],
) {
    if content.is_empty() {
        return;
    }
    let source = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("sward.write"),
        contents: content,
        usage: BufferUsages::COPY_SRC,
    });
    encoder.copy_buffer_to_buffer(&source, 0, target, offset, content.len() as u64);
}
