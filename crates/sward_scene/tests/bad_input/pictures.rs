//! Pictures of plants.

use super::Folder;

const PICTURED: &str = r#"(fields: [(on: Plane(),
    plants: [(picture: (color: "p.png", normal: "n.png"), probability: 1)])])"#;

/// A picture of a plant: a disc on nothing, as a PNG of some kind of pixels.
fn plant_png(size: u32, as_kind: impl Fn(image::RgbaImage) -> image::DynamicImage) -> Vec<u8> {
    let center = size as f32 / 2.0;
    let texel = |x: u32, y: u32| {
        let away = (x as f32 + 0.5 - center).hypot(y as f32 + 0.5 - center);
        image::Rgba([200, 40, 90, if away < 0.8 * center { 255 } else { 0 }])
    };
    let mut bytes = std::io::Cursor::new(Vec::new());
    let image = as_kind(image::RgbaImage::from_fn(size, size, texel));
    image.write_to(&mut bytes, image::ImageFormat::Png).expect("a PNG");
    bytes.into_inner()
}

/// The chunk of a PNG: its length, kind, content and checksum.
fn png_chunk(kind: &[u8; 4], content: &[u8]) -> Vec<u8> {
    let mut crc = u32::MAX;
    for byte in kind.iter().chain(content) {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = if crc & 1 == 1 { crc >> 1 ^ 0xedb8_8320 } else { crc >> 1 };
        }
    }
    let length = (content.len() as u32).to_be_bytes();
    [&length, &kind[..], content, &(!crc).to_be_bytes()].concat()
}

/// A palette PNG of 2 x 2 pixels, the second colour transparent.
fn palette_png() -> Vec<u8> {
    // Stored, not compressed: two rows of a filter byte and two indices
    let rows = [0_u8, 0, 1, 0, 1, 0];
    let (mut a, mut b) = (1_u32, 0_u32);
    for byte in rows {
        a += u32::from(byte);
        b += a;
    }
    let mut data = vec![0x78, 0x01, 0x01, 6, 0, 0xf9, 0xff];
    data.extend(rows);
    data.extend((b << 16 | a).to_be_bytes());
    [
        b"\x89PNG\r\n\x1a\n".to_vec(),
        png_chunk(b"IHDR", &[0, 0, 0, 2, 0, 0, 0, 2, 8, 3, 0, 0, 0]),
        png_chunk(b"PLTE", &[10, 200, 30, 250, 0, 0]),
        png_chunk(b"tRNS", &[255, 0]),
        png_chunk(b"IDAT", &data),
        png_chunk(b"IEND", &[]),
    ]
    .concat()
}

#[test]
fn broken_pictures_of_plants_are_named() {
    let folder = Folder::new("pictures");
    let whole = plant_png(8, Into::into);
    assert!(folder.error(PICTURED).contains("p.png: no such file"));
    folder.write("p.png", &whole);
    assert!(folder.error(PICTURED).contains("n.png: no such file"));
    folder.write("n.png", &plant_png(16, Into::into));
    let error = folder.error(PICTURED);
    assert!(error.contains("n.png: 16 x 16 texels, but the picture has 8 x 8"), "{error}");
    folder.write("n.png", &plant_png(8, Into::into));
    assert!(folder.parse(PICTURED).is_ok());
    let square = |width| image::DynamicImage::new_rgba8(width, 8);
    let save = |image: image::DynamicImage| {
        image.save_with_format(folder.0.join("p.png"), image::ImageFormat::Png).expect("saved");
    };
    save(square(12));
    assert!(folder.error(PICTURED).contains("p.png: 12 x 8 texels; make it square"));
    save(square(8));
    assert!(folder.error(PICTURED).contains("p.png: no texel has an alpha of 128 or more"));
    save(image::DynamicImage::new_rgba8(1, 1));
    assert!(folder.error(PICTURED).contains("p.png: 1 x 1 texels; use 2 to 4096 a side"));
    save(image::DynamicImage::new_luma8(4100, 4100));
    assert!(folder.error(PICTURED).contains("p.png: image of 4100 x 4100 pixels: sides must be"));
    let mut huge = whole.clone();
    huge[16..24].copy_from_slice(&[0, 0, 0xea, 0x60, 0, 0, 0xea, 0x60]);
    for (bytes, cause) in [
        (&whole[..whole.len() / 2], "p.png: broken or unsupported image"),
        (&whole[..20], "p.png: broken or unsupported image"),
        (b"GIF89a", "p.png: is no PNG or JPEG image"),
        (b"", "p.png: is no PNG or JPEG image"),
        (&huge, "p.png: "),
    ] {
        folder.write("p.png", bytes);
        let error = folder.error(PICTURED);
        assert!(error.contains(cause), "{cause}: {error}");
    }
    // Four inks: the frame's header says so, whatever comes after
    let cmyk = [
        &b"\xff\xd8\xff\xee\0\x0eAdobe\0\x64\0\0\0\0\x02"[..],
        b"\xff\xc0\0\x14\x08\0\x08\0\x08\x04\x01\x11\0\x02\x11\0\x03\x11\0\x04\x11\0",
    ];
    folder.write("p.png", &cmyk.concat());
    assert!(folder.error(PICTURED).contains("p.png: is a JPEG of four inks (CMYK)"));
}

#[test]
fn pictures_of_strips_are_read() {
    let folder = Folder::new("strips");
    let text =
        r#"(fields: [(on: Plane(), species: [(), (form: Strip(texture: (color: "p.png")))])])"#;
    assert!(folder.error(text).contains("p.png: no such file"));
    folder.write("p.png", &plant_png(8, Into::into));
    let scene = folder.parse(text).expect("a scene");
    let sward::Form::Strip(strip) = &scene.fields[0].desc.species[1].form else { panic!("strip") };
    assert_eq!(strip.texture.as_ref().map(|picture| picture.size()), Some(8));
}

/// Palettes, greys and 16 bits a channel are converted; a JPEG, which has no alpha, is told of.
#[test]
fn pictures_of_all_kinds_of_pixels_are_read() {
    use image::DynamicImage as Image;
    let folder = Folder::new("pixels");
    let text = PICTURED.replace(r#", normal: "n.png""#, "");
    let sixteen = plant_png(8, |image| Image::from(image).into_rgba16().into());
    let grey = plant_png(8, |image| Image::from(image).into_luma_alpha8().into());
    for bytes in [plant_png(8, Into::into), sixteen, grey, palette_png()] {
        folder.write("p.png", &bytes);
        let scene = folder.parse(&text).expect("a scene");
        assert!(scene.notes.is_empty(), "{:?}", scene.notes);
        let sward::Form::Billboard(billboard) = &scene.fields[0].desc.species[0].form else {
            panic!("no quads")
        };
        let sward::Look::Picture(picture) = &billboard.look else { panic!("no picture") };
        assert!(picture.rgba().chunks_exact(4).any(|texel| texel[3] == 0), "cut out");
    }
    let mut jpeg = std::io::Cursor::new(Vec::new());
    let image = Image::from(image::RgbImage::from_pixel(8, 8, image::Rgb([40, 120, 30])));
    image.write_to(&mut jpeg, image::ImageFormat::Jpeg).expect("a JPEG");
    folder.write("p.png", &jpeg.into_inner());
    let scene = folder.parse(&text).expect("a scene");
    assert!(scene.notes.iter().any(|n| n.contains("no transparent pixel")), "{:?}", scene.notes);
}
