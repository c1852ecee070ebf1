//! Pictures of a few blades.

use super::decoded::decode;
use super::rig::Rig;
use super::scenes::{SIZE, breeze, field_of, look, no_culling, random_field, see_all, species};
use super::targets::Target;
use crate::frame::draw::topology::Topology;
use crate::frame::level::FULL_DETAIL_PX;
use crate::frame::physics::twin::State;
use crate::gpu::state_twin::pack_state;
use crate::grow::Blade;
use crate::shared::curve_twin::project_tip;
use crate::{Frame, PhysicsModel, Range, Shape, Species, View};
use glam::{DVec3, Vec3};
use std::f32::consts::FRAC_PI_2;

pub(super) type Picture = Vec<[u8; 4]>;

/// The blades of a view on black, alpha 0.
pub(super) fn draw(rig: &mut Rig, view: usize) -> Picture {
    let target = Target::new(&rig.device, SIZE, wgpu::TextureFormat::Rgba8Unorm);
    rig.submit(|renderer, _, encoder| target.record(encoder, |pass| renderer.draw(pass, view)));
    rig.read(&target.out)
}

pub(super) fn covered(picture: &Picture) -> usize {
    picture.iter().filter(|p| p[3] > 0).count()
}

#[test]
fn a_field_covers_pixels_and_repeats_itself() {
    let mut rig = Rig::new(random_field(1, 3000, 4.0, 256));
    let wind = breeze();
    let view = look(Vec3::new(0.0, 1.5, 6.0), Vec3::ZERO);
    assert_eq!(covered(&draw(&mut rig, 0)), 0, "nothing was culled for a view yet");
    rig.step(&Frame::new(0.02, &wind), &[view]);
    let first = draw(&mut rig, 0);
    let share = covered(&first) as f32 / first.len() as f32;
    assert!((0.1..0.9).contains(&share), "{share} covered");
    let bright = first.iter().filter(|p| p[3] > 0 && p[1] > 10).count();
    assert!(bright * 2 > covered(&first), "the blades are lit");
    rig.cull(&[view]);
    assert_eq!(draw(&mut rig, 0), first, "bit for bit");
    assert_eq!(covered(&draw(&mut rig, 1)), 0, "a view that does not exist draws nothing");
    rig.cull(&[View { max_blades: Some(0), ..view }]);
    assert_eq!(covered(&draw(&mut rig, 0)), 0);
}

pub(super) fn blade(x: f32, species: u8) -> Blade {
    Blade {
        root: Vec3::new(x, 0.0, 0.0),
        up: Vec3::Y,
        facing: FRAC_PI_2,
        height: 0.5,
        width: 0.014,
        response: 5.0,
        species,
    }
}

/// A view in which a blade half a metre high is this many pixels high, as the levels see it.
pub(super) fn at_height(height_px: f32) -> View<'static> {
    let mut view = look(Vec3::new(0.0, 0.25, 0.6), Vec3::new(0.0, 0.25, 0.0));
    let focal = view.clip_from_view.y_axis.y * SIZE[1] as f32 / 2.0;
    view.detail = height_px / (0.5 * focal / 0.6);
    View { culling: no_culling(), ..view }
}

#[test]
fn vertices_are_those_of_the_levels() {
    // One pointed blade and two flat ones: 2n + 1 and 2n + 2, and three a ring where the ridge is
    let blades = [blade(0.0, 0), blade(0.0, 1), blade(0.0, 1)];
    let mut rig = Rig::new(field_of(species(), &blades, 64));
    let expected = [(300.0, 25 + 2 * 27), (60.0, 13 + 2 * 15), (15.0, 5 + 2 * 6), (5.0, 3 + 2 * 4)];
    for (level, (height_px, vertices)) in expected.into_iter().enumerate() {
        rig.cull(&[at_height(height_px)]);
        let (_, draws) = rig.list(0);
        assert_eq!((draws[level].count, draws[level + 4].count), (1, 2), "level {level}");
        assert_eq!(rig.statistics().vertices, vertices);
        let arguments: Vec<[u32; 5]> = rig.read(&rig.lists(0).indirect);
        let indices = Topology::of(level).indices().len() as u32;
        assert_eq!(arguments[level][..2], [indices * 64, 1]);
    }
}

