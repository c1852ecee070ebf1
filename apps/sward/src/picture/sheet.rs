//! Pictures side by side, each with a label over it.

use super::{Align, Canvas, INK, PAPER, Type};
use glam::IVec2;
use image::{RgbImage, imageops};

/// Pictures in rows, left to right, of equal cells: as large as the largest picture.
#[derive(Debug, Clone, Default)]
pub struct Sheet {
    /// Line over all; none where it is empty.
    pub title: String,
    /// Pictures a row; 0 counts as all in one row.
    pub columns: u32,
    /// Labels and pictures; a label is cut off where it is wider than its cell.
    pub pictures: Vec<(String, RgbImage)>,
}

impl Sheet {
    /// An empty sheet.
    pub fn new(title: impl Into<String>, columns: u32) -> Self {
        Self { title: title.into(), columns, pictures: Vec::new() }
    }

    /// Adds a picture.
    #[must_use]
    pub fn picture(mut self, label: impl Into<String>, picture: RgbImage) -> Self {
        self.pictures.push((label.into(), picture));
        self
    }

    /// The sheet as a picture; a pixel where it holds none.
    pub fn draw(&self) -> RgbImage {
        let side = |side: fn(&RgbImage) -> u32| self.pictures.iter().map(|(_, p)| side(p)).max();
        let cell = (side(RgbImage::width), side(RgbImage::height));
        let (Some(width), Some(height)) = cell else { return RgbImage::new(1, 1) };
        let count = self.pictures.len() as u32;
        let columns = if self.columns == 0 { count } else { self.columns.min(count) };
        let letters = Type::of((width, height));
        let (line, gap) = (letters.line() as u32, letters.line() as u32 / 2);
        let head = if self.title.is_empty() { 0 } else { line + gap };
        let (step_x, step_y) = (width + gap, height + line + gap + gap / 2);
        let mut sheet = RgbImage::from_pixel(
            columns * step_x + gap,
            count.div_ceil(columns) * step_y + gap + head,
            image::Rgb(INK),
        );
        for (i, (_, picture)) in (0_u32..).zip(&self.pictures) {
            let x = gap + i % columns * step_x + (width - picture.width()) / 2;
            let y = gap + head + i / columns * step_y + line + gap / 2;
            let y = y + (height - picture.height()) / 2;
            imageops::replace(&mut sheet, picture, i64::from(x), i64::from(y));
        }
        let mut canvas = Canvas::new(&mut sheet);
        canvas.text(IVec2::splat(gap as i32), &self.title, letters, PAPER, Align::Left);
        let letters_a_cell = (width as i32 / letters.measure("x").x) as usize;
        for (i, (label, _)) in (0_u32..).zip(&self.pictures) {
            let at = [gap + i % columns * step_x, gap + head + i / columns * step_y];
            let label: String = label.chars().take(letters_a_cell).collect();
            let at = IVec2::new(at[0] as i32, at[1] as i32);
            canvas.text(at, &label, letters, PAPER, Align::Left);
        }
        sheet
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::Rgb;

    #[test]
    fn every_picture_is_there_once() {
        let colors = [[255, 0, 0], [0, 255, 0], [0, 0, 255]];
        let mut sheet = Sheet::new("three", 2);
        for (i, color) in (0_u32..).zip(colors) {
            let picture = RgbImage::from_pixel(60 - 10 * i, 40, Rgb(color));
            sheet = sheet.picture(format!("picture {i} with a long name"), picture);
        }
        let drawn = sheet.draw();
        for (i, color) in (0_u32..).zip(colors) {
            let count = drawn.pixels().filter(|p| p.0 == color).count() as u32;
            assert_eq!(count, (60 - 10 * i) * 40, "{color:?}");
        }
        assert!(drawn.width() > 120 && drawn.height() > 80);
        assert!(drawn.pixels().any(|p| p.0 == PAPER), "labels");
        assert_eq!(Sheet::new("", 3).draw().dimensions(), (1, 1));
        let row = Sheet { columns: 0, ..sheet }.draw();
        assert!(row.width() > 180 && row.height() < 80);
    }
}
