//! A map of the wind over a scene's fields, seen from above: strength by colour, direction by
//! arrows, as figure 4 of Jahrmann and Wimmer shows its point sources. North (-z) is up.

mod ground;
mod marks;

use crate::picture::{Canvas, Corner, INK, Legend, PAPER, Type, ramp, ticks};
use glam::{IVec2, Vec2, Vec3};
use ground::Ground;
use image::{Rgb, RgbImage};
use sward::Wind;
use sward_scene::Scene;

/// What to draw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapOptions {
    /// Size of the picture, pixels.
    pub size: [u32; 2],
    /// Seconds from the scene's start.
    pub time_s: f64,
    /// Height over the fields' ground at which the wind is told, metres.
    pub height_m: f32,
}

/// Draws the map. The wind is that which `sward render` has at that time.
///
/// # Errors
/// Where the scene's wind is none.
pub fn draw(scene: &Scene, options: MapOptions) -> Result<RgbImage, sward::Error> {
    let mut wind = Wind::new(scene.wind_at(options.time_s as f32))?;
    wind.advance(f64::from(scene.warm_up_s) + options.time_s);
    let frame = Frame::around(scene, options.size);
    let ground = Ground::below(scene, &frame);
    let winds = sampled(&wind, &frame, &ground, options.height_m);
    let most = strongest(&winds);
    let mut image = colored(&frame, &ground, &winds, most);
    let mut canvas = Canvas::new(&mut image);
    draw_arrows(&mut canvas, &frame, &winds, most);
    marks::draw(&mut canvas, &frame, &wind);
    let title = format!("wind {} m over ground, {} s", options.height_m, options.time_s);
    let title = if scene.wind.is_empty() { format!("{title}: none") } else { title };
    Legend::new(title).bar(ramp, ticks(0.0, most, 4)).draw(&mut image, Corner::BottomRight);
    Ok(image)
}

/// The part of the world that the map shows.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Frame {
    /// World x, z of the upper left corner.
    min: Vec2,
    metres_a_pixel: f32,
    size: IVec2,
}

impl Frame {
    /// All fields and a little around, on the whole picture.
    fn around(scene: &Scene, size: [u32; 2]) -> Self {
        let positions = scene.fields.iter().flat_map(|f| &f.surface.mesh().positions);
        let (min, max) = positions.fold((Vec2::MAX, Vec2::MIN), |(min, max), at| {
            let at = Vec2::new(at.x, at.z);
            (min.min(at), max.max(at))
        });
        let size = IVec2::new(size[0] as i32, size[1] as i32);
        let extent = (max - min).max(Vec2::splat(1e-3)) * 1.06;
        let metres_a_pixel = (extent / size.as_vec2()).max_element();
        let corner = (min + max) / 2.0 - size.as_vec2() * metres_a_pixel / 2.0;
        Self { min: corner, metres_a_pixel, size }
    }

    /// World x, z of a place in the picture.
    fn world(&self, pixel: Vec2) -> Vec2 {
        self.min + pixel * self.metres_a_pixel
    }

    /// Place in the picture of a world x, z.
    fn pixel(&self, world: Vec2) -> Vec2 {
        (world - self.min) / self.metres_a_pixel
    }
}

/// A picture's worth of winds, one for each block of pixels.
struct Winds {
    /// Pixels a side of a block.
    block: i32,
    columns: i32,
    list: Vec<Vec3>,
}

impl Winds {
    /// Straight between the middles of blocks.
    fn at(&self, pixel: Vec2) -> Vec3 {
        let place = pixel / self.block as f32 - 0.5;
        let rows = self.list.len() as i32 / self.columns.max(1);
        let last = IVec2::new(self.columns, rows) - 1;
        let cell = |x: i32, y: i32| {
            let at = IVec2::new(x, y).clamp(IVec2::ZERO, last.max(IVec2::ZERO));
            self.list.get((at.y * self.columns + at.x) as usize).copied().unwrap_or_default()
        };
        let base = place.floor();
        let (t, IVec2 { x, y }) = (place - base, base.as_ivec2());
        let above = cell(x, y).lerp(cell(x + 1, y), t.x);
        above.lerp(cell(x, y + 1).lerp(cell(x + 1, y + 1), t.x), t.y)
    }
}

fn sampled(wind: &Wind, frame: &Frame, ground: &Ground, height_m: f32) -> Winds {
    // Finer than the eye sees on a map is not worth the wait
    let block = (frame.size.max_element() / 640).clamp(1, 4);
    let blocks = (frame.size + block - 1) / block;
    let tell = |i: i32| {
        let pixel = (IVec2::new(i % blocks.x, i / blocks.x).as_vec2() + 0.5) * block as f32;
        let at = frame.world(pixel);
        wind.strength_at(Vec3::new(at.x, ground.height(pixel) + height_m, at.y), 0.0)
    };
    let list = (0..blocks.x * blocks.y).map(tell).collect();
    Winds { block, columns: blocks.x, list }
}

/// What the ends of the colours mean: nearly the strongest wind, as a round number.
fn strongest(winds: &Winds) -> f32 {
    let mut strengths: Vec<f32> = winds.list.iter().map(|wind| wind.length()).collect();
    strengths.sort_by(f32::total_cmp);
    let most = crate::compare::percentile(&strengths, 0.995).max(0.1);
    let decade = 10_f32.powf(most.log10().floor());
    let round = [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0].map(|step| step * decade);
    round.into_iter().find(|round| *round >= most).unwrap_or(most)
}

fn colored(frame: &Frame, ground: &Ground, winds: &Winds, most: f32) -> RgbImage {
    RgbImage::from_fn(frame.size.x as u32, frame.size.y as u32, |x, y| {
        let pixel = Vec2::new(x as f32, y as f32) + 0.5;
        let color = ramp(winds.at(pixel).length() / most);
        // Where nothing grows the map is paler than the colours' own dark end
        match ground.is_field(pixel) {
            true => Rgb(color),
            false => Rgb(color.map(|c| (f32::from(c) * 0.45 + 58.0) as u8)),
        }
    })
}

/// Arrows as long as the level part of the wind is strong.
fn draw_arrows(canvas: &mut Canvas, frame: &Frame, winds: &Winds, most: f32) {
    let letters = Type::of((frame.size.x as u32, frame.size.y as u32));
    let step = letters.line() as f32 * 2.2;
    let stroke = letters.stroke() * 1.3;
    let counts = (frame.size.as_vec2() / step).floor().as_ivec2();
    let first = (frame.size.as_vec2() - (counts - 1).as_vec2() * step) / 2.0;
    for i in 0..counts.x * counts.y {
        let at = first + IVec2::new(i % counts.x, i / counts.x).as_vec2() * step;
        let wind = winds.at(at);
        let level = Vec2::new(wind.x, wind.z) / most;
        let length = level.length().min(1.2);
        if length < 0.02 {
            continue;
        }
        let half = level.normalize_or_zero() * (0.42 * step * (0.25 + 0.75 * length));
        let shadow = Vec2::splat(stroke * 0.8);
        canvas.arrow(at - half + shadow, at + half + shadow, stroke, INK);
        canvas.arrow(at - half, at + half, stroke, PAPER);
    }
}

#[cfg(test)]
mod tests;
