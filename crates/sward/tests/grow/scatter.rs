use super::{desc, hills, plane, roots, spacing};
use glam::{UVec2, Vec2, Vec3};
use rayon::ThreadPoolBuilder;
use sward::{Field, FieldDesc, Mesh, Range, Species, Surface, Tufts};

/// Triangles of very different size and shape, ten metres apart along x.
fn loose_triangles() -> Surface {
    let mut mesh = Mesh::default();
    for i in 0..40u32 {
        let at = Vec3::X * 10.0 * i as f32;
        let (a, b) = (0.2 + 0.1 * i as f32, 4.0 / (1.0 + (i % 7) as f32));
        mesh.positions.extend([at, at + Vec3::Z * a, at + Vec3::X * 0.1 * b + Vec3::Y * b]);
        mesh.triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
    }
    Surface::new(mesh).unwrap()
}

fn area(surface: &Surface, triangle: usize) -> f64 {
    let [a, b, c] =
        surface.mesh().triangles[triangle].map(|v| surface.mesh().positions[v as usize]);
    f64::from((b - a).cross(c - a).length()) * 0.5
}

#[test]
fn triangles_get_blades_by_area() {
    let surface = loose_triangles();
    let count = 20_000.0;
    for share in [0.0, 0.4] {
        let mut desc = desc(&surface, count, share);
        if let Some(tufts) = &mut desc.tufts {
            (tufts.radius_m, tufts.spread_m) = (0.05, 0.03);
        }
        let field = Field::grow(&surface, &desc).unwrap();
        assert_eq!(field.blades().len(), count as usize);
        let mut seen = vec![0.0; surface.triangle_count()];
        for root in roots(&field) {
            seen[(root.x / 10.0).round() as usize] += 1.0;
        }
        let chi_square: f64 = (0..seen.len())
            .map(|t| {
                let expected = count * area(&surface, t) / surface.area_m2();
                (seen[t] - expected) * (seen[t] - expected) / expected
            })
            .sum();
        // 39 degrees of freedom: 62.4 at 1 %. Tufts are lumps of about 13 blades.
        let limit = if share == 0.0 { 62.4 } else { 62.4 * 4.0 };
        assert!(chi_square < limit, "chi square {chi_square} at share {share}");
    }
}

#[test]
fn blades_are_uniform_inside_a_triangle() {
    let mesh = Mesh {
        positions: vec![Vec3::ZERO, Vec3::new(0.0, 3.0, 5.0), Vec3::new(4.0, 1.0, 0.0)],
        triangles: vec![[0, 1, 2]],
        ..Default::default()
    };
    let [a, b, c] = [mesh.positions[0], mesh.positions[1], mesh.positions[2]];
    let normal = (b - a).cross(c - a);
    let surface = Surface::new(mesh).unwrap();
    // Few blades each time, so that the strata do not hide a bias.
    let mut cells = [0.0f64; 16];
    let mut total = 0.0;
    for seed in 0..600 {
        let field = Field::grow(&surface, &FieldDesc { seed, ..desc(&surface, 7.0, 0.0) }).unwrap();
        for root in roots(&field) {
            let u = (root - a).cross(c - a).dot(normal) / normal.length_squared();
            let v = (b - a).cross(root - a).dot(normal) / normal.length_squared();
            // A square with even density from the triangle's weights, in 4 x 4 cells.
            let (along, away) = (v / (u + v), (u + v) * (u + v));
            let cell = |x: f32| ((x * 4.0) as usize).min(3);
            cells[cell(along) * 4 + cell(away)] += 1.0;
            total += 1.0;
        }
    }
    let expected = total / 16.0;
    let chi_square: f64 = cells.iter().map(|n| (n - expected) * (n - expected) / expected).sum();
    // 15 degrees of freedom: 30.6 at 1 %.
    assert!(chi_square < 30.6, "{chi_square}: {cells:?}");
}

#[test]
fn single_blades_clump_less_than_chance() {
    let surface = plane(10.0);
    let field = Field::grow(&surface, &desc(&surface, 2000.0, 0.0)).unwrap();
    let by_chance = 0.5 / (2000.0f32 / 100.0).sqrt();
    let ratio = spacing(&roots(&field)) / by_chance;
    assert!(ratio > 1.1, "{ratio}");
}

fn distance_to_triangle(p: Vec3, [a, b, c]: [Vec3; 3]) -> f32 {
    let normal = (b - a).cross(c - a).normalize();
    let inside = [(a, b), (b, c), (c, a)]
        .iter()
        .all(|&(from, to)| (to - from).cross(p - from).dot(normal) >= 0.0);
    if inside {
        return (p - a).dot(normal).abs();
    }
    let edge = |from: Vec3, to: Vec3| {
        let t = ((p - from).dot(to - from) / (to - from).length_squared()).clamp(0.0, 1.0);
        p.distance(from + (to - from) * t)
    };
    edge(a, b).min(edge(b, c)).min(edge(c, a))
}

