//! Pictures that a host gives for its own plants.

use super::paint::paint;
use super::strip::strip;
use super::{Angle, Plant};
use crate::Error;
use crate::bake::mips::{chain, passing};
use crate::bake::raster::{Texel, Tile};
use glam::{Vec2, Vec3};

/// Shortest and longest side, texels.
const LEAST_SIDE: u32 = 2;
const MOST_SIDE: u32 = 4096;
/// Alpha from which a texel counts as shown.
const SHOWN: u8 = 128;

/// A picture of a plant, or of the blade of a strip: square, with its root at the middle of the
/// lower edge. It is resampled to the size of the library's own textures, 128 x 128; larger ones
/// only cost time when they are read.
#[derive(Clone, PartialEq)]
pub struct Picture {
    size: u32,
    color: Vec<u8>,
    normal: Option<Vec<u8>>,
}

impl std::fmt::Debug for Picture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let normal = if self.normal.is_some() { ", with normals" } else { "" };
        write!(f, "Picture({0} x {0}{normal})", self.size)
    }
}

impl Picture {
    /// A picture of `size` (width, height) from 8-bit sRGB with straight alpha: 4 bytes a texel,
    /// row by row from the top. What has an alpha of half or more is plant, the rest is cut away.
    ///
    /// # Errors
    /// [`Error::Setting`] where it is not square, smaller than 2 or larger than 4096 a side, where
    /// bytes are missing or left over, or where nothing of it shows.
    pub fn new([width, height]: [u32; 2], rgba: Vec<u8>) -> Result<Self, Error> {
        let bad = |cause: String| Err(Error::setting("picture", cause));
        if width != height {
            return bad(format!("{width} x {height} texels; make it square"));
        }
        check_side([width, height])?;
        check_bytes("picture", width, &rgba)?;
        if !rgba.iter().skip(3).step_by(4).any(|alpha| *alpha >= SHOWN) {
            return bad(format!("no texel has an alpha of {SHOWN} or more, so nothing shows"));
        }
        Ok(Self { size: width, color: rgba, normal: None })
    }

    /// Adds normals, of the same size and order: red is right, green up, blue towards the viewer,
    /// -1..1 as 0..255; alpha is not read. Without, it is lit as a slightly rounded sheet.
    ///
    /// # Errors
    /// [`Error::Setting`] where the size or the number of bytes is not the picture's.
    pub fn with_normals(self, size: [u32; 2], rgba: Vec<u8>) -> Result<Self, Error> {
        if size != [self.size; 2] {
            let cause = format!(
                "{} x {} texels, but the picture has {2} x {2}; make them alike",
                size[0], size[1], self.size
            );
            return Err(Error::setting("picture.normals", cause));
        }
        check_bytes("picture.normals", self.size, &rgba)?;
        Ok(Self { normal: Some(rgba), ..self })
    }

    /// The library's own picture of a plant, of `size` texels a side, from the variant of a seed:
    /// its box, as wide as [`Plant::width_share`] says, stretched to a square. Unlit; alpha is how
    /// much of a texel the plant covers.
    ///
    /// # Errors
    /// [`Error::Setting`] where the size is out of 2 to 4096.
    pub fn paint(plant: Plant, seed: u64, angle: Angle, size: u32) -> Result<Self, Error> {
        check_side([size; 2])?;
        Ok(Self::from_tile(&paint(plant, seed, angle, size)))
    }

    /// The library's own texture of strips: a blade in greys, which the species' colours tint.
    ///
    /// # Errors
    /// [`Error::Setting`] where the size is out of 2 to 4096.
    pub fn strip(size: u32) -> Result<Self, Error> {
        check_side([size; 2])?;
        Ok(Self::from_tile(&strip(size)))
    }

    /// Side, texels.
    pub fn size(&self) -> u32 {
        self.size
    }

    /// 8-bit sRGB with straight alpha, row by row from the top.
    pub fn rgba(&self) -> &[u8] {
        &self.color
    }

    /// Normals, as those of [`Picture::with_normals`].
    pub fn normals(&self) -> Option<&[u8]> {
        self.normal.as_deref()
    }

    /// The levels that it is drawn with, each of half the size of the one before. With `kept`, as
    /// the library does, alphas are scaled level by level so that the share of it that passes the
    /// alpha test stays (I. Castano, "Computing alpha mipmaps", 2010); without, they are plain
    /// means, and narrow things vanish.
    pub fn mips(&self, kept: bool) -> Vec<MipLevel> {
        let base = self.tile();
        let levels = if kept {
            let shown = base.coverage();
            chain(base, shown)
        } else {
            let mut levels = vec![base];
            while let Some(last) = levels.last()
                && last.size[0] >= 8
            {
                levels.push(last.halved());
            }
            levels
        };
        let level = |tile: &Tile| MipLevel {
            size: tile.size[0],
            rgba: tile.texels.iter().flat_map(encode).collect(),
            shown: passing(tile),
        };
        levels.iter().map(level).collect()
    }

    fn from_tile(tile: &Tile) -> Self {
        let normal = |texel: &Texel| {
            let [x, y, z] = texel.normal.normalize_or(Vec3::Z).to_array();
            [x, y, z, 1.0].map(|c| ((0.5 * c + 0.5) * 255.0).round() as u8)
        };
        Self {
            size: tile.size[0],
            color: tile.texels.iter().flat_map(encode).collect(),
            normal: Some(tile.texels.iter().flat_map(normal).collect()),
        }
    }

