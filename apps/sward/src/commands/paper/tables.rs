//! The tables: ours with the paper's beside them.

use super::evaluate::{Run, Settings};
use super::grid::Grid;
use super::published::Published;
use super::quantity::{Condition, Quantity, SceneName};
use crate::measure::{frames_run, warm_up_frames};
use crate::table::thousands;
use anyhow::Result;
use serde_json::{Value as Json, json};
use sward_app::compare::flip;

const UNKNOWN: &str = "not available here";

/// Number, title, condition and rows of a table.
type Layout = (u32, &'static str, Condition, &'static [Quantity]);

const LAYOUTS: [Layout; 4] = [
    (1, "Everything on", Condition::All, &Quantity::COSTS),
    (2, "Blades culled by each test, everything on", Condition::All, &Quantity::CULLED),
    (3, "Collisions off", Condition::NoCollisions, &Quantity::COSTS),
    (4, "Culling off", Condition::NoCulling, &Quantity::COSTS),
];

/// All runs, and what they are compared with.
#[derive(Debug)]
pub struct Results {
    pub runs: Vec<Run>,
    pub published: Published,
    pub settings: Settings,
    relations: Vec<Relation>,
}

/// How conditions of one scene compare.
#[derive(Debug, Clone, Copy)]
struct Relation {
    scene: SceneName,
    /// Physics with collisions over physics without.
    collisions_cost: f32,
    /// A frame with culling over a frame without.
    culled_frame: f32,
    /// Mean FLIP of the frame with culling, against that without.
    culled_flip: f32,
}

impl Results {
    pub fn new(runs: Vec<Run>, published: Published, settings: Settings) -> Result<Self> {
        let find = |scene, condition| {
            runs.iter().find(|run: &&Run| (run.scene, run.condition) == (scene, condition))
        };
        let mut relations = Vec::new();
        for scene in SceneName::ALL {
            let [Some(all), Some(no_collisions), Some(no_culling)] =
                Condition::ALL.map(|condition| find(scene, condition))
            else {
                continue;
            };
            let ratio = |a: f32, b: f32| a / b.max(1e-6);
            let (ms, without) = (all.report.ms, no_culling.report.ms);
            relations.push(Relation {
                scene,
                collisions_cost: ratio(ms.physics.p50, no_collisions.report.ms.physics.p50),
                culled_frame: ratio(ms.frame.p50, without.frame.p50),
                culled_flip: flip(&no_culling.picture, &all.picture)?.mean,
            });
        }
        Ok(Self { runs, published, settings, relations })
    }

    fn run(&self, scene: SceneName, condition: Condition) -> Option<&Run> {
        self.runs.iter().find(|run| (run.scene, run.condition) == (scene, condition))
    }

    /// What was measured, on what and how, in sentences.
    pub fn circumstances(&self) -> Vec<String> {
        let Settings { size: [width, height], samples, frames, .. } = self.settings;
        let warm_up = warm_up_frames(frames);
        let counted = self.settings.counted_frame();
        let adapter = self.runs.first().map_or_else(String::new, |run| {
            let report = &run.report;
            format!("Adapter: {} ({}, {}). ", report.adapter, report.backend, report.driver)
        });
        let machine = self.published.machine.as_deref().unwrap_or(UNKNOWN);
        vec![
            format!(
                "{adapter}{width} x {height} pixels, {samples} {}. The paper's machine: {machine}.",
                if samples == 1 { "sample a pixel" } else { "samples a pixel" }
            ),
            format!(
                "Each scene runs at 60 frames a second of its own time, from its time 0. Whole \
                 frames, recorded as a program would, are measured from {} to {}; frames {} to \
                 {} are run stage by stage, each submitted and waited for, so their sum is \
                 above a whole frame. Times are medians over {frames} frames \
                 with the 99th percentile behind them, by wall clock; frames a second are those of \
                 the median whole frame. The three conditions of a scene are measured in turns of \
                 a few frames, so that a busy machine slows all alike. Counts are of frame {counted}.",
                warm_up + 1,
                warm_up + frames,
                warm_up + frames + 2,
                frames_run(frames),
            ),
            "Physics is wind, collision and the motion of blades; visibility is the culling of \
             patches and blades, the choice of levels and the draw lists; draw is the opaque \
             things, the grass and the sky. Of the colliders, a capsule or a box counts as one \
             sphere."
                .into(),
            "Culled counts are of blades in visible patches, and a blade that fails two tests \
             counts in both, as is said of the paper's. So 'culled by any of them' and 'blades drawn' add up \
             to 'blades in visible patches', and the four tests may add up to more."
                .into(),
            "The print was not at hand. That its table 2 counts culled blades by test is known at \
             second hand; that tables 1, 3 and 4 have one condition each is our own arrangement."
                .into(),
            format!("'{UNKNOWN}': {}", self.published.missing),
        ]
    }

    /// Tables 1 to 4, then those that the paper has not.
    pub fn grids(&self) -> Vec<Grid> {
        let mut grids: Vec<_> = LAYOUTS.iter().map(|layout| self.numbered(layout)).collect();
        grids.extend([self.relations(), self.memory()]);
        grids
    }

    fn numbered(&self, &(number, title, condition, quantities): &Layout) -> Grid {
        let mut head = vec![String::new()];
        for scene in SceneName::ALL {
            head.extend([format!("{}, paper", scene.key()), format!("{}, sward", scene.key())]);
        }
        let row = |&quantity: &Quantity| {
            let mut cells = vec![quantity.name().to_string()];
            for scene in SceneName::ALL {
                let published = self.published.get(scene, condition, quantity);
                cells.push(match published {
                    Some((value, _)) => quantity.write_published(value),
                    None => UNKNOWN.into(),
                });
                let run = self.run(scene, condition);
                cells.push(run.map_or_else(String::new, |run| {
                    quantity.measured(&run.report, run.spheres).write()
                }));
            }
            cells
        };
        Grid {
            title: format!("Table {number}. {title}"),
            note: String::new(),
            head,
            rows: quantities.iter().map(row).collect(),
        }
    }

