use super::{desc, plane};
use glam::{UVec2, Vec2, Vec3};
use proptest::prelude::*;
use sward::grow::Blade;
use sward::grow::terrain::NoiseTerrain;
use sward::{
    BladeOrder, DensityMap, Error, Field, FieldDesc, Mesh, Metric, Range, Shape, Species, Surface,
    Tufts,
};

fn triangle() -> Mesh {
    Mesh {
        positions: vec![Vec3::ZERO, Vec3::Z, Vec3::X],
        triangles: vec![[0, 1, 2]],
        ..Default::default()
    }
}

fn refused(mesh: Mesh, words: &[&str]) {
    let Err(Error::Mesh(message)) = Surface::new(mesh) else {
        panic!("accepted: {words:?}");
    };
    for word in words {
        assert!(message.contains(word), "{message} lacks {word}");
    }
}

#[test]
fn broken_meshes_are_refused_by_name() {
    refused(Mesh::default(), &["empty"]);
    refused(Mesh { triangles: vec![], ..triangle() }, &["empty"]);
    refused(
        Mesh { triangles: vec![[0, 1, 2], [0, 1, 3]], ..triangle() },
        &["triangle 1", "vertex 3"],
    );
    refused(Mesh { triangles: vec![[0, 1, 1]], ..triangle() }, &["area"]);
    refused(Mesh { normals: vec![Vec3::Y], ..triangle() }, &["3 vertices", "1 normals"]);
    refused(Mesh { uvs: vec![Vec2::ZERO; 2], ..triangle() }, &["2 texture coordinates"]);
    refused(Mesh { colors: vec![[1.0; 4]], ..triangle() }, &["1 colours"]);
    for bad in [f32::NAN, f32::INFINITY, 1e20] {
        let mut mesh = triangle();
        mesh.positions[1].y = bad;
        refused(mesh, &["position", "vertex 1"]);
    }
    refused(Mesh { normals: vec![Vec3::NAN; 3], ..triangle() }, &["normal", "vertex 0"]);
    refused(Mesh { uvs: vec![Vec2::NAN; 3], ..triangle() }, &["texture", "vertex 0"]);
    refused(Mesh { colors: vec![[f32::NAN; 4]; 3], ..triangle() }, &["colour", "vertex 0"]);
}

#[test]
fn degenerate_triangles_are_dropped_and_counted() {
    let mut mesh = triangle();
    mesh.positions.push(Vec3::X * 2.0);
    mesh.triangles.extend([[0, 0, 1], [0, 2, 3], [2, 1, 3]]);
    let surface = Surface::new(mesh).unwrap();
    assert_eq!((surface.triangle_count(), surface.dropped_triangles()), (2, 2));
    assert!((surface.area_m2() - 1.0).abs() < 1e-9);
    assert_eq!(surface.bounds(), (Vec3::ZERO, Vec3::new(2.0, 0.0, 1.0)));
}

#[test]
fn normals_are_smooth_across_split_vertices_unless_given() {
    // A roof of two slopes whose ridge vertices are split.
    let ridge = [Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 1.0, 1.0)];
    let mesh = Mesh {
        positions: vec![
            Vec3::new(-1.0, 0.0, 0.0),
            ridge[0],
            ridge[1],
            Vec3::new(1.0, 0.0, 0.0),
            ridge[0],
            ridge[1],
        ],
        triangles: vec![[0, 2, 1], [3, 4, 5]],
        ..Default::default()
    };
    let surface = Surface::new(mesh.clone()).unwrap();
    assert!(surface.mesh().normals[1].distance(Vec3::Y) < 1e-6);
    assert_eq!(surface.mesh().normals[1], surface.mesh().normals[4]);
    let given = Mesh { normals: vec![Vec3::new(0.0, 0.0, 2.0); 6], ..mesh };
    assert_eq!(Surface::new(given).unwrap().mesh().normals, vec![Vec3::Z; 6]);
}

