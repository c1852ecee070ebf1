//! The scenes that the project ships: each is valid, each looks as it did, and each file beside them
//! says where it comes from. `SWARD_BLESS=1 cargo test -p sward_app --test scenes` writes the
//! pictures anew; `common/golden.rs` says how they are compared.

mod common;

use common::{Folder, golden, shipped, stderr};
use std::collections::BTreeSet;
use std::path::Path;

/// A picture of a shipped scene, from its first camera.
fn looks(name: &str, arguments: &[&str]) {
    let scene = shipped().join(format!("{name}.ron"));
    let arguments = [&[scene.to_str().unwrap()], arguments].concat();
    golden::golden(&format!("scenes/{name}"), "256x144", &arguments);
}

macro_rules! scenes {
    ($($name:ident $arguments:tt),* $(,)?) => {
        const SCENES: &[&str] = &[$(stringify!($name)),*];
        $(#[test]
        fn $name() {
            looks(stringify!($name), &$arguments);
        })*
    };
}

// One test each, so that they run side by side and a failure names its scene.
scenes! {
    balls ["--time", "0.8"],
    bunny [],
    closeup [],
    displacement [],
    fur [],
    garden [],
    hand ["--time", "1.8"],
    hand_billboards ["--time", "1.8"],
    helicopter [],
    meadow [],
    minimal [],
    mobius [],
    nature [],
    plain [],
    planet [],
    reference [],
    shapes [],
    strips [],
    tornado [],
}

/// Names without endings of the files of one kind in a folder.
fn stems(folder: &Path, ending: &str) -> BTreeSet<String> {
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let files = files.filter(|path| path.extension().is_some_and(|e| e == ending));
    files.map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned()).collect()
}

#[test]
fn every_scene_has_its_picture_and_every_picture_its_scene() {
    let listed: BTreeSet<String> = SCENES.iter().map(|name| (*name).to_owned()).collect();
    assert_eq!(
        stems(&shipped(), "ron"),
        listed,
        "a scene without a test, or a test without a scene"
    );
    let pictures = golden::stored("scenes/x");
    assert_eq!(stems(pictures.parent().unwrap(), "png"), listed);
}

#[test]
fn every_scene_is_valid() {
    let folder = Folder::new();
    for name in stems(&shipped(), "ron") {
        let scene = shipped().join(format!("{name}.ron"));
        let output = folder.sward(&["check", scene.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(0), "{name}: {}", stderr(&output));
        // Meshes are packed where no spheres are kept beside them yet.
        let stderr = stderr(&output);
        let warnings = stderr.lines().filter(|line| !line.starts_with("note: packed '"));
        assert_eq!(warnings.collect::<Vec<_>>(), Vec::<&str>::new(), "{name} is to give none");
    }
}

#[test]
fn every_asset_has_its_licence_and_is_used() {
    let assets = shipped().join("assets");
    let licences = std::fs::read_to_string(assets.join("LICENSES.md")).unwrap();
    let read =
        |name: &String| std::fs::read_to_string(shipped().join(format!("{name}.ron"))).unwrap();
    let scenes: String = stems(&shipped(), "ron").iter().map(read).collect();
    for entry in std::fs::read_dir(&assets).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        // Spheres that fill a mesh are made when they are first wanted, maybe at this moment.
        if name == "LICENSES.md" || name.contains(".pack") {
            continue;
        }
        let headed = licences.lines().any(|line| line.starts_with("## ") && line.contains(&name));
        assert!(headed, "{name} has no section in LICENSES.md");
        let made_by = name.ends_with(".py");
        assert!(made_by || scenes.contains(&format!("assets/{name}")), "no scene uses {name}");
    }
}
