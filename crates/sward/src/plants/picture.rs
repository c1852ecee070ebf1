//! Pictures that a host gives for its own plants.

use crate::Error;

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
        if !(LEAST_SIDE..=MOST_SIDE).contains(&width) {
            return bad(format!(
                "{width} x {height} texels; use {LEAST_SIDE} to {MOST_SIDE} a side"
            ));
        }
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

    /// Side, texels.
    pub fn size(&self) -> u32 {
        self.size
    }

    /// Whether it has normals.
    pub fn has_normals(&self) -> bool {
        self.normal.is_some()
    }
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
        assert!(picture.with_normals([4, 4], grey(4)).expect("normals").has_normals());
    }
}
