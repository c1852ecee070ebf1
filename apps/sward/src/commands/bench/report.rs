//! What a measurement says: JSON and tables.

use super::Without;
use super::measure::Times;
use crate::input;
use crate::table::{Table, thousands};
use anyhow::{Context, Result};
use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use std::path::Path;
use sward::Statistics;
use sward_app::compare::percentile;
use sward_app::gpu::Gpu;
use sward_app::stage::StageOptions;
use sward_scene::Scene;

/// Median and 99th percentile.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Percentiles {
    p50: f32,
    p99: f32,
}

impl Percentiles {
    fn of(values: &[f32]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f32::total_cmp);
        Self { p50: percentile(&sorted, 0.5), p99: percentile(&sorted, 0.99) }
    }
}

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Milliseconds {
    frame: Percentiles,
    physics: Percentiles,
    visibility: Percentiles,
    draw: Percentiles,
    post: Percentiles,
}

/// A blade that fails two tests counts in both.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Culled {
    orientation: u64,
    frustum: u64,
    distance: u64,
    occlusion: u64,
}

/// One measurement.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Report {
    adapter: String,
    driver: String,
    backend: String,
    scene: String,
    size: [u32; 2],
    samples: u32,
    without: Vec<String>,
    patch_size: u32,
    blades_total: u64,
    patches: u64,
    patches_visible: u64,
    blades_visible: u64,
    blades_drawn: u64,
    blades_culled: Culled,
    blades_dropped: u64,
    spheres_tested: u64,
    #[serde(default)]
    patches_crowded: u64,
    vertices: u64,
    ms: Milliseconds,
    /// How the times were taken.
    timing: String,
    bytes_per_blade: f64,
    gpu_bytes: u64,
    grow_s: f64,
}

/// What was measured.
pub struct Measured {
    pub times: Times,
    pub statistics: Statistics,
    pub gpu_bytes: u64,
    pub patch_size: u32,
    pub grow_s: f64,
}

impl Report {
    /// Puts a measurement and its circumstances together.
    pub fn new(
        gpu: &Gpu,
        scene: &Scene,
        options: &StageOptions,
        without: &[Without],
        measured: Measured,
    ) -> Self {
        let info = gpu.adapter.get_info();
        let Measured { times, statistics: counted, gpu_bytes, patch_size, grow_s } = measured;
        let names = without.iter().filter_map(Without::to_possible_value);
        Self {
            adapter: info.name,
            driver: format!("{} {}", info.driver, info.driver_info).trim().into(),
            backend: info.backend.to_string(),
            scene: scene.name.clone(),
            size: options.size,
            samples: options.samples,
            without: names.map(|name| name.get_name().to_string()).collect(),
            patch_size,
            blades_total: counted.blades,
            patches: counted.patches,
            patches_visible: counted.patches_visible,
            blades_visible: counted.blades_visible,
            blades_drawn: counted.blades_drawn,
            blades_culled: Culled {
                orientation: counted.culled_orientation,
                frustum: counted.culled_frustum,
                distance: counted.culled_distance,
                occlusion: counted.culled_occlusion,
            },
            blades_dropped: counted.dropped,
            spheres_tested: counted.spheres_tested,
            patches_crowded: counted.patches_crowded,
            vertices: counted.vertices,
            ms: Milliseconds {
                frame: Percentiles::of(&times.frame),
                physics: Percentiles::of(&times.physics),
                visibility: Percentiles::of(&times.visibility),
                draw: Percentiles::of(&times.draw),
                post: Percentiles::of(&times.post),
            },
            timing: "wall clock, submitted and waited for; no timestamp queries".into(),
            bytes_per_blade: gpu_bytes as f64 / counted.blades.max(1) as f64,
            gpu_bytes,
            grow_s,
        }
    }
}

/// The file's form: the first report, and all of a sweep.
#[derive(Debug, Serialize, Deserialize)]
pub struct Document {
    #[serde(flatten)]
    first: Option<Report>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    sweep: Vec<Report>,
}

/// What is written to a file.
pub fn json(reports: &[Report]) -> Document {
    let sweep = if reports.len() > 1 { reports.to_vec() } else { Vec::new() };
    Document { first: reports.first().cloned(), sweep }
}

/// Reads an earlier measurement.
pub fn read(path: &Path) -> Result<Report> {
    let shown = path.display();
    let file = input::open(path).with_context(|| format!("--compare {shown}"))?;
    serde_json::from_reader(std::io::BufReader::new(file))
        .with_context(|| format!("--compare {shown}: not a file that bench --json wrote"))
}

