//! A page: up to four million blades of a field in buffers that one binding holds.

use super::bindings;
use super::buckets::Buckets;
use super::buffers::{filled, storage, write, write_at};
use super::layout::{
    BAND, GpuBand, GpuBlock, GpuField, GpuSpecies, GpuView, MAX_SPECIES, NEAR_STRIDE,
    TICKS_PER_SECOND,
};
use super::lists::ViewLists;
use super::packed::pack;
use super::pictures::Pictures;
use super::statistics::WORK_BYTES;
use crate::frame::cull::blocks::{BlockBox, block_boxes, patches_a_block, seen_blocks};
use crate::frame::draw::pipelines::Variant;
use crate::frame::sweep::grid::Grid;
use crate::renderer::Layouts;
use crate::{Field, Form, PhysicsModel, Shape, Technique};
use bytemuck::Zeroable;
use wgpu::BufferUsages;

/// Bytes of the species table.
pub const SPECIES_TABLE_BYTES: u64 = (MAX_SPECIES * size_of::<GpuSpecies>()) as u64;

/// Bytes of an entry of `Page::work`.
const WORK_ENTRY_BYTES: u64 = 8;
/// Most far patches that one group of lanes runs.
const FAR_PATCHES_A_GROUP: u32 = 32;
/// Where in `work_size` the arguments of the dispatch over far patches begin.
const FAR_GROUPS_AT: u64 = 20;
/// How much of `work_size` a view begins anew.
const VIEW_WORK_BYTES: u64 = 36;

/// How long a new blade counts as asleep, so that it wakes into the wind that blows.
const ASLEEP_AT_FIRST_S: f64 = 60.0;

/// Up to four million blades.
#[derive(Debug)]
pub struct Page {
    /// Counts.
    pub field: GpuField,
    /// Cells of its patches, where it lies about level.
    pub grid: Option<Grid>,
    /// Of everything that does not change.
    pub fingerprint: u64,
    /// Which draw lists its plants may be in, by technique.
    buckets: [Buckets; Technique::ALL.len()],
    /// Whether it has strips or billboards among its plants.
    pub other_forms: bool,
    /// Which pipelines draw it.
    pub variant: Variant,
    /// A colour a blade, or one word; for tests.
    #[cfg(test)]
    pub tints: wgpu::Buffer,
    /// Packed dynamic states.
    pub dynamics: wgpu::Buffer,
    /// `GpuBand` by 64 blades.
    pub bands: wgpu::Buffer,
    /// Chunks of colliders near each patch.
    pub near: wgpu::Buffer,
    /// Work entries of work.wgsl: bands, then far patches.
    pub work: wgpu::Buffer,
    /// Arguments of the dispatches over `work`, and counts, as work.wgsl numbers them.
    pub work_size: wgpu::Buffer,
    /// What `work_size` is reset to.
    work_reset: wgpu::Buffer,
    /// Bucket, morph and fade of each blade, two a word.
    pub decisions: wgpu::Buffer,
    pub(super) blocks: wgpu::Buffer,
    /// Where each of them lies.
    boxes: Vec<BlockBox>,
    /// Of its field: other pages may hold the same.
    pub pictures: Pictures,
    /// Bindings 0 to 4 of drawing.
    drawn: [wgpu::Buffer; 5],
    /// Group 1 of the compute stages.
    pub group: wgpu::BindGroup,
    /// Group 1 of drawing.
    pub draw_group: wgpu::BindGroup,
    /// Group 2 of the collider stage.
    pub collide: wgpu::BindGroup,
    /// Lists by view.
    pub views: Vec<ViewLists>,
    bytes: u64,
}

/// The state of a blade that stands straight up.
fn upright_state(model: PhysicsModel) -> [u32; 2] {
    match model {
        PhysicsModel::Sward => [0x7f_ffff, 0x7f_ffff],
        PhysicsModel::Paper => {
            let (center, length) = (0xffff_u32, (16383.0_f32 / 1.25).round() as u32);
            [center | center << 17, center >> 15 | length << 2]
        }
    }
}

fn first_bands(count: usize, ticks: u32) -> Vec<GpuBand> {
    let asleep = ticks.wrapping_sub((ASLEEP_AT_FIRST_S * TICKS_PER_SECOND) as u32);
    vec![GpuBand { ticks: asleep, anchor_ticks: asleep, ..GpuBand::zeroed() }; count]
}