type Change = Box<dyn Fn(&mut FieldDesc)>;

fn change(f: impl Fn(&mut FieldDesc) + 'static) -> Change {
    Box::new(f)
}

#[test]
fn every_setting_is_checked() {
    let surface = plane(2.0);
    let nan = f32::NAN;
    let tufts = |share, radius_m, spread_m| Some(Tufts { share, radius_m, spread_m });
    let texture = |width, height, values: &[f32]| {
        Some(DensityMap::Texture { width, height, values: values.to_vec() })
    };
    let cases: Vec<(&str, Change)> = vec![
        ("density", change(|d| d.density = 0.0)),
        ("density", change(|d| d.density = -1.0)),
        ("density", change(move |d| d.density = nan)),
        ("density", change(|d| d.density = f32::INFINITY)),
        ("density", change(|d| d.density = 1e-3)),
        ("density", change(|d| d.max_blades = 100)),
        ("max_blades", change(|d| d.max_blades = 0)),
        ("species", change(|d| d.species.clear())),
        ("species", change(|d| d.species = vec![Species::default(); 257])),
        ("species[0].share", change(|d| d.species[0].share = 0.0)),
        ("species[0].share", change(move |d| d.species[0].share = nan)),
        ("species[0].height_m.min", change(|d| d.species[0].height_m = Range::new(0.0, 1.0))),
        ("species[0].height_m", change(|d| d.species[0].height_m = Range::new(2.0, 1.0))),
        ("species[0].height_m.max", change(move |d| d.species[0].height_m = Range::new(1.0, nan))),
        ("species[0].width_m.min", change(move |d| d.species[0].width_m = Range::new(nan, 1.0))),
        ("species[0].response.max", change(|d| d.species[0].response.max = f32::INFINITY)),
        ("species[0].droop.min", change(|d| d.species[0].droop.min = -0.1)),
        ("species[0].gust", change(move |d| d.species[0].gust = nan)),
        ("species[0].arch", change(|d| d.species[0].arch = 1.5)),
        ("species[0].ridge", change(|d| d.species[0].ridge = -0.5)),
        ("species[0].shape.tip", change(|d| d.species[0].shape = Shape::TriangleTip { tip: 1.0 })),
        ("species[0].root_color.to", change(|d| d.species[0].root_color.to[1] = 2.0)),
        ("species[0].tip_color.from", change(move |d| d.species[0].tip_color.from[2] = nan)),
        ("tufts.share", change(move |d| d.tufts = tufts(1.1, 1.0, 1.0))),
        ("tufts.radius_m", change(move |d| d.tufts = tufts(0.5, 0.0, 1.0))),
        ("tufts.radius_m", change(move |d| d.tufts = tufts(0.5, nan, 1.0))),
        ("tufts.spread_m", change(move |d| d.tufts = tufts(0.5, 1.0, nan))),
        ("density_map", change(move |d| d.density_map = texture(2, 2, &[1.0]))),
        ("density_map", change(move |d| d.density_map = texture(0, 0, &[]))),
        ("density_map", change(move |d| d.density_map = texture(1, 2, &[1.0, nan]))),
        ("density_map", change(move |d| d.density_map = texture(1, 1, &[1.5]))),
        ("max_slope_deg", change(move |d| d.max_slope_deg = nan)),
        ("max_slope_deg", change(|d| d.max_slope_deg = 181.0)),
        ("height_limits_m", change(|d| d.height_limits_m = (1.0, 0.0))),
        ("height_limits_m", change(move |d| d.height_limits_m = (nan, 0.0))),
        ("upright", change(move |d| d.upright = nan)),
        ("patch_size", change(|d| d.patch_size = 0)),
        ("patch_size", change(|d| d.patch_size = 100)),
        ("patch_size", change(|d| d.patch_size = 1088)),
    ];
    for (name, change) in cases {
        let mut desc = desc(&surface, 500.0, 0.0);
        change(&mut desc);
        match Field::grow(&surface, &desc) {
            Err(Error::Setting { setting, cause }) => {
                assert_eq!(setting, name, "{cause}");
            }
            other => panic!("{name}: {:?}", other.map(|f| f.blades().len())),
        }
    }
}

