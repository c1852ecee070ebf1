//! Each blade test on blades for which the answer is known, both ways of each of the paper's slips.

use super::depth::{depth_of, depth_texture};
use super::rig::{Rig, shared};
use super::scenes::{facing_origin, field_of, look, no_culling};
use crate::gpu::view::LEAST_WIDTH_PX;
use crate::grow::Blade;
use crate::{Culling, Range, Shape, Species, Statistics, View};
use glam::Vec3;
use glam::camera::rh::proj::directx::perspective;
use std::f32::consts::FRAC_PI_2;
use std::sync::{Mutex, PoisonError};

fn flat_species() -> Species {
    Species {
        shape: Shape::Quad,
        height_m: Range::new(1.0, 2.0),
        width_m: Range::new(0.01, 0.2),
        ridge: 0.0,
        arch: 0.0,
        ..Species::default()
    }
}

/// An upright blade a metre high and 20 cm wide; facing 0 looks along +x, a right angle along +z.
fn blade(root: Vec3, facing: f32) -> Blade {
    Blade { root, up: Vec3::Y, facing, height: 1.0, width: 0.2, response: 5.0, species: 0 }
}

fn counts_of(species: Species, blades: &[Blade], view: View) -> Statistics {
    static RIG: Mutex<Option<Rig>> = Mutex::new(None);
    let field = field_of(vec![species], blades, 64);
    // A test that failed leaves nothing behind: the field is replaced
    let mut slot = RIG.lock().unwrap_or_else(PoisonError::into_inner);
    let rig = slot.get_or_insert_with(|| Rig::new(field.clone()));
    rig.replace(field);
    rig.cull(&[view]);
    rig.statistics()
}

fn counts(blades: &[Blade], view: View) -> Statistics {
    counts_of(flat_species(), blades, view)
}

const PAPER: Culling = Culling {
    frustum: false,
    distance: false,
    orientation: false,
    occlusion: false,
    paper: true,
    max_distance_m: f32::INFINITY,
};

#[test]
fn orientation_culls_a_blade_seen_along_its_width() {
    let ours = Culling { orientation: true, ..no_culling() };
    let paper = Culling { orientation: true, ..PAPER };
    let along_width = |facing: f32, culling, ridge| {
        let view = View { culling, ..facing_origin() };
        let species = Species { ridge, ..flat_species() };
        let counts = counts_of(species, &[blade(Vec3::ZERO, facing)], view);
        assert_eq!(counts.blades_drawn + counts.culled_orientation, 1);
        counts.culled_orientation == 1
    };
    for culling in [ours, paper] {
        assert!(along_width(0.0, culling, 0.0), "edge-on, {culling:?}");
        assert!(!along_width(FRAC_PI_2, culling, 0.0), "face-on, {culling:?}");
    }
    // The paper drops what still shows 0.42 of its width; ours what shows under a tenth of a pixel
    let turned = 25_f32.to_radians();
    assert!(along_width(turned, paper, 0.0));
    assert!(!along_width(turned, ours, 0.0));
    assert!(!along_width(30_f32.to_radians(), paper, 0.0));
    // A folded blade shows its ridge where its width does not
    assert!(!along_width(0.0, ours, 0.5));
    assert!(along_width(0.0, paper, 0.5));
    let off = View { culling: no_culling(), ..facing_origin() };
    assert_eq!(counts(&[blade(Vec3::ZERO, 0.0)], off).blades_drawn, 1);
}

/// Root, middle and tip of a blade can all be outside while the curve crosses the view.
#[test]
fn frustum_keeps_a_blade_that_crosses_the_view() {
    let tall = Blade { height: 2.0, ..blade(Vec3::ZERO, FRAC_PI_2) };
    let narrow = |x: f32, culling| {
        let mut view = look(Vec3::new(x, 0.875, 10.0), Vec3::new(x, 0.875, 0.0));
        view.clip_from_view = perspective(2_f32.to_radians(), 4.0 / 3.0, 0.1, 100.0);
        counts(&[tall], View { culling, ..view })
    };
    let ours = Culling { frustum: true, ..no_culling() };
    let paper = Culling { frustum: true, ..PAPER };
    assert_eq!(narrow(0.0, ours).blades_drawn, 1);
    assert_eq!(narrow(0.0, paper).culled_frustum, 1);
    assert_eq!(narrow(0.0, paper).blades_drawn, 0);
    assert_eq!(narrow(50.0, no_culling()).blades_drawn, 1);
    assert_eq!(narrow(50.0, ours).patches_visible, 0);
}

/// Blades of one patch, some in view: the blade test counts the others.
#[test]
fn frustum_culls_the_blades_that_are_outside() {
    let blades: Vec<_> = [-30.0, -1.0, 0.0, 1.0, 30.0, 40.0]
        .map(|x| blade(Vec3::new(x, 0.0, 0.0), FRAC_PI_2))
        .to_vec();
    for culling in [Culling { frustum: true, ..no_culling() }, Culling { frustum: true, ..PAPER }] {
        let counted = counts(&blades, View { culling, ..facing_origin() });
        assert_eq!((counted.blades_drawn, counted.culled_frustum), (3, 3));
    }
    // Behind the camera, between its side planes' extensions
    let behind = [blade(Vec3::new(0.0, 0.0, 8.0), 0.0), blade(Vec3::ZERO, 0.0)];
    let culling = Culling { frustum: true, ..no_culling() };
    let counted = counts(&behind, View { culling, ..facing_origin() });
    assert_eq!((counted.blades_drawn, counted.culled_frustum), (1, 1));
}

