//! Sound files with some bytes changed.

use super::files::HILLS;
use super::{Folder, png};
use proptest::prelude::*;
use std::path::Path;
use sward_scene::parse;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn damaged_scenes_never_panic(
        which in 0_usize..3,
        cut in 0.0_f64..2.0,
        edits in prop::collection::vec((0.0_f64..1.0, "[ -~]{0,2}"), 0..4),
    ) {
        let scenes = [
            include_str!("../../../../scenes/minimal.ron"),
            "(fields: [(on: Plane(), species: [(height_m: (1, 2), root_color: (\"#aabbcc\", (1, 0, 1)))],
              tufts: (share: 0.5), height_limits_m: (-inf, 3.5))], cameras: [(eye: (0, 1, 2), target: (0, 0, 0))])",
            "(fields: [(on: Sphere(segments: 8), count: 30)], wind: [Cosine(), Gusts(seed: 3),
              Rotor(path: [(0, 1, 2, 3)]), Fan(direction: (0, -1, 1e-3)), Vortex()],
              spheres: [(path: [(0, 1, 2, 3), (2, 3, 4, 5)])], sun: (azimuth_deg: 1e3) /* end */)",
        ];
        let mut text = scenes[which].to_owned();
        for (at, with) in edits {
            let at = ((at * text.len() as f64) as usize).min(text.len() - 1);
            text.replace_range(at..=at, &with);
        }
        if cut < 1.0 {
            text.truncate((cut * text.len() as f64) as usize);
        }
        let _ = parse(&text, Path::new("/nowhere/scene.ron"));
    }

    #[test]
    fn damaged_files_never_panic(
        flips in prop::collection::vec((0.0_f64..1.0, any::<u8>()), 0..5),
        cut in 0.0_f64..2.0,
    ) {
        let folder = Folder::new("damaged");
        let obj: &[u8] = b"v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/1/1 -1/-1/-1\n";
        for (name, whole, scene) in [
            ("h.png", png(5, 4, true), HILLS),
            ("b.obj", obj.to_vec(), r#"(fields: [(on: File("b.obj"))])"#),
        ] {
            let mut bytes = whole;
            for (at, value) in &flips {
                let at = ((at * bytes.len() as f64) as usize).min(bytes.len() - 1);
                bytes[at] = *value;
            }
            if cut < 1.0 {
                bytes.truncate((cut * bytes.len() as f64) as usize);
            }
            folder.write(name, &bytes);
            let _ = folder.parse(scene);
        }
    }
}
