//! Text, lines, arrows and boxes. Lines are smoothed; letters are whole pixels.

use super::Color;
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle, iso_8859_1 as fonts};
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::*;
use embedded_graphics::text::{Baseline, Text};
use glam::{IVec2, Vec2};
use image::{Rgb, RgbImage};
use std::convert::Infallible;

/// A size of letters: a font, enlarged by a whole number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Type {
    font: &'static MonoFont<'static>,
    scale: i32,
}

/// Where text lies from its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Align {
    /// The point is the upper left corner.
    Left,
    /// The point is the middle of the upper edge.
    Center,
    /// The point is the upper right corner.
    Right,
}

impl Type {
    /// The size that suits a picture: about a fortieth of its height.
    pub fn of(size: (u32, u32)) -> Self {
        let height = size.1.min(size.0 * 9 / 16);
        let (font, scale) = match height {
            0..280 => (&fonts::FONT_6X10, 1),
            280..560 => (&fonts::FONT_7X13, 1),
            560..900 => (&fonts::FONT_9X15, 1),
            900..1500 => (&fonts::FONT_10X20, 1),
            _ => (&fonts::FONT_10X20, (height / 750).clamp(2, 64)),
        };
        Self { font, scale: scale as i32 }
    }

    /// The next smaller size; `None` below the smallest.
    pub fn smaller(self) -> Option<Self> {
        if self.scale > 1 {
            return Some(Self { scale: self.scale - 1, ..self });
        }
        let sizes = [&fonts::FONT_10X20, &fonts::FONT_9X15, &fonts::FONT_7X13, &fonts::FONT_6X10];
        let font = sizes.into_iter().find(|font| self.letter() > letter_of(font).y)?;
        Some(Self { font, scale: 1 })
    }

    fn letter(self) -> i32 {
        letter_of(self.font).y
    }

    /// Height of a line, pixels.
    pub fn line(self) -> i32 {
        self.letter() * self.scale
    }

    /// Width and height of a text of one line, pixels.
    pub fn measure(self, text: &str) -> IVec2 {
        let letters = text.chars().count() as i32;
        IVec2::new(letters * letter_of(self.font).x, self.letter()) * self.scale
    }

    /// Width of a thin line that goes with these letters, pixels.
    pub fn stroke(self) -> f32 {
        self.line() as f32 / 14.0
    }
}

fn letter_of(font: &MonoFont) -> IVec2 {
    let size = font.character_size;
    IVec2::new(size.width as i32, size.height as i32)
}

/// A picture to draw on. What lies outside it is left out.
#[derive(Debug)]
pub struct Canvas<'a> {
    image: &'a mut RgbImage,
}

impl<'a> Canvas<'a> {
    /// Draws on this picture.
    pub fn new(image: &'a mut RgbImage) -> Self {
        Self { image }
    }

    /// Width and height, pixels.
    pub fn size(&self) -> IVec2 {
        IVec2::new(self.image.width() as i32, self.image.height() as i32)
    }

    /// One line of text.
    pub fn text(&mut self, at: IVec2, text: &str, letters: Type, color: Color, align: Align) {
        let width = letters.measure(text).x;
        let left = match align {
            Align::Left => at.x,
            Align::Center => at.x - width / 2,
            Align::Right => at.x - width,
        };
        let style = MonoTextStyle::new(letters.font, BinaryColor::On);
        let line = Text::with_baseline(text, Point::zero(), style, Baseline::Top);
        let origin = IVec2::new(left, at.y);
        let Ok(_) = line.draw(&mut Glyphs { canvas: self, origin, scale: letters.scale, color });
    }

