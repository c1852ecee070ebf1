//! What is baked of each field, when a view first needs it.

use super::{Layouts, Renderer};
use crate::bake::canopy::{canopy, layers};
use crate::bake::cluster::clusters;
use crate::bake::stand::Stands;
use crate::gpu::page::Page;
use crate::gpu::pictures::Pictures;
use crate::{Field, Technique};
use std::ops::Range;

/// A field, as far as something may still be baked of it.
#[derive(Debug)]
pub(super) struct Unbaked {
    stands: Stands,
    pictures: Pictures,
    pages: Range<usize>,
}

impl Unbaked {
    /// A field that is in these pages, with the pictures of its plants.
    pub(super) fn new(field: &Field, pictures: Pictures, pages: Range<usize>) -> Self {
        Self { stands: Stands::of(field), pictures, pages }
    }

    fn bake(
        self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        layouts: &Layouts,
        pages: &mut [Page],
    ) {
        let clusters = clusters(&self.stands);
        let canopy = canopy(&self.stands, Some(&clusters));
        let [radius, height, mean_height, _] = canopy.size;
        let size = [mean_height, radius, height, self.stands.means.width()];
        let (cluster_color, color) = clusters.color.texture(device, "sward.cluster_color");
        let (cluster_shape, shape) = clusters.shape.texture(device, "sward.cluster_shape");
        color.iter().chain(&shape).for_each(|upload| upload.record(encoder));
        let layers = layers(&canopy);
        let canopy = Pictures::canopy_buffer(device, &canopy);
        let pictures = Pictures { cluster_color, cluster_shape, canopy, ..self.pictures };
        for page in pages.get_mut(self.pages).into_iter().flatten() {
            page.set_baked(device, encoder, layouts, (size, layers), &pictures);
        }
    }
}

impl Renderer {
    /// Bakes what a technique needs of the fields that are new.
    pub(super) fn bake(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        technique: Technique,
    ) {
        if technique == Technique::Continuum {
            for field in std::mem::take(&mut self.unbaked) {
                field.bake(device, encoder, &self.layouts, &mut self.pages);
            }
        }
    }
}
