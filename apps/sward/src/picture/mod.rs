//! Drawing onto pictures: text, lines, arrows, boxes, legends, colour bars and sheets of pictures.
//! Sizes follow the picture's: what is readable at 1280x720 stays so at 320x180 and at 4K.
//!
//! ```
//! use sward_app::picture::{Corner, Legend};
//! let mut picture = image::RgbImage::new(640, 360);
//! Legend::new("level").entry([230, 80, 40], "8 segments").entry([40, 120, 230], "4 segments")
//!     .draw(&mut picture, Corner::TopLeft);
//! ```
//!
//! Letters are the public-domain X11 fonts that `embedded-graphics` brings (Latin-1; other
//! characters show as `?`), enlarged by whole numbers.

mod canvas;
mod legend;
mod ramp;
mod sheet;

pub use canvas::{Align, Canvas, Type};
pub use legend::{ColorBar, Legend, ticks};
pub use ramp::{oklch, ramp};
pub use sheet::Sheet;

/// A colour, sRGB.
pub type Color = [u8; 3];

/// Nearly white: text and lines on dark ground.
pub const PAPER: Color = [244, 244, 240];
/// Nearly black: text and lines on light ground.
pub const INK: Color = [22, 24, 28];

/// A corner of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Corner {
    /// Above, left.
    TopLeft,
    /// Above, right.
    TopRight,
    /// Below, left.
    BottomLeft,
    /// Below, right.
    BottomRight,
}
