//! What shows of clusters as they are drawn: pictures on cards that hide each other.
//!
//! Cards of a field all lie alike, so of two that meet the nearer one hides the other as a whole, and
//! of a card its upper parts show more than its lower ones. That is not what shows of the grass itself,
//! whose depths mix blade by blade; so what clusters are lit by is fitted to this.

use super::Triangle;
use super::canopy::met;
use super::cluster::{CLUSTER_BLADES, Clusters};
use super::cover::{ROWS, axes, sine};
use super::mips::Chain;
use super::raster::Window;
use crate::gpu::layout::GpuCanopy;
use glam::{Vec2, Vec3};
use std::f32::consts::{FRAC_PI_2, TAU};

/// Elevations that pictures are taken from: 0, 30, 60 and 90 degrees.
pub(crate) const ELEVATIONS: usize = 4;
/// Sides that they are seen from.
pub(crate) const AZIMUTHS: usize = 4;
/// Elevations from which what a cluster covers is measured: between the pictures', too.
pub(crate) const STEPS: usize = 2 * ELEVATIONS - 1;
/// Texels of an edge.
pub(crate) const TEXELS: u32 = 64;

/// Where a ray meets so many blades, hardly any ground shows, and more would change nothing.
const HIDING: f32 = 5.0;
/// From above, a cluster's blades are spread over so much less of a card than from the side.
const TOGETHER: f32 = 0.85;
/// Share of their mean distance within which clusters, evenly spread, have none before them.
const APART: f32 = 0.55;
/// Clusters are drawn at most so many times as wide as they are.
const MOST_WIDER: f32 = 1.5;

/// Size of the cylinder that holds a cluster, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Size {
    /// Half width.
    pub radius: f32,
    /// Height.
    pub height: f32,
}

impl Size {
    /// How high a card stands in the picture, seen from an angle over the ground.
    fn tall(self, angle: f32) -> f32 {
        self.height * angle.cos() + 2.0 * self.radius * angle.sin()
    }
}

/// What a card shows: from the near foot of the cylinder to its far top; from a step of elevation and a
/// side.
pub(crate) fn card(size: Size, step: usize, side: usize) -> Window {
    let angle = step as f32 * FRAC_PI_2 / (STEPS - 1) as f32;
    let [_, right, up] = axes(side as f32 * TAU / AZIMUTHS as f32, angle.sin());
    Window {
        center: up * (0.5 * size.height * angle.cos()),
        right,
        up,
        half: Vec2::new(size.radius, 0.5 * size.tall(angle)),
        size: [TEXELS; 2],
        samples: 1,
    }
}

/// Share of the card that is covered, in the mean over all places and sides.
pub(crate) fn cover(variants: &[Vec<Triangle>], size: Size, step: usize) -> f32 {
    let sides = |own| (0..AZIMUTHS).map(move |side| card(size, step, side).see(own).coverage());
    let all = variants.iter().flat_map(|own| sides(&own[..]));
    all.sum::<f32>() / (variants.len().max(1) * AZIMUTHS) as f32
}

/// A row of texels in the mean over all pictures of an elevation: how much of it is covered, and the
/// colour of that.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Line {
    /// Share that is covered.
    pub alpha: f32,
    /// Colour times that share.
    pub tone: Vec3,
}

/// Of each elevation, from the top down.
pub(crate) type Lines = [[Line; TEXELS as usize]; ELEVATIONS];

/// The lines of all pictures, of which so many follow each other that are of one elevation.
pub(crate) fn lines(chains: &[Chain]) -> Lines {
    let mut lines = [[Line::default(); TEXELS as usize]; ELEVATIONS];
    let texels_a_line = (chains.len() / ELEVATIONS).max(1) as f32 * TEXELS as f32;
    for (index, chain) in chains.iter().enumerate() {
        let own = &mut lines[index / AZIMUTHS % ELEVATIONS];
        let texels = chain.first().map_or(&[][..], |tile| &tile.texels);
        for (line, row) in own.iter_mut().zip(texels.chunks(TEXELS as usize)) {
            for texel in row {
                line.alpha += texel.alpha / texels_a_line;
                line.tone += texel.albedo * (texel.alpha / texels_a_line);
            }
        }
    }
    lines
}

/// How cards of a field stand.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cards<'a> {
    /// Of each.
    pub size: Size,
    /// As of [`Clusters::cover`].
    pub cover: &'a [f32; STEPS],
    /// Clusters a square metre.
    pub dense: f32,
    /// Of their field.
    pub canopy: &'a GpuCanopy,
}

