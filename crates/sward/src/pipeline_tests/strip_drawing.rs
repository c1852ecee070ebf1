//! Pictures of single strips.

use super::decoded::decode;
use super::drawing::{Picture, at_height, blade, covered, difference, draw};
use super::rig::Rig;
use super::scenes::{SIZE, breeze, facing_origin, field_of, look, no_culling, see_all, species};
use crate::frame::physics::twin::State;
use crate::gpu::state_twin::pack_state;
use crate::grow::Blade;
use crate::shared::curve_twin::project_tip;
use crate::shared::noise_twin::hash01;
use crate::{
    Cosine, Form, Frame, PhysicsModel, Range, Species, Strip, Technique, View, Wind, WindSource,
};
use glam::{DVec3, Vec2, Vec3};

fn kind(strip: Strip) -> Species {
    Species {
        form: Form::Strip(strip),
        height_m: Range::new(0.2, 1.0),
        width_m: Range::new(0.01, 0.4),
        ..species()[0].clone()
    }
}

fn rig(strip: Strip, blades: &[Blade]) -> Rig {
    let mut rig = Rig::new(field_of(vec![kind(strip)], blades, 64));
    // Lights it
    rig.step(&Frame::new(0.0, &breeze()), &[by_strips(see_all())]);
    rig
}

fn by_strips(view: View) -> View {
    View { technique: Technique::Strips, culling: no_culling(), ..view }
}

/// Pixels covered in each row.
fn widths(picture: &Picture) -> Vec<usize> {
    picture.chunks(SIZE[0] as usize).map(|row| row.iter().filter(|p| p[3] > 0).count()).collect()
}

/// Its texture cuts a rounded tip out of a strip of full width.
#[test]
fn the_tip_is_cut_by_the_texture() {
    let wide = Blade { height: 1.0, width: 0.3, ..blade(0.0, 0) };
    let mut rig = rig(Strip { fold_deg: 0.0, sway: 0.0, ..Strip::default() }, &[wide]);
    let near = look(Vec3::new(0.0, 0.5, 1.1), Vec3::new(0.0, 0.5, 0.0));
    rig.cull(&[by_strips(near)]);
    let picture = draw(&mut rig, 0);
    let rows: Vec<usize> = widths(&picture).into_iter().filter(|width| *width > 0).collect();
    println!("{rows:?}");
    let (top, middle) = (rows[rows.len() / 40], rows[rows.len() / 2]);
    assert!(rows.len() > 30 && middle > 10, "{rows:?}");
    assert!(top * 2 < middle, "{top} of {middle} near the tip");
    let full = rows.len() * rows.iter().max().copied().unwrap_or(0);
    let share = covered(&picture) as f32 / full as f32;
    assert!((0.6..0.95).contains(&share), "{share} of its box");
    assert_eq!(rig.statistics().strips_drawn, 1);
}

/// Folded strips are as wide from everywhere; a flat one is not.
#[test]
fn a_fold_shows_from_every_side() {
    let seen = |fold_deg: f32, facing: f32| {
        let own = Blade { height: 1.0, width: 0.3, facing, ..blade(0.0, 0) };
        let mut rig = rig(Strip { fold_deg, sway: 0.0, ..Strip::default() }, &[own]);
        rig.cull(&[by_strips(facing_origin())]);
        covered(&draw(&mut rig, 0))
    };
    let (along, across) = (0.0, std::f32::consts::FRAC_PI_2);
    assert!(seen(0.0, along) * 8 < seen(0.0, across), "a flat blade has an edge");
    assert!(seen(90.0, along) * 4 > seen(90.0, across), "a folded one has none");
}

/// A strip that bends far over, drawn just above and just below the height at which it changes.
#[test]
fn a_change_of_rings_does_not_show() {
    let bent = Blade { width: 0.08, ..blade(0.0, 0) };
    let own = Strip { sway: 0.0, ..Strip::default() };
    let mut rig = rig(own.clone(), &[bent]);
    let physics = decode(&rig.field)[0].physics;
    let lean = physics.up + DVec3::new(0.8, 0.0, 1.2);
    let tip = project_tip(lean, physics.up, physics.facing, physics.arch);
    rig.write_states(&[pack_state(&physics, State { tip, crush: 0.0 }, PhysicsModel::Sward)]);
    let mut at = |height_px: f32| {
        rig.cull(&[by_strips(at_height(height_px))]);
        draw(&mut rig, 0)
    };
    let change = own.few_rings_px * (hash01(0, 26) - 0.5).exp2();
    let (far_above, above, below) = (at(change * 4.0), at(change * 1.002), at(change * 0.998));
    let (color, outline) = difference(&above, &below);
    let (hard_color, hard_outline) = difference(&far_above, &below);
    println!(
        "{color:.4}, {outline} of {}; unmorphed {hard_color:.4}, {hard_outline}",
        covered(&below)
    );
    assert!(color < 0.02 && outline * 50 <= covered(&below), "{color} {outline}");
    assert!(hard_outline > 3 * outline.max(1), "the measure sees the rings");
}

/// With the physics at rest, a strip sways by itself, and only where it is told to.
#[test]
fn strips_sway_on_the_winds_cosine() {
    let plants = [-0.4, 0.0, 0.4].map(|x| Blade { height: 1.0, width: 0.1, ..blade(x, 0) });
    let cosine = Cosine { strength: 1.0, direction: Vec2::X, period_s: 1.0, ..Cosine::default() };
    let pictures = |sway: f32| {
        let mut rig = rig(Strip { sway, ..Strip::default() }, &plants);
        let mut wind = Wind::new(vec![WindSource::Cosine(cosine)]).expect("valid wind");
        [0.0, 0.3].map(|dt_s| {
            wind.advance(dt_s);
            rig.step(&Frame::new(0.0, &wind), &[by_strips(facing_origin())]);
            draw(&mut rig, 0)
        })
    };
    let [first, later] = pictures(0.0);
    assert_eq!(first, later, "no time passes for the physics");
    let [first, later] = pictures(0.4);
    let (_, outline) = difference(&first, &later);
    assert!(outline * 10 > covered(&first), "{outline} of {}", covered(&first));
}
