//! Files that a scene refers to: meshes and images. Every index and every number is checked here.

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
