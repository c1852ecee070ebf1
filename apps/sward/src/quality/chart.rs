//! Charts of lines.

use crate::picture::{Align, Canvas, Color, INK, PAPER, Type, ticks};
use glam::{IVec2, Vec2};
use image::{Rgb, RgbImage};

const SIZE: [u32; 2] = [960, 540];
const GREY: Color = [205, 205, 200];

/// A line of a chart; it is broken where a point is no number.
#[derive(Debug, Clone)]
pub(super) struct Line {
    pub name: String,
    pub color: Color,
    pub points: Vec<Vec2>,
}

/// Lines over one axis.
#[derive(Debug, Clone)]
pub(super) struct Chart {
    pub title: String,
    /// What lies along x.
    pub along: String,
    /// Whether equal factors are equally far apart along x.
    pub log_x: bool,
    pub lines: Vec<Line>,
    /// A level that should not be passed.
    pub limit: Option<f32>,
    /// Ranges of x that are tinted, with their names.
    pub ranges: Vec<([f32; 2], String)>,
}

/// From values to pixels.
struct Axes {
    min: Vec2,
    max: Vec2,
    log_x: bool,
    corner: Vec2,
    size: Vec2,
}

impl Axes {
    fn x(&self, x: f32) -> f32 {
        let scaled = |x: f32| if self.log_x { x.max(1e-6).ln() } else { x };
        let (from, to) = (scaled(self.min.x), scaled(self.max.x));
        let share = (scaled(x) - from) / (to - from).max(1e-9);
        self.corner.x + self.size.x * share.clamp(0.0, 1.0)
    }

    fn at(&self, value: Vec2) -> Vec2 {
        let share = (value.y - self.min.y) / (self.max.y - self.min.y).max(1e-9);
        Vec2::new(self.x(value.x), self.corner.y + self.size.y * (1.0 - share.clamp(0.0, 1.0)))
    }
}

impl Chart {
    pub fn draw(&self) -> RgbImage {
        let mut image = RgbImage::from_pixel(SIZE[0], SIZE[1], Rgb(PAPER));
        let letters = Type::of((SIZE[0], SIZE[1]));
        let line = letters.line();
        let axes = self.axes(letters);
        let mut canvas = Canvas::new(&mut image);
        self.draw_ranges(&mut canvas, &axes, letters);
        self.draw_grid(&mut canvas, &axes, letters);
        if let Some(limit) = self.limit.filter(|limit| *limit <= axes.max.y) {
            let ends = [axes.min.x, axes.max.x].map(|x| axes.at(Vec2::new(x, limit)));
            canvas.line(ends[0], ends[1], 1.5, [200, 60, 40]);
        }
        for series in &self.lines {
            for pair in series.points.windows(2) {
                if let [a, b] = pair
                    && a.is_finite()
                    && b.is_finite()
                {
                    canvas.line(axes.at(*a), axes.at(*b), 2.0, series.color);
                }
            }
        }
        canvas.text(IVec2::splat(line / 2), &self.title, letters, INK, Align::Left);
        self.draw_names(&mut canvas, letters);
        image
    }

    fn axes(&self, letters: Type) -> Axes {
        let points = || self.lines.iter().flat_map(|l| &l.points).filter(|p| p.is_finite());
        let fold = |f: fn(Vec2, Vec2) -> Vec2, from| points().copied().fold(from, f);
        let (low, high) = (fold(Vec2::min, Vec2::INFINITY), fold(Vec2::max, Vec2::NEG_INFINITY));
        let (low, high) = if low.is_finite() { (low, high) } else { (Vec2::ZERO, Vec2::ONE) };
        // From 0, unless what varies is a small part of what is there
        let floor = if low.y > 0.6 * high.y { low.y - 0.3 * (high.y - low.y) } else { 0.0 };
        let top = high.y.max(self.limit.unwrap_or(0.0).min(3.0 * high.y));
        let line = letters.line() as f32;
        let corner = Vec2::new(4.5 * line, 4.0 * line);
        Axes {
            min: Vec2::new(low.x, floor.min(low.y)),
            max: Vec2::new(high.x, floor + (top - floor).max(1e-6) * 1.06),
            log_x: self.log_x,
            corner,
            size: Vec2::new(SIZE[0] as f32 - line, SIZE[1] as f32 - 3.0 * line) - corner,
        }
    }

