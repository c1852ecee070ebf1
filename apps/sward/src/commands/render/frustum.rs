//! `--debug frustum`: the ground from above, with the part of it that the camera sees and the cells
//! that a sweep finds for it, as in figure 3 of Olofsson and Silven.

use crate::table::thousands;
use anyhow::{Context, Result};
use glam::{Vec2, Vec3, Vec3Swizzles};
use image::{Rgb, RgbImage};
use sward::{Mesh, Sweep, SweepMethod, View, ground_corners};
use sward_app::gpu::Gpu;
use sward_app::picture::{Canvas, Color, Corner, INK, Legend, PAPER};
use sward_app::stage::StageOptions;
use sward_scene::{Camera, Scene};

/// Cells along the longer side of the ground.
const CELLS: f32 = 48.0;

const SEEN: Color = [126, 178, 84];
const UNSEEN: Color = [150, 148, 142];
const BEYOND: Color = [48, 52, 58];
const FOOTPRINT: Color = [232, 92, 40];
const EYE: Color = [36, 84, 190];

/// The ground of a scene, and what its camera sees of it.
struct Ground<'a> {
    mesh: &'a Mesh,
    sweep: Sweep,
    listed: Vec<bool>,
}

/// Draws the map for the scene's first ground that grass grows on; and says what was found.
pub fn picture(scene: &Scene, gpu: &Gpu, options: &StageOptions) -> Result<(RgbImage, String)> {
    let field = scene.fields.first().context("the scene has no field")?;
    let mesh = &scene.objects.get(field.object).context("the field has no ground")?.mesh;
    let bounds = field.surface.bounds();
    let size = (bounds.1 - bounds.0).xz().max_element().max(1e-3);
    let mut sweep = Sweep::new(&gpu.device, mesh, size / CELLS)
        .with_context(|| format!("{}: the ground of '{}'", scene.path.display(), field.name))?;
    let aspect = options.size[0] as f32 / options.size[1] as f32;
    let camera = &options.camera;
    let view = View::new(camera.view_from_world(), camera.clip_from_view(aspect), options.size);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    sweep.encode(&gpu.device, &mut encoder, &view)?;
    gpu.queue.submit([encoder.finish()]);
    let listed = listed_cells(gpu, &sweep)?;
    let ground = Ground { mesh, sweep, listed };
    let footprint = footprint(&view, bounds);
    let map = Map::over(&ground, camera, options.size);
    let mut picture = RgbImage::from_pixel(options.size[0], options.size[1], Rgb(BEYOND));
    map.draw_ground(&mut picture, &ground);
    map.draw_camera(&mut picture, camera, &footprint);
    let found = found(&ground);
    legend(&found).draw(&mut picture, Corner::TopLeft);
    Ok((picture, found))
}

/// How many cells, and by which method.
fn found(ground: &Ground) -> String {
    let count = ground.listed.iter().filter(|listed| **listed).count();
    let all = thousands(ground.listed.len() as u64);
    let method = match ground.sweep.method() {
        SweepMethod::Corners => "ground sweep",
        _ => "every cell tested",
    };
    format!("{method}: {} of {all} cells", thousands(count as u64))
}

fn legend(found: &str) -> Legend {
    Legend::new(found)
        .entry(SEEN, "cells that are drawn")
        .entry(UNSEEN, "cells that are not")
        .entry(FOOTPRINT, "where the ground meets the frustum")
        .entry(EYE, "camera")
}

/// Where the mean height of the ground meets the frustum: none where the camera looks straight down.
fn footprint(view: &View, (low, high): (Vec3, Vec3)) -> Vec<Vec2> {
    // Beyond the farthest corner of the ground nothing is to be seen
    let eye = view.view_from_world.inverse().w_axis.truncate();
    let reach = (eye - low).abs().max((eye - high).abs()).length();
    let corners = ground_corners(view, f64::from(0.5 * (low.y + high.y)), f64::from(reach));
    corners.map_or(Vec::new(), |corners| corners.map(|c| c.place.as_vec2()).to_vec())
}

/// Which cells the sweep listed.
fn listed_cells(gpu: &Gpu, sweep: &Sweep) -> Result<Vec<bool>> {
    let source = sweep.cells();
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("sward.cells"),
        size: source.size(),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    encoder.copy_buffer_to_buffer(source, 0, &buffer, 0, source.size());
    gpu.queue.submit([encoder.finish()]);
    buffer.map_async(wgpu::MapMode::Read, .., |_| {});
    gpu.wait()?;
    let mapped = buffer.get_mapped_range(..).context("the cells cannot be read back")?;
    let mut words =
        mapped.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]));
    let count = words.next().unwrap_or(0);
    let [columns, rows] = sweep.size();
    let mut listed = vec![false; columns as usize * rows as usize];
    for cell in words.take(count as usize) {
        if let Some(cell) = listed.get_mut(cell as usize) {
            *cell = true;
        }
    }
    Ok(listed)
}

/// From the ground to the picture: -z is up.
struct Map {
    /// (x, z) in the middle of the picture, metres.
    center: Vec2,
    pixels_a_metre: f32,
    size: Vec2,
}

