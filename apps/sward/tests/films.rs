//! Films, and what is said where there is no ffmpeg or it fails.

mod common;

use common::{Folder, scene, stderr, stdout};
use std::process::Command;

/// Whether there is one. Where the setup was to install it, its lack is a failure.
fn ffmpeg() -> bool {
    let there = Command::new("ffmpeg").arg("-version").output().is_ok();
    let wanted = ["CI", "SWARD_TEST_FFMPEG"].iter().any(|name| std::env::var_os(name).is_some());
    assert!(there || !wanted, "films cannot be tested: there is no ffmpeg on the PATH");
    there
}

const FRAMES: [&str; 2] = ["--frames", "0..3"];

fn render(folder: &Folder, extra: &[&str]) -> (Option<i32>, String, String) {
    let scene = scene("moving.ron");
    let output = folder.sward(&[&["render", &scene], &FRAMES[..], extra].concat());
    (output.status.code(), stdout(&output), stderr(&output))
}

/// The film's frames as RGB.
fn decoded(folder: &Folder, film: &str) -> Vec<u8> {
    let film = folder.path(film);
    let arguments = ["-loglevel", "error", "-i", film.to_str().unwrap()];
    let output = Command::new("ffmpeg")
        .args(arguments)
        .args(["-f", "rawvideo", "-pix_fmt", "rgb24", "-"])
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", stderr(&output));
    output.stdout
}

fn mean_difference(film: &[u8], picture: &image::RgbImage, [width, height]: [u32; 2]) -> f64 {
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let bytes = pixels.flat_map(|(x, y)| picture.get_pixel(x, y).0);
    let sum: f64 = film.iter().zip(bytes).map(|(a, b)| f64::from(a.abs_diff(b))).sum();
    sum / film.len() as f64
}

/// Every frame is there, in its colours; where there is no ffmpeg, that is said.
#[test]
fn films_show_the_frames() {
    let folder = Folder::new();
    let cases = [("a.mp4", [96, 64]), ("a.gif", [97, 65])];
    for (film, [width, height]) in cases {
        let (code, said, told) = render(&folder, &["-o", film, "--size", "97x65"]);
        if !ffmpeg() {
            assert_eq!(code, Some(2), "{told}");
            assert!(told.contains("needs ffmpeg, which is not on the PATH"), "{told}");
            assert!(folder.names().is_empty());
            continue;
        }
        assert_eq!(code, Some(0), "{told}");
        assert!(said.starts_with(&format!("{film} (3 frames, 0 to 2): 97 x 65")), "{said}");
        let note = "note: a.mp4: 97 x 65 is cropped to 96 x 64: H.264 needs even sides\n";
        assert_eq!(told, if film == "a.mp4" { note } else { "" });
        let film = decoded(&folder, film);
        let frame = (width * height * 3) as usize;
        assert_eq!(film.len(), 3 * frame);
        render(&folder, &["-o", "%d.png", "--size", "97x65"]);
        let picture = |i| image::open(folder.path(&format!("{i}.png"))).unwrap().into_rgb8();
        let pictures = [0, 1, 2].map(picture);
        for (i, shown) in film.chunks_exact(frame).enumerate() {
            let to = |picture| mean_difference(shown, picture, [width, height]);
            let differences: Vec<_> = pictures.iter().map(to).collect();
            assert!(differences[i] < 9.0, "frame {i}: {differences:?}");
            // And it is this one, neither the one before nor the one after
            for (other, difference) in differences.iter().enumerate().filter(|(j, _)| *j != i) {
                assert!(*difference > 1.5 * differences[i], "{i} as {other}: {differences:?}");
            }
        }
    }
}

/// ffmpeg would take the one for a protocol, the other for an option.
#[test]
fn names_of_films_are_names() {
    if !ffmpeg() {
        return;
    }
    let folder = Folder::new();
    for (film, output) in [("12:30.mp4", "--output=12:30.mp4"), ("-a.gif", "--output=-a.gif")] {
        let (code, _, told) = render(&folder, &[output, "--size", "32x32"]);
        assert_eq!(code, Some(0), "{film}: {told}");
        assert!(folder.names().contains(&film.into()), "{:?}", folder.names());
    }
    assert_eq!(folder.names().len(), 2);
}

#[test]
fn without_ffmpeg_one_line_says_so() {
    let folder = Folder::new();
    let scene = scene("tiny.ron");
    let arguments = ["render", &scene, "-o", "a.gif", "--frames", "0..2"];
    let output = folder.sward_with(&arguments, &[("PATH", "/none")]);
    let error = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{error}");
    assert!(error.contains("-o a.gif: needs ffmpeg") && error.lines().count() == 1, "{error}");
    assert!(folder.names().is_empty());
}

/// One that ends at once, and one that ends after all frames.
#[test]
#[cfg(unix)]
fn an_ffmpeg_that_fails_is_told_by_its_last_line() {
    use std::os::unix::fs::PermissionsExt;
    for script in ["", "cat > /dev/null; touch \"${last#file:}\""] {
        let folder = Folder::new();
        let text = format!(
            "#!/bin/sh\nfor last; do :; done\n{script}\necho first >&2\necho 'no such codec' >&2\necho >&2\nexit 3\n"
        );
        let fake = folder.path("ffmpeg");
        std::fs::write(&fake, text).unwrap();
        std::fs::set_permissions(&fake, std::fs::Permissions::from_mode(0o755)).unwrap();
        let path = format!("{}:{}", folder.path("").display(), std::env::var("PATH").unwrap());
        std::fs::write(folder.path("a.mp4"), "earlier").unwrap();
        let scene = scene("tiny.ron");
        let size = ["--size", "640x480"];
        let arguments =
            [&["render", &scene, "-o", "a.mp4", "--frames", "0..2"], &size[..]].concat();
        let output = folder.sward_with(&arguments, &[("PATH", &path)]);
        let error = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{error}");
        assert_eq!(error, "error: a.mp4: ffmpeg failed: no such codec\n");
        assert_eq!(folder.names(), ["a.mp4", "ffmpeg"], "{script}");
        assert_eq!(std::fs::read(folder.path("a.mp4")).unwrap(), b"earlier");
    }
}