#[test]
fn distance_keeps_near_blades_and_thins_far_ones() {
    let thin = Blade { width: 0.01, ..blade(Vec3::ZERO, FRAC_PI_2) };
    let culling = Culling { distance: true, ..no_culling() };
    let at = |share: f32, detail: f32| {
        // So far off that the blade's width is this share of the least that is drawn
        let focal = facing_origin().clip_from_view.y_axis.y * 48.0;
        let eye = Vec3::new(0.0, 0.5, 0.01 * focal / (share * LEAST_WIDTH_PX));
        let view = View { culling, detail, ..look(eye, Vec3::new(0.0, 0.5, 0.0)) };
        counts(&[thin; 64], view)
    };
    assert_eq!(at(3.0, 1.0).blades_drawn, 64);
    // Ranks (i + 1/2) / 64 below the share stay
    assert_eq!(at(0.3, 1.0).blades_drawn, 19);
    assert_eq!(at(0.3, 1.0).culled_distance, 45);
    assert_eq!(at(0.1, 1.0).blades_drawn, 6);
    assert_eq!(at(0.1, 3.0).blades_drawn, 19, "detail thins later");
    assert_eq!(at(0.1, f32::INFINITY).blades_drawn, 64);
}

/// Equation 20 printed as a test for culling is the test for keeping, with ceil.
#[test]
fn the_papers_distance_test_keeps_the_near() {
    let paper = Culling { distance: true, max_distance_m: 100.0, ..PAPER };
    let at = |away: f32, height: f32| {
        let eye = Vec3::new(0.0, height, away);
        let view = View { culling: paper, ..look(eye, Vec3::ZERO) };
        counts(&[blade(Vec3::ZERO, FRAC_PI_2); 64], view).blades_drawn
    };
    // 4 runs of 16; of each ceil(16 (1 - d / 100)) stay
    assert_eq!(at(1.0, 0.0), 64);
    assert_eq!(at(20.1, 0.0), 4 * 13);
    assert_eq!(at(49.0, 0.0), 4 * 9);
    assert_eq!(at(99.0, 0.0), 4, "the farthest level keeps one");
    assert_eq!(at(110.0, 0.0), 0);
    assert_eq!(at(20.1, 60.0), 4 * 13, "height above the ground does not count");
}

#[test]
fn max_distance_ends_the_field() {
    let culling = Culling { distance: true, max_distance_m: 30.0, ..no_culling() };
    let at = |away: f32| {
        let view = look(Vec3::new(0.0, 0.5, away), Vec3::new(0.0, 0.5, 0.0));
        counts(&[blade(Vec3::ZERO, FRAC_PI_2)], View { culling, ..view })
    };
    assert_eq!(at(20.0).blades_drawn, 1);
    assert_eq!(at(30.2).culled_distance, 1);
    assert_eq!(at(60.0).patches_visible, 0);
}

/// A wall 5 m off over the left half of the picture.
#[test]
fn occlusion_culls_what_the_wall_hides() {
    let culling = Culling { occlusion: true, ..no_culling() };
    let wall = depth_of(&facing_origin(), 5.0);
    for samples in [1, 4] {
        let expression = format!("select(1.0, {wall:.9}, p.x < 64.0)");
        let depth = depth_texture(&shared(), samples, &expression);
        let view = View { culling, opaque_depth: Some(&depth), ..facing_origin() };
        let kept = |root: Vec3| {
            let counted = counts(&[blade(root, FRAC_PI_2)], view);
            assert_eq!(counted.blades_drawn + counted.culled_occlusion, 1);
            counted.blades_drawn == 1
        };
        assert!(!kept(Vec3::new(-1.0, 0.0, -2.0)), "behind the wall, {samples} samples");
        assert!(kept(Vec3::new(-1.0, 0.0, 2.0)), "in front of it");
        assert!(kept(Vec3::new(1.0, 0.0, -2.0)), "beside it");
        assert!(kept(Vec3::new(-1.0, 0.0, -0.01)), "within the bias");
        // The root is under the picture's lower edge: what is not seen hides nothing
        assert!(kept(Vec3::new(-1.0, -3.3, -1.0)), "partly off the screen");
        let off = View { culling: no_culling(), ..view };
        assert_eq!(counts(&[blade(Vec3::new(-1.0, 0.0, -2.0), 0.0)], off).blades_drawn, 1);
    }
}

/// A pixel whose samples differ hides only what is behind the farthest of them.
#[test]
fn one_open_sample_keeps_the_blade() {
    let culling = Culling { occlusion: true, ..no_culling() };
    let wall = depth_of(&facing_origin(), 5.0);
    let behind = blade(Vec3::new(-1.0, 0.0, -2.0), FRAC_PI_2);
    for (expression, drawn) in [("sample == 2u", 1), ("sample == 7u", 0)] {
        let expression = format!("select({wall:.9}, 1.0, {expression})");
        let depth = depth_texture(&shared(), 4, &expression);
        let view = View { culling, opaque_depth: Some(&depth), ..facing_origin() };
        assert_eq!(counts(&[behind], view).blades_drawn, drawn, "{expression}");
    }
}

#[test]
fn a_blade_that_fails_two_tests_counts_in_both() {
    let culling = Culling { occlusion: true, orientation: true, ..PAPER };
    let wall = depth_of(&facing_origin(), 5.0);
    let depth = depth_texture(&shared(), 1, &format!("{wall:.9}"));
    let view = View { culling, opaque_depth: Some(&depth), ..facing_origin() };
    let counted = counts(&[blade(Vec3::new(0.0, 0.0, -2.0), 0.0)], view);
    assert_eq!((counted.culled_occlusion, counted.culled_orientation), (1, 1));
    assert_eq!(counted.blades_drawn, 0);
}
