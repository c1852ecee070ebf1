//! What colours mean: a panel in a corner of a picture.

use super::{Align, Canvas, Color, Corner, INK, PAPER, Type};
use glam::IVec2;
use image::RgbImage;

/// A panel: a title, rows of a swatch and a label, and a bar of colours with ticks. Any of them may
/// be left out.
#[derive(Debug, Clone, Default)]
pub struct Legend {
    /// First line; none where it is empty.
    pub title: String,
    /// Swatches and what they mean.
    pub entries: Vec<(Color, String)>,
    /// A bar for numbers.
    pub bar: Option<ColorBar>,
}

/// A bar of colours from its lowest value, left, to its highest.
#[derive(Debug, Clone)]
pub struct ColorBar {
    /// Colour of a place on the bar, 0..=1.
    pub color: fn(f32) -> Color,
    /// Places on the bar, 0..=1, and what is written under them; see [`ticks`].
    pub ticks: Vec<(f32, String)>,
}

/// Round numbers from `min` to `max`, about `count` of them, by their places in 0..=1.
pub fn ticks(min: f32, max: f32, count: u32) -> Vec<(f32, String)> {
    let span = max - min;
    if !(span > 0.0 && span.is_finite()) {
        return vec![(0.0, format!("{min}"))];
    }
    let rough = span / count.max(1) as f32;
    let decade = 10_f32.powf(rough.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * decade);
    let step = steps.into_iter().find(|step| *step >= rough * 0.999).unwrap_or(rough);
    let decimals = (-step.log10().floor()).clamp(0.0, 9.0) as usize;
    let first = (min / step - 1e-3).ceil() as i32;
    let last = (max / step + 1e-3).floor() as i32;
    let tick = |i: i32| {
        let value = i as f32 * step;
        (((value - min) / span).clamp(0.0, 1.0), format!("{value:.decimals$}"))
    };
    (first..=last).map(tick).collect()
}

/// Sizes of a panel, pixels, for one size of letters.
struct Layout {
    letters: Type,
    margin: i32,
    size: IVec2,
    bar_width: i32,
}

impl Legend {
    /// A panel of this title, with nothing below it.
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), ..Self::default() }
    }

    /// Adds a row.
    #[must_use]
    pub fn entry(mut self, color: Color, label: impl Into<String>) -> Self {
        self.entries.push((color, label.into()));
        self
    }

    /// Sets the bar.
    #[must_use]
    pub fn bar(mut self, color: fn(f32) -> Color, ticks: Vec<(f32, String)>) -> Self {
        self.bar = Some(ColorBar { color, ticks });
        self
    }

    /// Draws the panel into a corner; in smaller letters where it would not fit.
    pub fn draw(&self, image: &mut RgbImage, corner: Corner) {
        let mut letters = Type::of(image.dimensions());
        let room = IVec2::new(image.width() as i32, image.height() as i32);
        let mut layout = self.layout(letters);
        while (layout.size + 2 * layout.margin).cmpgt(room).any() {
            let Some(smaller) = letters.smaller() else { break };
            letters = smaller;
            layout = self.layout(letters);
        }
        let margin = layout.margin;
        let (near, far) = (IVec2::splat(margin), room - layout.size - margin);
        let min = match corner {
            Corner::TopLeft => near,
            Corner::TopRight => IVec2::new(far.x, near.y),
            Corner::BottomLeft => IVec2::new(near.x, far.y),
            Corner::BottomRight => far,
        };
        self.draw_at(&mut Canvas::new(image), min, &layout);
    }

    fn layout(&self, letters: Type) -> Layout {
        let line = letters.line();
        let (margin, row) = (line / 2, line * 5 / 4);
        let width = |text: &str| letters.measure(text).x;
        let rows = self.entries.iter().map(|(_, label)| width(label) + row);
        let mut inner = IVec2::new(rows.max().unwrap_or(0).max(width(&self.title)), 0);
        if !self.title.is_empty() {
            inner.y += row;
        }
        inner.y += row * self.entries.len() as i32;
        let mut bar_width = 0;
        if let Some(bar) = &self.bar {
            // Labels lie side by side with a space between them.
            let widest = bar.ticks.iter().map(|(_, label)| width(label)).max().unwrap_or(0);
            let labels = (widest + letters.measure(" ").x) * bar.ticks.len() as i32;
            bar_width = labels.max(line * 10).max(inner.x - widest);
            inner.x = inner.x.max(bar_width + widest);
            inner.y += line * 9 / 4;
        }
        Layout { letters, margin, size: inner + 2 * margin, bar_width }
    }

    fn draw_at(&self, canvas: &mut Canvas, min: IVec2, layout: &Layout) {
        let Layout { letters, margin, size, .. } = *layout;
        let line = letters.line();
        canvas.fill(min, min + size, INK, 0.78);
        let mut at = min + margin;
        if !self.title.is_empty() {
            canvas.text(at, &self.title, letters, PAPER, Align::Left);
            at.y += line * 5 / 4;
        }
        for (color, label) in &self.entries {
            canvas.fill(at, at + line * 9 / 10, *color, 1.0);
            canvas.frame(at, at + line * 9 / 10, (line / 14).max(1), PAPER);
            canvas.text(at + IVec2::X * (line * 5 / 4), label, letters, PAPER, Align::Left);
            at.y += line * 5 / 4;
        }
        if let Some(bar) = &self.bar {
            let left = min.x + (size.x - layout.bar_width) / 2;
            bar.draw(canvas, IVec2::new(left, at.y), layout);
        }
    }
}