    /// Text with a thin edge of another colour, so that it can be read on anything.
    pub fn text_on_picture(
        &mut self,
        at: IVec2,
        text: &str,
        letters: Type,
        [color, edge]: [Color; 2],
        align: Align,
    ) {
        for (x, y) in [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)] {
            self.text(at + IVec2::new(x, y) * letters.scale, text, letters, edge, align);
        }
        self.text(at, text, letters, color, align);
    }

    /// A filled box from `min` up to, but without, `max`; `opacity` 0..=1.
    pub fn fill(&mut self, min: IVec2, max: IVec2, color: Color, opacity: f32) {
        let (min, max) = (min.max(IVec2::ZERO), max.min(self.size()));
        for y in min.y..max.y {
            for x in min.x..max.x {
                self.blend(IVec2::new(x, y), color, opacity);
            }
        }
    }

    /// A box's edge, inside it.
    pub fn frame(&mut self, min: IVec2, max: IVec2, width: i32, color: Color) {
        let inner = (min + width, max - width);
        self.fill(min, IVec2::new(max.x, inner.0.y), color, 1.0);
        self.fill(IVec2::new(min.x, inner.1.y), max, color, 1.0);
        self.fill(IVec2::new(min.x, inner.0.y), IVec2::new(inner.0.x, inner.1.y), color, 1.0);
        self.fill(IVec2::new(inner.1.x, inner.0.y), IVec2::new(max.x, inner.1.y), color, 1.0);
    }

    /// A straight line with round ends, `width` pixels wide. Pixel centres lie at halves.
    pub fn line(&mut self, from: Vec2, to: Vec2, width: f32, color: Color) {
        let along = to - from;
        let per_length = along.length_squared().max(1e-12).recip();
        self.cover(from.min(to) - width, from.max(to) + width, color, |at| {
            let t = ((at - from).dot(along) * per_length).clamp(0.0, 1.0);
            0.5 * width - (from + along * t).distance(at)
        });
    }

    /// A line with a filled head at `to`. `width` is the line's; a head is four times as wide, and
    /// short arrows are smaller as a whole.
    pub fn arrow(&mut self, from: Vec2, to: Vec2, width: f32, color: Color) {
        let Some(along) = (to - from).try_normalize() else { return };
        let length = from.distance(to);
        let head = (4.0 * width).min(0.6 * length);
        let neck = to - along * head;
        self.line(from, neck, width.min(0.5 * head), color);
        let side = along.perp() * 0.5 * head;
        self.triangle([to, neck + side, neck - side], color);
    }

    /// A filled triangle.
    pub fn triangle(&mut self, corners: [Vec2; 3], color: Color) {
        let [a, b, c] = corners;
        let turn = (b - a).perp_dot(c - a).signum();
        // Distance inside an edge, with corners in order of a positive turn.
        let edge = |from: Vec2, to: Vec2, at: Vec2| {
            turn * (to - from).normalize_or_zero().perp_dot(at - from)
        };
        self.cover(a.min(b).min(c) - 1.0, a.max(b).max(c) + 1.0, color, |at| {
            edge(a, b, at).min(edge(b, c, at)).min(edge(c, a, at))
        });
    }

    /// A circle's line, `width` pixels wide; filled where `width` is the radius or more.
    pub fn circle(&mut self, center: Vec2, radius: f32, width: f32, color: Color) {
        let reach = radius + 0.5 * width + 1.0;
        let filled = width >= radius;
        self.cover(center - reach, center + reach, color, |at| {
            let distance = center.distance(at);
            if filled { radius - distance } else { 0.5 * width - (distance - radius).abs() }
        });
    }

    /// Blends a shape, given by the distance inside it, over the pixels of a box.
    fn cover(&mut self, min: Vec2, max: Vec2, color: Color, inside: impl Fn(Vec2) -> f32) {
        if !(min.is_finite() && max.is_finite()) {
            return;
        }
        let min = min.floor().as_ivec2().max(IVec2::ZERO);
        let max = (max.ceil().as_ivec2() + 1).min(self.size());
        for y in min.y..max.y {
            for x in min.x..max.x {
                let at = IVec2::new(x, y);
                let coverage = (inside(at.as_vec2() + 0.5) + 0.5).clamp(0.0, 1.0);
                self.blend(at, color, coverage);
            }
        }
    }

    fn blend(&mut self, at: IVec2, color: Color, opacity: f32) {
        if opacity <= 0.0 || at.cmplt(IVec2::ZERO).any() {
            return;
        }
        let Some(Rgb(pixel)) = self.image.get_pixel_mut_checked(at.x as u32, at.y as u32) else {
            return;
        };
        for (old, new) in pixel.iter_mut().zip(color) {
            let mixed = f32::from(*old) + (f32::from(new) - f32::from(*old)) * opacity.min(1.0);
            *old = mixed.round() as u8;
        }
    }
}

/// Enlarges what is drawn on it and paints it in one colour.
struct Glyphs<'a, 'b> {
    canvas: &'a mut Canvas<'b>,
    origin: IVec2,
    scale: i32,
    color: Color,
}

impl OriginDimensions for Glyphs<'_, '_> {
    fn size(&self) -> Size {
        Size::new(self.canvas.image.width(), self.canvas.image.height())
    }
}

