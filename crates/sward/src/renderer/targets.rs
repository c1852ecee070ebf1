//! What the host draws to.

use crate::Error;

/// Formats of the host's targets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Targets {
    /// Colour target that blades are drawn to, in linear light.
    pub color: wgpu::TextureFormat,
    /// Depth target; reversed depth is not supported yet: near is 0, far is 1.
    pub depth: wgpu::TextureFormat,
    /// Samples a pixel of both.
    pub samples: u32,
}

impl Targets {
    /// A colour format with a 32-bit depth, one sample a pixel.
    pub fn single_sampled(color: wgpu::TextureFormat) -> Self {
        Self { color, depth: wgpu::TextureFormat::Depth32Float, samples: 1 }
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        if self.color.is_depth_stencil_format() {
            return Err(Error::setting("targets.color", "must be a colour format"));
        }
        if !self.depth.has_depth_aspect() {
            return Err(Error::setting("targets.depth", "must be a depth format"));
        }
        if ![1, 2, 4, 8, 16].contains(&self.samples) {
            return Err(Error::setting("targets.samples", "must be 1, 2, 4, 8 or 16"));
        }
        Ok(())
    }
}
