//! Debug views: what they list, what they count as the reason, what they show; and that other views
//! are as they were.

use super::drawing::{Picture, blade, covered, draw};
use super::rig::Rig;
use super::scenes::{
    Draws, SIZE, breeze, field_of, look, no_culling, random_blade, random_field, random_view,
    see_all,
};
use crate::frame::draw::topology::Topology;
use crate::gpu::layout::{BILLBOARD_BUCKETS, STRIP_BUCKETS};
use crate::grow::Blade;
use crate::{
    Bands, Billboard, Collider, Culling, DebugView, Error, Form, Frame, Observer, Plant, Range,
    Species, Sphere, Strip, Technique, View,
};
use glam::{Mat4, Vec3};

fn rig() -> Rig {
    Rig::new(random_field(1, 1500, 5.0, 64))
}

fn reasons(rig: &Rig) -> Vec<u32> {
    let buffer = rig.renderer.explained(0).expect("a debug view was culled");
    let mut all: Vec<u32> = rig.read(buffer);
    all.truncate(rig.field.blades().len());
    all
}

/// Blades that a test fails, counted as the statistics do: in patches that the view sees.
#[test]
fn reasons_are_those_that_the_statistics_count() {
    let mut rig = rig();
    for seed in 0..6 {
        let view = View { debug: Some(DebugView::Culling), ..random_view(seed, 5.0) };
        rig.step(&Frame::new(0.02, &breeze()), &[view]);
        let counted = rig.statistics();
        let reasons = reasons(&rig);
        let drawn = reasons.iter().filter(|r| *r & 15 == 0).count() as u64;
        assert_eq!(drawn, counted.blades_drawn, "view {seed}");
        let failed = |bit: u32| reasons.iter().filter(|r| *r & bit != 0).count() as u64;
        let hidden = counted.blades - counted.blades_visible;
        // Whole patches fail as one, and blades of a thinned band are not tested further
        assert!(failed(2) >= counted.culled_frustum && failed(4) >= counted.culled_distance);
        assert!(failed(2) + failed(4) >= hidden, "view {seed}");
        let moved = reasons.iter().filter(|r| *r & 16 != 0).count() as u64;
        assert_eq!(moved, counted.blades_moved, "view {seed}");
        // Every blade is listed, in the bucket of its level
        let (list, _) = rig.list(0);
        assert_eq!(list.len(), 1500);
    }
}

#[test]
fn blades_by_level_and_blades_that_moved_are_counted() {
    let mut rig = rig();
    rig.step(&Frame::new(0.02, &breeze()), &[see_all()]);
    let counted = rig.statistics();
    assert_eq!(counted.drawn_by_level.iter().sum::<u64>(), counted.blades_drawn);
    assert_eq!(counted.blades_moved, 1500);
    // A moving ball wakes the patches near it, seen or not
    let at = |x: f32| Sphere { center: Vec3::new(x, 0.2, 0.0), radius: 0.3 };
    let last_pose = Some(crate::Pose::at(Vec3::new(-0.05, 0.2, 0.0)));
    let ball = [Collider { last_pose, ..Collider::ball(at(0.0)) }];
    let away = View { culling: Culling::default(), ..super::scenes::see_none() };
    let wind = breeze();
    let frame = Frame { colliders: &ball, ..Frame::new(0.02, &wind) };
    rig.step(&frame, &[View { debug: Some(DebugView::Awake), ..away }]);
    let touched = reasons(&rig).iter().filter(|r| *r & 48 == 48).count() as u64;
    assert!(touched > 0 && touched < 1500, "{touched}");
    assert_eq!(touched, rig.statistics().blades_moved);
}

fn picture(rig: &mut Rig, view: View) -> Picture {
    rig.step(&Frame::new(0.0, &breeze()), &[view]);
    draw(rig, 0)
}

#[test]
fn a_debug_view_leaves_no_trace() {
    let mut rig = rig();
    let plain = look(Vec3::new(0.0, 1.5, 6.0), Vec3::ZERO);
    let before = picture(&mut rig, plain);
    for debug in DebugView::ALL {
        let shown = picture(&mut rig, View { debug: Some(debug), ..plain });
        assert!(shown != before, "{debug:?} shows something else");
    }
    assert!(picture(&mut rig, plain) == before, "and then all is as it was");
}

