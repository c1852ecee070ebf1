//! Small pictures against stored ones. `SWARD_BLESS=1` writes them anew: look at them before they are
//! committed.
//!
//! Drivers round differently, so pictures are compared by FLIP, whose 99th percentile catches a
//! fault too small for the mean.

use super::{Folder, stderr};
use image::RgbImage;
use std::path::{Path, PathBuf};
use sward_app::compare::flip;

/// Equal but for rounding: measured 0 on the driver that drew them.
const MEAN: f32 = 0.01;
const P99: f32 = 0.15;

/// Where a stored picture is.
pub fn stored(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/golden/{name}.png"))
}

/// Renders a small picture.
pub fn draw(folder: &Folder, name: &str, size: &str, arguments: &[&str]) -> RgbImage {
    let file = format!("{name}.png");
    let size = ["--size", size, "-o", &file];
    let output = folder.sward(&[&["render"], arguments, &size[..]].concat());
    // Without an adapter this fails, loudly, as it should.
    assert!(output.status.success(), "{name}: {}", stderr(&output));
    image::open(folder.path(&file)).unwrap().into_rgb8()
}

/// Renders and compares.
pub fn golden(name: &str, size: &str, arguments: &[&str]) {
    let folder = Folder::new();
    let picture = draw(&folder, name, size, arguments);
    if std::env::var_os("SWARD_BLESS").is_some() {
        picture.save(stored(name)).unwrap();
        return;
    }
    let expected = image::open(stored(name)).unwrap().into_rgb8();
    let result = flip(&expected, &picture).unwrap();
    if result.mean > MEAN || result.p99 > P99 {
        let kept = keep(name, &picture);
        panic!("{name}: {result:?}, above {MEAN} and {P99}; the new picture is {}", kept.display());
    }
}

/// Keeps a picture that failed, to be looked at.
fn keep(name: &str, picture: &RgbImage) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    picture.save(&path).unwrap();
    path
}
