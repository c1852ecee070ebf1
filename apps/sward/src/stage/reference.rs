//! The reference: 8 x 8 samples a pixel. What is drawn is the picture 8 times as wide and high, in
//! tiles that fit the device, each averaged in linear light. So every blade's vertices are worked
//! out once a tile, and not once a sample.

use super::Stage;
use super::frame::FrameUniform;
use super::fullscreen::Fullscreen;
use super::light::{SUM_FORMAT, averaging};
use super::post::{Drawn, Position};
use super::targets::{Targets, texture};
use crate::gpu::Gpu;
use anyhow::Result;
use glam::{Mat4, Vec2, Vec3};

/// Samples a side of a pixel.
const SIDE: u32 = 8;
/// Most samples of a tile; with colour and depth, 12 bytes each, 604 MB.
const MOST_SAMPLES: u32 = 8192 * 6144;

/// A part of the picture, and how finely it is sampled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crop {
    /// Its corner in the picture, upper left, pixels.
    pub origin: Vec2,
    /// Pixels; it may reach beyond the picture.
    pub size: [u32; 2],
    /// Samples of the target that a side of a pixel has.
    pub side: f32,
}

impl Crop {
    /// All of a picture, a sample of the target a pixel.
    pub fn whole(size: [u32; 2]) -> Self {
        Self { origin: Vec2::ZERO, size, side: 1.0 }
    }

    /// From the clip space of a whole picture of `size` to the part's.
    pub fn clip_from_picture(self, size: [u32; 2]) -> Mat4 {
        if self.origin == Vec2::ZERO && self.size == size {
            return Mat4::IDENTITY;
        }
        let vec = |[x, y]: [u32; 2]| Vec2::new(x as f32, y as f32);
        let (picture, part) = (vec(size), vec(self.size));
        // Rows run down, clip space up
        let center = (self.origin * 2.0 + part) / picture - 1.0;
        let scale = picture / part;
        Mat4::from_scale(scale.extend(1.0))
            * Mat4::from_translation(Vec3::new(-center.x, center.y, 0.0))
    }
}

/// The parts that a picture is drawn in: all of one size, from left to right, then down.
fn tiles(size: [u32; 2], most_side: u32) -> Vec<Crop> {
    let most = (most_side / SIDE).max(1);
    let fitted = |length: u32, most: u32| length.div_ceil(length.div_ceil(most.max(1)));
    let width = fitted(size[0], most);
    let height = fitted(size[1], most.min(MOST_SAMPLES / (SIDE * SIDE * width)));
    let tile = |x: u32, y: u32| Crop {
        origin: Vec2::new(x as f32, y as f32),
        size: [width, height],
        side: SIDE as f32,
    };
    let columns = || (0..size[0]).step_by(width as usize);
    let rows = (0..size[1]).step_by(height as usize);
    rows.flat_map(|y| columns().map(move |x| tile(x, y))).collect()
}

/// What a reference is drawn to: a tile's samples, the tile averaged, and all of them together.
#[derive(Debug)]
pub(super) struct Supersampled {
    tiles: Vec<Crop>,
    samples: Targets,
    average: Fullscreen,
    inputs: wgpu::BindGroup,
    tile: wgpu::Texture,
    tile_view: wgpu::TextureView,
    linear: wgpu::Texture,
    linear_view: wgpu::TextureView,
    /// Where what is done to the picture at the end needs them.
    positions: Option<Positions>,
}

/// World positions: a tile's, and all of them together.
#[derive(Debug)]
struct Positions {
    tile: Position,
    whole: wgpu::Texture,
    whole_view: wgpu::TextureView,
}

impl Positions {
    fn new(device: &wgpu::Device, frame: &FrameUniform, tile: [u32; 2], size: [u32; 2]) -> Self {
        use wgpu::TextureUsages as U;
        let (name, usage) = ("sward.stage.positions", U::TEXTURE_BINDING | U::COPY_DST);
        let whole = texture(device, name, size, SUM_FORMAT, 1, usage);
        Self {
            tile: Position::new(device, frame, tile, 1),
            whole_view: whole.create_view(&Default::default()),
            whole,
        }
    }
}

impl Supersampled {
    fn new(gpu: &Gpu, frame: &FrameUniform, size: [u32; 2]) -> Self {
        let device = &gpu.device;
        let tiles = tiles(size, device.limits().max_texture_dimension_2d);
        let tile_size = tiles.first().map_or(size, |tile| tile.size);
        let samples = Targets::without_picture(device, tile_size.map(|side| side * SIDE));
        let average = averaging(device, frame, false);
        let inputs = average.bind(device, &[samples.linear()]);
        use wgpu::TextureUsages as U;
        let tile_usage = U::RENDER_ATTACHMENT | U::COPY_SRC;
        let tile = texture(device, "sward.stage.tile", tile_size, SUM_FORMAT, 1, tile_usage);
        let usage = U::TEXTURE_BINDING | U::COPY_DST | U::COPY_SRC;
        let linear = texture(device, "sward.stage.linear", size, SUM_FORMAT, 1, usage);
        Self {
            tile_view: tile.create_view(&Default::default()),
            linear_view: linear.create_view(&Default::default()),
            tiles,
            samples,
            average,
            inputs,
            tile,
            linear,
            positions: None,
        }
    }

