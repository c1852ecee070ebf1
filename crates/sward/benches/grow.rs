//! Time to grow a million blades: scatter, blades, patches.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use sward::grow::terrain::NoiseTerrain;
use sward::{Field, FieldDesc, Mesh, Surface, Tufts};

const BLADES: f64 = 1e6;

fn million(c: &mut Criterion) {
    let mesh = Mesh::terrain(NoiseTerrain::default()).expect("the default terrain is in range");
    let surface = Surface::new(mesh.clone()).expect("a terrain has area");
    let density = (BLADES / surface.area_m2()) as f32;
    let tufts = |share| Some(Tufts { share, radius_m: 0.5, spread_m: 0.25 });
    let mut group = c.benchmark_group("grow");
    group.sample_size(10);
    for (name, tufts) in [("singles", None), ("mixed", tufts(0.5)), ("tufts", tufts(1.0))] {
        let desc = FieldDesc { density, tufts, ..Default::default() };
        group.bench_function(format!("million/{name}"), |b| {
            b.iter(|| Field::grow(black_box(&surface), black_box(&desc)));
        });
    }
    group.bench_function("surface/131072 triangles", |b| {
        b.iter(|| Surface::new(black_box(mesh.clone())));
    });
    group.finish();
}

criterion_group!(benches, million);
criterion_main!(benches);
