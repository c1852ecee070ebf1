//! The reference of bands.wgsl.

use super::twin::{rank_fade, widening};
use crate::Bands;
use crate::gpu::layout::{BILLBOARD_BUCKETS, MODEL_BUCKET};
use crate::shared::noise_twin::hash01;

const BAND_MORPH: f32 = 0.5;
const BAND_SALT: u32 = 31;
/// Share from which on none shrinks: 1 over 1 less the share of those that shrink.
const ALL_WHOLE: f32 = 1.0 / 0.7;

/// How a plant is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Choice {
    /// Draw list; none where the plant is gone.
    pub(crate) bucket: Option<usize>,
    pub(crate) morph: f32,
    pub(crate) fade: f32,
    pub(crate) widened: f32,
}

/// How many times as far as the settings say this plant changes.
pub(crate) fn stretch(bands: &Bands, detail: f32, id: u32) -> f32 {
    detail * (1.0 + bands.jitter * (2.0 * hash01(id, BAND_SALT) - 1.0))
}

fn smooth(x: f32) -> f32 {
    let t = x.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// A plant at a distance. `keep` is the share that its width on the screen keeps, `rank` its place in
/// its patch; it is culled by distance.
pub(crate) fn choose(
    bands: &Bands,
    stretch: f32,
    (distance, keep, rank): (f32, f32, f32),
    modelled: bool,
) -> Choice {
    let [near, end, last] = [bands.near_m, bands.middle_m, bands.far_m.min(1e30)];
    let start = (end + (near - end) * BAND_MORPH) * stretch;
    let (near, end) = (near * stretch, end * stretch);
    let mut share = ALL_WHOLE;
    if distance > end {
        share += (bands.far_share - share) * smooth(distance / end - 1.0);
    }
    let share = share.min(keep);
    let mut morph =
        if distance <= start { 0.0 } else { smooth((distance - start) / (end - start)) };
    let mut bucket = BILLBOARD_BUCKETS[usize::from(morph >= 1.0)];
    if distance < near && modelled {
        (bucket, morph) = (MODEL_BUCKET, smooth(distance / near * 2.0 - 1.0));
    }
    let gone = ((1.0 - distance / (last * stretch)) * 10.0).clamp(0.0, 1.0);
    let fade = rank_fade(share, rank) * gone;
    Choice { bucket: (fade > 0.0).then_some(bucket), morph, fade, widened: widening(share) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(bands: &Bands, id: u32, distance: f32, rank: f32) -> Choice {
        choose(bands, stretch(bands, 1.0, id), (distance, 1e6, rank), true)
    }

    /// What is drawn changes by degrees: quads are the far ones before the list changes, plants that go
    /// have shrunk to nothing.
    #[test]
    fn nothing_switches_between_quads() {
        let bands = Bands { far_m: 90.0, ..Bands::default() };
        for id in 0..50 {
            let rank = hash01(id, 3);
            let mut last = at(&bands, id, bands.near_m * 1.3, rank);
            for step in 0..9000 {
                let distance = bands.near_m * 1.3 + step as f32 * 0.0125;
                let now = at(&bands, id, distance, rank);
                assert!((now.morph - last.morph).abs() < 0.02, "{id} at {distance}");
                assert!((now.fade - last.fade).abs() < 0.02, "{id} at {distance}");
                assert!((now.widened / last.widened - 1.0).abs() < 0.02);
                if now.bucket != last.bucket && now.bucket.is_some() {
                    assert!(last.morph > 0.99 && now.morph == 1.0, "{id} at {distance}: {now:?}");
                }
                last = now;
            }
        }
    }

    /// No two plants of a thousand change at one place, and the farther the band, the wider they spread.
    #[test]
    fn plants_change_each_at_its_own_distance() {
        let bands = Bands::default();
        let spread = |edge: f32| {
            let ends = (0..1000).map(|id| edge * stretch(&bands, 1.0, id));
            let (low, high) = ends.fold((f32::MAX, 0.0_f32), |(a, b), x| (a.min(x), b.max(x)));
            (low / edge, high / edge, high - low)
        };
        let (near, far) = (spread(bands.near_m), spread(bands.middle_m));
        assert!(near.0 < 0.76 && near.1 > 1.24 && near.0 >= 0.75 && near.1 <= 1.25, "{near:?}");
        assert!(far.2 > 4.9 * near.2, "{far:?}");
    }

    #[test]
    fn far_plants_are_fewer_and_cover_as_much() {
        let bands = Bands::default();
        let count = 5000;
        let (mut kept, mut area) = (0, 0.0);
        for id in 0..count {
            let rank = (id as f32 + 0.5) / count as f32;
            let choice = at(&bands, id, 200.0, rank);
            assert!(choice.bucket.is_none_or(|bucket| bucket == BILLBOARD_BUCKETS[1]));
            kept += u32::from(choice.bucket.is_some());
            area += f64::from(choice.fade * choice.widened);
        }
        let (kept, area) = (f64::from(kept) / f64::from(count), area / f64::from(count));
        assert!((kept - f64::from(bands.far_share)).abs() < 0.01, "{kept}");
        assert!((area - 1.0).abs() < 0.01, "{area}");
    }
}
