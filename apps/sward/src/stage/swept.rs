//! Ground drawn by the cells that the camera sees, in scenes drawn by strips.

use crate::gpu::Gpu;
use sward::{Sweep, Technique, View};
use sward_scene::Object;

/// Cells along the longer side of a ground.
const CELLS: f32 = 64.0;

/// A ground and its sweep.
#[derive(Debug)]
pub(super) struct Swept {
    sweep: Sweep,
    /// Whether it is of the camera that is drawn.
    is_listed: bool,
}

impl Swept {
    /// Of an object that carries grass and lies about level; none for others, which are drawn whole.
    pub fn new(gpu: &Gpu, object: &Object, technique: Technique) -> Option<Self> {
        if technique != Technique::Strips || !object.carries_grass {
            return None;
        }
        let positions = object.mesh.positions.iter().copied();
        let low = positions.clone().reduce(|a, b| a.min(b))?;
        let size = positions.reduce(|a, b| a.max(b))? - low;
        let side_m = size.x.max(size.z);
        if size.y > 0.5 * side_m {
            return None;
        }
        // One that does not fit the device is drawn whole, too
        let sweep = Sweep::new(&gpu.device, &object.mesh, side_m / CELLS).ok()?;
        Some(Self { sweep, is_listed: false })
    }

    /// Lists what a view sees.
    pub fn encode(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        view: &View,
    ) {
        self.is_listed = self.sweep.encode(device, encoder, view).is_ok();
    }

    /// The sweep, once it is of the camera.
    pub fn listed(&self) -> Option<&Sweep> {
        Some(&self.sweep).filter(|_| self.is_listed)
    }
}