/// Group 1 of drawing.
fn draw_group(
    device: &wgpu::Device,
    layouts: &Layouts,
    (drawn, bands): (&[wgpu::Buffer; 5], &wgpu::Buffer),
    pictures: &Pictures,
) -> wgpu::BindGroup {
    use wgpu::BindingResource::{Sampler, TextureView};
    let mut resources: Vec<_> = drawn.iter().map(|b| b.as_entire_binding()).collect();
    resources.extend([
        TextureView(&pictures.cluster_color),
        TextureView(&pictures.cluster_shape),
        TextureView(&pictures.plant_color),
        TextureView(&pictures.plant_normal),
        Sampler(&pictures.sampler),
        bands.as_entire_binding(),
        TextureView(&pictures.plant_models),
    ]);
    bindings::group(device, "sward.draw_field", &layouts.draw_field, &resources)
}

impl Page {
    /// Uploads a run of a field's patches.
    pub fn new(
        device: &wgpu::Device,
        layouts: &Layouts,
        (field, pictures): (&Field, &Pictures),
        species: &[GpuSpecies],
        patch_range: std::ops::Range<usize>,
        model: PhysicsModel,
        ticks: u32,
    ) -> Self {
        let packed = pack(field, patch_range.start, patch_range.len());
        let counts = packed.field;
        let band_count = u64::from(counts.patch_count * (counts.patch_size / BAND));
        let boxes = block_boxes(&packed.patches, patches_a_block(counts.patch_size));
        let data = |label, content: &[u8], usage| filled(device, label, content, usage);
        let store = |label, bytes| storage(device, label, bytes, BufferUsages::empty());
        let fingerprint = packed.fingerprint(species);
        let page = [bytemuck::bytes_of(&counts), bytemuck::cast_slice(species)].concat();
        let page = data("sward.page", &page, BufferUsages::UNIFORM);
        let blades =
            data("sward.blades", bytemuck::cast_slice(&packed.blades), BufferUsages::STORAGE);
        let tints = data("sward.tints", bytemuck::cast_slice(&packed.tints), BufferUsages::STORAGE);
        let patches =
            data("sward.patches", bytemuck::cast_slice(&packed.patches), BufferUsages::STORAGE);
        let states = vec![upright_state(model); packed.blades.len()];
        let dynamics = data("sward.dynamics", bytemuck::cast_slice(&states), BufferUsages::STORAGE);
        let clocks = first_bands(band_count as usize, ticks);
        let bands = data("sward.bands", bytemuck::cast_slice(&clocks), BufferUsages::STORAGE);
        let near = store("sward.near", u64::from(counts.patch_count * NEAR_STRIDE) * 4);
        let far_entries = u64::from(counts.patch_count + FAR_PATCHES_A_GROUP);
        let work = store("sward.work", (band_count + far_entries) * WORK_ENTRY_BYTES);
        let work_size = storage(device, "sward.work_size", WORK_BYTES, BufferUsages::INDIRECT);
        let reset = [0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0_u32];
        let work_reset =
            data("sward.work_reset", bytemuck::cast_slice(&reset), BufferUsages::empty());
        let decisions = store("sward.decisions", band_count * u64::from(BAND) * 2);
        let blocks = store("sward.blocks", (boxes.len() * size_of::<GpuBlock>()) as u64);
        let shared = [&page, &blades, &patches];
        let drawn = [&page, &blades, &patches, &dynamics, &tints].map(Clone::clone);
        let sized =
            [&blades, &tints, &patches, &dynamics, &bands, &near, &work, &decisions, &blocks];
        Self {
            field: counts,
            grid: packed.grid,
            fingerprint,
            buckets: Technique::ALL.map(|technique| Buckets::of(field.species(), technique)),
            other_forms: field.species().iter().any(|s| !matches!(s.form, Form::Blade)),
            variant: Variant {
                lobed: field.species().iter().any(|s| s.shape == Shape::Dandelion),
                tinted: !field.tints().is_empty(),
                ..Variant::default()
            },
            group: bindings::buffers(device, "sward.field", &layouts.field, &shared),
            draw_group: draw_group(device, layouts, (&drawn, &bands), pictures),
            collide: bindings::buffers(
                device,
                "sward.collide",
                &layouts.collide,
                &[&near, &work, &work_size],
            ),
            views: Vec::new(),
            bytes: sized.iter().map(|b| b.size()).sum(),
            #[cfg(test)]
            tints,
            dynamics,
            bands,
            near,
            work,
            work_size,
            work_reset,
            decisions,
            blocks,
            boxes,
            pictures: pictures.clone(),
            drawn,
        }
    }

