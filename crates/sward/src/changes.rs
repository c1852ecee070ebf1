//! Where along the distance plants change their form.

use crate::frame::level::{FULL_DETAIL_PX, LEVELS, MORPH_SHARE};
use crate::gpu::view::{CLUSTER_HEIGHT_PX, LEAST_WIDTH_PX, focal_px};
use crate::{Range, Species, Technique, View};

/// Heights on the screen between which clusters end: a test compares them with end.wgsl.
pub(crate) const CANOPY_END_PX: [f32; 2] = [1.0, 0.35];

/// A change of form, over a range of distances: plants of one species differ in size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// From what to what.
    pub name: &'static str,
    /// Where the smallest plants begin it, metres from the eye.
    pub nearest_m: f32,
    /// Where the largest have ended it, metres.
    pub farthest_m: f32,
}

impl View<'_> {
    /// The changes that plants of a species go through from near to far, in views of this size and
    /// detail; none in an orthographic view, at one forced level, or where the technique has its own.
    /// For measurements: nothing else needs it.
    pub fn changes(&self, species: &Species) -> Vec<Change> {
        if self.clip_from_view.w_axis.w.abs() > 0.5 || self.level.is_some() {
            return Vec::new();
        }
        let scale = focal_px(self) * self.detail;
        let change = |name, size_m: Range, [from_px, to_px]: [f32; 2]| Change {
            name,
            nearest_m: size_m.min * scale / from_px,
            farthest_m: size_m.max * scale / to_px,
        };
        let names = ["8 to 4 segments", "4 to 2 segments", "2 to 1 segments"];
        let levels = (1..LEVELS).zip(names).map(|(level, name)| {
            let end_px = FULL_DETAIL_PX * 0.25_f32.powi(level as i32);
            let start_px = end_px * 4.0_f32.powf(MORPH_SHARE);
            change(name, species.height_m, [start_px, end_px])
        });
        let thinned_px = match self.technique {
            Technique::Continuum => [2.0 * LEAST_WIDTH_PX / 1.4, LEAST_WIDTH_PX / 1.4],
            // A quarter of the blades are left at its end
            _ => [2.0 * LEAST_WIDTH_PX / 1.4, 0.25 * LEAST_WIDTH_PX],
        };
        let mut changes = Vec::new();
        match self.technique {
            Technique::Blades => {
                changes.extend(levels);
                changes.push(change("blades thinned", species.width_m, thinned_px));
            }
            Technique::Continuum => {
                changes.extend(levels);
                changes.push(change("blades thinned", species.width_m, thinned_px));
                changes.push(change("blades to clusters", species.height_m, CLUSTER_HEIGHT_PX));
                changes.push(change("clusters to ground", species.height_m, CANOPY_END_PX));
            }
            _ => {}
        }
        changes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Mat4;
    use glam::camera::rh::proj::directx::perspective;

    #[test]
    fn clusters_end_where_the_shader_says() {
        let [first, last] = CANOPY_END_PX.map(|px| format!("{px:?}"));
        let line = format!("const CANOPY_END_PX: vec2<f32> = vec2<f32>({first}, {last});");
        assert!(include_str!("frame/light/end.wgsl").contains(&line), "{line}");
    }

    #[test]
    fn changes_lie_where_the_sizes_are() {
        let clip = perspective(90_f32.to_radians(), 1.0, 0.1, 100.0);
        let mut view = View::new(Mat4::IDENTITY, clip, [480, 480]);
        view.technique = Technique::Blades;
        let species = Species { height_m: Range::new(1.0, 2.0), ..Species::default() };
        let changes = view.changes(&species);
        // A metre is 240 pixels at 1 m, and blades of 120 pixels have left the first level.
        assert!((changes[0].farthest_m - 4.0).abs() < 1e-3, "{changes:?}");
        assert!(changes.iter().all(|change| change.nearest_m < change.farthest_m));
        view.detail = 2.0;
        assert!((view.changes(&species)[0].farthest_m - 8.0).abs() < 1e-3);
        view.level = Some(1);
        assert_eq!(view.changes(&species), []);
    }
}
