//! Colliders as spheres that lie inside them.

use crate::{Collider, ColliderShape, Sphere};
use glam::Vec3;

/// Most spheres along an axis.
const MOST_ALONG: f32 = 64.0;

/// Spheres that fill a collider; none where its pose is not sound.
pub(crate) fn inside(collider: &Collider) -> Vec<Sphere> {
    let Some(pose) = collider.pose.sound() else { return Vec::new() };
    let mut spheres = match collider.shape {
        ColliderShape::Sphere { radius } => vec![Sphere { center: Vec3::ZERO, radius }],
        ColliderShape::Capsule { from, to, radius } => along(from, to, radius),
        ColliderShape::Cuboid { half_extents } => fill(half_extents),
        ColliderShape::Spheres(spheres) => spheres.to_vec(),
    };
    for sphere in &mut spheres {
        sphere.center = pose.point(sphere.center);
    }
    spheres
}

fn along(from: Vec3, to: Vec3, radius: f32) -> Vec<Sphere> {
    let count = (from.distance(to) / radius.max(1e-6) * 2.0).ceil().clamp(0.0, MOST_ALONG);
    let place = |i: u32| if count > 0.0 { i as f32 / count } else { 0.0 };
    (0..=count as u32).map(|i| Sphere { center: from.lerp(to, place(i)), radius }).collect()
}

/// Rows of spheres along the longest edge, as thick as the shortest.
fn fill(half: Vec3) -> Vec<Sphere> {
    let radius = half.min_element();
    let count = |h: f32| ((h / radius.max(1e-6) * 1.5).ceil() - 1.0).clamp(0.0, 8.0) as i32;
    let at = |i: i32, n: i32, h: f32| if n > 0 { (h - radius) * i as f32 / n as f32 } else { 0.0 };
    let (x, y, z) = (count(half.x), count(half.y), count(half.z));
    let rows = (-x..=x).flat_map(|i| (-y..=y).map(move |j| (i, j)));
    rows.flat_map(|(i, j)| (-z..=z).map(move |k| (i, j, k)))
        .map(|(i, j, k)| Vec3::new(at(i, x, half.x), at(j, y, half.y), at(k, z, half.z)))
        .map(|center| Sphere { center, radius })
        .collect()
}
