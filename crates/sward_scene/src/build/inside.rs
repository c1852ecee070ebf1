//! A field on a part of an object: a disk seen from above, with a soft rim.

use crate::check::{Key, MAX_M, Problem};
use crate::schema::InsideFile;
use glam::{Vec2, Vec3Swizzles};
use std::collections::HashMap;
use sward::{DensityMap, Mesh};

/// Texels a side of the mask.
const SIDE: u32 = 128;

/// Cuts the mesh down to the triangles that reach into the disk, maps it from above, and makes the
/// mask that goes with that map.
pub(super) fn cut(
    mesh: &Mesh,
    inside: &InsideFile,
    key: &Key,
) -> Result<(Mesh, DensityMap), Problem> {
    let [x, z] = inside.center;
    let center = key.at("center").vector([x, 0.0, z])?.xz();
    let radius = key.at("radius_m").above_zero(inside.radius_m, MAX_M)?;
    let soft = key.at("soft_m").within(inside.soft_m, 0.0, radius)?;
    let part = part(mesh, center, radius);
    if part.triangles.is_empty() {
        return Err(key.problem("nothing of the object lies inside; move `center`"));
    }
    Ok((part, mask(radius, soft)))
}

fn part(mesh: &Mesh, center: Vec2, radius: f32) -> Mesh {
    let mut part = Mesh::default();
    let mut known: HashMap<u32, u32> = HashMap::new();
    let at = |index: u32| mesh.positions.get(index as usize).map(|p| p.xz());
    for triangle in &mesh.triangles {
        let [Some(a), Some(b), Some(c)] = triangle.map(at) else { continue };
        // The bounding box, as a large triangle may reach in with no corner inside.
        let nearest = center.clamp(a.min(b).min(c), a.max(b).max(c));
        if nearest.distance(center) > radius {
            continue;
        }
        part.triangles.push(triangle.map(|index| {
            *known.entry(index).or_insert_with(|| {
                let i = index as usize;
                part.positions.extend(mesh.positions.get(i));
                part.normals.extend(mesh.normals.get(i));
                let from_center = at(index).unwrap_or(center) - center;
                part.uvs.push(from_center / (2.0 * radius * MARGIN) + 0.5);
                (part.positions.len() - 1) as u32
            })
        }));
    }
    part
}

/// The mask's square over the disk's: triangles reach beyond the rim, and maps wrap.
const MARGIN: f32 = 4.0 / 3.0;

fn mask(radius: f32, soft: f32) -> DensityMap {
    let mut values = Vec::with_capacity((SIDE * SIDE) as usize);
    for row in 0..SIDE {
        for column in 0..SIDE {
            let texel = Vec2::new(column as f32 + 0.5, row as f32 + 0.5) / SIDE as f32 - 0.5;
            let distance = texel.length() * 2.0 * radius * MARGIN;
            let t = ((radius - distance) / soft.max(radius * 1e-3)).clamp(0.0, 1.0);
            values.push(t * t * (3.0 - 2.0 * t));
        }
    }
    DensityMap::Texture { width: SIDE, height: SIDE, values }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level(side: f32, cells: u32) -> Mesh {
        Mesh::plane(Vec2::splat(side), glam::UVec2::splat(cells)).expect("a plane")
    }

    #[test]
    fn the_cut_keeps_what_reaches_in_and_the_mask_fades_to_the_rim() {
        let inside = InsideFile { center: [3.0, -2.0], radius_m: 2.0, soft_m: 1.0 };
        let (part, map) = cut(&level(20.0, 40), &inside, &Key::name("k")).expect("inside");
        assert!(part.positions.iter().all(|p| p.xz().distance(Vec2::new(3.0, -2.0)) < 3.0));
        assert!(part.triangles.len() > 90);
        assert_eq!(part.uvs.len(), part.positions.len());
        let DensityMap::Texture { values, .. } = map else { panic!("a texture") };
        let middle = values[(64 * SIDE + 64) as usize];
        assert_eq!((middle, values[0], values[(64 * SIDE) as usize]), (1.0, 0.0, 0.0));
    }

    #[test]
    fn beside_the_object_is_an_error() {
        let inside = InsideFile { center: [300.0, 0.0], radius_m: 2.0, soft_m: 1.0 };
        let problem = cut(&level(20.0, 4), &inside, &Key::name("k")).expect_err("beside");
        assert!(problem.cause.contains("inside"));
    }
}