#[test]
fn too_many_blades_say_how_many_fit() {
    let surface = plane(2.0);
    let desc = FieldDesc { max_blades: 1234, ..desc(&surface, 5000.0, 0.0) };
    let message = Field::grow(&surface, &desc).unwrap_err().to_string();
    assert!(message.contains("5000") && message.contains("1234 fit"), "{message}");
    assert!(message.contains("308.5"), "{message}");
    let desc = FieldDesc { density: 1e9, max_blades: u64::MAX, ..desc };
    let message = Field::grow(&plane(100.0), &desc).unwrap_err().to_string();
    assert!(message.contains("4294967295 fit"), "{message}");
}

#[test]
fn blades_placed_by_hand_are_checked() {
    let good = Blade {
        root: Vec3::ZERO,
        up: Vec3::Y,
        facing: 0.0,
        height: 0.4,
        width: 0.01,
        response: 5.0,
        species: 0,
    };
    let field = |blades: &[Blade]| {
        let kinds = vec![Species::default()];
        Field::from_blades(kinds, blades, 64, Metric::Euclidean, BladeOrder::Progressive)
    };
    assert!(field(&[good]).is_ok());
    assert!(field(&[]).is_err());
    for (name, bad) in [
        ("root", Blade { root: Vec3::NAN, ..good }),
        ("up", Blade { up: Vec3::ZERO, ..good }),
        ("up", Blade { up: Vec3::NAN, ..good }),
        ("facing", Blade { facing: f32::NAN, ..good }),
        ("height", Blade { height: 0.0, ..good }),
        // Beyond the species' range, which the GPU's steps cannot say
        ("height", Blade { height: 0.6, ..good }),
        ("width", Blade { width: 0.001, ..good }),
        ("width", Blade { width: f32::NAN, ..good }),
        ("response", Blade { response: f32::INFINITY, ..good }),
        ("species", Blade { species: 1, ..good }),
    ] {
        let message = field(&[good, bad]).unwrap_err().to_string();
        assert!(message.starts_with(&format!("blades[1].{name}: ")), "{message}");
    }
}

#[test]
fn shapes_refuse_silly_parameters() {
    let two = UVec2::splat(8);
    let terrain = NoiseTerrain { resolution: 4, ..Default::default() };
    let bad = [
        Mesh::plane(Vec2::new(0.0, 1.0), two),
        Mesh::plane(Vec2::new(f32::NAN, 1.0), two),
        Mesh::plane(Vec2::ONE, UVec2::new(0, 1)),
        Mesh::plane(Vec2::ONE, UVec2::MAX),
        Mesh::sphere(-1.0, 8),
        Mesh::sphere(1.0, 1),
        Mesh::sphere(1.0, u32::MAX),
        Mesh::torus(1.0, 1.0, two),
        Mesh::torus(1.0, 0.5, UVec2::splat(2)),
        Mesh::mobius(1.0, 3.0, two),
        Mesh::mobius(1.0, 0.5, UVec2::new(2, 1)),
        Mesh::heightmap(1, 5, &[0.0; 5], Vec2::ONE),
        Mesh::heightmap(2, 2, &[0.0; 3], Vec2::ONE),
        Mesh::heightmap(2, 2, &[0.0, f32::NAN, 0.0, 0.0], Vec2::ONE),
        Mesh::terrain(NoiseTerrain { size_m: f32::NAN, ..terrain }),
        Mesh::terrain(NoiseTerrain { octaves: 0, ..terrain }),
        Mesh::terrain(NoiseTerrain { resolution: u32::MAX, ..terrain }),
        Mesh::terrain(NoiseTerrain { feature_m: 0.0, ..terrain }),
    ];
    for (i, result) in bad.into_iter().enumerate() {
        assert!(matches!(result, Err(Error::Setting { .. })), "case {i}");
    }
}