    fn texel(&self, x: u32, y: u32) -> Texel {
        let at = 4 * (y * self.size + x) as usize;
        let channel = |i: usize| self.color.get(at + i).copied().unwrap_or(0);
        let normal = match &self.normal {
            Some(bytes) => {
                let part = |i: usize| f32::from(bytes.get(at + i).copied().unwrap_or(128));
                Vec3::new(part(0), part(1), part(2)) / 127.5 - 1.0
            }
            None => {
                Vec3::new(ROUNDED * (2.0 * (x as f32 + 0.5) / self.size as f32 - 1.0), 0.0, 1.0)
            }
        };
        Texel {
            albedo: Vec3::new(channel(0).into(), channel(1).into(), channel(2).into())
                .map(|c| linear(c / 255.0)),
            alpha: f32::from(channel(3)) / 255.0,
            normal: normal.normalize_or(Vec3::Z),
            height_share: 1.0 - (y as f32 + 0.5) / self.size as f32,
            thickness: 1.0,
        }
    }

    fn tile(&self) -> Tile {
        let texels = (0..self.size * self.size).map(|i| self.texel(i % self.size, i / self.size));
        let mut tile = Tile { size: [self.size; 2], texels: texels.collect() };
        tile.dilate();
        tile
    }

    /// At another size: means where it becomes smaller, interpolated where it becomes larger.
    pub(super) fn resampled(&self, size: u32) -> Tile {
        if size == self.size {
            return self.tile();
        }
        let step = self.size as f32 / size as f32;
        let texels = (0..size * size).map(|i| {
            let corner = Vec2::new((i % size) as f32, (i / size) as f32) * step;
            // At least a texel wide, so that an enlarged picture is smooth
            let grow = 0.5 * (1.0 - step).max(0.0);
            self.mean(corner - grow, corner + step + grow)
        });
        let mut tile = Tile { size: [size; 2], texels: texels.collect() };
        tile.dilate();
        tile
    }

    /// The mean over a box, in texels, weighted by alpha; beyond the rim is nothing.
    fn mean(&self, low: Vec2, high: Vec2) -> Texel {
        let end = self.size as f32;
        let mut sum = Texel::EMPTY;
        let cells = |low: f32, high: f32| low.max(0.0) as u32..(high.min(end).ceil() as u32);
        for y in cells(low.y, high.y) {
            for x in cells(low.x, high.x) {
                let cell = Vec2::new(x as f32, y as f32);
                let part = (high.min(cell + 1.0) - low.max(cell)).max(Vec2::ZERO);
                let texel = self.texel(x, y);
                let weight = part.x * part.y * texel.alpha;
                sum.albedo += texel.albedo * weight;
                sum.normal += texel.normal * weight;
                sum.height_share += texel.height_share * weight;
                sum.alpha += weight;
            }
        }
        if sum.alpha <= 0.0 {
            return Texel::EMPTY;
        }
        let area = high.min(Vec2::splat(end)) - low.max(Vec2::ZERO);
        Texel {
            albedo: sum.albedo / sum.alpha,
            alpha: (sum.alpha / (area.x * area.y)).min(1.0),
            normal: sum.normal.normalize_or(Vec3::Z),
            height_share: sum.height_share / sum.alpha,
            thickness: 1.0,
        }
    }
}

/// One level of a picture's mips.
#[derive(Debug, Clone, PartialEq)]
pub struct MipLevel {
    /// Side, texels.
    pub size: u32,
    /// 8-bit sRGB with straight alpha, row by row from the top.
    pub rgba: Vec<u8>,
    /// Share of its area that passes the alpha test, 0..=1.
    pub shown: f32,
}

/// How far the normals of a picture that has none turn to the sides.
const ROUNDED: f32 = 0.35;

fn linear(x: f32) -> f32 {
    if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
}

fn encoded(x: f32) -> f32 {
    if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 }
}

fn encode(texel: &Texel) -> [u8; 4] {
    let byte = |x: f32| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    let [r, g, b] = texel.albedo.to_array().map(|c| byte(encoded(c)));
    [r, g, b, byte(texel.alpha)]
}

fn check_side([width, height]: [u32; 2]) -> Result<(), Error> {
    if (LEAST_SIDE..=MOST_SIDE).contains(&width) && width == height {
        return Ok(());
    }
    let cause = format!("{width} x {height} texels; use {LEAST_SIDE} to {MOST_SIDE} a side");
    Err(Error::setting("picture", cause))
}

fn check_bytes(setting: &str, side: u32, rgba: &[u8]) -> Result<(), Error> {
    let needed = 4 * side as usize * side as usize;
    if rgba.len() == needed {
        return Ok(());
    }
    let cause = format!("{} bytes; {side} x {side} texels of RGBA are {needed}", rgba.len());
    Err(Error::setting(setting, cause))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey(side: usize) -> Vec<u8> {
        vec![200; 4 * side * side]
    }

    #[test]
    fn what_cannot_be_shown_is_refused() {
        let text = |size, bytes| Picture::new(size, bytes).expect_err("bad").to_string();
        assert!(text([4, 8], grey(4)).contains("4 x 8 texels; make it square"));
        assert!(text([1, 1], grey(1)).contains("use 2 to 4096 a side"));
        assert!(text([5000, 5000], Vec::new()).contains("use 2 to 4096 a side"));
        assert!(text([4, 4], grey(3)).contains("36 bytes; 4 x 4 texels of RGBA are 64"));
        assert!(text([4, 4], vec![127; 64]).contains("nothing shows"));
        let picture = Picture::new([4, 4], grey(4)).expect("a picture");
        let error = picture.clone().with_normals([8, 8], grey(8)).expect_err("bad").to_string();
        assert!(error.contains("picture.normals: 8 x 8 texels, but the picture has 4 x 4"));
        assert!(picture.clone().with_normals([4, 4], grey(3)).is_err());
        assert!(picture.with_normals([4, 4], grey(4)).expect("normals").normals().is_some());
    }
}
