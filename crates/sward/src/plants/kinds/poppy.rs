//! The common poppy.

use crate::plants::builder::{Builder, Head, Skin, outward, sideways};
use crate::plants::model::Outline;
use glam::Vec3;

const STEM: [[f32; 3]; 3] = [[0.07, 0.12, 0.03], [0.12, 0.18, 0.05], [0.16, 0.20, 0.07]];
const LEAF: [[f32; 3]; 3] = [[0.05, 0.10, 0.03], [0.11, 0.19, 0.06], [0.16, 0.25, 0.08]];
/// Dark at the root.
const PETAL: [[f32; 3]; 3] = [[0.03, 0.004, 0.006], [0.60, 0.025, 0.010], [0.74, 0.055, 0.016]];
const INNER: [[f32; 3]; 3] = [[0.02, 0.003, 0.005], [0.50, 0.016, 0.008], [0.64, 0.035, 0.012]];
const DARK: [[f32; 3]; 3] = [[0.012, 0.010, 0.014]; 3];
const CAPSULE: [[f32; 3]; 3] = [[0.12, 0.17, 0.06], [0.16, 0.21, 0.08], [0.10, 0.12, 0.05]];

/// Red cups on slender stems, a nodding bud, cut leaves below.
pub(super) fn poppy(build: &mut Builder) {
    for index in 0..9 {
        let angle = build.round(index, 9, 0.0, 0.8) * 2.0;
        let high = build.between(0.0, 0.28);
        let reach = build.between(0.14, 0.27);
        let rise = build.between(0.12, 0.3);
        let tone = build.between(0.8, 1.2);
        let skin = Skin::new(Outline::Toothed, 0.4, LEAF).toned(tone);
        build.arching(Vec3::Y * high, angle, [reach, rise, 0.4 * reach], 0.1, skin);
    }
    let first = build.between(0.0, 6.0);
    for index in 0..2 {
        let angle = build.round(index, 2, first, 0.5);
        let high = if index == 0 { 0.9 } else { build.between(0.6, 0.74) };
        let at = outward(angle) * build.between(0.05, 0.14) + Vec3::Y * high;
        build.stem(outward(angle) * 0.01, at, 0.011, Skin::new(Outline::Stem, 0.9, STEM));
        let axis = Vec3::Y + outward(angle + build.between(-0.6, 0.6)) * build.between(0.5, 1.0);
        cup(build, &Head::new(at, axis));
    }
    bud(build, first + 1.6);
}

/// Four broad petals, two within two, round a dark heart.
fn cup(build: &mut Builder, head: &Head) {
    let first = build.between(0.0, 6.0);
    for (pair, colors, size, raised) in [(0, PETAL, 0.18, 0.28), (1, INNER, 0.165, 0.62)] {
        for index in 0..3 {
            let angle = build.round(index, 3, first + pair as f32, 0.3);
            let knee = head.at + head.direction(angle, raised - 0.25) * (0.6 * size);
            let tip = head.at + head.direction(angle, raised + 0.25) * size;
            let tone = build.between(0.85, 1.15);
            let skin = Skin::new(Outline::Fan, 0.12, colors).toned(tone);
            build.flat([head.at, knee, tip], head.tangent(angle), 0.22, skin);
        }
    }
    for index in 0..7 {
        let angle = build.round(index, 7, 0.0, 0.4);
        let tip = head.at + head.direction(angle, 0.75) * 0.06;
        let stamen = Skin::new(Outline::Fan, 0.6, DARK);
        build.flat([head.at, head.at.lerp(tip, 0.5), tip], head.tangent(angle), 0.02, stamen);
    }
    let (low, high) = (head.at + head.axis * 0.005, head.at + head.axis * 0.055);
    build.rounded([low, low.lerp(high, 0.5), high], 0.03, Skin::new(Outline::Petal, 0.9, CAPSULE));
}

/// A bud that hangs from its bent stem.
fn bud(build: &mut Builder, angle: f32) {
    let out = outward(angle);
    let high = build.between(0.55, 0.72);
    let top = out * 0.1 + Vec3::Y * high;
    let neck = top + out * 0.05 - Vec3::Y * 0.035;
    let stem = Skin::new(Outline::Stem, 0.9, STEM);
    build.stem(out * 0.01, top, 0.009, stem);
    build.rounded([top, top + out * 0.04 + Vec3::Y * 0.035, neck], 0.008, stem);
    let end = neck + out * 0.02 - Vec3::Y * 0.075;
    build.rounded([neck, neck.lerp(end, 0.5), end], 0.04, Skin::new(Outline::Disc, 0.9, CAPSULE));
    // A rim of red where it opens
    let rim = Skin::new(Outline::Leaf, 0.3, PETAL);
    build.flat([neck, neck.lerp(end, 0.5) + out * 0.015, end], sideways(angle), 0.012, rim);
}
