//! Daisy, cornflower and dandelion: heads of many small flowers.

use crate::plants::builder::{Builder, Head, Skin, outward, over_a_ball};
use crate::plants::model::Outline;
use glam::Vec3;
use std::f32::consts::TAU;

const STEM: [[f32; 3]; 3] = [[0.08, 0.13, 0.03], [0.12, 0.19, 0.05], [0.15, 0.22, 0.06]];
const LEAF: [[f32; 3]; 3] = [[0.05, 0.10, 0.02], [0.09, 0.19, 0.03], [0.14, 0.27, 0.05]];
const RAY: [[f32; 3]; 3] = [[0.62, 0.64, 0.52], [0.80, 0.80, 0.78], [0.84, 0.80, 0.80]];
const YOLK: [[f32; 3]; 3] = [[0.62, 0.34, 0.01], [0.80, 0.52, 0.02], [0.62, 0.34, 0.01]];

/// White rays round yellow discs, over a rosette of leaves.
pub(super) fn daisy(build: &mut Builder) {
    for index in 0..9 {
        let angle = build.round(index, 9, 0.0, 0.5);
        let reach = build.between(0.24, 0.36);
        let rise = build.between(0.08, 0.22);
        let tone = build.between(0.8, 1.2);
        let skin = Skin::new(Outline::Petal, 0.4, LEAF).toned(tone);
        build.arching(outward(angle) * 0.02, angle, [reach, rise, 0.35 * rise], 0.11, skin);
    }
    let first = build.between(0.0, TAU);
    for (index, high) in [0.86, 0.64, 0.45].into_iter().enumerate() {
        let angle = build.round(index, 3, first, 0.4);
        let reach = build.between(0.1, 0.17) + 0.05 * index as f32;
        let at = outward(angle) * reach + Vec3::Y * (high + build.between(-0.04, 0.02));
        build.stem(outward(angle) * 0.01, at, 0.018, Skin::new(Outline::Stem, 0.9, STEM));
        let lean = build.between(0.6, 1.3);
        rays(build, &Head::new(at, Vec3::Y + outward(angle) * lean));
    }
}

fn rays(build: &mut Builder, head: &Head) {
    let count = 15;
    for index in 0..count {
        let angle = build.round(index, count, 0.0, 0.3);
        let length = build.between(0.165, 0.185);
        let raised = build.between(0.0, 0.25);
        let from = head.at + head.direction(angle, 0.0) * 0.03;
        let tip = head.at + head.direction(angle, raised) * length;
        let knee = head.at + head.direction(angle, raised + 0.15) * (0.55 * length);
        let tone = build.between(0.9, 1.05);
        let skin = Skin::new(Outline::Petal, 0.2, RAY).toned(tone);
        build.flat([from, knee, tip], head.tangent(angle), 0.055, skin);
    }
    let heart = Head::new(head.at + head.axis * 0.012, head.axis);
    build.dome(&heart, 0.062, 0.035, Skin::new(Outline::Disc, 0.9, YOLK));
}

const FLORET: [[f32; 3]; 3] = [[0.10, 0.06, 0.42], [0.06, 0.10, 0.62], [0.09, 0.17, 0.76]];
const HEART: [[f32; 3]; 3] = [[0.12, 0.02, 0.26], [0.20, 0.03, 0.36], [0.30, 0.08, 0.46]];
const SCALES: [[f32; 3]; 3] = [[0.09, 0.12, 0.05], [0.13, 0.15, 0.06], [0.10, 0.07, 0.04]];
const SILVER: [[f32; 3]; 3] = [[0.08, 0.12, 0.06], [0.15, 0.21, 0.11], [0.19, 0.25, 0.14]];

/// Blue heads of trumpet-shaped florets on slender, branched stems.
pub(super) fn cornflower(build: &mut Builder) {
    let first = build.between(0.0, TAU);
    for index in 0..2 {
        let angle = build.round(index, 2, first, 0.6);
        let high = if index == 0 { 0.86 } else { build.between(0.62, 0.72) };
        let at = outward(angle) * build.between(0.06, 0.12) + Vec3::Y * high;
        build.stem(outward(angle) * 0.01, at, 0.010, Skin::new(Outline::Stem, 0.9, STEM));
        let axis = Vec3::Y + outward(angle) * build.between(0.5, 1.0);
        trumpets(build, &Head::new(at, axis));
    }
    for index in 0..11 {
        let angle = build.round(index, 11, first, 0.8) * 4.0;
        let high = build.between(0.0, 0.5);
        let reach = build.between(0.12, 0.24) * (1.0 - 0.6 * high);
        let rise = build.between(0.1, 0.26);
        let tone = build.between(0.8, 1.15);
        let skin = Skin::new(Outline::Leaf, 0.4, SILVER).toned(tone);
        build.arching(Vec3::Y * high, angle, [reach, rise, 0.3 * rise], 0.022, skin);
    }
}

