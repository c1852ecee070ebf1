//! `sward paper` on stand-ins of its scenes.

mod common;

use common::{Folder, scene, stderr, stdout};
use serde_json::Value;

fn paper(folder: &Folder, extra: &[&str]) -> String {
    let scenes = scene("paper");
    let base = ["paper", "-o", "out", "--scenes", &scenes, "--quick", "--frames", "1"];
    let output = folder.sward(&[&base[..], extra].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_eq!(stderr(&output), "");
    stdout(&output)
}

fn read(folder: &Folder, name: &str) -> String {
    std::fs::read_to_string(folder.path("out").join(name)).unwrap()
}

fn json(folder: &Folder) -> Value {
    serde_json::from_str(&read(folder, "tables.json")).unwrap()
}

/// Targets of `href="..."`, `src="..."` and `](...)`.
fn links(text: &str) -> Vec<String> {
    let after = |mark: &str, end: char| {
        let parts = text.split(mark).skip(1);
        parts.map(|part| part.split(end).next().unwrap().to_string()).collect::<Vec<_>>()
    };
    [after("href=\"", '"'), after("src=\"", '"'), after("](", ')')].concat()
}

/// All on one run: it takes the longest of all tests of the command.
#[test]
fn tables_pictures_and_pages() {
    let folder = Folder::new();
    let said = paper(&folder, &[]);
    assert!(said.contains("out/index.html: tables and "), "{said}");
    let tables = json(&folder);
    every_run_adds_up(&tables);
    culling_and_collisions_are_off_where_they_should_be(&tables);
    tables_say_what_the_runs_say(&tables);
    every_link_leads_to_a_file(&folder);
    the_papers_column_is_honest(&folder, &tables);
}

fn every_run_adds_up(tables: &Value) {
    let runs = tables["runs"].as_array().unwrap();
    assert_eq!(runs.len(), 6);
    for run in runs {
        let report = &run["report"];
        let count = |key: &str| report[key].as_u64().unwrap();
        let culled = |key: &str| report["blades_culled"][key].as_u64().unwrap();
        let by_test = ["orientation", "frustum", "distance", "occlusion"].map(culled);
        let any = count("blades_visible") - count("blades_drawn") - count("blades_dropped");
        let (most, sum) = (by_test.into_iter().max().unwrap(), by_test.iter().sum::<u64>());
        // A blade that fails two tests counts in both.
        assert!((most..=sum).contains(&any), "{any} culled, by test {by_test:?}: {run}");
        assert_eq!(count("blades_dropped"), 0);
        assert!(count("blades_drawn") > 0 && count("blades_visible") <= count("blades_total"));
        for part in ["frame", "physics", "visibility", "draw", "post"] {
            let ms = |which: &str| report["ms"][part][which].as_f64().unwrap();
            assert!(ms("p50") > 0.0 && ms("p99") >= ms("p50"), "{part}");
        }
    }
}

fn run<'a>(tables: &'a Value, scene: &str, condition: &str) -> &'a Value {
    let runs = tables["runs"].as_array().unwrap();
    let found = runs.iter().find(|run| run["scene"] == scene && run["condition"] == condition);
    &found.unwrap()["report"]
}

fn culling_and_collisions_are_off_where_they_should_be(tables: &Value) {
    for scene in ["nature", "helicopter"] {
        let off = run(tables, scene, "culling_off");
        assert_eq!(off["blades_drawn"], off["blades_total"]);
        assert_eq!(off["blades_visible"], off["blades_total"]);
        let on = run(tables, scene, "everything_on");
        assert!(on["blades_drawn"].as_u64() < off["blades_drawn"].as_u64(), "{scene}");
    }
    let tested = |condition| run(tables, "nature", condition)["spheres_tested"].as_u64().unwrap();
    assert!(tested("everything_on") > 0 && tested("culling_off") > 0);
    assert_eq!(tested("collisions_off"), 0);
    let hidden = &run(tables, "nature", "everything_on")["blades_culled"]["occlusion"];
    assert!(hidden.as_u64().unwrap() > 0, "the rocks hide nothing");
}

fn tables_say_what_the_runs_say(tables: &Value) {
    let numbers: Vec<_> = tables["tables"]
        .as_array()
        .unwrap()
        .iter()
        .map(|t| t["number"].as_u64().unwrap())
        .collect();
    assert_eq!(numbers, [1, 2, 3, 4]);
    let cell = |table: usize, quantity: &str, scene: &str| {
        let rows = tables["tables"][table]["rows"].as_array().unwrap();
        let row = rows.iter().find(|row| row["quantity"] == quantity).unwrap();
        row["scenes"][scene]["sward"].clone()
    };
    for (table, condition) in [(0, "everything_on"), (2, "collisions_off"), (3, "culling_off")] {
        for scene in ["nature", "helicopter"] {
            let report = run(tables, scene, condition);
            assert_eq!(cell(table, "blades_drawn", scene), report["blades_drawn"]);
            assert_eq!(cell(table, "frame_ms", scene), report["ms"]["frame"]);
            let fps = cell(table, "fps", scene).as_f64().unwrap();
            let ms = report["ms"]["frame"]["p50"].as_f64().unwrap();
            assert!((fps * ms / 1e3 - 1.0).abs() < 1e-4, "{fps} of {ms}");
        }
    }
    let count = |quantity: &str| cell(1, quantity, "nature").as_u64().unwrap();
    assert_eq!(count("culled_any") + count("blades_drawn"), count("blades_visible"));
    for key in ["adapter", "driver", "backend", "size", "samples", "frames_measured"] {
        assert!(!tables[key].is_null(), "{key}");
    }
    // One unmeasured and one measured frame, as a whole and then by stage; four to be counted.
    assert_eq!(tables["frame_counted"], 8);
}