    /// The whole picture, averaged.
    pub fn linear(&self) -> &wgpu::Texture {
        &self.linear
    }

    /// Records the average of a tile's samples into its place, and their positions.
    fn average(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameUniform,
        crop: Crop,
        depth: &wgpu::TextureView,
    ) {
        self.average.run(encoder, &[&self.tile_view], &frame.group, &self.inputs);
        into_place(encoder, &self.tile, &self.linear, crop);
        if let Some(Positions { tile, whole, .. }) = &self.positions {
            tile.run(device, encoder, frame, depth);
            into_place(encoder, tile.target(), whole, crop);
        }
    }
}

/// Copies a tile to where it belongs in the whole.
fn into_place(
    encoder: &mut wgpu::CommandEncoder,
    tile: &wgpu::Texture,
    whole: &wgpu::Texture,
    crop: Crop,
) {
    let [x, y] = crop.origin.as_uvec2().to_array();
    let mut to = whole.as_image_copy();
    to.origin = wgpu::Origin3d { x, y, z: 0 };
    let extent = wgpu::Extent3d {
        width: crop.size[0].min(whole.width() - x),
        height: crop.size[1].min(whole.height() - y),
        depth_or_array_layers: 1,
    };
    encoder.copy_texture_to_texture(tile.as_image_copy(), to, extent);
}

impl Stage {
    /// Draws the reference up to the encoded picture.
    pub(super) fn render_reference(&mut self) -> Result<()> {
        self.draw_reference()?;
        let Some(target) = &self.supersampled else { return Ok(()) };
        let mut encoder = self.encoder();
        let position = target.positions.as_ref().map(|positions| &positions.whole_view);
        let drawn = Drawn { color: &target.linear_view, position };
        let (device, picture) = (&self.gpu.device, &self.targets.picture_view);
        self.post.run(device, &mut encoder, &self.uniform, drawn, picture);
        self.submit(encoder);
        Ok(())
    }

    /// Draws the reference in linear light.
    pub(super) fn draw_reference(&mut self) -> Result<()> {
        let mut target = match self.supersampled.take() {
            Some(target) => target,
            None => Supersampled::new(&self.gpu, &self.uniform, self.options.size),
        };
        let tile_size = target.tiles.first().map_or(self.options.size, |tile| tile.size);
        if self.post.needs_positions() && target.positions.is_none() {
            let (device, frame) = (&self.gpu.device, &self.uniform);
            target.positions = Some(Positions::new(device, frame, tile_size, self.options.size));
        }
        std::mem::swap(&mut self.targets, &mut target.samples);
        let drawn = self.draw_tiles(&target);
        std::mem::swap(&mut self.targets, &mut target.samples);
        self.crop = Crop::whole(self.options.size);
        self.depth_is_opaque = false;
        self.write_camera();
        self.supersampled = Some(target);
        drawn
    }

