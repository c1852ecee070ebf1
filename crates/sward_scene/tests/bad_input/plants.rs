//! Plants by probability.

use super::error;
use std::path::Path;
use sward_scene::{Scene, parse};

#[test]
fn plants_that_cannot_be_mixed_are_refused() {
    let cases = [
        (
            r#"plants: [(kind: "rose", probability: 1)]"#,
            "plants[0].kind: unknown plant 'rose'; known: meadow-grass,",
        ),
        (
            r#"plants: [(kind: "poppy", probability: -0.1)]"#,
            "plants[0].probability: -0.1 is out of range",
        ),
        (r#"plants: [(kind: "poppy", probability: NaN)]"#, "plants[0].probability: NaN"),
        (r#"plants: [(kind: "poppy", probability: 0)]"#, "plants: all probabilities are 0"),
        (r#"plants: [(kind: "poppy")]"#, "the key 'probability' is missing"),
        (
            r#"plants: [(kind: "poppy", probability: 1)], garden: 0.5"#,
            "garden: 0.5 asks for grasses",
        ),
        (
            r#"plants: [(kind: "poppy", probability: 1)], garden: 1.5"#,
            "garden: 1.5 is out of range",
        ),
        (r#"garden: 0.5"#, "garden: it mixes `plants`"),
        (
            r#"plants: [(kind: "poppy", probability: 1)], species: [()]"#,
            "plants: give `plants` or `species`",
        ),
        (r#"plants: [(kind: "poppy", probability: 1, quads: 7)]"#, "plants[0].quads: 7"),
        (
            r#"plants: [(kind: "poppy", probability: 1, sizes: (0, 0, 0))]"#,
            "plants[0].sizes: all are 0",
        ),
        (
            r#"plants: [(kind: "poppy", probability: 1, turn_deg: (9, 3))]"#,
            "plants[0].turn_deg: (9, 3)",
        ),
    ];
    for (keys, expected) in cases {
        let text = error(&format!("(fields: [(on: Plane(), {keys})])"));
        assert!(text.starts_with("scene.ron:1:") && text.contains(expected), "{keys}: {text}");
    }
    let scene = |keys: &str| format!("(fields: [(on: Plane(), plants: [{keys}])])");
    let text = scene(r#"(kind: "poppy", probability: 2), (kind: "fine-grass", probability: 6)"#);
    let mut mixed = parse(&text, Path::new("scene.ron")).expect("a scene");
    assert!(mixed.notes[0].contains("add up to 8.000"), "{:?}", mixed.notes);
    let shares = |scene: &Scene| -> Vec<f32> {
        scene.fields[0].desc.species.iter().map(|s| s.share).collect()
    };
    assert_eq!(shares(&mixed), [0.25, 0.75]);
    mixed.set_garden(0.9).expect("both kinds are there");
    assert!((shares(&mixed)[0] - 0.9).abs() < 1e-6);
    let refused = mixed.set_garden(-1.0).expect_err("bad").to_string();
    assert!(refused.contains("fields[0].garden: -1 is out of range"), "{refused}");
}