    fn relations(&self) -> Grid {
        let row = |relation: &Relation| {
            vec![
                relation.scene.key().to_string(),
                format!("{:.2}", relation.collisions_cost),
                format!("{:.2}", relation.culled_frame),
                format!("{:.4}", relation.culled_flip),
            ]
        };
        Grid {
            title: "Relations between the conditions".into(),
            note:
                "Ours only, from the tables above; they depend less on the machine than times do. \
                   FLIP is 0 where two pictures look equal."
                    .into(),
            head: [
                "scene",
                "physics, with collisions over without",
                "frame, with culling over without",
                "FLIP, with culling against without",
            ]
            .map(String::from)
            .to_vec(),
            rows: self.relations.iter().map(row).collect(),
        }
    }

    fn memory(&self) -> Grid {
        let row = |scene| {
            let report = &self.run(scene, Condition::All)?.report;
            Some(vec![
                scene.key().to_string(),
                thousands(report.blades_total),
                format!("{:.1}", report.bytes_per_blade),
                thousands(report.gpu_bytes),
                format!("{:.2}", report.grow_s),
            ])
        };
        Grid {
            title: "Memory and growing".into(),
            note: "Ours only. All allocations that grow with the blades, draw lists included."
                .into(),
            head: ["scene", "blades", "bytes a blade", "bytes on the GPU", "seconds to grow"]
                .map(String::from)
                .to_vec(),
            rows: SceneName::ALL.into_iter().filter_map(row).collect(),
        }
    }

    /// Where the numbers of the paper's columns come from, one line each.
    pub fn sources(&self) -> Vec<String> {
        let mut lines: Vec<(String, Vec<String>)> = Vec::new();
        for (number, _, condition, quantities) in LAYOUTS {
            let cells = SceneName::ALL.into_iter();
            for (scene, &quantity) in cells.flat_map(|s| quantities.iter().map(move |q| (s, q))) {
                let Some((_, source)) = self.published.get(scene, condition, quantity) else {
                    continue;
                };
                let line = format!("{}, {}: {source}", scene.key(), quantity.name());
                match lines.iter_mut().find(|(known, _)| *known == line) {
                    Some((_, tables)) => tables.push(number.to_string()),
                    None => lines.push((line, vec![number.to_string()])),
                }
            }
        }
        let one = |(line, tables): (String, Vec<String>)| match tables.as_slice() {
            [table] => format!("{line} (table {table})."),
            tables => format!("{line} (tables {}).", tables.join(", ")),
        };
        lines.into_iter().map(one).collect()
    }

    /// `tables.md`.
    pub fn markdown(&self) -> String {
        let mut text = format!("## Tables\n\nThe paper: {}.\n", self.published.paper);
        for line in self.circumstances() {
            text += &format!("\n{line}\n");
        }
        for grid in self.grids() {
            text += &format!("\n{}", grid.markdown());
        }
        text += "\n### Sources of the paper's columns\n\n";
        for line in self.sources() {
            text += &format!("- {line}\n");
        }
        text
    }

    /// `tables.json`.
    pub fn json(&self) -> Json {
        let table = |&(number, title, condition, quantities): &Layout| {
            let rows: Vec<_> = quantities.iter().map(|&q| self.json_row(condition, q)).collect();
            json!({ "number": number, "title": title, "condition": condition.key(), "rows": rows })
        };
        let relation = |r: &Relation| {
            json!({
                "scene": r.scene.key(),
                "physics_with_collisions_over_without": r.collisions_cost,
                "frame_with_culling_over_without": r.culled_frame,
                "flip_with_culling_against_without": r.culled_flip,
            })
        };
        let run = |run: &Run| {
            json!({
                "scene": run.scene.key(),
                "condition": run.condition.key(),
                "spheres": run.spheres,
                "report": run.report,
            })
        };
        let first = self.runs.first().map(|run| &run.report);
        let Settings { size, samples, frames, .. } = self.settings;
        json!({
            "paper": self.published.paper,
            "missing": self.published.missing,
            "adapter": first.map(|report| &report.adapter),
            "driver": first.map(|report| &report.driver),
            "backend": first.map(|report| &report.backend),
            "size": size,
            "samples": samples,
            "frames_measured": frames,
            "frame_counted": self.settings.counted_frame(),
            "tables": LAYOUTS.iter().map(table).collect::<Vec<_>>(),
            "relations": self.relations.iter().map(relation).collect::<Vec<_>>(),
            "runs": self.runs.iter().map(run).collect::<Vec<_>>(),
        })
    }

    fn json_row(&self, condition: Condition, quantity: Quantity) -> Json {
        let cell = |scene: SceneName| {
            let published = self.published.get(scene, condition, quantity);
            let run = self.run(scene, condition);
            let ours = run.map(|run| quantity.measured(&run.report, run.spheres).json());
            let cell = json!({
                "paper": published.map(|(value, _)| value),
                "source": published.map(|(_, source)| source),
                "sward": ours,
            });
            (scene.key().to_string(), cell)
        };
        let cells: serde_json::Map<_, _> = SceneName::ALL.into_iter().map(cell).collect();
        json!({ "quantity": quantity.key(), "name": quantity.name(), "scenes": cells })
    }
}
