//! PNG and JPEG images.

use crate::SceneError;
use image::{DynamicImage, ImageFormat, ImageReader, Limits};
use std::io::Cursor;
use std::path::Path;

/// An image: 8-bit sRGB with straight alpha.
#[derive(Clone, PartialEq)]
pub struct TextureImage {
    /// Width, texels.
    pub width: u32,
    /// Height, texels.
    pub height: u32,
    /// RGBA, row by row from the top: `width * height * 4` bytes.
    pub pixels: Vec<u8>,
}

impl std::fmt::Debug for TextureImage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "TextureImage({} x {})", self.width, self.height)
    }
}

/// Longest side of an image, pixels: what every adapter takes as a texture.
pub(crate) const MAX_SIDE: u32 = 8192;
const MAX_BYTES: u64 = 1 << 30;

/// Longest side of a picture of a plant, pixels: it is resampled to far fewer anyway.
const MAX_PICTURE_SIDE: u32 = 4096;

/// Decodes a PNG or JPEG, told apart by its bytes.
pub(crate) fn decode(file: &Path, bytes: &[u8]) -> Result<DynamicImage, SceneError> {
    decode_up_to(file, bytes, MAX_SIDE)
}

fn decode_up_to(file: &Path, bytes: &[u8], most: u32) -> Result<DynamicImage, SceneError> {
    let format = image::guess_format(bytes)
        .ok()
        .filter(|format| matches!(format, ImageFormat::Png | ImageFormat::Jpeg))
        .ok_or_else(|| SceneError::asset(file, "is no PNG or JPEG image; convert it to PNG"))?;
    if format == ImageFormat::Jpeg && jpeg_channels(bytes) == Some(4) {
        let cause = "is a JPEG of four inks (CMYK), which has no one colour on a screen; convert it to \
                     sRGB";
        return Err(SceneError::asset(file, cause));
    }
    let broken = |error: image::ImageError| {
        let cause = format!("broken or unsupported image: {error}; export it again");
        SceneError::asset(file, cause)
    };
    let reader = || ImageReader::with_format(Cursor::new(bytes), format);
    let (width, height) = reader().into_dimensions().map_err(broken)?;
    if width == 0 || height == 0 || width.max(height) > most {
        let cause =
            format!("image of {width} x {height} pixels: sides must be 1 to {most}; scale it down");
        return Err(SceneError::asset(file, cause));
    }
    let mut limited = reader();
    let mut limits = Limits::default();
    limits.max_alloc = Some(MAX_BYTES);
    limited.limits(limits);
    limited.decode().map_err(broken)
}

/// Channels of a JPEG, as the header of its frame says; `None` where there is none.
fn jpeg_channels(bytes: &[u8]) -> Option<u8> {
    let mut at = 2;
    loop {
        let &[0xff, marker, high, low] = bytes.get(at..at + 4)? else { return None };
        match marker {
            // Frames of all kinds; the three in between are tables
            0xc4 | 0xc8 | 0xcc => {}
            0xc0..=0xcf => return bytes.get(at + 9).copied(),
            // The picture's data follow
            0xda => return None,
            // A byte that fills up
            0xff => {
                at += 1;
                continue;
            }
            _ => {}
        }
        at += 2 + usize::from(u16::from_be_bytes([high, low]));
    }
}

/// Decodes a picture of a plant, whatever its kind of pixels.
pub(crate) fn picture(file: &Path, bytes: &[u8]) -> Result<TextureImage, SceneError> {
    let image = decode_up_to(file, bytes, MAX_PICTURE_SIDE)?.into_rgba8();
    Ok(TextureImage { width: image.width(), height: image.height(), pixels: image.into_raw() })
}

/// Decodes a texture.
pub(crate) fn texture(file: &Path, bytes: &[u8]) -> Result<TextureImage, SceneError> {
    let image = decode(file, bytes)?.into_rgba8();
    Ok(TextureImage { width: image.width(), height: image.height(), pixels: image.into_raw() })
}

/// Decodes a grey map to values 0..=1, as they are stored (no transfer function).
pub(crate) fn density(file: &Path, bytes: &[u8]) -> Result<sward::DensityMap, SceneError> {
    let image = decode(file, bytes)?.into_luma16();
    let (width, height) = image.dimensions();
    let values = image.into_raw().iter().map(|&v| f32::from(v) / f32::from(u16::MAX)).collect();
    Ok(sward::DensityMap::Texture { width, height, values })
}

/// Decodes a map of winds: a grey image is the strength along the wind; of a colour image red is along
/// the wind and green across it, and the middle of their range is none. Values are taken as stored.
pub(crate) fn wind(file: &Path, bytes: &[u8]) -> Result<sward::WindMap, SceneError> {
    let image = decode(file, bytes)?;
    let (width, height) = (image.width(), image.height());
    if width.max(height) > sward::WindMap::MAX_SIDE {
        let most = sward::WindMap::MAX_SIDE;
        let cause = format!("{width} x {height} pixels: a map of winds has at most {most} a side");
        return Err(SceneError::asset(file, cause));
    }
    let pixels = image.into_rgb16().into_raw();
    let (pixels, _) = pixels.as_chunks::<3>();
    let unit = |value: u16| f32::from(value) / f32::from(u16::MAX);
    let grey = pixels.iter().all(|[r, g, b]| r == g && g == b);
    let winds = pixels.iter().map(|[r, g, _]| match grey {
        true => [unit(*r), 0.0],
        false => [r, g].map(|part| 2.0 * unit(*part) - 1.0),
    });
    sward::WindMap::new(width, height, winds.collect())
        .map_err(|error| SceneError::asset(file, error.to_string()))
}
