//! Rocks and trees, made from noise-displaced balls and cones.

use super::random::Random;
use glam::{Vec2, Vec3};
use sward::Mesh;

/// A unit ball as a grid of `rings` by twice as many segments, each direction moved to
/// `place(direction)`.
fn ball(rings: u32, place: impl Fn(Vec3) -> Vec3) -> Mesh {
    let segments = rings * 2;
    let mut mesh = Mesh::default();
    for ring in 0..=rings {
        let (sin_v, cos_v) = (std::f32::consts::PI * ring as f32 / rings as f32).sin_cos();
        for segment in 0..=segments {
            let u = (segment % segments) as f32 / segments as f32;
            let (sin_u, cos_u) = (std::f32::consts::TAU * u).sin_cos();
            // At the poles sin is not quite 0 in f32: the ring would not close.
            let sin_v = if ring == 0 || ring == rings { 0.0 } else { sin_v };
            mesh.positions.push(place(Vec3::new(sin_v * sin_u, cos_v, sin_v * cos_u)));
            mesh.uvs.push(Vec2::new(segment as f32 / segments as f32, ring as f32 / rings as f32));
        }
    }
    let row = segments + 1;
    for ring in 0..rings {
        for segment in 0..segments {
            let a = ring * row + segment;
            let (b, c, d) = (a + 1, a + row, a + row + 1);
            if ring > 0 {
                mesh.triangles.push([a, c, b]);
            }
            if ring + 1 < rings {
                mesh.triangles.push([b, c, d]);
            }
        }
    }
    mesh.normals = smooth_normals(&mesh, row);
    mesh
}

/// Area-weighted normals; the two rims of the seam and the poles share theirs.
fn smooth_normals(mesh: &Mesh, row: u32) -> Vec<Vec3> {
    let mut normals = vec![Vec3::ZERO; mesh.positions.len()];
    for &triangle in &mesh.triangles {
        let [a, b, c] = crate::assets::mesh::corners(mesh, triangle);
        let normal = (b - a).cross(c - a);
        for index in triangle {
            if let Some(n) = normals.get_mut(index as usize) {
                *n += normal;
            }
        }
    }
    let rings = normals.len() / row as usize;
    for (i, ring) in normals.chunks_exact_mut(row as usize).enumerate() {
        let sum = if i == 0 || i + 1 == rings { Some(ring.iter().sum::<Vec3>()) } else { None };
        let seam =
            ring.first().copied().unwrap_or(Vec3::Y) + ring.last().copied().unwrap_or(Vec3::Y);
        if let Some(sum) = sum {
            ring.fill(sum);
        } else {
            ring.first_mut().into_iter().for_each(|n| *n = seam);
            ring.last_mut().into_iter().for_each(|n| *n = seam);
        }
    }
    normals.into_iter().map(|n| n.normalize_or(Vec3::Y)).collect()
}

/// Smooth noise over directions, about -1..=1: a few plane waves.
struct Lumps {
    waves: Vec<(Vec3, f32, f32)>,
}

impl Lumps {
    fn new(random: &mut Random, frequencies: &[f32]) -> Self {
        let mut waves = Vec::new();
        for &frequency in frequencies {
            for _ in 0..4 {
                let wave = random.direction() * frequency * random.between(0.7, 1.3);
                waves.push((wave, random.between(0.0, 6.3), 1.0 / frequency));
            }
        }
        let total: f32 = waves.iter().map(|wave| wave.2 * wave.2 / 2.0).sum();
        let scale = 0.5 / total.sqrt().max(1e-6);
        waves.iter_mut().for_each(|wave| wave.2 *= scale);
        Self { waves }
    }

    fn at(&self, point: Vec3) -> f32 {
        let wave = |&(wave, phase, strength): &(Vec3, f32, f32)| {
            (wave.dot(point) + phase).sin() * strength
        };
        self.waves.iter().map(wave).sum()
    }
}

/// A boulder: a ball cut by a few planes, then roughened. A third of it lies below the origin.
pub(super) fn rock(radius_m: f32, rough: f32, seed: u32) -> Mesh {
    let mut random = Random::new(u64::from(seed), 11);
    let lumps = Lumps::new(&mut random, &[1.6, 3.7, 8.0]);
    let cuts: Vec<(Vec3, f32)> =
        (0..9).map(|_| (random.direction(), 1.0 - rough * random.between(0.2, 1.1))).collect();
    let squash = Vec3::new(random.between(0.85, 1.2), random.between(0.6, 0.85), 1.0);
    ball(28, |direction| {
        let faces = cuts.iter().map(|(normal, distance)| {
            let along = normal.dot(direction);
            if along > 0.05 { distance / along } else { f32::INFINITY }
        });
        let reach = faces.fold(1.0_f32, f32::min).max(0.25);
        let reach = reach * (1.0 + 0.35 * rough * lumps.at(direction));
        let point = direction * reach * squash;
        (point + Vec3::Y * (squash.y / 3.0)) * radius_m
    })
}

/// A hilly ball's shape.
pub(super) struct Planet {
    pub(super) radius_m: f32,
    pub(super) relief_m: f32,
    pub(super) hill_m: f32,
    pub(super) seed: u32,
}

/// A ball with hills all over it.
pub(super) fn planet(planet: &Planet, rings: u32) -> Mesh {
    let mut random = Random::new(u64::from(planet.seed), 13);
    let wave = std::f32::consts::TAU * planet.radius_m / planet.hill_m;
    let lumps = Lumps::new(&mut random, &[wave, 2.1 * wave]);
    ball(rings, |direction| {
        // Most of the noise lies within -1..=1: its range is the relief.
        let hill = lumps.at(direction).clamp(-1.0, 1.0);
        direction * (planet.radius_m + 0.5 * planet.relief_m * hill)
    })
}