/// At one level all blades have that level's colour, which is the palette's at the tips.
#[test]
fn levels_show_in_their_colours() {
    let mut rig = rig();
    for (level, (name, color)) in DebugView::Level.colors().iter().take(4).enumerate() {
        let eye = look(Vec3::new(0.0, 1.5, 6.0), Vec3::ZERO);
        let view = View { debug: Some(DebugView::Level), level: Some(level as u8), ..eye };
        let picture = picture(&mut rig, view);
        let brightest = picture.iter().filter(|p| p[3] > 0).max_by_key(|p| p.iter().take(3).max());
        let brightest = brightest.expect("blades");
        let strongest = (0..3).max_by(|a, b| color[*a].total_cmp(&color[*b])).unwrap_or(0);
        let expected = color[strongest] * 255.0;
        let got = f32::from(brightest[strongest]);
        assert!((got / expected - 1.0).abs() < 0.15, "{name}: {brightest:?}, not {color:?}");
    }
}

/// A broad blade before the camera: lines alone cover less than the triangles between them, and no
/// pixel beside them.
#[test]
fn a_wireframe_lies_on_the_blades() {
    let mut rig = super::lobes::leaf(crate::Shape::Quad);
    let near = super::lobes::front(0);
    let solid = picture(&mut rig, near);
    let lines = picture(&mut rig, View { debug: Some(DebugView::Wireframe), ..near });
    let outside = solid.iter().zip(&lines).filter(|(s, l)| s[3] == 0 && l[3] > 0).count();
    let (lines, solid) = (covered(&lines), covered(&solid));
    assert!(outside == 0 && lines * 10 < solid * 9 && lines > solid / 10, "{lines} of {solid}");
    let corners = crate::frame::debug::corners();
    for bucket in 0..8 {
        let own = Topology::of(bucket).indices();
        let stored = &corners[bucket * 96..bucket * 96 + own.len()];
        assert!(stored.iter().zip(own).all(|(a, b)| *a == u32::from(b)), "bucket {bucket}");
    }
}

#[test]
fn an_observer_sees_what_another_view_culled() {
    let mut rig = rig();
    let view = look(Vec3::new(0.0, 1.5, 6.0), Vec3::ZERO);
    let plain = picture(&mut rig, view);
    let same =
        Observer { view_from_world: view.view_from_world, clip_from_view: view.clip_from_view };
    assert!(picture(&mut rig, View { observer: Some(same), ..view }) == plain);
    let high = look(Vec3::new(0.0, 9.0, 0.01), Vec3::ZERO);
    let observer = Some(Observer {
        view_from_world: high.view_from_world,
        clip_from_view: high.clip_from_view,
    });
    let culled = rig.list(0);
    let above = picture(&mut rig, View { observer, ..view });
    assert_eq!(rig.list(0), culled, "the view's own lists");
    assert!(above != plain && covered(&above) > 0);
    let broken = Observer { view_from_world: Mat4::NAN, clip_from_view: high.clip_from_view };
    let error = rig.submit(|renderer, (device, _), encoder| {
        let view = View { observer: Some(broken), ..view };
        renderer.cull(device, encoder, &[view]).expect_err("no camera")
    });
    assert!(matches!(error, Error::Setting { setting, .. } if setting == "view.observer"));
}

/// Plants of one form, up to a third of a metre wide.
fn of_form(form: &Form) -> Rig {
    let (width_m, height_m) = (Range::new(0.1, 0.3), Range::new(0.3, 0.9));
    let kind = Species { form: form.clone(), width_m, height_m, ..Species::default() };
    let (mut draws, species) = (Draws::new(1), vec![kind]);
    let blades: Vec<_> = (0..60).map(|_| random_blade(&mut draws, &species, 2.0)).collect();
    Rig::new(field_of(species, &blades, 64))
}

/// Whether a pixel has this colour, at any brightness.
pub(super) fn has_color(pixel: &[u8; 4], color: [f32; 3]) -> bool {
    let strongest = (0..3).max_by(|a, b| color[*a].total_cmp(&color[*b])).unwrap_or(0);
    let scale = f32::from(pixel[strongest]) / color[strongest];
    pixel[3] > 0 && (0..3).all(|i| (f32::from(pixel[i]) - color[i] * scale).abs() < 3.0)
}

fn of_color(picture: &Picture, color: [f32; 3]) -> usize {
    picture.iter().filter(|pixel| has_color(pixel, color)).count()
}

