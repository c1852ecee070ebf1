//! Depth of field: two copies, the second blurred on from the first, and the mix by distance.

use super::super::frame::FrameUniform;
use super::super::fullscreen::{FullscreenDesc, Input};
use super::Filter;
use crate::gpu::COLOR_FORMAT;
use sward_scene::DepthOfFieldSettings;

/// Widest blur, as a standard deviation in heights of the picture: it costs with its width.
const MOST_BLUR: f32 = 0.03;
/// The wider copy's blur in that of what is infinitely far: things close before the lens need more.
const WIDER: f32 = 2.5;

/// The passes.
#[derive(Debug)]
pub(super) struct DepthOfField {
    copy: Filter,
    halve: Filter,
    /// Of each copy: along x, then along y.
    blurs: [[Filter; 2]; 2],
    focused: Filter,
}

impl DepthOfField {
    pub fn new(device: &wgpu::Device, frame: &FrameUniform, size: [u32; 2]) -> Self {
        let half = size.map(|side| side.div_ceil(2));
        let quarter = half.map(|side| side.div_ceil(2));
        let base = FullscreenDesc {
            name: "copy",
            source: "",
            formats: &[COLOR_FORMAT; 2],
            samples: 1,
            inputs: &[Input::Color; 2],
            constants: &[],
            background: false,
        };
        let lensed = |rest: &str| [include_str!("lens.wgsl"), rest].join("\n");
        let copy = lensed(include_str!("copy.wgsl"));
        let blur = lensed(include_str!("blur.wgsl"));
        let focused = lensed(include_str!("focused.wgsl"));
        let along = |level: f64, along_x: f64, size| {
            let constants = &[("LEVEL", level), ("ALONG_X", along_x)];
            let desc = FullscreenDesc { name: "blur", source: &blur, constants, ..base };
            Filter::new(device, frame, size, &desc)
        };
        let blurs = |level, size| [along(level, 1.0, size), along(level, 0.0, size)];
        let copy = FullscreenDesc { source: &copy, ..base };
        let halve = FullscreenDesc { name: "halve", source: include_str!("halve.wgsl"), ..base };
        let focused = FullscreenDesc {
            name: "focused",
            source: &focused,
            formats: &[COLOR_FORMAT],
            inputs: &[Input::Color; 6],
            ..base
        };
        Self {
            copy: Filter::new(device, frame, half, &copy),
            halve: Filter::new(device, frame, quarter, &halve),
            blurs: [blurs(0.0, half), blurs(1.0, quarter)],
            focused: Filter::new(device, frame, size, &focused),
        }
    }

    /// From colour and positions to the colour that a lens shows.
    pub fn run(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameUniform,
        [color, position]: [&wgpu::TextureView; 2],
    ) -> &wgpu::TextureView {
        let step = |encoder: &mut _, filter: &Filter, from: &[&wgpu::TextureView]| {
            filter.run(device, encoder, frame, from);
        };
        let first: Vec<_> = self.blurs[0][1].to.iter().collect();
        let sources = [(&self.copy, vec![color, position]), (&self.halve, first)];
        for ((shrink, from), [along_x, along_y]) in sources.iter().zip(&self.blurs) {
            step(encoder, shrink, from);
            step(encoder, along_x, &shrink.to.iter().collect::<Vec<_>>());
            step(encoder, along_y, &along_x.to.iter().collect::<Vec<_>>());
        }
        let copies = self.blurs.iter().flat_map(|[_, along_y]| &along_y.to);
        let from: Vec<_> = [color, position].into_iter().chain(copies).collect();
        self.focused.run(device, encoder, frame, &from)
    }
}

/// What the shaders know of the lens: metres in focus; pixels across of the disc that a point
/// infinitely far is blurred to; standard deviations of the two copies, pixels. `focal` is the
/// camera's: 1 / tan of half its vertical view.
pub(in crate::stage) fn lens(
    settings: Option<DepthOfFieldSettings>,
    focal: f32,
    height_px: f32,
) -> [f32; 4] {
    let Some(DepthOfFieldSettings { focus_m, aperture_m }) = settings else { return [0.0; 4] };
    // A point far behind the focus shows as the whole opening does at the plane in focus
    let disc_px = aperture_m * 0.5 * height_px * focal / focus_m;
    let widest = (WIDER * disc_px / 4.0).min(MOST_BLUR * height_px);
    [focus_m, disc_px, widest / WIDER, widest]
}