    /// Empties the list of work and every count beside it.
    pub fn reset_all_work(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.copy_buffer_to_buffer(&self.work_reset, 0, &self.work_size, 0, WORK_BYTES);
    }

    /// Empties the list of work for a view; the collider stage's count stays, to be reported.
    pub fn reset_view_work(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.copy_buffer_to_buffer(&self.work_reset, 0, &self.work_size, 0, VIEW_WORK_BYTES);
        // The last group of far patches may not be full
        encoder.clear_buffer(&self.work, self.band_count() * WORK_ENTRY_BYTES, None);
    }

    /// Lists every band as work, with all its blades; the counts beside the list stay.
    pub fn work_on_all(&self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder) {
        let GpuField { blade_count, patch_count, patch_size, .. } = self.field;
        let bands_of = |patch: u32| {
            let count = patch_size.min(blade_count - patch * patch_size);
            (0..count.div_ceil(BAND)).map(move |band| [patch, count | band << 16])
        };
        let entries: Vec<[u32; 2]> = (0..patch_count).flat_map(bands_of).collect();
        write(device, encoder, &self.work, bytemuck::cast_slice(&entries));
        let size = [entries.len() as u32, 1, 1];
        write(device, encoder, &self.work_size, bytemuck::cast_slice(&size));
        write_at(device, encoder, &self.work_size, FAR_GROUPS_AT, bytemuck::bytes_of(&0_u32));
    }

    /// Finds the blocks that a view may see, or has it see all.
    pub fn see_blocks(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        index: usize,
        (view, all): (&GpuView, bool),
    ) {
        let numbers = if all {
            (0..self.block_count()).collect()
        } else {
            seen_blocks(&self.boxes, view, self.field.cluster)
        };
        self.views[index].seen.set(device, encoder, numbers);
    }

    /// Patches of a block.
    pub fn patches_a_block(&self) -> u32 {
        patches_a_block(self.field.patch_size)
    }

    /// One group a band at work, or a few far patches.
    pub fn dispatch_work(&self, pass: &mut wgpu::ComputePass, far: bool) {
        pass.dispatch_workgroups_indirect(&self.work_size, if far { FAR_GROUPS_AT } else { 0 });
    }

    fn band_count(&self) -> u64 {
        u64::from(self.field.patch_count * self.bands_per_patch())
    }

    /// Bands of a patch.
    pub fn bands_per_patch(&self) -> u32 {
        self.field.patch_size / BAND
    }

    /// Blocks of the scan.
    pub fn block_count(&self) -> u32 {
        self.boxes.len() as u32
    }

    /// The buffers that carry a simulation from one step to the next; all others are made anew in
    /// each.
    pub fn state(&self) -> [&wgpu::Buffer; 2] {
        [&self.dynamics, &self.bands]
    }

    /// Bytes of everything that grows with the blades, without the draw lists.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Bytes of the draw lists.
    pub fn list_bytes(&self) -> u64 {
        self.views.iter().map(|v| v.bytes).sum()
    }

    /// Stands every blade up again, for a model that keeps its state in other bits.
    pub fn reset(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        model: PhysicsModel,
        ticks: u32,
    ) {
        let states = vec![upright_state(model); self.field.blade_count as usize];
        write(device, encoder, &self.dynamics, bytemuck::cast_slice(&states));
        let clocks = first_bands((self.bands.size() / size_of::<GpuBand>() as u64) as usize, ticks);
        write(device, encoder, &self.bands, bytemuck::cast_slice(&clocks));
    }

    /// Gives it what was baked of its field: the size of its clusters, and pictures.
    pub fn set_baked(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        layouts: &Layouts,
        (cluster, layers): ([f32; 4], [f32; 2]),
        pictures: &Pictures,
    ) {
        self.field.cluster = cluster;
        self.field.layers = layers;
        write(device, encoder, &self.drawn[0], bytemuck::bytes_of(&self.field));
        self.draw_group = draw_group(device, layouts, (&self.drawn, &self.bands), pictures);
        self.pictures = pictures.clone();
        self.bind_baked(device, layouts);
    }

    /// Which draw lists its plants may be in, in a view of that technique.
    pub fn buckets(&self, technique: Technique) -> Buckets {
        self.buckets[technique as usize]
    }
}
