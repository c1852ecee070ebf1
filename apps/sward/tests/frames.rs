//! Any range of frames is, byte for byte, that part of the whole run: simulated without drawing, or
//! from a saved state.

mod common;

use common::{Folder, scene, stderr, stdout};

/// What was told on standard error, and the summary.
fn render(folder: &Folder, pictures: &str, extra: &[&str]) -> (String, String) {
    let scene = scene("moving.ron");
    let base = ["render", &scene, "--size", "96x64", "-o", pictures];
    let output = folder.sward(&[&base[..], extra].concat());
    assert_eq!(output.status.code(), Some(0), "{extra:?}: {}", stderr(&output));
    (stderr(&output), stdout(&output))
}

fn same(folder: &Folder, pictures: [&str; 2], frames: std::ops::Range<u32>) {
    for frame in frames {
        let [one, other] = pictures.map(|name| {
            let name = name.replace("%d", &frame.to_string());
            std::fs::read(folder.path(&name)).unwrap_or_else(|error| panic!("{name}: {error}"))
        });
        assert!(one == other, "{pictures:?}: frame {frame} differs");
    }
}

#[test]
fn two_halves_are_the_whole() {
    let folder = Folder::new();
    render(&folder, "whole%d.png", &["--frames", "0..8"]);
    render(&folder, "half%d.png", &["--frames", "0..4"]);
    let (told, said) = render(&folder, "half%d.png", &["--frames", "4..8"]);
    assert!(told.is_empty() && !said.contains("started"), "{told}{said}");
    same(&folder, ["whole%d.png", "half%d.png"], 0..8);
    let bytes = |frame: u32| std::fs::read(folder.path(&format!("whole{frame}.png"))).unwrap();
    assert!(bytes(3) != bytes(7), "nothing moves");
}

#[test]
fn a_saved_state_goes_on_as_the_whole_run_does() {
    let folder = Folder::new();
    render(&folder, "whole%d.png", &["--frames", "0..9"]);
    let every = ["--frames", "0..5", "--state-every", "3", "--states", "kept"];
    render(&folder, "first%d.png", &every);
    assert!(folder.path("kept/moving.000003.state").is_file());
    same(&folder, ["whole%d.png", "first%d.png"], 0..5);
    let goes_on = |name: &str, frames: &str, every: &[&str], from: u32| {
        let states = ["--states", "kept", "--frames", frames];
        let (told, said) = render(&folder, name, &[&states[..], every].concat());
        let expected = format!("started from the state of frame {from}");
        assert!(told.is_empty() && said.contains(&expected), "{told}{said}");
    };
    goes_on("second%d.png", "5..8", &["--state-every", "3"], 3);
    same(&folder, ["whole%d.png", "second%d.png"], 5..8);
    goes_on("third%d.png", "6..9", &[], 6);
    same(&folder, ["whole%d.png", "third%d.png"], 6..9);
}

#[test]
fn states_that_do_not_fit_are_told_and_not_used() {
    let folder = Folder::new();
    render(&folder, "%d.png", &["--frames", "0..5", "--state-every", "2"]);
    let (two, four) = (folder.path("moving.000002.state"), folder.path("moving.000004.state"));
    let sound = std::fs::read(&four).unwrap();
    let told_of = |cause: &str, from: u32, extra: &[&str]| {
        let (told, _) = render(&folder, "again%d.png", &[&["--frames", "4..5"], extra].concat());
        assert!(told.starts_with("note: moving.000004.state is not used: it "), "{told}");
        let expected = format!("{cause}; the run is simulated from frame {from} on");
        assert!(told.contains(&expected) && told.lines().count() == 1, "{told}");
    };
    told_of("is of another camera, size, rate or other setting", 0, &["--camera", "side"]);
    std::fs::write(&four, &sound[..sound.len() - 1]).unwrap();
    told_of("is cut short", 2, &[]);
    same(&folder, ["%d.png", "again%d.png"], 4..5);
    let head = sound.iter().position(|byte| *byte == b'\n').unwrap();
    let line = std::str::from_utf8(&sound[..head]).unwrap();
    let older = line.replace("\"version\":", "\"version\":9");
    assert_ne!(older, line);
    std::fs::write(&four, [older.as_bytes(), &sound[head..]].concat()).unwrap();
    told_of("was made by another version of the simulation", 2, &[]);
    let mut flipped = sound.clone();
    flipped[sound.len() - 100] ^= 1;
    std::fs::write(&four, &flipped).unwrap();
    std::fs::write(&two, "{}").unwrap();
    told_of("is damaged", 0, &[]);
    same(&folder, ["%d.png", "again%d.png"], 4..5);
}