impl Map {
    /// Shows the ground and the camera.
    fn over(ground: &Ground, camera: &Camera, size: [u32; 2]) -> Self {
        let size = Vec2::new(size[0] as f32, size[1] as f32);
        let (low, high) = ground.sweep.bounds();
        let (low, high) = (low.xz().min(camera.eye.xz()), high.xz().max(camera.eye.xz()));
        let fit = 0.94 * size / (high - low).max(Vec2::splat(1e-3));
        Self { center: 0.5 * (low + high), pixels_a_metre: fit.min_element(), size }
    }

    fn pixel(&self, place: Vec2) -> Vec2 {
        (place - self.center) * self.pixels_a_metre + 0.5 * self.size
    }

    /// Triangles in the colour of their cell, lit from the upper left; then the lines of the grid.
    fn draw_ground(&self, picture: &mut RgbImage, ground: &Ground) {
        let sun = Vec3::new(-0.5, 0.7, -0.5).normalize();
        let cells = Cells::of(&ground.sweep);
        for triangle in &ground.mesh.triangles {
            let corners = triangle.map(|v| ground.mesh.positions.get(v as usize).copied());
            let [Some(a), Some(b), Some(c)] = corners else { continue };
            let normal = (b - a).cross(c - a).normalize_or(Vec3::Y);
            let light = 0.35 + 0.75 * (normal * normal.y.signum()).dot(sun).max(0.0);
            let cell = cells.cell((a + b + c).xz() / 3.0);
            let seen = ground.listed.get(cell).copied().unwrap_or(false);
            let color = if seen { SEEN } else { UNSEEN };
            let lit = color.map(|channel| (f32::from(channel) * light).clamp(0.0, 255.0) as u8);
            self.fill(picture, [a, b, c].map(|corner| self.pixel(corner.xz())), lit);
        }
        let mut canvas = Canvas::new(picture);
        for (from, to) in cells.lines() {
            canvas.line(self.pixel(from), self.pixel(to), 0.35, INK);
        }
    }

    /// Without smooth edges, which would show where triangles meet.
    fn fill(&self, picture: &mut RgbImage, [a, b, c]: [Vec2; 3], color: Color) {
        let area = (b - a).perp_dot(c - a);
        let min = a.min(b).min(c).floor().max(Vec2::ZERO).as_uvec2();
        let max = a.max(b).max(c).ceil().clamp(Vec2::ZERO, self.size).as_uvec2();
        for y in min.y..max.y {
            for x in min.x..max.x {
                let at = Vec2::new(x as f32, y as f32) + 0.5;
                let (u, v) = ((b - a).perp_dot(at - a) / area, (at - a).perp_dot(c - a) / area);
                // A little over the edge, so that no pixel between two triangles is left out
                if u >= -1e-3 && v >= -1e-3 && u + v <= 1.001 {
                    picture.put_pixel(x, y, Rgb(color));
                }
            }
        }
    }

    fn draw_camera(&self, picture: &mut RgbImage, camera: &Camera, footprint: &[Vec2]) {
        let width = (self.size.y / 240.0).max(1.5);
        let mut canvas = Canvas::new(picture);
        for (i, from) in footprint.iter().enumerate() {
            let to = footprint[(i + 1) % footprint.len()];
            canvas.line(self.pixel(*from), self.pixel(to), width, FOOTPRINT);
        }
        let eye = self.pixel(camera.eye.xz());
        let ahead = (camera.target - camera.eye).xz().normalize_or_zero();
        canvas.arrow(eye, eye + ahead * 16.0 * width, 1.2 * width, EYE);
        canvas.circle(eye, 3.2 * width, 4.0 * width, PAPER);
        canvas.circle(eye, 2.4 * width, 3.0 * width, EYE);
    }
}

/// The grid of a sweep.
struct Cells {
    columns: u32,
    rows: u32,
    low: Vec2,
    high: Vec2,
}

impl Cells {
    fn of(sweep: &Sweep) -> Self {
        let [columns, rows] = sweep.size();
        let (low, high) = (sweep.rectangle(0).0, sweep.rectangle(columns * rows - 1).1);
        Self { columns, rows, low, high }
    }

    fn cell(&self, place: Vec2) -> usize {
        let share = (place - self.low) / (self.high - self.low);
        let at = |share: f32, count: u32| ((share * count as f32).max(0.0) as u32).min(count - 1);
        (at(share.x, self.columns) * self.rows + at(share.y, self.rows)) as usize
    }

    /// All lines between cells.
    fn lines(&self) -> impl Iterator<Item = (Vec2, Vec2)> + '_ {
        let along = |i: u32, count: u32| i as f32 / count as f32;
        let x = (0..=self.columns).map(move |i| {
            let x = self.low.x + (self.high.x - self.low.x) * along(i, self.columns);
            (Vec2::new(x, self.low.y), Vec2::new(x, self.high.y))
        });
        let z = (0..=self.rows).map(move |i| {
            let z = self.low.y + (self.high.y - self.low.y) * along(i, self.rows);
            (Vec2::new(self.low.x, z), Vec2::new(self.high.x, z))
        });
        x.chain(z)
    }
}