/// Mean difference of two pictures over what either covers, 0 to 1, and how many pixels only one
/// of them covers.
pub(super) fn difference(a: &Picture, b: &Picture) -> (f32, usize) {
    let either = a.iter().zip(b).filter(|(a, b)| a[3] > 0 || b[3] > 0);
    let (mut sum, mut count, mut edge) = (0.0, 0, 0);
    for (a, b) in either {
        count += 1;
        edge += usize::from((a[3] > 0) != (b[3] > 0));
        sum += (0..3).map(|i| f32::from(a[i].abs_diff(b[i]))).sum::<f32>() / (3.0 * 255.0);
    }
    (sum / count as f32, edge)
}

/// A blade that bends far over, drawn just above and just below each change of level.
#[test]
fn a_change_of_level_does_not_show() {
    let leaf = Species { shape: Shape::Dandelion, ..species()[0].clone() };
    for (kind, own) in species().into_iter().chain([leaf]).enumerate() {
        let wide = Species { width_m: Range::new(0.01, 0.1), ..own };
        let bent = Blade { width: 0.08, ..blade(0.0, 0) };
        let mut rig = Rig::new(field_of(vec![wide], &[bent], 64));
        // Lights it
        rig.step(&Frame::new(0.0, &breeze()), &[see_all()]);
        let own = decode(&rig.field)[0].physics;
        let tip = project_tip(own.up + DVec3::new(0.8, 0.0, 1.2), own.up, own.facing, own.arch);
        let state = State { tip, crush: 0.0 };
        rig.write_states(&[pack_state(&own, state, PhysicsModel::Sward)]);
        let mut at = |height_px: f32| {
            rig.cull(&[at_height(height_px)]);
            draw(&mut rig, 0)
        };
        let levels = [0.6, 0.6 / 4.0, 0.6 / 16.0].map(|share| at(FULL_DETAIL_PX * share));
        for (level, share) in [1.0 / 4.0, 1.0 / 16.0, 1.0 / 64.0].into_iter().enumerate() {
            let edge = FULL_DETAIL_PX * share;
            let (above, below) = (at(edge * 1.001), at(edge * 0.999));
            let (color, outline) = difference(&above, &below);
            let (hard_color, hard_outline) = difference(&levels[level], &below);
            println!(
                "species {kind}, level {level}: {color:.4}, {outline} of {} pixels; unmorphed \
                 {hard_color:.4}, {hard_outline}",
                covered(&below)
            );
            // The last level lights a blade at its ends only, so that its middle changes shade
            let most = [0.03, 0.03, 0.045][level];
            assert!(color < most, "species {kind}, level {level}: {color}");
            // A leaf's outline is several times as long for its area; and what the last levels cut
            // along another diagonal is here drawn nine times as large as where they change
            let edge_share = if kind == 2 { [20, 50, 6][level] } else { 50 };
            assert!(
                outline * edge_share <= covered(&below),
                "species {kind}, level {level}: {outline}"
            );
            assert!(hard_outline > 2 * outline, "the measure sees a level");
        }
    }
}

#[test]
fn every_blade_of_a_full_view_is_drawn() {
    let mut rig = Rig::new(random_field(2, 500, 2.0, 64));
    rig.cull(&[see_all()]);
    assert_eq!(rig.statistics().blades_drawn, 500);
    let (_, draws) = rig.list(0);
    let vertices = (0..8).map(|b| u64::from(draws[b].count * Topology::of(b).vertices()));
    assert_eq!(rig.statistics().vertices, vertices.sum::<u64>());
}