/// Tables of times and counts, with an earlier measurement beside them where there is one.
pub fn tables(report: &Report, baseline: Option<&Report>) -> String {
    let left_out = match report.without.as_slice() {
        [] => String::new(),
        without => format!(", without {}", without.join(", ")),
    };
    let [width, height] = report.size;
    let head = format!(
        "{}: {width} x {height}, {} samples{left_out}\n{} ({}, {})\n",
        report.scene, report.samples, report.adapter, report.backend, report.driver
    );
    format!("{head}\n{}\n{}", times(report, baseline), counts(report, baseline))
}

fn times(report: &Report, baseline: Option<&Report>) -> Table {
    let mut table = Table::new(with(["ms", "p50", "p99"], baseline, ["before", "change"]));
    type Pick = fn(&Milliseconds) -> Percentiles;
    let rows: [(&str, Pick); 5] = [
        ("frame", |ms| ms.frame),
        ("physics alone", |ms| ms.physics),
        ("visibility alone", |ms| ms.visibility),
        ("draw alone", |ms| ms.draw),
        ("post alone", |ms| ms.post),
    ];
    for (name, pick) in rows {
        let Percentiles { p50, p99 } = pick(&report.ms);
        let mut row = vec![name.to_string(), format!("{p50:.2}"), format!("{p99:.2}")];
        if let Some(before) = baseline {
            let before = pick(&before.ms).p50;
            row.extend([format!("{before:.2}"), change(p50.into(), before.into())]);
        }
        table.row(row);
    }
    table
}

fn counts(report: &Report, baseline: Option<&Report>) -> Table {
    let mut table = Table::new(with(["count", ""], baseline, ["before", "change"]));
    type Pick = fn(&Report) -> u64;
    let rows: [(&str, Pick); 14] = [
        ("blades", |r| r.blades_total),
        ("patches", |r| r.patches),
        ("patches visible", |r| r.patches_visible),
        ("blades in them", |r| r.blades_visible),
        ("blades drawn", |r| r.blades_drawn),
        ("culled by orientation", |r| r.blades_culled.orientation),
        ("culled by frustum", |r| r.blades_culled.frustum),
        ("culled by distance", |r| r.blades_culled.distance),
        ("culled by occlusion", |r| r.blades_culled.occlusion),
        ("dropped (list full)", |r| r.blades_dropped),
        ("spheres tested", |r| r.spheres_tested),
        ("patches crowded", |r| r.patches_crowded),
        ("vertices", |r| r.vertices),
        ("bytes on the GPU", |r| r.gpu_bytes),
    ];
    for (name, pick) in rows {
        let mut row = vec![name.to_string(), thousands(pick(report))];
        if let Some(before) = baseline {
            let (now, before) = (pick(report), pick(before));
            row.extend([thousands(before), change(now as f64, before as f64)]);
        }
        table.row(row);
    }
    type Real = fn(&Report) -> f64;
    let reals: [(&str, Real); 2] =
        [("bytes a blade", |r| r.bytes_per_blade), ("seconds to grow", |r| r.grow_s)];
    for (name, pick) in reals {
        let mut row = vec![name.to_string(), format!("{:.2}", pick(report))];
        if let Some(before) = baseline {
            row.extend([format!("{:.2}", pick(before)), change(pick(report), pick(before))]);
        }
        table.row(row);
    }
    table
}

fn with<'a, const N: usize, const M: usize>(
    head: [&'a str; N],
    baseline: Option<&Report>,
    more: [&'a str; M],
) -> Vec<&'a str> {
    let more = if baseline.is_some() { &more[..] } else { &[] };
    [&head[..], more].concat()
}

fn change(now: f64, before: f64) -> String {
    match (now == before, before == 0.0) {
        (true, _) => "=".into(),
        (_, true) => "new".into(),
        _ => format!("{:+.1} %", (now / before - 1.0) * 100.0),
    }
}

/// One row a patch size.
pub fn sweep_table(reports: &[Report]) -> Table {
    let mut table =
        Table::new(["patch size", "patches", "visible", "blades drawn", "frame ms", "grow s"]);
    for report in reports {
        table.row([
            report.patch_size.to_string(),
            thousands(report.patches),
            thousands(report.patches_visible),
            thousands(report.blades_drawn),
            format!("{:.2}", report.ms.frame.p50),
            format!("{:.2}", report.grow_s),
        ]);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_read_well() {
        assert_eq!(change(1.1, 1.0), "+10.0 %");
        assert_eq!(change(0.5, 1.0), "-50.0 %");
        assert_eq!(change(0.0, 0.0), "=");
        assert_eq!(change(3.0, 0.0), "new");
    }
}
