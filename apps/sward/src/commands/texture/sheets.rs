//! Pictures about textures: all plants with their names, and mips side by side.

use anyhow::Result;
use glam::IVec2;
use image::{Rgb, RgbImage, imageops};
use sward::{Picture, Plant, plants::Angle, plants::MipLevel};
use sward_app::picture::{Align, Canvas, Color, PAPER, Sheet, Type};

/// Behind plants: the dull green of far grass.
const BEHIND: Color = [74, 84, 62];
/// Where the alpha test lets a texel through.
const SHOWN: u8 = 128;

/// A picture over the ground colour, `width` by `height`.
fn over_ground(picture: &Picture, [width, height]: [u32; 2]) -> RgbImage {
    let size = picture.size();
    let texel = |x: u32, y: u32| {
        let at = 4 * (y * size / height * size + x * size / width) as usize;
        let [r, g, b, alpha] = [0, 1, 2, 3].map(|i| picture.rgba()[at + i]);
        let mix = |over: u8, under: u8| {
            let alpha = f32::from(alpha) / 255.0;
            (f32::from(over) * alpha + f32::from(under) * (1.0 - alpha)).round() as u8
        };
        Rgb([mix(r, BEHIND[0]), mix(g, BEHIND[1]), mix(b, BEHIND[2])])
    };
    RgbImage::from_fn(width, height, texel)
}

/// A plant from the side, as wide as it is, and from above beside it.
fn cell(plant: Plant, size: u32, seed: u64) -> Result<RgbImage> {
    let side = Picture::paint(plant, seed, Angle::Side { turned: 0.0 }, size)?;
    let above = Picture::paint(plant, seed, Angle::Above, size / 2)?;
    let width = ((size as f32 * plant.width_share()).round() as u32).clamp(1, size);
    let mut cell = RgbImage::from_pixel(size + size / 2, size, Rgb(BEHIND));
    let side = over_ground(&side, [width, size]);
    imageops::replace(&mut cell, &side, i64::from((size - width) / 2), 0);
    let above = over_ground(&above, [size / 2; 2]);
    imageops::replace(&mut cell, &above, i64::from(size), i64::from(size / 4));
    Ok(cell)
}

/// All kinds from the side and from above, and the blade of strips.
pub(super) fn atlas(size: u32, seed: u64) -> Result<RgbImage> {
    let mut sheet = Sheet::new("", 3);
    for plant in Plant::ALL {
        sheet = sheet.picture(plant.name(), cell(plant, size, seed)?);
    }
    let blade = over_ground(&Picture::strip(size)?, [size / 5, size]);
    let mut last = RgbImage::from_pixel(size + size / 2, size, Rgb(BEHIND));
    imageops::replace(&mut last, &blade, i64::from(size / 2 - size / 10), 0);
    Ok(sheet.picture("strip", last).draw())
}

/// What the alpha test leaves of a level, enlarged.
fn cut(level: &MipLevel, size: u32) -> RgbImage {
    let texel = |x: u32, y: u32| {
        let at = 4 * (y * level.size / size * level.size + x * level.size / size) as usize;
        match level.rgba[at + 3] {
            SHOWN.. => Rgb([0, 1, 2].map(|i| level.rgba[at + i])),
            _ => Rgb(BEHIND),
        }
    };
    RgbImage::from_fn(size, size, texel)
}

/// The levels of plain means above, those that keep their coverage below; under each the share that
/// shows.
pub(super) fn mips(name: &str, picture: &Picture) -> RgbImage {
    let rows = [("plain means", picture.mips(false)), ("coverage kept", picture.mips(true))];
    let side = (picture.size() / 2).clamp(96, 256);
    let letters = Type::of((side * 4, side * 2));
    let line = letters.line() as u32;
    let (gap, row) = (line / 2, side + 3 * line);
    let columns = rows.iter().map(|(_, levels)| levels.len()).max().unwrap_or(1) as u32;
    let size = [columns * (side + gap) + gap, rows.len() as u32 * row + line];
    let mut sheet = RgbImage::from_pixel(size[0], size[1], Rgb([22, 24, 28]));
    for (r, (label, levels)) in (0_u32..).zip(&rows) {
        let top = gap + r * row;
        let title = format!("{name}: {label}");
        let at = IVec2::new(gap as i32, top as i32);
        Canvas::new(&mut sheet).text(at, &title, letters, PAPER, Align::Left);
        for (column, level) in (0_u32..).zip(levels) {
            let left = gap + column * (side + gap);
            let shown = cut(level, side);
            imageops::replace(&mut sheet, &shown, left.into(), (top + line + gap / 2).into());
            let text = format!("{}: {:.1} %", level.size, 100.0 * level.shown);
            let at = IVec2::new(left as i32, (top + line + gap + side) as i32);
            Canvas::new(&mut sheet).text(at, &text, letters, PAPER, Align::Left);
        }
    }
    sheet
}