/// Each trumpet is a fork, wide at its end, so that the head has teeth.
fn trumpets(build: &mut Builder, head: &Head) {
    let base = head.at - head.axis * 0.015;
    let (low, high) = (base - head.axis * 0.05, base + head.axis * 0.04);
    build.rounded([low, low.lerp(high, 0.5), high], 0.055, Skin::new(Outline::Disc, 0.9, SCALES));
    let count = 8;
    for index in 0..count {
        let angle = build.round(index, count, 0.0, 0.3);
        let raised = build.between(0.15, 0.45);
        let tone = build.between(0.85, 1.15);
        for turn in [-0.17, 0.17] {
            let skin = Skin::new(Outline::Fan, 0.2, FLORET).toned(tone);
            let knee = head.at + head.direction(angle, raised + 0.5) * 0.06;
            let tip = head.at + head.direction(angle + turn, raised) * 0.15;
            build.flat([head.at, knee, tip], head.tangent(angle + turn), 0.046, skin);
        }
    }
    for index in 0..6 {
        let angle = build.round(index, 6, 0.3, 0.4);
        let tip = head.at + head.direction(angle, 1.0) * 0.075;
        let skin = Skin::new(Outline::Fan, 0.3, HEART);
        build.flat([head.at, head.at.lerp(tip, 0.5), tip], head.tangent(angle), 0.022, skin);
    }
}

const DOWN: [[f32; 3]; 3] = [[0.80, 0.80, 0.77], [0.60, 0.59, 0.54], [0.80, 0.80, 0.77]];
const STALK: [[f32; 3]; 3] = [[0.17, 0.13, 0.07], [0.62, 0.60, 0.53], [0.80, 0.80, 0.77]];
const TOOTHED: [[f32; 3]; 3] = [[0.09, 0.12, 0.04], [0.08, 0.19, 0.03], [0.12, 0.26, 0.04]];
const SCAPE: [[f32; 3]; 3] = [[0.22, 0.16, 0.09], [0.22, 0.22, 0.09], [0.20, 0.24, 0.08]];

/// The white ball of seeds of a dandelion, over its toothed leaves.
pub(super) fn dandelion_clock(build: &mut Builder) {
    for index in 0..6 {
        let angle = build.round(index, 6, 0.0, 0.5);
        let reach = build.between(0.28, 0.39);
        let rise = build.between(0.16, 0.36);
        let tone = build.between(0.8, 1.2);
        let skin = Skin::new(Outline::Toothed, 0.4, TOOTHED).toned(tone);
        build.arching(outward(angle) * 0.02, angle, [reach, rise, 0.5 * rise], 0.12, skin);
    }
    let lean = outward(build.between(0.0, TAU)) * build.between(0.0, 0.09);
    let at = lean + Vec3::Y * 0.8;
    build.stem(Vec3::ZERO, at, 0.022, Skin::new(Outline::Stem, 0.9, SCAPE));
    let (low, high) = (at - Vec3::Y * 0.02, at + Vec3::Y * 0.03);
    build.rounded([low, at, high], 0.05, Skin::new(Outline::Disc, 0.9, STALK));
    ball(build, at + Vec3::Y * 0.01);
}

/// Umbrellas of hairs, evenly over a ball: each a stalk that opens, and hairs across.
fn ball(build: &mut Builder, at: Vec3) {
    let count = 28;
    let turned = build.between(0.0, TAU);
    for index in 0..count {
        let out = over_a_ball(index, count, turned);
        let seed = Head::new(at + out * 0.15, out);
        let roll = build.between(0.0, TAU);
        let (stalk, hairs) = (Skin::new(Outline::Umbrella, 0.3, STALK), seed.direction(roll, 0.0));
        let end = seed.at + out * 0.032;
        build.flat([at + out * 0.02, at + out * 0.08, end], hairs, 0.07, stalk);
        let hair = seed.tangent(roll) * 0.05;
        let curve = [end - hair, seed.at - out * 0.02, end + hair];
        build.flat(curve, hairs, 0.036, Skin::new(Outline::Brushes, 0.1, DOWN));
    }
}