/// A tree's shape.
pub(super) struct Tree {
    pub(super) height_m: f32,
    pub(super) crown_m: f32,
    pub(super) leaf: [f32; 3],
    pub(super) bark: [f32; 3],
    pub(super) seed: u32,
}

/// Trunk and crown in one mesh, told apart by vertex colours.
pub(super) fn tree(tree: &Tree) -> Mesh {
    let mut random = Random::new(u64::from(tree.seed), 12);
    let mut mesh = trunk(tree, &mut random);
    let blobs = 9;
    for blob in 0..blobs {
        let lumps = Lumps::new(&mut random, &[2.5, 6.0, 12.0]);
        // The golden angle spreads the blobs round the trunk.
        let angle = blob as f32 * 2.399_963 + random.between(-0.4, 0.4);
        let rise = blob as f32 / (blobs - 1) as f32;
        let out = tree.crown_m * 0.52 * (1.0 - rise * rise * 0.9) * random.between(0.8, 1.1);
        let radius = tree.crown_m * random.between(0.42, 0.58) * (1.0 - 0.3 * rise);
        let top = tree.height_m - radius * 0.85;
        let low = (tree.height_m * 0.42).min(top);
        let center = Vec3::new(angle.sin() * out, low + (top - low) * rise, angle.cos() * out);
        let mut part = ball(14, |direction| {
            let reach = radius * (1.0 + 0.22 * lumps.at(direction));
            center + direction * reach * Vec3::new(1.0, 0.82, 1.0)
        });
        let shade = random.between(0.85, 1.15);
        let lit = |p: &Vec3| {
            // Leaves inside and below get less light.
            let up = ((p.y - center.y) / radius).clamp(-1.0, 1.0);
            let light = shade * (0.8 + 0.2 * up);
            let [r, g, b] = tree.leaf.map(|c| (c * light).clamp(0.0, 1.0));
            [r, g, b, 1.0]
        };
        part.colors = part.positions.iter().map(lit).collect();
        crate::assets::mesh::append(&mut mesh, &part);
    }
    mesh
}

/// The trunk near the ground as a capsule: from below the foot to a third of the height, with the
/// radius that it has at the ground.
pub(super) fn trunk_capsule(height_m: f32) -> (Vec3, Vec3, f32) {
    (Vec3::NEG_Y * height_m * 0.1, Vec3::Y * height_m * 0.33, height_m * 0.0302)
}

fn trunk(tree: &Tree, random: &mut Random) -> Mesh {
    let (foot, top) = (tree.height_m * 0.035, tree.height_m * 0.75);
    let lean = Vec3::new(random.between(-0.05, 0.05), 0.0, random.between(-0.05, 0.05));
    let mut mesh = ball(10, |direction| {
        // The ball's height runs along the trunk; it starts below ground, so that slopes show no gap.
        let along = direction.y * 0.5 + 0.5;
        let radius = foot * (1.0 - 0.7 * along) * (1.0 + 0.8 * (1.0 - along).powi(8));
        let side = Vec3::new(direction.x, 0.0, direction.z).normalize_or_zero();
        let flat = if direction.y.abs() > 0.99 { 0.0 } else { radius };
        side * flat + (Vec3::Y + lean) * (along * (top + foot * 8.0) - foot * 8.0)
    });
    let [r, g, b] = tree.bark;
    mesh.colors = vec![[r, g, b, 1.0]; mesh.positions.len()];
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outward_share(mesh: &Mesh, center: Vec3) -> f32 {
        let outward = mesh.triangles.iter().filter(|t| {
            let [a, b, c] = crate::assets::mesh::corners(mesh, **t);
            (b - a).cross(c - a).dot((a + b + c) / 3.0 - center) > 0.0
        });
        outward.count() as f32 / mesh.triangles.len() as f32
    }

    #[test]
    fn rocks_are_closed_face_outwards_and_differ_by_seed() {
        let rock_1 = rock(2.0, 0.35, 1);
        assert!(outward_share(&rock_1, Vec3::Y * 0.5) > 0.99);
        assert_ne!(rock_1.positions, rock(2.0, 0.35, 2).positions);
        assert_eq!(rock_1, rock(2.0, 0.35, 1));
        let longest = rock_1.positions.iter().map(|p| p.length()).fold(0.0, f32::max);
        assert!((1.0..4.0).contains(&longest), "{longest}");
    }

    #[test]
    fn planets_are_closed_and_hilly() {
        let made = planet(&Planet { radius_m: 5.0, relief_m: 0.8, hill_m: 4.0, seed: 1 }, 48);
        assert!(outward_share(&made, Vec3::ZERO) > 0.999);
        let radii = made.positions.iter().map(|p| p.length());
        let (low, high) = radii.fold((9.0_f32, 0.0_f32), |(l, h), r| (l.min(r), h.max(r)));
        assert!((4.59..4.85).contains(&low) && (5.15..5.41).contains(&high), "{low} to {high}");
    }

    #[test]
    fn trees_reach_their_height() {
        let tree = tree(&Tree {
            height_m: 7.0,
            crown_m: 2.4,
            leaf: [0.1, 0.2, 0.05],
            bark: [0.1; 3],
            seed: 3,
        });
        let top = tree.positions.iter().map(|p| p.y).fold(0.0, f32::max);
        assert!((6.0..8.5).contains(&top), "{top}");
        assert_eq!(tree.colors.len(), tree.positions.len());
        assert!(tree.positions.iter().chain(&tree.normals).all(|v| v.is_finite()));
    }
}