    fn draw_ranges(&self, canvas: &mut Canvas, axes: &Axes, letters: Type) {
        let (top, bottom) = (axes.corner.y, axes.corner.y + axes.size.y);
        let small = letters.smaller().unwrap_or(letters);
        for (i, (range, name)) in (0..).zip(&self.ranges) {
            let [from, to] = range.map(|x| axes.x(x));
            let tint = [[255, 220, 150], [180, 220, 255], [200, 240, 180], [240, 200, 230]];
            let [from_x, to_x, top, bottom] = [from, to, top, bottom].map(|c| c as i32);
            let color = tint[i as usize % tint.len()];
            canvas.fill(IVec2::new(from_x, top), IVec2::new(to_x, bottom), color, 0.45);
            let at = IVec2::new(from_x + 2, bottom - (i + 1) * (small.line() + 2));
            canvas.text(at, name, small, INK, Align::Left);
        }
    }

    fn draw_grid(&self, canvas: &mut Canvas, axes: &Axes, letters: Type) {
        let line = letters.line() as f32;
        let bottom = axes.corner.y + axes.size.y;
        for (share, label) in ticks(axes.min.y, axes.max.y, 6) {
            let y = bottom - axes.size.y * share;
            let left = Vec2::new(axes.corner.x, y);
            canvas.line(left, left + Vec2::X * axes.size.x, 1.0, GREY);
            let at = (left - Vec2::new(0.4 * line, 0.5 * line)).as_ivec2();
            canvas.text(at, &label, letters, INK, Align::Right);
        }
        for (x, label) in self.marks(axes) {
            let foot = Vec2::new(axes.x(x), bottom);
            canvas.line(foot, foot + Vec2::Y * 0.3 * line, 1.0, INK);
            let at = (foot + Vec2::Y * 0.4 * line).as_ivec2();
            canvas.text(at, &label, letters, INK, Align::Center);
        }
        let corner = Vec2::new(axes.corner.x, bottom);
        canvas.line(corner, corner + Vec2::X * axes.size.x, 1.0, INK);
        let at = Vec2::new(axes.corner.x + 0.5 * axes.size.x, bottom + 1.6 * line).as_ivec2();
        canvas.text(at, &self.along, letters, INK, Align::Center);
    }

    /// Places along x, and what is written under them.
    fn marks(&self, axes: &Axes) -> Vec<(f32, String)> {
        if !self.log_x {
            let span = axes.max.x - axes.min.x;
            let ticks = ticks(axes.min.x, axes.max.x, 8).into_iter();
            return ticks.map(|(share, label)| (axes.min.x + share * span, label)).collect();
        }
        let decades = (-3..5).map(|power| 10_f32.powi(power));
        let steps = decades.flat_map(|decade| [1.0, 2.0, 5.0].map(|step| step * decade));
        let inside = steps.filter(|x| (axes.min.x..=axes.max.x).contains(x));
        inside.map(|x| (x, format!("{x}"))).collect()
    }

    fn draw_names(&self, canvas: &mut Canvas, letters: Type) {
        let line = letters.line();
        let mut at = IVec2::new(5 * line, 2 * line);
        for series in &self.lines {
            let from = at.as_vec2() + Vec2::new(0.0, 0.5 * line as f32);
            canvas.line(from, from + Vec2::X * 1.5 * line as f32, 3.0, series.color);
            at.x += 2 * line;
            canvas.text(at, &series.name, letters, INK, Align::Left);
            at.x += letters.measure(&series.name).x + line;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_drawn_in_their_colours_and_odd_values_harm_nothing() {
        let points = (1..50).map(|i| Vec2::new(i as f32, (i as f32).sin())).collect();
        let red = [250, 10, 10];
        let mut chart = Chart {
            title: "title".into(),
            along: "distance, m".into(),
            log_x: true,
            lines: vec![Line { name: "one".into(), color: red, points }],
            limit: Some(0.5),
            ranges: vec![([2.0, 9.0], "change".into())],
        };
        let drawn = chart.draw();
        assert!(drawn.pixels().filter(|p| p.0 == red).count() > 500);
        chart.lines[0].points = vec![Vec2::NAN, Vec2::ONE, Vec2::INFINITY];
        chart.draw();
        chart.lines.clear();
        chart.draw();
    }
}