impl ColorBar {
    fn draw(&self, canvas: &mut Canvas, min: IVec2, layout: &Layout) {
        let Layout { letters, bar_width, .. } = *layout;
        let line = letters.line();
        let last = (bar_width - 1).max(1);
        for x in 0..bar_width {
            let color = (self.color)(x as f32 / last as f32);
            let left = min + IVec2::X * x;
            canvas.fill(left, left + IVec2::new(1, line * 9 / 10), color, 1.0);
        }
        for (place, label) in &self.ticks {
            let x = min.x + (place.clamp(0.0, 1.0) * last as f32).round() as i32;
            let mark = IVec2::new(x, min.y + line * 9 / 10);
            canvas.fill(mark, mark + IVec2::new((line / 14).max(1), line / 4), PAPER, 1.0);
            let below = IVec2::new(x, mark.y + line * 3 / 10);
            canvas.text(below, label, letters, PAPER, Align::Center);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::ramp;

    #[test]
    fn ticks_are_round_and_in_place() {
        let labels = |min, max, n| -> Vec<String> {
            ticks(min, max, n).into_iter().map(|(_, label)| label).collect()
        };
        assert_eq!(labels(0.0, 1.0, 4), ["0.0", "0.5", "1.0"]);
        assert_eq!(labels(0.0, 1.2, 6), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0", "1.2"]);
        assert_eq!(labels(0.0, 37.0, 5), ["0", "10", "20", "30"]);
        assert_eq!(labels(-2.0, 2.0, 4), ["-2", "-1", "0", "1", "2"]);
        assert_eq!(ticks(0.0, 4.0, 2)[1], (0.5, "2".into()));
        assert_eq!(labels(1.0, 1.0, 3), ["1"]);
        assert_eq!(labels(0.0, f32::NAN, 3), ["0"]);
    }

    /// The panel lies in its corner, whole, at any size of picture; nothing else is touched.
    #[test]
    fn panels_fit_their_corner() {
        let legend = Legend::new("wind").entry([255, 0, 0], "source").bar(ramp, ticks(0.0, 1.0, 4));
        for size in [(200, 120), (1280, 720), (4000, 2000)] {
            for (corner, right, bottom) in [
                (Corner::TopLeft, false, false),
                (Corner::TopRight, true, false),
                (Corner::BottomLeft, false, true),
                (Corner::BottomRight, true, true),
            ] {
                let ground = image::Rgb([200, 200, 255]);
                let mut image = RgbImage::from_pixel(size.0, size.1, ground);
                legend.draw(&mut image, corner);
                let mut red = 0;
                for (x, y, pixel) in image.enumerate_pixels() {
                    let near = |at: u32, side: u32, far: bool| (at > side / 2) == far;
                    let inside = near(x, size.0, right) && near(y, size.1, bottom);
                    assert!(size.0 < 999 || inside || *pixel == ground, "{size:?} {corner:?}");
                    red += u32::from(pixel.0 == [255, 0, 0]);
                }
                assert!(red >= 25, "{size:?} {corner:?}: the swatch shows");
            }
        }
        legend.draw(&mut RgbImage::new(1, 1), Corner::TopLeft);
        Legend::default().draw(&mut RgbImage::new(9, 9), Corner::BottomRight);
    }
}
