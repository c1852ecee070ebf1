use super::{desc, hills, roots, spacing};
use glam::{Quat, Vec3};
use proptest::prelude::*;
use std::collections::HashSet;
use sward::grow::Blade;
use sward::{BladeOrder, Field, FieldDesc, Metric, Range, Species};

#[test]
fn patches_have_equal_counts_and_hold_every_blade_once() {
    let surface = hills();
    for (patch_size, metric, order) in [
        (64, Metric::Euclidean, BladeOrder::Progressive),
        (256, Metric::Manhattan, BladeOrder::Morton),
        (1024, Metric::Euclidean, BladeOrder::Lexicographic),
    ] {
        let desc = FieldDesc { patch_size, metric, order, ..desc(&surface, 10_500.0, 0.3) };
        let field = Field::grow(&surface, &desc).unwrap();
        let patches = field.patches();
        assert_eq!(patches.len(), 10_500usize.div_ceil(patch_size as usize));
        for (i, patch) in patches.iter().enumerate() {
            assert_eq!(patch.first, i as u32 * patch_size);
            let last = i + 1 == patches.len();
            assert_eq!(patch.count, if last { 10_500 - patch.first } else { patch_size });
        }
        let distinct: HashSet<_> =
            field.blades().iter().map(|b| b.root.to_array().map(f32::to_bits)).collect();
        assert_eq!(distinct.len(), 10_500);
        // Another way of sorting keeps the blades.
        let again =
            Field::from_blades(desc.species, field.blades(), 64, Metric::Euclidean, order).unwrap();
        let same: HashSet<_> =
            again.blades().iter().map(|b| b.root.to_array().map(f32::to_bits)).collect();
        assert_eq!(distinct, same);
    }
}

/// Chunks of `size` along the Morton curve over the field's box.
fn morton_chunks(points: &[Vec3], size: usize) -> Vec<Vec<Vec3>> {
    let low = points.iter().fold(Vec3::INFINITY, |l, &p| l.min(p));
    let high = points.iter().fold(Vec3::NEG_INFINITY, |h, &p| h.max(p));
    let scale = 65_535.0 / (high - low).max_element();
    let mut sorted = points.to_vec();
    sorted.sort_by_cached_key(|&p| {
        let cell = ((p - low) * scale).as_uvec3();
        (0..16).fold(0u64, |code, bit| {
            let pick = |x: u32, at: u32| u64::from(x >> bit & 1) << (3 * bit + at);
            code | pick(cell.x, 0) | pick(cell.y, 1) | pick(cell.z, 2)
        })
    });
    sorted.chunks(size).map(<[Vec3]>::to_vec).collect()
}

/// Mean diagonal and mean surface of the groups' boxes.
fn boxes(groups: &[Vec<Vec3>]) -> (f32, f32) {
    let sums = groups.iter().fold((0.0, 0.0), |(diagonal, area), group| {
        let low = group.iter().fold(Vec3::INFINITY, |l, &p| l.min(p));
        let high = group.iter().fold(Vec3::NEG_INFINITY, |h, &p| h.max(p));
        let e = high - low;
        (diagonal + e.length(), area + e.x * e.y + e.y * e.z + e.z * e.x)
    });
    (sums.0 / groups.len() as f32, sums.1 / groups.len() as f32)
}

#[test]
fn patches_are_more_compact_than_morton_chunks() {
    let surface = hills();
    for metric in [Metric::Euclidean, Metric::Manhattan] {
        let desc = FieldDesc { metric, ..desc(&surface, 50_000.0, 0.0) };
        let field = Field::grow(&surface, &desc).unwrap();
        let points = roots(&field);
        let own: Vec<Vec<Vec3>> = points.chunks(256).map(<[Vec3]>::to_vec).collect();
        let (own, morton) = (boxes(&own), boxes(&morton_chunks(&points, 256)));
        println!("{metric:?}: diagonal, area {own:?}; Morton {morton:?}");
        assert!(own.0 < 0.85 * morton.0 && own.1 < 0.7 * morton.1, "{own:?} {morton:?}");
    }
}

#[test]
fn progressive_prefixes_are_spread_evenly() {
    let surface = hills();
    let grow = |order| {
        let desc = FieldDesc { order, ..desc(&surface, 256.0 * 32.0, 0.0) };
        Field::grow(&surface, &desc).unwrap()
    };
    let (progressive, morton) = (grow(BladeOrder::Progressive), grow(BladeOrder::Morton));
    for (i, patch) in progressive.patches().iter().enumerate() {
        let run = patch.first as usize..(patch.first + patch.count) as usize;
        let ours = &roots(&progressive)[run.clone()];
        // Each half along the longer side holds half of every prefix.
        let extent = patch.root_max - patch.root_min;
        let axis = extent.max_position();
        let mut along: Vec<f32> = ours.iter().map(|r| r[axis]).collect();
        along.sort_by(f32::total_cmp);
        let middle = along[along.len() / 2];
        for length in 1..=ours.len() {
            let low = ours[..length].iter().filter(|r| r[axis] < middle).count();
            assert!(low.abs_diff(length - low) <= 1, "patch {i}, prefix {length}: {low}");
        }
        let theirs = &roots(&morton)[run];
        for length in [8, 16, 33, 64, 100] {
            let (own, other) = (spacing(&ours[..length]), spacing(&theirs[..length]));
            assert!(own > 1.15 * other, "patch {i}, prefix {length}: {own} and {other}");
        }
    }
}