fn every_link_leads_to_a_file(folder: &Folder) {
    for page in ["index.html", "index.md"] {
        let text = read(folder, page);
        let links = links(&text);
        assert!(links.len() >= 8, "{links:?}");
        for link in links {
            assert!(!link.contains(':') && !link.starts_with('/'), "{link} leads elsewhere");
            assert!(folder.path("out").join(&link).is_file(), "{page}: {link}");
        }
        assert!(text.contains("sward render scenes/nature.ron"), "{page}: no command");
        assert!(text.contains("among the scenes"), "{page}: nothing is said to be missing");
    }
}

fn the_papers_column_is_honest(folder: &Folder, tables: &Value) {
    let text = read(folder, "tables.md");
    assert!(text.contains("| blades | 397,881 |") && text.contains("not available here"), "{text}");
    for table in tables["tables"].as_array().unwrap() {
        for row in table["rows"].as_array().unwrap() {
            for (scene, cell) in row["scenes"].as_object().unwrap() {
                assert_eq!(cell["paper"].is_null(), cell["source"].is_null(), "{scene} {row}");
            }
        }
    }
}

#[test]
fn numbers_that_are_filled_in_appear_beside_ours() {
    let folder = Folder::new();
    let filled = "(paper: \"p\", machine: Some(\"a card\"), missing: \"why\", numbers: [
        (scene: nature, conditions: [collisions_off], quantity: frame_ms, value: 12.345,
         source: \"table 9\")])";
    std::fs::write(folder.path("mine.ron"), filled).unwrap();
    paper(&folder, &["--published", "mine.ron", "--no-pictures"]);
    let text = read(&folder, "tables.md");
    assert!(text.contains("| whole frame, ms | 12.35 |"), "{text}");
    assert!(text.contains("The paper's machine: a card."), "{text}");
    assert!(text.contains("- nature, whole frame, ms: table 9 (table 3)."), "{text}");
    assert!(!text.contains("397,881"), "{text}");
    let rows = json(&folder)["tables"][2]["rows"].clone();
    let row = rows.as_array().unwrap().iter().find(|row| row["quantity"] == "frame_ms").unwrap();
    assert_eq!(row["scenes"]["nature"]["paper"], 12.345);
    assert_eq!(row["scenes"]["nature"]["source"], "table 9");
    assert!(row["scenes"]["helicopter"]["paper"].is_null());
    let out = std::fs::read_dir(folder.path("out")).unwrap();
    let mut names: Vec<_> = out.map(|f| f.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    assert_eq!(names, ["index.html", "index.md", "tables.json", "tables.md"]);
}

/// Exit code 2, one line, and nothing new in the folder.
fn refused(extra: &[&str], cause: &str) {
    let folder = Folder::new();
    std::fs::write(folder.path("file.txt"), "not a folder").unwrap();
    std::fs::create_dir(folder.path("empty")).unwrap();
    std::fs::write(folder.path("bad.ron"), "(paper: 1)").unwrap();
    let output = folder.sward(&[&["paper", "--quick"], extra].concat());
    let error = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{extra:?}: {error}");
    assert_eq!(error.lines().count(), 1, "{extra:?}: {error}");
    assert!(error.starts_with("error: ") && error.contains(cause), "{extra:?}: {error}");
    assert_eq!(folder.names(), ["bad.ron", "empty", "file.txt"], "{extra:?}");
}

#[test]
fn bad_input() {
    let scenes = scene("paper");
    refused(&[], "--output");
    refused(&["-o", "file.txt", "--scenes", &scenes], "-o file.txt: is a file; name a folder");
    refused(&["-o", "file.txt/out", "--scenes", &scenes], "-o file.txt/out");
    refused(&["-o", "out", "--scenes", "empty"], "empty/nature.ron");
    refused(&["-o", "out", "--scenes", "none"], "--scenes none: is not a folder");
    refused(&["-o", "out", "--scenes", "file.txt"], "--scenes file.txt: is not a folder");
    refused(&["-o", "out", "--scenes", &scenes, "--frames", "0"], "--frames");
    refused(&["-o", "out", "--scenes", &scenes, "--size", "0x9"], "--size");
    refused(&["-o", "out", "--scenes", &scenes, "--size", "99999x9"], "max_texture_dimension_2d");
    refused(&["-o", "out", "--scenes", &scenes, "--samples", "3"], "--samples 3");
    let published = |file| ["-o", "out", "--scenes", &scenes, "--published", file];
    refused(&published("none.ron"), "--published none.ron");
    refused(&published("bad.ron"), "--published bad.ron: line 1: ");
}