#[test]
fn shapes_face_outward_and_have_the_area_they_should() {
    let two = UVec2::new(96, 48);
    let tau = std::f64::consts::TAU;
    let heights: Vec<f32> = (0..64).map(|i| (i % 8) as f32).collect();
    let shapes = [
        ("plane", Mesh::plane(Vec2::new(2.0, 3.0), two), 6.0),
        ("sphere", Mesh::sphere(2.0, 64), 8.0 * tau),
        ("torus", Mesh::torus(2.0, 0.5, two), tau * tau),
        ("mobius", Mesh::mobius(2.0, 0.4, two), 2.0 * tau * 2.0 * 0.4),
        ("heightmap", Mesh::heightmap(8, 8, &heights, Vec2::splat(7.0)), 49.0 * 2f64.sqrt()),
        ("terrain", Mesh::terrain(NoiseTerrain { height_m: 0.0, ..Default::default() }), 1e4),
    ];
    for (name, mesh, area) in shapes {
        let surface = Surface::new(mesh.unwrap()).unwrap();
        assert_eq!(surface.dropped_triangles(), 0, "{name}");
        let off = surface.area_m2() / area - 1.0;
        assert!(off.abs() < 0.01, "{name}: {} is not {area}", surface.area_m2());
        let mesh = surface.mesh();
        for t in &mesh.triangles {
            let [a, b, c] = t.map(|v| mesh.positions[v as usize]);
            let face = (b - a).cross(c - a).normalize();
            for v in t {
                assert!(face.dot(mesh.normals[*v as usize]) > 0.9, "{name}: {a} {b} {c}");
            }
        }
    }
}

#[test]
fn terrain_is_hilly_and_of_its_height() {
    let terrain = NoiseTerrain { size_m: 400.0, height_m: 10.0, ..Default::default() };
    let (low, high) = Surface::new(Mesh::terrain(terrain).unwrap()).unwrap().bounds();
    assert!((7.0..14.0).contains(&(high.y - low.y)), "{low} {high}");
    assert!(low.y < -2.0 && high.y > 2.0, "{low} {high}");
}

fn odd_float() -> impl Strategy<Value = f32> {
    prop_oneof![
        6 => -2.0f32..2.0,
        1 => prop::sample::select(vec![0.0, -0.0, f32::NAN, f32::INFINITY, 1e30, 1e9, 1e-30, f32::MIN_POSITIVE]),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn no_mesh_makes_growing_panic(
        points in prop::collection::vec((odd_float(), odd_float(), odd_float()), 0..8),
        triangles in prop::collection::vec([0u32..9, 0u32..9, 0u32..9], 0..8),
        share in prop::sample::select(vec![0.0, 0.5, 1.0]),
    ) {
        let positions: Vec<Vec3> = points.iter().map(|&(x, y, z)| Vec3::new(x, y, z)).collect();
        let mesh = Mesh { positions, triangles, ..Default::default() };
        if let Ok(surface) = Surface::new(mesh) {
            let scale = surface.area_m2().sqrt() as f32;
            let mut desc = desc(&surface, 300.0, 0.0);
            desc.density = desc.density.clamp(f32::MIN_POSITIVE, 1e9);
            if share > 0.0 && scale < 1e5 && scale > 1e-20 {
                desc.tufts = Some(Tufts { share, radius_m: scale * 0.2, spread_m: scale * 0.1 });
            }
            if let Ok(field) = Field::grow(&surface, &desc) {
                for blade in field.blades() {
                    prop_assert!(blade.root.is_finite() && blade.up.is_normalized());
                }
            }
        }
    }
}