#[test]
fn progressive_prefixes_beat_chance() {
    let surface = hills();
    let field = Field::grow(&surface, &desc(&surface, 256.0 * 32.0, 0.0)).unwrap();
    let (mut own, mut chance) = (0.0, 0.0);
    for patch in field.patches() {
        let run = patch.first as usize..(patch.first + patch.count) as usize;
        let blades = &roots(&field)[run];
        // A random subset: 97 is prime to 256.
        let random: Vec<Vec3> =
            (0..32).map(|k: usize| blades[(k * k * 97 + k * 31) % 256]).collect();
        own += spacing(&blades[..32]);
        chance += spacing(&random);
    }
    println!("spacing of 32: {own} against {chance}");
    assert!(own > 1.1 * chance, "{own} {chance}");
}

#[test]
fn other_orders_are_as_named() {
    let surface = hills();
    let desc = FieldDesc { order: BladeOrder::Lexicographic, ..desc(&surface, 1000.0, 0.0) };
    let field = Field::grow(&surface, &desc).unwrap();
    for patch in roots(&field).chunks(256) {
        assert!(patch.is_sorted_by(|a, b| a.to_array() <= b.to_array()));
    }
    let desc = FieldDesc { order: BladeOrder::Morton, ..desc };
    let field = Field::grow(&surface, &desc).unwrap();
    for patch in roots(&field).chunks(256) {
        let step: f32 = patch.windows(2).map(|w| w[0].distance(w[1])).sum::<f32>() / 256.0;
        let any: f32 = (0..255)
            .map(|i| patch[i % patch.len()].distance(patch[(i * 97) % patch.len()]))
            .sum::<f32>()
            / 255.0;
        assert!(step < 0.6 * any, "{step} {any}");
    }
}

/// A pose by equations 10 to 12 of J: the curve's points for a tip direction, of length `h`.
fn pose(blade: &Blade, direction: Vec3) -> [Vec3; 3] {
    let (cl, sl) = (direction.dot(blade.up), direction.reject_from_normalized(blade.up).length());
    let (a, b) = (2.0 * cl * sl + 4.0 * sl - 3.0, 8.0 - 2.0 * cl - 6.0 * sl);
    let mut rho = 6.0 / (b + (b * b + 12.0 * a).max(0.0).sqrt());
    if rho * sl >= 0.95 {
        let e = 11.8 - 0.1 * cl;
        rho = (e - (e * e - 104.4).sqrt()) / 6.0;
    }
    let reach = rho * sl;
    let v1 = blade.root + blade.up * blade.height * (1.0 - reach).max(0.05 * reach.max(1.0));
    [blade.root, v1, blade.root + direction * rho * blade.height]
}

fn unit() -> impl Strategy<Value = Vec3> {
    (-1.0f32..1.0, 0.0f32..std::f32::consts::TAU).prop_map(|(y, angle)| {
        let r = (1.0 - y * y).sqrt();
        Vec3::new(r * angle.cos(), y, r * angle.sin())
    })
}

proptest! {
    #[test]
    fn bounds_hold_every_pose(
        up in unit(),
        direction in unit(),
        sideways in unit(),
        height in 0.01f32..3.0,
        width in 0.001f32..0.5,
        root in unit(),
    ) {
        let up = up.normalize();
        let blade = Blade {
            root: root * 10.0, up, facing: 1.0, height, width, response: 5.0, species: 0,
        };
        let kind = Species {
            height_m: Range::new(height, height),
            width_m: Range::new(width, width),
            ..Species::default()
        };
        let field = Field::from_blades(
            vec![kind], &[blade], 64, Metric::Euclidean, BladeOrder::Progressive,
        ).unwrap();
        let (low, high) = field.bounds();
        // Mirror the direction to the upper side of the root plane.
        let below = direction.dot(up).min(0.0);
        let direction = (direction - 2.0 * below * up).normalize();
        let [v0, v1, v2] = pose(&blade, direction);
        for step in 0..=20 {
            let t = step as f32 / 20.0;
            let p = v0.lerp(v1, t).lerp(v1.lerp(v2, t), t) + sideways * width * 0.5;
            prop_assert!(p.cmpge(low - 1e-4).all() && p.cmple(high + 1e-4).all(), "{p} {low} {high}");
        }
        // And no larger than need be: a ball would be as wide below the plane.
        let flat = Quat::from_rotation_arc(up, Vec3::Y) * (high - v0);
        prop_assert!(flat.is_finite() && (high - low).max_element() <= 2.05 * height + width + 1e-4);
    }
}
