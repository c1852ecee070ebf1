//! Growing: surfaces, scatter, blades, patches, and what they refuse.

mod colors;
mod input;
mod masks;
mod obstacles;
mod patches;
mod scatter;

use glam::{UVec2, Vec2, Vec3};
use sward::grow::terrain::NoiseTerrain;
use sward::{Field, FieldDesc, Mesh, Surface, Tufts};

/// A level square of one metre a side times `size`, in two triangles.
pub(crate) fn plane(size: f32) -> Surface {
    Surface::new(Mesh::plane(Vec2::splat(size), UVec2::ONE).unwrap()).unwrap()
}

pub(crate) fn hills() -> Surface {
    let terrain =
        NoiseTerrain { size_m: 30.0, feature_m: 12.0, resolution: 64, ..Default::default() };
    Surface::new(Mesh::terrain(terrain).unwrap()).unwrap()
}

/// `count` blades, `share` of them in tufts.
pub(crate) fn desc(surface: &Surface, count: f64, share: f32) -> FieldDesc {
    let tufts = Tufts { share, radius_m: 0.5, spread_m: 0.3 };
    FieldDesc {
        density: (count / surface.area_m2()) as f32,
        tufts: (share > 0.0).then_some(tufts),
        ..Default::default()
    }
}

pub(crate) fn roots(field: &Field) -> Vec<Vec3> {
    field.blades().iter().map(|b| b.root).collect()
}

/// Mean distance from each point to its nearest neighbour.
pub(crate) fn spacing(points: &[Vec3]) -> f32 {
    let nearest = |i: usize| {
        (points.iter().enumerate())
            .filter(|&(j, _)| j != i)
            .map(|(_, q)| q.distance_squared(points[i]))
            .fold(f32::INFINITY, f32::min)
            .sqrt()
    };
    (0..points.len()).map(nearest).sum::<f32>() / points.len() as f32
}
