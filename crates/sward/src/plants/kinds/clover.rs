//! Red clover.

use crate::plants::builder::{Builder, Head, Skin, outward, over_a_ball};
use crate::plants::model::Outline;
use glam::Vec3;
use std::f32::consts::TAU;

const STEM: [[f32; 3]; 3] = [[0.07, 0.12, 0.03], [0.11, 0.19, 0.05], [0.14, 0.22, 0.06]];
/// With a pale bow across.
const LEAFLET: [[f32; 3]; 3] = [[0.05, 0.14, 0.025], [0.22, 0.33, 0.12], [0.06, 0.17, 0.03]];
const FLORET: [[f32; 3]; 3] = [[0.55, 0.32, 0.42], [0.62, 0.19, 0.42], [0.55, 0.12, 0.36]];

/// Leaves of three, and round heads above them.
pub(super) fn clover(build: &mut Builder) {
    for index in 0..7 {
        let angle = build.round(index, 7, 0.2, 0.6);
        let high = build.between(0.32, 0.68);
        let reach = build.between(0.14, 0.38);
        leaf_of_three(build, outward(angle) * reach + Vec3::Y * high, angle);
    }
    for index in 0..2 {
        let angle = build.round(index, 2, 1.1, 0.6);
        let reach = build.between(0.06, 0.2);
        let at = outward(angle) * reach + Vec3::Y * (0.86 - 0.17 * index as f32);
        build.stem(outward(angle) * 0.02, at, 0.022, Skin::new(Outline::Stem, 0.9, STEM));
        head(build, at);
    }
}

fn leaf_of_three(build: &mut Builder, at: Vec3, angle: f32) {
    build.stem(outward(angle) * 0.03, at, 0.014, Skin::new(Outline::Stem, 0.9, STEM));
    // It looks out and up
    let tilt = outward(angle) * build.between(0.25, 0.9) + Vec3::Y;
    let head = Head::new(at, tilt);
    let first = build.between(0.0, TAU);
    let tone = build.between(0.8, 1.15);
    for index in 0..3 {
        let turned = build.round(index, 3, first, 0.1);
        let length = 0.17;
        let knee = at + head.direction(turned, 0.35) * (0.5 * length);
        let tip = at + head.direction(turned, 0.05) * length;
        let skin = Skin::new(Outline::Petal, 0.35, LEAFLET).toned(tone);
        build.flat([at, knee, tip], head.tangent(turned), 0.135, skin);
    }
}

/// Florets all over a ball, the lower ones hanging out, the upper ones standing.
fn head(build: &mut Builder, at: Vec3) {
    let core = Skin::new(Outline::Disc, 0.9, [FLORET[2], FLORET[2], FLORET[1]]);
    let (low, high) = (at - Vec3::Y * 0.08, at + Vec3::Y * 0.085);
    build.rounded([low, at, high], 0.16, core);
    let count = 15;
    let turned = build.between(0.0, TAU);
    for index in 0..count {
        let head = Head::new(at, over_a_ball(index, count, turned));
        let from = at + head.axis * 0.04;
        let tip = at + head.axis * build.between(0.085, 0.1) + Vec3::Y * 0.02;
        let tone = build.between(0.8, 1.2);
        let skin = Skin::new(Outline::Petal, 0.3, FLORET).toned(tone);
        let roll = build.between(0.0, TAU);
        build.flat([from, from.lerp(tip, 0.5), tip], head.direction(roll, 0.0), 0.062, skin);
    }
}
