//! A renderer with one field: stepped, culled and read back.

use crate::frame::level::continuum_twin::anchor_count;
use crate::gpu::layout::{BAND, GpuBand, GpuDraw};
use crate::gpu::lists::ViewLists;
use crate::gpu::page::Page;
use crate::gpu::test_device;
use crate::{Field, Frame, Renderer, Statistics, Targets, View};
use std::sync::OnceLock;

/// A device and its queue.
pub(super) type Gpu = (wgpu::Device, wgpu::Queue);

/// The device that most tests share.
pub(super) fn shared() -> Gpu {
    static SHARED: OnceLock<Gpu> = OnceLock::new();
    SHARED.get_or_init(test_device::device).clone()
}

pub(super) struct Rig {
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
    pub renderer: Renderer,
    pub field: Field,
    statistics: Option<Statistics>,
}

impl Rig {
    pub fn new(field: Field) -> Self {
        Self::on(shared(), field)
    }

    pub fn on((device, queue): Gpu, field: Field) -> Self {
        let targets = Targets::single_sampled(wgpu::TextureFormat::Rgba8Unorm);
        let mut renderer = Renderer::new(&device, targets).expect("the device has the limits");
        renderer.add_field(&device, &field).expect("the field fits");
        Self { device, queue, renderer, field, statistics: None }
    }

    /// The same renderer with another field: pipelines are dear.
    pub fn replace(&mut self, field: Field) {
        self.renderer.clear();
        self.renderer.add_field(&self.device, &field).expect("the field fits");
        self.field = field;
    }

    /// Records with the renderer and waits for the work.
    pub fn submit<T>(
        &mut self,
        record: impl FnOnce(&mut Renderer, &Gpu, &mut wgpu::CommandEncoder) -> T,
    ) -> T {
        let gpu = (self.device.clone(), self.queue.clone());
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let result = record(&mut self.renderer, &gpu, &mut encoder);
        self.queue.submit([encoder.finish()]);
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("the work ends");
        // Another test's thread may be the one that is told of the mapping
        while self.renderer.counts_in_flight() {
            std::thread::yield_now();
        }
        self.statistics = self.renderer.statistics(&self.device);
        result
    }

    pub fn simulate(&mut self, frame: &Frame) {
        self.submit(|renderer, (device, _), encoder| {
            renderer.simulate(device, encoder, frame).expect("valid frame");
        });
    }

    pub fn cull(&mut self, views: &[View]) {
        self.submit(|renderer, (device, _), encoder| {
            renderer.cull(device, encoder, views).expect("valid views");
        });
    }

    pub fn step(&mut self, frame: &Frame, views: &[View]) {
        self.submit(|renderer, (device, _), encoder| {
            renderer.simulate(device, encoder, frame).expect("valid frame");
            renderer.cull(device, encoder, views).expect("valid views");
        });
    }

    /// The counts of the last work.
    pub fn statistics(&self) -> Statistics {
        self.statistics.expect("something was culled")
    }

    pub fn read<T: bytemuck::Pod>(&self, buffer: &wgpu::Buffer) -> Vec<T> {
        test_device::read(&self.device, &self.queue, buffer)
    }

    pub fn page(&self, index: usize) -> &Page {
        &self.renderer.pages()[index]
    }

    pub fn lists(&self, view: usize) -> &ViewLists {
        &self.page(0).views[view]
    }

    /// Packed states of page 0.
    pub fn states(&self) -> Vec<[u32; 2]> {
        let words = self.read(&self.page(0).dynamics);
        words[..self.page(0).field.blade_count as usize].to_vec()
    }

    pub fn write_states(&self, states: &[[u32; 2]]) {
        self.queue.write_buffer(&self.page(0).dynamics, 0, bytemuck::cast_slice(states));
    }

    pub fn bands(&self) -> Vec<GpuBand> {
        self.read(&self.page(0).bands)
    }

    /// Patches at work in page 0, in order: index, whether wholly inside, blades that are kept, and
    /// whether only its anchors are run.
    pub fn all_work(&self) -> Vec<(u32, bool, u32, bool)> {
        let size: Vec<u32> = self.read(&self.page(0).work_size);
        let entries: Vec<[u32; 2]> = self.read(&self.page(0).work);
        let (bands, far) = entries.split_at(self.bands().len());
        let entry = |e: &[u32; 2], far| (e[0] & 0x7fff_ffff, e[0] >> 31 == 1, e[1] & 0xffff, far);
        let first = bands[..size[0] as usize].iter().filter(|e| e[1] >> 16 == 0);
        let mut work: Vec<_> = first.map(|e| entry(e, false)).collect();
        work.extend(far[..size[8] as usize].iter().map(|e| entry(e, true)));
        work.sort_unstable();
        work
    }

    /// The same where no patch is far.
    pub fn work(&self) -> Vec<(u32, bool, u32)> {
        let work = self.all_work();
        assert!(work.iter().all(|entry| !entry.3));
        work.iter().map(|(patch, inside, kept, _)| (*patch, *inside, *kept)).collect()
    }

    /// What was decided for each blade of page 0: none for a blade that was not dispatched.
    pub fn decisions(&self) -> Vec<Option<u16>> {
        let field = self.page(0).field;
        let all: Vec<u16> = self.read(&self.page(0).decisions);
        let mut decided = vec![None; field.blade_count as usize];
        for (patch, _, kept, far) in self.all_work() {
            let first = patch * field.patch_size;
            let count = field.patch_size.min(field.blade_count - first);
            let run = if far { anchor_count(count) } else { kept.div_ceil(BAND) * BAND };
            for index in (first..first + run.min(count)).map(|i| i as usize) {
                decided[index] = Some(all[index]);
            }
        }
        decided
    }

    /// The draw list of a view in page 0, and each bucket's range.
    pub fn list(&self, view: usize) -> (Vec<u32>, Vec<GpuDraw>) {
        let draws: Vec<GpuDraw> = self.read(&self.lists(view).draws);
        let mut list: Vec<u32> = self.read(&self.lists(view).list);
        list.truncate(draws.iter().map(|d| d.count as usize).sum());
        (list, draws)
    }
}