    /// Draws all tiles to the samples that are the stage's targets for now.
    fn draw_tiles(&mut self, target: &Supersampled) -> Result<()> {
        for &tile in &target.tiles {
            self.crop = tile;
            self.depth_is_opaque = false;
            self.write_camera();
            let mut encoder = self.encoder();
            self.encode_opaque(&mut encoder);
            self.encode_cull(&mut encoder)?;
            self.encode_draw(&mut encoder);
            // The tile's samples are the stage's targets
            target.average(
                &self.gpu.device,
                &mut encoder,
                &self.uniform,
                tile,
                &self.targets.depth,
            );
            self.submit(encoder);
            self.gpu.wait()?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::readback;
    use super::*;
    use glam::{Vec4, Vec4Swizzles};

    #[test]
    fn tiles_cover_the_picture_once_and_fit() {
        for size in [[1, 1], [640, 480], [1024, 768], [1280, 720], [3840, 2160], [1025, 7]] {
            for most in [2048, 8192, 32_768] {
                let tiles = tiles(size, most);
                let mut covered = 0;
                for tile in &tiles {
                    let [w, h] = tile.size;
                    assert!(w * 8 <= most && h * 8 <= most && w * h * 64 <= MOST_SAMPLES);
                    let origin = tile.origin.as_uvec2().to_array();
                    let inside = |i: usize| tile.size[i].min(size[i] - origin[i]);
                    covered += inside(0) * inside(1);
                }
                assert_eq!(covered, size[0] * size[1], "{size:?} in {}", tiles.len());
            }
        }
        assert_eq!(tiles([1024, 768], 8192).len(), 1);
    }

    #[test]
    fn a_point_of_the_picture_lies_where_its_tile_has_it() {
        let size = [1000, 600];
        for tile in tiles(size, 2048) {
            let clip = Vec4::new(0.3, -0.2, 0.4, 2.0);
            let pixel = |clip: Vec4, [w, h]: [u32; 2]| {
                let ndc = clip.xy() / clip.w;
                (ndc * Vec2::new(0.5, -0.5) + 0.5) * Vec2::new(w as f32, h as f32)
            };
            let in_tile = pixel(tile.clip_from_picture(size) * clip, tile.size);
            assert!((in_tile + tile.origin - pixel(clip, size)).length() < 1e-2);
        }
    }

    const SCENE: &str = "(
        objects: [
            (name: \"ground\", source: Terrain(size_m: 6, relief_m: 0.6, hill_m: 4, seed: 2)),
            (name: \"rock\", source: Rock(radius_m: 0.4), above: \"ground\", at: [(0.4, 1)]),
        ],
        fields: [(on: Object(\"ground\"), density: 60)],
        cameras: [(eye: (0, 1.2, 3.4), target: (0, 0.4, 0))],
        warm_up_s: 0,
    )";

    /// The mean of 64 pictures with one sample a pixel, at the reference's 64 places.
    fn by_passes(gpu: &Gpu, stage: &mut Stage) -> Vec<Vec4> {
        let size = stage.options.size;
        let mut target = Supersampled::new(gpu, &stage.uniform, size);
        target.inputs = target.average.bind(&gpu.device, &[stage.targets.linear()]);
        let mut sums = vec![Vec4::ZERO; (size[0] * size[1]) as usize];
        for i in 0..SIDE * SIDE {
            let place = Vec2::new((i % SIDE) as f32, (i / SIDE) as f32) + 0.5;
            let shifted = Crop { origin: place / SIDE as f32 - 0.5, ..Crop::whole(size) };
            target.tiles = vec![shifted];
            stage.draw_tiles(&target).unwrap();
            let picture = readback::floats(gpu, &target.linear).unwrap();
            sums.iter_mut().zip(picture).for_each(|(sum, pixel)| *sum += pixel / 64.0);
        }
        sums
    }

    #[test]
    fn tiles_show_what_64_shifted_pictures_do() {
        let gpu = Gpu::headless().expect("a graphics adapter");
        let scene = sward_scene::parse(SCENE, std::path::Path::new("s.ron")).unwrap();
        let fields = crate::grow::grow(&scene, &gpu.device.limits(), Default::default()).unwrap();
        let mut options = super::super::StageOptions::new(&scene, None, [80, 60], 1).unwrap();
        options.reference = true;
        let mut stage = Stage::new(&gpu, &scene, &fields, options).unwrap();
        stage.warm_up().unwrap();
        stage.render_reference().unwrap();
        let read = |stage: &Stage| {
            readback::floats(&gpu, &stage.supersampled.as_ref().unwrap().linear).unwrap()
        };
        let whole = read(&stage);
        let expected = by_passes(&gpu, &mut stage);
        let off = |a: &[Vec4], b: &[Vec4]| {
            let off = a.iter().zip(b).map(|(a, b)| (*a - *b).abs().truncate().max_element());
            let all: Vec<f32> = off.collect();
            let mean = all.iter().sum::<f32>() / all.len() as f32;
            [mean, all.into_iter().fold(0.0, f32::max)]
        };
        let light = expected.iter().map(|p| p.y).sum::<f32>() / expected.len() as f32;
        assert!(light > 0.05, "it is dark: {light}");
        // A few samples lie so near to an edge that rounding decides.
        let near = |[mean, worst]: [f32; 2]| mean < 2e-3 * light && worst < 0.15 * light;
        let passes = off(&whole, &expected);
        assert!(near(passes), "off by {passes:?} of {light}");
        // In tiles of 20 x 20 pixels the same comes out.
        let mut small = Supersampled::new(&gpu, &stage.uniform, [20, 20]);
        small.tiles = tiles([80, 60], 160);
        small.linear = stage.supersampled.take().unwrap().linear;
        small.linear_view = small.linear.create_view(&Default::default());
        stage.supersampled = Some(small);
        stage.render_reference().unwrap();
        let tiled = off(&read(&stage), &whole);
        assert!(near(tiled), "tiles: off by {tiled:?} of {light}");
    }
}
