use super::{desc, hills, plane, roots};
use glam::Vec3;
use std::collections::HashSet;
use sward::{DensityMap, Error, Field, FieldDesc, Mesh, Surface};

fn bits(v: Vec3) -> [u32; 3] {
    v.to_array().map(f32::to_bits)
}

#[test]
fn a_texture_thins_through_uvs() {
    let surface = plane(10.0);
    // Left half bare, right half half as dense; uv.x grows with x.
    let mut values = vec![0.0; 32];
    values.extend([0.5; 32]);
    let values: Vec<f32> = (0..64).map(|i| values[(i % 8) * 8]).collect();
    let map = DensityMap::Texture { width: 8, height: 8, values };
    let desc = FieldDesc { density_map: Some(map), ..desc(&surface, 16_000.0, 0.3) };
    let field = Field::grow(&surface, &desc).unwrap();
    let left = roots(&field).iter().filter(|r| r.x > -4.3 && r.x < -0.7).count();
    let right = roots(&field).iter().filter(|r| r.x > 0.7 && r.x < 4.3).count();
    assert_eq!(left, 0);
    let expected = 16_000.0 * 0.36 * 0.5;
    assert!((right as f32 - expected).abs() < 0.05 * expected, "{right} of {expected}");
}

#[test]
fn vertex_colours_thin() {
    let mut mesh = plane(10.0).mesh().clone();
    mesh.colors = mesh.positions.iter().map(|p| [p.x / 10.0 + 0.5, 1.0, 1.0, 1.0]).collect();
    let surface = Surface::new(mesh).unwrap();
    let map = Some(DensityMap::VertexColor);
    let desc = FieldDesc { density_map: map, ..desc(&surface, 10_000.0, 0.0) };
    let field = Field::grow(&surface, &desc).unwrap();
    let right = roots(&field).iter().filter(|r| r.x > 0.0).count();
    assert!((right as f32 - 3750.0).abs() < 150.0, "{right}");
    let all = field.blades().len();
    assert!((all as f32 - 5000.0).abs() < 150.0, "{all}");
}

#[test]
fn slope_and_height_limits_remove_blades_and_change_none() {
    let surface = hills();
    let free = desc(&surface, 20_000.0, 0.3);
    let all: HashSet<_> = {
        let field = Field::grow(&surface, &free).unwrap();
        field.blades().iter().map(|b| (bits(b.root), b.height.to_bits())).collect()
    };
    let limits = [
        FieldDesc { max_slope_deg: 15.0, ..free.clone() },
        FieldDesc { height_limits_m: (-0.5, 1.0), ..free.clone() },
    ];
    for desc in limits {
        let field = Field::grow(&surface, &desc).unwrap();
        let kept = field.blades().len();
        assert!(kept > 1000 && kept < 19_000, "{kept}");
        for blade in field.blades() {
            assert!(all.contains(&(bits(blade.root), blade.height.to_bits())));
            let (low, high) = desc.height_limits_m;
            assert!(blade.root.y >= low && blade.root.y <= high);
            if desc.max_slope_deg < 180.0 && blade.up.y < 15.0f32.to_radians().cos() - 1e-4 {
                // Only a tuft's blades lean away from the normal.
                assert!(blade.up.y > (15.0f32 + 20.0).to_radians().cos(), "{blade:?}");
            }
        }
    }
}

#[test]
fn level_ground_passes_a_slope_limit_of_zero() {
    let surface = plane(3.0);
    let desc = FieldDesc { max_slope_deg: 0.0, ..desc(&surface, 500.0, 0.0) };
    assert_eq!(Field::grow(&surface, &desc).unwrap().blades().len(), 500);
}

#[test]
fn a_mask_that_removes_all_is_an_error() {
    let surface = plane(3.0);
    let desc = FieldDesc { height_limits_m: (5.0, 6.0), ..desc(&surface, 500.0, 0.0) };
    assert!(matches!(Field::grow(&surface, &desc), Err(Error::Mesh(m)) if m.contains("500")));
}

#[test]
fn a_map_needs_its_data() {
    let mut mesh: Mesh = plane(3.0).mesh().clone();
    mesh.uvs.clear();
    let surface = Surface::new(mesh).unwrap();
    let texture = DensityMap::Texture { width: 1, height: 1, values: vec![1.0] };
    for (map, word) in [(texture, "texture coordinates"), (DensityMap::VertexColor, "colours")] {
        let desc = FieldDesc { density_map: Some(map), ..desc(&surface, 500.0, 0.0) };
        let error = Field::grow(&surface, &desc).unwrap_err().to_string();
        assert!(error.starts_with("density_map") && error.contains(word), "{error}");
    }
}