impl DrawTarget for Glyphs<'_, '_> {
    type Color = BinaryColor;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<BinaryColor>>,
    {
        for Pixel(point, color) in pixels {
            if color.is_on() {
                let min = self.origin + IVec2::new(point.x, point.y) * self.scale;
                self.canvas.fill(min, min + self.scale, self.color, 1.0);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(draw: impl Fn(&mut Canvas)) -> RgbImage {
        let mut image = RgbImage::new(80, 40);
        draw(&mut Canvas::new(&mut image));
        image
    }

    fn sum(image: &RgbImage) -> f32 {
        image.pixels().map(|p| f32::from(p.0[0]) / 255.0).sum()
    }

    const WHITE: Color = [255; 3];

    #[test]
    fn shapes_cover_their_area() {
        let about = |image: RgbImage, area: f32| {
            let covered = sum(&image);
            assert!((covered / area - 1.0).abs() < 0.06, "{covered} of {area}");
        };
        let vec = Vec2::new;
        about(drawn(|c| c.fill(IVec2::new(3, 4), IVec2::new(13, 9), WHITE, 1.0)), 50.0);
        about(drawn(|c| c.line(vec(10.0, 10.0), vec(60.0, 30.0), 3.0, WHITE)), 53.85 * 3.0 + 7.07);
        let corners = [vec(5.0, 5.0), vec(45.0, 8.0), vec(20.0, 35.0)];
        about(drawn(|c| c.triangle(corners, WHITE)), 577.5);
        let turned = [corners[0], corners[2], corners[1]];
        about(drawn(|c| c.triangle(turned, WHITE)), 577.5);
        about(drawn(|c| c.circle(vec(40.0, 20.0), 10.0, 2.0, WHITE)), 125.7);
        about(drawn(|c| c.circle(vec(40.0, 20.0), 10.0, 10.0, WHITE)), 314.2);
    }

    #[test]
    fn an_arrow_is_thickest_at_its_head() {
        let image = drawn(|c| c.arrow(Vec2::new(5.0, 20.0), Vec2::new(70.0, 20.0), 3.0, WHITE));
        let column = |x| (0..40).map(|y| f32::from(image.get_pixel(x, y).0[0])).sum::<f32>();
        assert!(column(59) > 2.0 * column(30) && column(30) > 500.0);
        assert_eq!(column(75), 0.0);
    }

    #[test]
    fn letters_grow_with_the_picture_and_stay_inside_their_size() {
        let lines = [(160, 90), (640, 360), (1280, 720), (1920, 1080), (3840, 2160), (7680, 4320)]
            .map(|size| Type::of(size).line());
        assert!(lines.is_sorted_by(|a, b| a < b), "{lines:?}");
        assert_eq!(lines[0], 10);
        let image =
            drawn(|c| c.text(IVec2::new(4, 6), "Wg²", Type::of((1, 1)), WHITE, Align::Left));
        let size = Type::of((1, 1)).measure("Wg²");
        for (x, y, pixel) in image.enumerate_pixels() {
            let outside = x < 4 || y < 6 || x as i32 >= 4 + size.x || y as i32 >= 6 + size.y;
            assert!(!outside || pixel.0 == [0; 3], "{x} {y}");
        }
        assert!(sum(&image) > 20.0);
        let mut sizes = vec![Type::of((7680, 4320))];
        while let Some(next) = sizes.last().and_then(|t| t.smaller()) {
            assert!(next.line() < sizes[sizes.len() - 1].line());
            sizes.push(next);
        }
        assert_eq!(sizes.last().map(|t| t.line()), Some(10));
    }

    #[test]
    fn what_lies_outside_is_left_out() {
        let image = drawn(|c| {
            c.text(IVec2::new(-30, -5), "far outside", Type::of((1, 1)), WHITE, Align::Right);
            c.line(Vec2::splat(-1e6), Vec2::new(-5.0, 1e6), 2.0, WHITE);
            c.arrow(Vec2::NAN, Vec2::ONE, 2.0, WHITE);
            c.arrow(Vec2::ONE, Vec2::ONE, 2.0, WHITE);
            c.circle(Vec2::splat(500.0), f32::INFINITY, 2.0, WHITE);
            c.fill(IVec2::splat(i32::MIN / 2), IVec2::splat(-1), WHITE, 1.0);
        });
        assert_eq!(sum(&image), 0.0);
    }
}
