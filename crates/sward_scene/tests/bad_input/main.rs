//! Each kind of bad input is one line that names the file, the place and the cause; none panics.

mod damaged;
mod files;
mod pictures;
mod plants;
mod text;
mod values;

use std::path::{Path, PathBuf};
use sward_scene::{Scene, SceneError, parse};

/// A folder of its own for each test, gone at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("sward_scene_{test}_{}", std::process::id()));
        std::fs::create_dir_all(&path).expect("a temporary folder");
        Self(path)
    }
    fn write(&self, name: &str, bytes: &[u8]) {
        std::fs::write(self.0.join(name), bytes).expect("a file");
    }
    fn parse(&self, text: &str) -> Result<Scene, SceneError> {
        parse(text, &self.0.join("scene.ron"))
    }
    fn error(&self, text: &str) -> String {
        one_line(self.parse(text))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn one_line(result: Result<Scene, SceneError>) -> String {
    let text = result.expect_err("bad input").to_string();
    assert!(!text.contains('\n') && text.contains(": "), "{text}");
    text
}

fn error(text: &str) -> String {
    one_line(parse(text, Path::new("scene.ron")))
}

/// A 16-bit or 8-bit grey PNG.
fn png(width: u32, height: u32, sixteen: bool) -> Vec<u8> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    let value = |x: u32, y: u32| ((x * 7 + y * 13) % 251) as u16;
    let image = if sixteen {
        let pixel = |x, y| image::Luma([value(x, y) * 257]);
        image::DynamicImage::ImageLuma16(image::ImageBuffer::from_fn(width, height, pixel))
    } else {
        let pixel = |x, y| image::Luma([value(x, y) as u8]);
        image::DynamicImage::ImageLuma8(image::ImageBuffer::from_fn(width, height, pixel))
    };
    image.write_to(&mut bytes, image::ImageFormat::Png).expect("a PNG");
    bytes.into_inner()
}
