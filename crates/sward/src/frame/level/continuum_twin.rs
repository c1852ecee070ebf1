//! The CPU reference of continuum.wgsl, for fields of blades.

use super::twin::{rank_fade, widening};
use crate::gpu::layout::GpuView;
use crate::shared::noise_twin::hash01;

pub(crate) const CLUSTER_BLADES: u32 = 32;
const CLUSTER_GROWS: f32 = 0.25;
const ANCHOR_SHRINKS: f32 = 0.1;
const FADE_SHARE: f32 = 0.3;
/// Of end.wgsl.
const CANOPY_END_PX: [f32; 2] = [1.0, 0.35];

pub(crate) fn anchor_count(count: u32) -> u32 {
    count.div_ceil(CLUSTER_BLADES)
}

pub(crate) fn progress(view: &GpuView, height_px: f32) -> f32 {
    let [start, end] = view.cluster_height;
    ((start / height_px.max(1e-6)).log2() / (start / end).log2()).clamp(-1.0, 1.0)
}

/// Mean growth of all clusters.
pub(crate) fn grown(change: f32) -> f32 {
    let progress = change.max(0.0);
    let last = 1.0 - CLUSTER_GROWS;
    let whole = (progress - CLUSTER_GROWS).max(0.0);
    let yet = (progress - last).max(0.0);
    let growing = progress - whole;
    (whole + (growing * growing - yet * yet) / (2.0 * CLUSTER_GROWS)) / last
}

pub(crate) fn mean_kept(share: f32) -> f32 {
    1.0 / widening(share)
}

/// The inverse of [`mean_kept`].
pub(crate) fn share_that_keeps(mean: f32) -> f32 {
    let half = 1.0 - 0.5 * FADE_SHARE;
    if mean <= half {
        return mean / half;
    }
    let shy = 1.0 - FADE_SHARE;
    let b = shy + FADE_SHARE * (1.0 - mean);
    (b - (b * b - shy * shy).max(0.0).sqrt()) / (shy * shy)
}

/// A plant, and how large it is on the screen.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plant {
    pub id: u32,
    pub local: u32,
    pub count: u32,
    /// Pixels that a metre covers.
    pub scale: f32,
    /// Share of blades of its width that are kept.
    pub keep: f32,
}

/// Whether it is drawn as a cluster, and what is left of its width: 0 is not drawn.
pub(crate) fn choose(view: &GpuView, cluster: [f32; 4], plant: Plant) -> (bool, f32) {
    let [height, radius, ..] = cluster;
    let rank = (plant.local as f32 + 0.5) / plant.count as f32;
    let progress = progress(view, height * plant.scale);
    if progress <= -ANCHOR_SHRINKS {
        return (false, rank_fade(plant.keep, rank));
    }
    let single = |left: f32| rank_fade(share_that_keeps(left * mean_kept(plant.keep)), rank);
    let left = 1.0 - grown(progress);
    if plant.local >= anchor_count(plant.count) {
        return (false, single(left));
    }
    let begins = hash01(plant.id, 41) * (1.0 - CLUSTER_GROWS);
    if progress <= begins {
        let shrunk = ((begins - progress) / ANCHOR_SHRINKS).clamp(0.0, 1.0);
        return (false, single(left) * shrunk);
    }
    let own = ((progress - begins) / CLUSTER_GROWS).min(1.0);
    let [first, last] = CANOPY_END_PX;
    let gone = ((first - height * plant.scale * view.detail) / (first - last)).clamp(0.0, 1.0);
    let share = (2.0 * radius * plant.scale / view.least_cluster).max(1e-3);
    let rank = (plant.local as f32 + 0.5) / anchor_count(plant.count) as f32;
    (true, own * rank_fade(share_that_keeps(mean_kept(share) * (1.0 - gone)), rank))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_and_means_are_each_others_inverse() {
        for step in 1..=100 {
            let mean = step as f32 / 100.0;
            let back = mean_kept(share_that_keeps(mean));
            assert!((back - mean).abs() < 1e-4, "{mean}: {back}");
        }
        // Where none is thinned, the smallest share that keeps all
        assert!((share_that_keeps(1.0) - 1.0 / 0.7).abs() < 1e-4);
    }

    /// What blades lose the clusters win, all along the change: counts times sizes.
    #[test]
    fn the_change_keeps_the_covered_area() {
        let ids = 0..40_000_u32;
        for step in 0..=20 {
            let progress = step as f32 / 20.0;
            let one = |id: u32| {
                let begins = hash01(id, 41) * (1.0 - CLUSTER_GROWS);
                ((progress - begins) / CLUSTER_GROWS).clamp(0.0, 1.0)
            };
            let clusters = ids.clone().map(|id| f64::from(one(id))).sum::<f64>() / 40_000.0;
            let left = 1.0 - grown(progress);
            for keep in [0.2, 0.9, 1.3, 3.0] {
                let share = share_that_keeps(left * mean_kept(keep));
                let fade = |i: u32| f64::from(rank_fade(share, (i as f32 + 0.5) / 40_000.0));
                let blades = ids.clone().map(fade).sum::<f64>() / 40_000.0;
                let area = clusters + blades * f64::from(widening(keep));
                assert!((area - 1.0).abs() < 0.01, "progress {progress}, keep {keep}: {area}");
            }
        }
    }

    /// No plant jumps: a step in distance of a two-hundredth, 17 cm at 33 m, changes no width by more
    /// than two fifths.
    #[test]
    fn plants_change_little_by_little() {
        let view = GpuView {
            cluster_height: [14.0, 8.0],
            least_cluster: 6.0,
            detail: 1.0,
            ..bytemuck::Zeroable::zeroed()
        };
        let cluster = [0.5, 0.4, 0.6, 0.0];
        for local in [0, 3, 7, 8, 40, 200] {
            let mut last = (false, 1.0);
            for step in 0..1800 {
                let scale = 60.0 * 0.995_f32.powi(step);
                let plant = Plant { id: 77 + local, local, count: 256, scale, keep: scale * 0.02 };
                let now = choose(&view, cluster, plant);
                if now.0 == last.0 {
                    assert!((now.1 - last.1).abs() < 0.4, "{local} at {scale}: {last:?}, {now:?}");
                } else {
                    // A blade is gone, or nearly, when its cluster begins, and the cluster is small
                    assert!(last.1 < 0.35 && now.1 < 0.2, "{local} at {scale}: {last:?}, {now:?}");
                }
                last = now;
            }
            assert_eq!(last.1, 0.0, "in the end only ground is left");
        }
    }
}
