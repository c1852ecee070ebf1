//! Puts models together: stems, leaves, heads of flowers.

use super::model::{MAX_RIBBONS, Model, Outline, Ribbon};
use crate::grow::random::{Draws, Purpose, Stream};
use glam::Vec3;
use std::f32::consts::TAU;

/// A place with an axis, such as that of a flower.
#[derive(Debug, Clone, Copy)]
pub(super) struct Head {
    pub(super) at: Vec3,
    pub(super) axis: Vec3,
    across: Vec3,
    other: Vec3,
}

impl Head {
    pub(super) fn new(at: Vec3, axis: Vec3) -> Self {
        let axis = axis.normalize_or(Vec3::Y);
        let across = axis.any_orthonormal_vector();
        Self { at, axis, across, other: axis.cross(across) }
    }

    /// The direction at an angle round the axis, raised towards it.
    pub(super) fn direction(&self, angle: f32, raised: f32) -> Vec3 {
        let out = self.across * angle.cos() + self.other * angle.sin();
        out * raised.cos() + self.axis * raised.sin()
    }

    /// Perpendicular to the axis and to the direction at that angle.
    pub(super) fn tangent(&self, angle: f32) -> Vec3 {
        self.other * angle.cos() - self.across * angle.sin()
    }
}

/// Away from the plant's middle, level, at an angle round it.
pub(super) fn outward(angle: f32) -> Vec3 {
    Vec3::new(angle.cos(), 0.0, angle.sin())
}

/// Level, across that direction.
pub(super) fn sideways(angle: f32) -> Vec3 {
    Vec3::new(-angle.sin(), 0.0, angle.cos())
}

/// The direction of one of `count` points spread evenly over a ball, from its top downwards.
pub(super) fn over_a_ball(index: usize, count: usize, turned: f32) -> Vec3 {
    let y = 1.0 - (2.0 * index as f32 + 1.0) / count as f32;
    // The golden angle
    let angle = turned + index as f32 * 2.399_963;
    outward(angle) * (1.0 - y * y).sqrt() + Vec3::Y * y
}

/// How a ribbon looks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Skin {
    pub(super) outline: Outline,
    pub(super) colors: [Vec3; 3],
    pub(super) thickness: f32,
}

impl Skin {
    pub(super) fn new(outline: Outline, thickness: f32, colors: [[f32; 3]; 3]) -> Self {
        Self { outline, colors: colors.map(Vec3::from), thickness }
    }

    /// The same, lighter or darker.
    pub(super) fn toned(self, tone: f32) -> Self {
        Self { colors: self.colors.map(|color| (color * tone).min(Vec3::splat(0.95))), ..self }
    }
}

/// A model in the making.
#[derive(Debug)]
pub(super) struct Builder {
    ribbons: Vec<Ribbon>,
    draws: Draws,
}

impl Builder {
    /// Starts the variant of a seed; `kind` keeps the kinds apart.
    pub(super) fn new(seed: u64, kind: u64) -> Self {
        Self { ribbons: Vec::new(), draws: Stream::new(seed, Purpose::Plant).at(kind) }
    }

    /// A value between two.
    pub(super) fn between(&mut self, least: f32, most: f32) -> f32 {
        least + (most - least) * self.draws.unit()
    }

    /// The angle of one of `count` things that stand round something, not quite evenly.
    pub(super) fn round(&mut self, index: usize, count: usize, first: f32, jitter: f32) -> f32 {
        let step = TAU / count as f32;
        first + step * (index as f32 + jitter * self.between(-0.5, 0.5))
    }

    /// A flat ribbon.
    pub(super) fn flat(&mut self, curve: [Vec3; 3], side: Vec3, width: f32, skin: Skin) {
        self.add(curve, side, width, skin, false);
    }

    /// A ribbon that stands for something round, as thick as a blade whatever its skin says.
    pub(super) fn rounded(&mut self, curve: [Vec3; 3], width: f32, skin: Skin) {
        self.add(curve, Vec3::X, width, Skin { thickness: 1.0, ..skin }, true);
    }

    fn add(&mut self, curve: [Vec3; 3], side: Vec3, width: f32, skin: Skin, round: bool) {
        let Skin { outline, colors, thickness } = skin;
        self.ribbons.push(Ribbon { curve, side, width, outline, colors, round, thickness });
    }

    /// A stem that rises from one place to another, upright first.
    pub(super) fn stem(&mut self, from: Vec3, to: Vec3, width: f32, skin: Skin) {
        let knee = from.lerp(to, 0.5);
        let lift = 0.25 * (to - from).dot(Vec3::Y);
        self.rounded(
            [
                from,
                Vec3::new(from.x * 0.7 + knee.x * 0.3, knee.y + lift, from.z * 0.7 + knee.z * 0.3),
                to,
            ],
            width,
            skin,
        );
    }

    /// A leaf or blade: out at an angle and up, then over; `reach` out, `rise` up, `hang` down again.
    pub(super) fn arching(
        &mut self,
        from: Vec3,
        angle: f32,
        [reach, rise, hang]: [f32; 3],
        width: f32,
        skin: Skin,
    ) {
        let out = outward(angle);
        let knee = from + out * (0.35 * reach) + Vec3::Y * rise;
        let tip = from + out * reach + Vec3::Y * (rise - hang);
        self.flat([from, knee, tip], sideways(angle), width, skin);
    }

    /// A dome over a head: two ribbons that cross.
    pub(super) fn dome(&mut self, head: &Head, radius: f32, high: f32, skin: Skin) {
        for angle in [0.4, 0.4 + 0.25 * TAU] {
            let out = head.direction(angle, 0.0) * radius;
            let top = head.at + head.axis * (2.0 * high);
            self.flat([head.at - out, top, head.at + out], head.tangent(angle), 2.0 * radius, skin);
        }
    }

    /// Scales it so that it just fits: its top at 1, all of it within half of `width` of the middle
    /// line, nothing under the ground.
    pub(super) fn finish(mut self, width: f32) -> Model {
        self.ribbons.truncate(MAX_RIBBONS);
        let (mut top, mut radius) = (1e-3_f32, 1e-3_f32);
        for ribbon in &self.ribbons {
            for step in 0..=16 {
                let v = step as f32 / 16.0;
                let (center, half) = (ribbon.point(v), 0.5 * ribbon.width_at(v));
                // Round ones may turn to any side
                let edges = [ribbon.across(v, Vec3::X), Vec3::X, Vec3::Z];
                let edges = if ribbon.round { &edges[1..] } else { &edges[..1] };
                for edge in edges {
                    for at in [center - *edge * half, center + *edge * half] {
                        top = top.max(at.y);
                        radius = radius.max(at.x.hypot(at.z));
                    }
                }
            }
        }
        let (up, out) = (0.998 / top, 0.499 * width / radius);
        let fit = |at: Vec3| Vec3::new(at.x * out, (at.y * up).max(0.0), at.z * out);
        for ribbon in &mut self.ribbons {
            ribbon.curve = ribbon.curve.map(fit);
            ribbon.width *= out.min(up);
        }
        Model { ribbons: self.ribbons }
    }
}
