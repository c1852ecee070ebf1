//! Keys for what a plant looks like.

use serde::Deserialize;

/// What a plant looks like: a kind that the library models and paints, or pictures.
#[derive(Debug, Clone, Deserialize)]
pub enum LookFile {
    /// A tuft of broad arching blades.
    MeadowGrass,
    /// A tuft with high stalks that bear seed heads.
    TallGrass,
    /// A dense tuft of thin blades.
    FineGrass,
    /// Leaves of three, and round pink heads.
    Clover,
    /// White rays round yellow discs.
    Daisy,
    /// Red cups on slender stems.
    Poppy,
    /// Blue heads on branched stems.
    Cornflower,
    /// The white ball of seeds of a dandelion.
    DandelionClock,
    /// Pictures of the scene's own.
    Picture(PictureFile),
}

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