impl Cards<'_> {
    /// The pictures of an elevation and how often the higher ones are drawn: the twin of `picture_of`
    /// in cluster.wgsl.
    pub(crate) fn drawn_from(&self, angle: f32) -> (usize, f32) {
        let elevation = angle * (ELEVATIONS - 1) as f32 / FRAC_PI_2;
        let below = elevation.floor().min((ELEVATIONS - 2) as f32);
        let part = elevation - below;
        let tall = |at: f32| self.size.tall(at * FRAC_PI_2 / (ELEVATIONS - 1) as f32);
        let high = part * tall(below + 1.0);
        (below as usize, high / ((1.0 - part) * tall(below) + high))
    }

    /// Clusters that a ray meets on its way to the ground, each as wide as it is, where such a share of them
    /// has grown, counted as if all had; as if they stood at random places.
    fn alone(&self, angle: f32, grown: f32) -> f32 {
        let step = angle * (STEPS - 1) as f32 / FRAC_PI_2;
        let low = step.floor().min((STEPS - 2) as f32);
        let tall = |at: f32| self.size.tall(at * FRAC_PI_2 / (STEPS - 1) as f32);
        let [a, b] = [low, low + 1.0].map(|at| self.cover[at as usize] * tall(at));
        let area = 2.0 * self.size.radius * (a + (b - a) * (step - low));
        let sine = angle.sin().max(1e-3);
        let share = area / (2.0 * self.size.radius * self.size.tall(angle));
        let alpha = (share / (1.0 - TOGETHER * sine)).clamp(1e-3, 0.95) * grown.clamp(0.01, 1.0);
        (self.dense * area / sine * -(1.0 - alpha).ln() / alpha).max(1e-6)
    }

    /// How many times as wide they are drawn where a ray meets so many blades, and such a share of them has
    /// grown: the twin of `wider`, without wind.
    pub(crate) fn wider(&self, angle: f32, blades: f32, grown: f32) -> f32 {
        (blades.min(HIDING) / self.alone(angle, grown)).clamp(1.0, MOST_WIDER)
    }

    /// Clusters that a ray meets as they are drawn.
    fn met(&self, angle: f32) -> f32 {
        let blades = self::met(self.canopy, angle.sin());
        self.alone(angle, 1.0) * self.wider(angle, blades, 1.0)
    }
}

/// Mean colour of the texels that show where a ray meets so many clusters, the next of which stand so
/// many lines lower.
fn shown(lines: &Lines, (below, above): (usize, f32), met: f32, lower: f32) -> Vec3 {
    let line = |i: usize| {
        let (low, high) = (lines[below][i], lines[below + 1][i]);
        Line {
            alpha: low.alpha + (high.alpha - low.alpha) * above,
            tone: low.tone.lerp(high.tone, above),
        }
    };
    let total = (0..TEXELS as usize).map(|i| line(i).alpha).sum::<f32>().max(1e-9);
    let mut seen = Line::default();
    for i in 0..TEXELS as usize {
        // Nearer cards stand lower: their parts from here up lie before it
        let end = i as f32 + 0.5 - lower;
        let over: f32 = (0..i + 1).map(|k| line(k).alpha * (end - k as f32).clamp(0.0, 1.0)).sum();
        let passes = (-met * over / total).exp();
        seen.alpha += line(i).alpha * passes;
        seen.tone += line(i).tone * passes;
    }
    seen.tone / seen.alpha.max(1e-12)
}

/// Puts what is known of clusters into a canopy.
pub(crate) fn set_cards(canopy: &mut GpuCanopy, clusters: &Clusters, each_m2: f32) {
    let dense = 1.0 / (CLUSTER_BLADES as f32 * each_m2.max(1e-9));
    let cards = Cards { size: clusters.size, cover: &clusters.cover, dense, canopy };
    let tone = |angle: f32| {
        let lower = APART * dense.powf(-0.5) * angle.sin() / cards.size.tall(angle);
        let lower = lower * TEXELS as f32;
        shown(&clusters.lines, cards.drawn_from(angle), cards.met(angle), lower)
    };
    let mut looks = [[0.0; 4]; STEPS + 1];
    for (step, (look, cover)) in looks.iter_mut().zip(clusters.cover).enumerate() {
        let angle = step as f32 * FRAC_PI_2 / (STEPS - 1) as f32;
        *look = tone(angle).extend(cover).to_array();
    }
    looks[STEPS][0] = dense;
    let tones: [Vec3; ROWS] = std::array::from_fn(|row| tone(sine(row).asin()));
    canopy.cards = looks;
    for (row, tone) in canopy.rows.iter_mut().zip(tones) {
        row.shown = tone.extend(row.shown[3]).to_array();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is drawn and what is reckoned with have the same constants.
    #[test]
    fn the_shaders_have_these_constants() {
        let cards = include_str!("../frame/draw/cards.wgsl");
        let level = include_str!("../frame/level/continuum.wgsl");
        for (text, name, value) in [
            (cards, "HIDING", HIDING),
            (cards, "TOGETHER", TOGETHER),
            (level, "MOST_WIDER", MOST_WIDER),
        ] {
            let line = format!("const {name}: f32 = {value:?};");
            assert!(text.contains(&line), "{line}");
        }
    }

    /// A picture dark below and light above: the more cards a ray meets, the lighter what shows.
    #[test]
    fn the_upper_parts_show_where_cards_stand_close() {
        let line = |i: usize| Line { alpha: 0.4, tone: Vec3::splat(0.4 * (1.0 - i as f32 / 64.0)) };
        let lines: Lines = [std::array::from_fn(line); ELEVATIONS];
        let tone = |met: f32, lower: f32| shown(&lines, (1, 0.3), met, lower).x;
        let alone = tone(0.0, 0.0);
        assert!((alone - 0.5).abs() < 0.01, "{alone}");
        let close = [0.5, 2.0, 8.0].map(|met| tone(met, 0.0));
        assert!(close.is_sorted() && close[0] > alone && close[2] > 0.85, "{close:?}");
        assert!(tone(8.0, 10.0) < close[2], "the next one stands lower");
    }
}
