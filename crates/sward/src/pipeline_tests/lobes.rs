//! The dandelion's outline as it is drawn, and levels that are forced.

use super::drawing::{Picture, covered, draw};
use super::rig::Rig;
use super::scenes::{SIZE, field_of, look, no_culling, random_field, see_all};
use crate::frame::draw::lobes_twin::{LOBES, leaf_inside, maxima};
use crate::grow::Blade;
use crate::{Range, Shape, Species, View};
use glam::Vec3;
use std::f32::consts::FRAC_PI_2;

const HEIGHT: f32 = 0.5;
const WIDTH: f32 = 0.2;
const AWAY: f32 = 0.55;

pub(super) fn leaf(shape: Shape) -> Rig {
    let species = Species {
        shape,
        width_m: Range::new(WIDTH, WIDTH),
        height_m: Range::new(HEIGHT, HEIGHT),
        ridge: 0.0,
        ..Species::default()
    };
    let blade = Blade {
        root: Vec3::ZERO,
        up: Vec3::Y,
        facing: FRAC_PI_2,
        height: HEIGHT,
        width: WIDTH,
        response: 5.0,
        species: 0,
    };
    Rig::new(field_of(vec![species], &[blade], 64))
}

/// Straight in front of the leaf, which stands upright until it is simulated.
pub(super) fn front(level: u8) -> View<'static> {
    let view = look(Vec3::new(0.0, HEIGHT / 2.0, AWAY), Vec3::new(0.0, HEIGHT / 2.0, 0.0));
    View { level: Some(level), culling: no_culling(), ..view }
}

/// The leaf's widths by row, from the root, in pixels.
fn widths(picture: &Picture) -> Vec<f64> {
    let rows = picture.chunks(SIZE[0] as usize).rev();
    let widths = rows.map(|row| row.iter().filter(|p| p[3] > 0).count() as f64);
    widths.skip_while(|w| *w == 0.0).collect()
}

/// Place on the leaf that a pixel's centre shows: share of the length, half widths off the middle.
fn place(pixel: usize) -> (f64, f64) {
    let (x, y) = (pixel % SIZE[0] as usize, pixel / SIZE[0] as usize);
    let focal = front(0).clip_from_view.y_axis.y * SIZE[1] as f32 / 2.0;
    let metres = |px: f32| f64::from(px * AWAY / focal);
    let side = metres(x as f32 + 0.5 - SIZE[0] as f32 / 2.0) / f64::from(WIDTH / 2.0);
    let up = metres(SIZE[1] as f32 / 2.0 - y as f32 - 0.5);
    (up / f64::from(HEIGHT) + 0.5, side.abs())
}

#[test]
fn lobes_survive_at_every_level() {
    let mut rig = leaf(Shape::Dandelion);
    for level in 0..4 {
        rig.cull(&[front(level)]);
        let picture = draw(&mut rig, 0);
        let lobes = maxima(&widths(&picture), 1.5);
        assert_eq!(lobes, LOBES, "level {level}: {:?}", widths(&picture));
        let wrong = (0..picture.len()).filter(|&pixel| {
            let (along, side) = place(pixel);
            let inside = (0.0..=1.0).contains(&along) && leaf_inside(along, side) > 0.0;
            inside != (picture[pixel][3] > 0)
        });
        let (wrong, all) = (wrong.count(), covered(&picture));
        println!("level {level}: {wrong} of {all} pixels differ from the outline");
        assert!(all > 300 && wrong * 50 < all, "level {level}: {wrong} of {all}");
    }
    let mut plain = leaf(Shape::TriangleTip { tip: 0.5 });
    plain.cull(&[front(0)]);
    assert_eq!(maxima(&widths(&draw(&mut plain, 0)), 1.5), 1, "the measure sees lobes only");
}

/// Far off a leaf is a blade like others: the width correction fills its lobes.
#[test]
fn a_leaf_a_pixel_wide_is_whole() {
    let mut rig = leaf(Shape::Dandelion);
    let eye = Vec3::new(0.0, HEIGHT / 2.0, 16.0);
    let target = Vec3::new(0.0, HEIGHT / 2.0, 0.0);
    let mut count = |width_correction| {
        let view = View { culling: no_culling(), width_correction, ..look(eye, target) };
        rig.cull(&[view]);
        covered(&draw(&mut rig, 0))
    };
    let (with, without) = (count(true), count(false));
    assert!(with > without && without > 0, "{with} {without}");
}

#[test]
fn a_forced_level_holds_for_every_blade() {
    let mut rig = Rig::new(random_field(3, 600, 20.0, 64));
    for level in 0..4 {
        rig.cull(&[View { level: Some(level), ..see_all() }]);
        let (list, draws) = rig.list(0);
        let at = usize::from(level);
        assert_eq!(draws[at].count + draws[at + 4].count, 600);
        assert!(list.iter().all(|entry| (entry >> 22) & 31 == 0), "no blade morphs");
    }
    rig.cull(&[see_all()]);
    let (_, draws) = rig.list(0);
    assert!((0..4).filter(|&level| draws[level].count > 0).count() > 1, "else by size");
}