/// Strips, quads and models cover in every debug view what they do in their own look, and have their
/// form's colour where levels are shown.
#[test]
fn every_form_shows() {
    let quads = Form::Billboard(Billboard::new(Plant::Daisy));
    let strips = Form::Strip(Strip::default());
    for (form, technique, near_m, slot) in [
        (&strips, Technique::Strips, 0.01, 6),
        (&quads, Technique::Billboards, 0.01, 7),
        (&quads, Technique::Billboards, 50.0, 9),
    ] {
        let mut rig = of_form(form);
        let bands = Bands { near_m, middle_m: near_m + 90.0, jitter: 0.0, ..Bands::default() };
        let eye = look(Vec3::new(0.0, 1.5, 4.0), Vec3::ZERO);
        let plain = View { technique, bands, culling: no_culling(), ..eye };
        let shown = picture(&mut rig, plain);
        let full = covered(&shown);
        assert!(full > 500, "{full}");
        for debug in DebugView::ALL {
            let other = picture(&mut rig, View { debug: Some(debug), ..plain });
            let beside = shown.iter().zip(&other).filter(|(s, o)| s[3] == 0 && o[3] > 0).count();
            let own = covered(&other);
            println!("{slot} {debug:?}: {own} of {full} pixels, {beside} beside");
            if debug == DebugView::Wireframe {
                // So small, most of their pixels lie on an edge
                assert!(own * 2 > full, "{slot}: {own} of {full} are lines");
                continue;
            }
            assert!(beside == 0 && own == full, "{slot} {debug:?}: {own} of {full}, {beside}");
            if debug == DebugView::Level {
                let own = of_color(&other, debug.colors()[slot].1);
                assert!(own * 20 > full * 19, "{slot}: {own} of {full} in the form's colour");
            }
        }
    }
}

/// One quad of two pieces that fills the picture: four triangles, with nothing between their edges.
#[test]
fn a_quads_wireframe_is_the_edges_of_its_triangles() {
    let form = Form::Billboard(Billboard { quads: 1, ..Billboard::new(Plant::Daisy) });
    let kind = Species { form, width_m: Range::new(0.5, 1.0), ..Species::default() };
    let own = Blade { height: 0.6, width: 0.6, ..blade(0.0, 0) };
    let kind = Species { height_m: Range::new(0.6, 0.7), ..kind };
    let mut rig = Rig::new(field_of(vec![kind], &[own], 64));
    let near = look(Vec3::new(0.0, 0.3, 0.65), Vec3::new(0.0, 0.3, 0.0));
    let bands = Bands { near_m: 0.01, jitter: 0.0, ..Bands::default() };
    let debug = Some(DebugView::Wireframe);
    let technique = Technique::Billboards;
    let view = View { technique, bands, debug, culling: no_culling(), ..near };
    let lines = picture(&mut rig, view);
    // Up a column of the picture: bottom, diagonal, middle, diagonal, and the top where it shows
    for column in 30..100 {
        let pixels = lines.iter().skip(column).step_by(SIZE[0] as usize);
        let shown: Vec<bool> = pixels.map(|p| p[3] > 0).collect();
        let crossed = shown.windows(2).filter(|pair| !pair[0] && pair[1]).count();
        assert!((2..=5).contains(&crossed), "{column}: {crossed}");
    }
    let share = covered(&lines) as f32 / lines.len() as f32;
    assert!((0.03..0.08).contains(&share), "{share}");
}

/// Plants that no test keeps are listed in a form that their technique draws.
#[test]
fn what_is_dropped_shows_in_its_own_form() {
    let quads = Form::Billboard(Billboard::new(Plant::Daisy));
    let strips = Form::Strip(Strip::default());
    for (form, technique, buckets) in [
        (&strips, Technique::Strips, STRIP_BUCKETS),
        (&strips, Technique::Continuum, STRIP_BUCKETS),
        (&quads, Technique::Billboards, BILLBOARD_BUCKETS),
        (&quads, Technique::Continuum, BILLBOARD_BUCKETS),
    ] {
        let mut rig = of_form(form);
        let high = look(Vec3::new(0.0, 9.0, 0.01), Vec3::ZERO);
        let observer = Some(Observer {
            view_from_world: high.view_from_world,
            clip_from_view: high.clip_from_view,
        });
        let debug = Some(DebugView::Culling);
        let view = View { technique, debug, observer, ..super::scenes::see_none() };
        let picture = picture(&mut rig, view);
        let listed: u32 = buckets.iter().map(|bucket| rig.list(0).1[*bucket].count).sum();
        assert_eq!(listed, 60, "{technique:?}");
        let unseen = of_color(&picture, DebugView::Culling.colors()[1].1);
        assert!(unseen > 50, "{technique:?}: {unseen} pixels");
    }
}
