//! What a measurement says: JSON and tables.

use crate::input;
use crate::measure::{Milliseconds, Percentiles, Report};
use crate::table::{Table, thousands};
use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};
use std::path::Path;

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
    let rows: [(&str, Pick); 19] = [
        ("blades", |r| r.blades_total),
        ("patches", |r| r.patches),
        ("patches visible", |r| r.patches_visible),
        ("blades in them", |r| r.blades_visible),
        ("blades drawn", |r| r.blades_drawn),
        ("  of 8 segments", |r| r.drawn_by_level[0]),
        ("  of 4", |r| r.drawn_by_level[1]),
        ("  of 2", |r| r.drawn_by_level[2]),
        ("  of 1", |r| r.drawn_by_level[3]),
        ("  clusters", |r| r.clusters_drawn),
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
