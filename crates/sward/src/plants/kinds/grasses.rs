//! Three grasses: broad and arching, tall with seed heads, fine.

use crate::plants::builder::{Builder, Skin, outward, sideways};
use crate::plants::model::Outline;
use glam::Vec3;
use std::f32::consts::TAU;

const BLADE: [[f32; 3]; 3] = [[0.035, 0.075, 0.014], [0.10, 0.20, 0.032], [0.23, 0.34, 0.075]];
const FINE: [[f32; 3]; 3] = [[0.05, 0.08, 0.02], [0.12, 0.20, 0.045], [0.27, 0.33, 0.10]];
const STALK: [[f32; 3]; 3] = [[0.06, 0.11, 0.02], [0.15, 0.22, 0.05], [0.33, 0.31, 0.12]];
const SEED: [[f32; 3]; 3] = [[0.20, 0.17, 0.07], [0.36, 0.27, 0.13], [0.47, 0.36, 0.20]];

/// Where blade `index` of a tuft comes out of the ground.
fn foot(build: &mut Builder, angle: f32, radius: f32) -> Vec3 {
    outward(angle) * build.between(0.2, 1.0) * radius
}

/// A tuft of broad arching blades.
pub(super) fn meadow(build: &mut Builder) {
    let count = 34;
    for index in 0..count {
        let angle = build.round(index, count, 0.0, 1.0) * 7.0 % TAU;
        let from = foot(build, angle, 0.12);
        // The short ones lie over the farthest
        let size = build.between(0.35, 1.0);
        let reach = build.between(0.16, 0.42) * (1.35 - 0.5 * size);
        let rise = 1.1 * size;
        let hang = build.between(0.2, 0.9) * reach;
        let tone = build.between(0.75, 1.2);
        let skin = Skin::new(Outline::Blade, 0.35, BLADE).toned(tone);
        let width = build.between(0.03, 0.046);
        build.arching(from, angle, [reach, rise, hang], width, skin);
    }
}

/// A tuft with high stalks that bear seed heads.
pub(super) fn tall(build: &mut Builder) {
    for index in 0..14 {
        let angle = build.round(index, 14, 0.3, 1.0) * 5.0 % TAU;
        let from = foot(build, angle, 0.05);
        let size = build.between(0.35, 0.72);
        let reach = build.between(0.15, 0.24);
        let tone = build.between(0.75, 1.15);
        let skin = Skin::new(Outline::Blade, 0.35, BLADE).toned(tone);
        let hang = build.between(0.2, 1.0) * reach;
        build.arching(from, angle, [reach, size, hang], 0.024, skin);
    }
    for index in 0..4 {
        let angle = build.round(index, 4, 1.0, 0.7);
        let from = foot(build, angle, 0.03);
        let out = outward(angle) * build.between(0.04, 0.13);
        let to = from + out + Vec3::Y * build.between(0.72, 0.88);
        build.stem(from, to, 0.008, Skin::new(Outline::Stem, 0.9, STALK));
        // A leaf on the stalk
        let node = from.lerp(to, build.between(0.3, 0.5));
        let turned = angle + build.between(-1.5, 1.5);
        let leaf = Skin::new(Outline::Blade, 0.35, BLADE);
        build.arching(node, turned, [0.15, 0.2, 0.08], 0.014, leaf);
        panicle(build, to, out.normalize_or(Vec3::X));
    }
}

/// A loose head of seeds that leans over.
fn panicle(build: &mut Builder, at: Vec3, lean: Vec3) {
    let length = build.between(0.2, 0.25);
    let spine = |t: f32| at + Vec3::Y * (length * t) + lean * (0.2 * length * t * t);
    let tone = build.between(0.85, 1.15);
    for index in 0..9 {
        let t = index as f32 / 9.0;
        let angle = index as f32 * 2.4 + build.between(-0.3, 0.3);
        let from = spine(0.8 * t - 0.05);
        let out = outward(angle) * (0.05 * (1.0 - 0.75 * t));
        let tip = spine(t + 0.32) + out;
        let skin = Skin::new(Outline::Leaf, 0.6, SEED).toned(tone);
        let knee = from.lerp(tip, 0.5) + out * 0.5;
        build.flat([from, knee, tip], sideways(angle) + outward(angle) * 0.7, 0.022, skin);
    }
}

/// A dense tuft of thin, nearly upright blades.
pub(super) fn fine(build: &mut Builder) {
    let count = 56;
    for index in 0..count {
        let angle = build.round(index, count, 0.0, 1.0) * 11.0 % TAU;
        let from = foot(build, angle, 0.08);
        let size = build.between(0.5, 1.0);
        let reach = build.between(0.03, 0.36) * size;
        let tip = from + outward(angle) * reach + Vec3::Y * (size - 0.25 * reach);
        let knee = from + outward(angle) * (0.25 * reach) + Vec3::Y * (0.62 * size);
        let tone = build.between(0.75, 1.25);
        let skin = Skin::new(Outline::Blade, 0.5, FINE).toned(tone);
        build.rounded([from, knee, tip], 0.014, skin);
    }
}