#[test]
fn every_root_lies_on_the_mesh() {
    let shapes = [
        Mesh::sphere(2.0, 12).unwrap(),
        Mesh::torus(2.0, 0.6, UVec2::new(24, 12)).unwrap(),
        Mesh::mobius(2.0, 1.0, UVec2::new(32, 3)).unwrap(),
        hills().mesh().clone(),
        loose_triangles().mesh().clone(),
    ];
    for (i, mesh) in shapes.into_iter().enumerate() {
        let surface = Surface::new(mesh).unwrap();
        let (low, high) = surface.bounds();
        let tolerance = 1e-3 * (high - low).max_element();
        // Tufts as wide as the shape bends: straight-line offsets would float.
        let mut desc = desc(&surface, 400.0, 0.7);
        desc.tufts = Some(Tufts { share: 0.7, radius_m: 1.0, spread_m: 1.0 });
        let field = Field::grow(&surface, &desc).unwrap();
        let mesh = surface.mesh();
        for blade in field.blades() {
            let off = (mesh.triangles.iter())
                .map(|t| distance_to_triangle(blade.root, t.map(|v| mesh.positions[v as usize])))
                .fold(f32::INFINITY, f32::min);
            assert!(off < tolerance, "shape {i}: {} is {off} m off", blade.root);
            assert!(blade.up.is_normalized());
        }
    }
}

#[test]
fn up_follows_the_normal_or_the_sky() {
    let surface = Surface::new(Mesh::sphere(3.0, 24).unwrap()).unwrap();
    let grow = |upright| {
        Field::grow(&surface, &FieldDesc { upright, ..desc(&surface, 3000.0, 0.0) }).unwrap()
    };
    for blade in grow(0.0).blades() {
        assert!(blade.up.dot(blade.root.normalize()) > 0.99, "{blade:?}");
    }
    assert!(grow(1.0).blades().iter().all(|b| b.up.distance(Vec3::Y) < 1e-5));
    assert!(grow(0.5).blades().iter().all(|b| b.up.is_normalized()));
}

#[test]
fn any_number_of_threads_grows_the_same_field() {
    let surface = hills();
    let desc = desc(&surface, 60_000.0, 0.5);
    let grow = |threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| Field::grow(&surface, &desc).unwrap())
    };
    let one = grow(1);
    // Field equality compares floats by value; no value is NaN, and none is -0 by chance alone.
    assert!(one == grow(2) && one == grow(5));
    let other = Field::grow(&surface, &FieldDesc { seed: 2, ..desc.clone() }).unwrap();
    assert!(one != other, "the seed must matter");
}

#[test]
fn blades_stay_in_their_species_ranges_and_follow_the_mix() {
    let surface = plane(20.0);
    let tall = Species {
        share: 3.0,
        height_m: Range::new(1.0, 1.5),
        width_m: Range::new(0.02, 0.03),
        response: Range::new(2.0, 2.5),
        ..Species::default()
    };
    let species = vec![Species::default(), tall];
    for share in [0.0, 0.6] {
        let desc = FieldDesc { species: species.clone(), ..desc(&surface, 40_000.0, share) };
        let field = Field::grow(&surface, &desc).unwrap();
        let mut seen = [0; 2];
        for blade in field.blades() {
            let kind = &species[usize::from(blade.species)];
            seen[usize::from(blade.species)] += 1;
            for (value, range) in [
                (blade.height, kind.height_m),
                (blade.width, kind.width_m),
                (blade.response, kind.response),
            ] {
                assert!((range.min..=range.max).contains(&value), "{blade:?}");
            }
            assert!((0.0..std::f32::consts::TAU).contains(&blade.facing));
        }
        let ratio = f64::from(seen[1]) / field.blades().len() as f64;
        assert!((ratio - 0.75).abs() < 0.04, "{ratio}");
    }
}

#[test]
fn tufts_gather_blades() {
    let surface = plane(10.0);
    let mut desc = desc(&surface, 3000.0, 1.0);
    desc.tufts = Some(Tufts { share: 1.0, radius_m: 1.0, spread_m: 0.2 });
    let field = Field::grow(&surface, &desc).unwrap();
    assert_eq!(field.blades().len(), 3000);
    // Cells of 0.1 m: tufts of 0.2 m radius a metre apart leave most of them empty.
    let mut cells = std::collections::HashSet::new();
    for root in roots(&field) {
        cells.insert(((root.xz_cell(0.1)).x, root.xz_cell(0.1).y));
    }
    assert!(cells.len() < 1800, "{} of 10000 cells hold blades", cells.len());
}

trait Cell {
    fn xz_cell(self, size: f32) -> glam::IVec2;
}

impl Cell for Vec3 {
    fn xz_cell(self, size: f32) -> glam::IVec2 {
        (Vec2::new(self.x, self.z) / size).floor().as_ivec2()
    }
}

#[test]
fn a_count_is_met_exactly_with_and_without_tufts() {
    for tufts in [None, Some(Tufts { share: 0.4, radius_m: 0.5, spread_m: 0.2 })] {
        let desc = FieldDesc { count: Some(12_345), density: 1.0, tufts, ..Default::default() };
        let field = Field::grow(&hills(), &desc).unwrap();
        assert_eq!(field.blades().len(), 12_345);
    }
    for (count, max_blades) in [(0, u64::MAX), (101, 100), (1 << 33, u64::MAX)] {
        let desc = FieldDesc { count: Some(count), max_blades, ..Default::default() };
        let error = Field::grow(&hills(), &desc).unwrap_err().to_string();
        assert!(error.starts_with("count: "), "{error}");
    }
}
