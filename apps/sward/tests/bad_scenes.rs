//! Scenes with bad pictures, bands and mixes: exit code 2 and one line that says what is wrong.

mod common;

use common::{Folder, stderr, stdout};
use image::{DynamicImage, ImageFormat};

/// Each way to use a picture, F.
const USES: [&str; 6] = [
    r#"fields: [(on: Plane(), plants: [(picture: (color: "F"), probability: 1)])]"#,
    r#"fields: [(on: Plane(), species: [(form: Strip(texture: (color: "F")))])]"#,
    r#"fields: [(on: Plane(), color: Texture("F"))]"#,
    r#"fields: [(on: Plane(), density_map: Texture("F"))]"#,
    r#"fields: [(on: Plane())], wind: [Texture(file: "F")]"#,
    r#"fields: [(on: Heightmap(file: "F", size_m: (20, 10)))]"#,
];

/// Checks a scene; gives what was said and the exit code.
fn check(folder: &Folder, keys: &str) -> (String, Option<i32>) {
    std::fs::write(folder.path("s.ron"), format!("({keys})")).unwrap();
    let output = folder.sward(&["check", "s.ron"]);
    let refused = output.status.code() == Some(2);
    assert!(!refused || stdout(&output).is_empty(), "{keys}: {}", stdout(&output));
    (stderr(&output), output.status.code())
}

fn refused(folder: &Folder, keys: &str, cause: &str) {
    let (error, code) = check(folder, keys);
    assert_eq!(code, Some(2), "{keys}: {error}");
    assert_eq!(error.lines().count(), 1, "{keys}: {error}");
    assert!(error.starts_with("error: ") && error.contains(cause), "{keys}: {error}");
}

fn png(image: impl Into<DynamicImage>) -> Vec<u8> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    image.into().write_to(&mut bytes, ImageFormat::Png).unwrap();
    bytes.into_inner()
}

/// A disc on nothing.
fn disc(width: u32, height: u32) -> image::RgbaImage {
    image::RgbaImage::from_fn(width, height, |x, y| {
        let inside = (1..width - 1).contains(&x) && (1..height - 1).contains(&y);
        image::Rgba([200, 40, 90, if inside { 255 } else { 0 }])
    })
}

#[test]
fn pictures_that_cannot_be_used() {
    let folder = Folder::new();
    let whole = png(disc(8, 8));
    // A frame of four inks, whatever comes after it
    let cmyk = [
        &b"\xff\xd8\xff\xee\0\x0eAdobe\0\x64\0\0\0\0\x02"[..],
        b"\xff\xc0\0\x14\x08\0\x08\0\x08\x04\x01\x11\0\x02\x11\0\x03\x11\0\x04\x11\0",
    ];
    let huge = png(image::GrayImage::new(8200, 1));
    let files: [(&str, Option<&[u8]>, &str); 6] = [
        ("none.png", None, "none.png: no such file"),
        ("cut.png", Some(&whole[..whole.len() / 2]), "cut.png: broken or unsupported image"),
        ("huge.png", Some(&huge), "huge.png: image of 8200 x 1 pixels: sides must be"),
        ("inks.jpg", Some(&cmyk.concat()), "inks.jpg: is a JPEG of four inks (CMYK)"),
        ("text.png", Some(b"no picture"), "text.png: is no PNG or JPEG image"),
        ("empty.png", Some(b""), "empty.png: is no PNG or JPEG image"),
    ];
    for (name, bytes, cause) in files {
        if let Some(bytes) = bytes {
            std::fs::write(folder.path(name), bytes).unwrap();
        }
        for keys in USES {
            refused(&folder, &keys.replace('F', name), cause);
        }
    }
    std::fs::write(folder.path("wide.png"), png(disc(12, 8))).unwrap();
    for keys in &USES[..2] {
        refused(&folder, &keys.replace('F', "wide.png"), "wide.png: 12 x 8 texels; make it square");
    }
}

/// 16 bits a channel are more than is needed, and read.
#[test]
fn pictures_of_16_bits_are_read() {
    let folder = Folder::new();
    let deep = DynamicImage::from(disc(8, 8)).into_rgba16();
    std::fs::write(folder.path("deep.png"), png(deep)).unwrap();
    for keys in &USES[..5] {
        let (said, code) = check(&folder, &keys.replace('F', "deep.png"));
        assert_eq!((said.as_str(), code), ("", Some(0)), "{keys}");
    }
}

#[test]
fn bands_and_mixes() {
    let folder = Folder::new();
    for (distances, cause) in [
        ("", "0 bands: there are three"),
        ("9, 3, 20", "9, 3, 20 are out of order"),
        ("3, 9, 9", "out of order"),
        ("3, NaN, 20", "bands.distances_m[1]: NaN"),
        ("-3, 9, 20", "bands.distances_m[0]: -3"),
    ] {
        let keys = format!("fields: [(on: Plane())], bands: (distances_m: [{distances}])");
        refused(&folder, &keys, cause);
    }
    for (probability, cause) in [
        ("-0.1", "plants[0].probability: -0.1 is out of range"),
        ("NaN", "plants[0].probability: NaN"),
        ("inf", "plants[0].probability: inf"),
        ("0", "plants: all probabilities are 0"),
    ] {
        let plants = format!(r#"(kind: "poppy", probability: {probability})"#);
        let keys = format!("fields: [(on: Plane(), plants: [{plants}])]");
        refused(&folder, &keys, cause);
    }
}
