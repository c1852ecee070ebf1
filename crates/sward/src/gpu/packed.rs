//! A run of a field's patches as the words that a page's buffers hold.

use super::fingerprint;
use super::layout::{GpuField, GpuPatch, GpuSpecies};
use super::quantize::{gpu_patch, pack_blade};
use crate::Field;
use crate::frame::sweep::grid::Grid;
use crate::frame::sweep::patches::{NO_CELL, patch_grid};
use crate::grow::Patch;
use rayon::prelude::*;

/// Content of a page's buffers.
pub struct Packed {
    /// Counts.
    pub field: GpuField,
    /// Static words of each blade.
    pub blades: Vec<[u32; 4]>,
    /// A colour a blade; one that is never read where the field has none.
    pub tints: Vec<u32>,
    /// Boxes and cells.
    pub patches: Vec<GpuPatch>,
    /// The cells that a sweep goes through, where the patches lie flat.
    pub grid: Option<Grid>,
}

impl Packed {
    /// Stands for what does not change.
    pub fn fingerprint(&self, species: &[GpuSpecies]) -> u64 {
        let parts: [&[u8]; 4] = [
            bytemuck::bytes_of(&self.field),
            bytemuck::cast_slice(&self.blades),
            bytemuck::cast_slice(&self.patches),
            bytemuck::cast_slice(species),
        ];
        parts.into_iter().map(fingerprint::of).fold(0, fingerprint::fold)
    }
}

/// Packs a run of patches.
pub fn pack(field: &Field, first_patch: usize, patch_count: usize) -> Packed {
    let patches = &field.patches()[first_patch..first_patch + patch_count];
    let cells = patch_grid(patches);
    let blades = patches
        .par_iter()
        .flat_map_iter(|patch| {
            let own = patch.first as usize..(patch.first + patch.count) as usize;
            field.blades()[own]
                .iter()
                .map(|b| pack_blade(b, patch, &field.species()[usize::from(b.species)]))
        })
        .collect::<Vec<_>>();
    Packed {
        field: GpuField {
            blade_count: blades.len() as u32,
            patch_count: patch_count as u32,
            patch_size: field.patch_size(),
            first_id: patches.first().map_or(0, |p| p.first),
            cluster: [0.0; 4],
            ..bytemuck::Zeroable::zeroed()
        },
        patches: gpu_patches(field, patches, cells.as_ref()),
        grid: cells.map(|(grid, _)| grid),
        tints: tints(field, patches),
        blades,
    }
}

fn gpu_patches(
    field: &Field,
    patches: &[Patch],
    cells: Option<&(Grid, Vec<u32>)>,
) -> Vec<GpuPatch> {
    let own = |(i, patch)| {
        let cell = cells.and_then(|(_, cells)| cells.get(i)).copied().unwrap_or(NO_CELL);
        GpuPatch { cell, ..gpu_patch(patch, field.blades()) }
    };
    patches.iter().enumerate().map(own).collect()
}

fn tints(field: &Field, patches: &[Patch]) -> Vec<u32> {
    let own = |patch: &Patch| {
        let run = patch.first as usize..(patch.first + patch.count) as usize;
        field.tints().get(run).unwrap_or_default().to_vec()
    };
    let mut tints: Vec<u32> = patches.iter().flat_map(own).collect();
    if tints.is_empty() {
        tints.push(0);
    }
    tints
}
