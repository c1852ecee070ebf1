//! Keys for pictures of plants.

use serde::Deserialize;

/// A picture of a plant, or of the blade of a strip: square PNG or JPEG, 2 to 4096 pixels a side, the
/// root at the middle of its lower edge. Palettes, greys and 16 bits a channel are converted.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PictureFile {
    /// Colour, sRGB; what has an alpha of half or more is plant. Needed.
    pub color: String,
    /// Normals, of the same size: red right, green up, blue towards the viewer; default: a slightly
    /// rounded sheet.
    #[serde(default)]
    pub normal: Option<String>,
}
