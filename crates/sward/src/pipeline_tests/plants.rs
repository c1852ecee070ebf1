//! Modelled plants as they are drawn, against their pictures and against plants of quads.

use super::drawing::{Picture, covered, draw};
use super::rig::Rig;
use super::scenes::{SIZE, field_of, look, no_culling};
use crate::gpu::layout::{BILLBOARD_BUCKETS, MODEL_BUCKET};
use crate::grow::Blade;
use crate::plants::Angle;
use crate::shared::noise_twin::hash01;
use crate::{Bands, Field, Frame, Plant, Range, Species, Technique, View, Wind};
use glam::Vec3;
use glam::camera::rh::proj::directx::orthographic;
use std::f32::consts::FRAC_PI_2;

const HEIGHT: f32 = 0.5;
/// As the shader picks a variant.
const SALT: u32 = 41;

/// One upright plant that faces along z.
fn alone(plant: Plant) -> Field {
    let width = HEIGHT * plant.width_share();
    let species = Species {
        height_m: Range::new(HEIGHT, HEIGHT),
        width_m: Range::new(width, width),
        droop: Range::new(0.0, 0.0),
        ..Species::plant(plant)
    };
    let blade = Blade {
        root: Vec3::ZERO,
        up: Vec3::Y,
        facing: FRAC_PI_2,
        height: HEIGHT,
        width,
        response: 5.0,
        species: 0,
    };
    field_of(vec![species], &[blade], 64)
}

/// Straight in front, in parallel, the plant as high as the picture.
fn front(near_m: f32) -> View<'static> {
    let middle = Vec3::Y * (0.5 * HEIGHT);
    let mut view = look(middle + Vec3::Z, middle);
    let half = Vec3::new(SIZE[0] as f32 / SIZE[1] as f32, 1.0, 0.0) * (0.5 * HEIGHT);
    view.clip_from_view = orthographic(-half.x, half.x, -half.y, half.y, 0.1, 30.0);
    let bands = Bands { near_m, middle_m: near_m + 100.0, jitter: 0.0, ..Bands::default() };
    View { technique: Technique::Billboards, bands, culling: no_culling(), ..view }
}

fn drawn(rig: &mut Rig, near_m: f32, bucket: usize) -> Picture {
    let still = Wind::new(Vec::new()).expect("no wind");
    rig.step(&Frame::new(0.01, &still), &[front(near_m)]);
    assert_eq!(rig.list(0).1[bucket].count, 1, "in bucket {bucket}");
    draw(rig, 0)
}

/// Share of what either covers that both do.
fn overlap(picture: &Picture, painted: &crate::Picture, width_share: f32) -> f32 {
    let (mut both, mut either) = (0, 0);
    for (index, pixel) in picture.iter().enumerate() {
        let (x, y) = (index as u32 % SIZE[0], index as u32 / SIZE[0]);
        let across = (x as f32 + 0.5 - 0.5 * SIZE[0] as f32) / SIZE[1] as f32 / width_share + 0.5;
        let column = (across * painted.size() as f32).floor();
        let row = y * painted.size() / SIZE[1];
        let inside = (0.0..painted.size() as f32).contains(&column);
        let at = 4 * (row * painted.size() + column as u32) as usize + 3;
        let shown = inside && painted.rgba()[at] >= 128;
        both += u32::from(shown && pixel[3] > 0);
        either += u32::from(shown || pixel[3] > 0);
    }
    both as f32 / either as f32
}

fn mean_color(picture: &Picture) -> Vec3 {
    let shown = picture.iter().filter(|p| p[3] > 0);
    let sum: Vec3 = shown.map(|p| Vec3::new(p[0].into(), p[1].into(), p[2].into())).sum();
    sum / covered(picture) as f32 / 255.0
}

#[test]
fn models_look_like_their_pictures_and_like_the_quads() {
    let mut rig = Rig::new(alone(Plant::Daisy));
    // The only plant's number in its field is 0
    let variant = (hash01(0, SALT) * 4.0) as u64;
    let mut wrong = Vec::new();
    for plant in Plant::ALL {
        rig.replace(alone(plant));
        let model = drawn(&mut rig, 50.0, MODEL_BUCKET);
        let side = Angle::Side { turned: 0.0 };
        let painted = crate::Picture::paint(plant, variant, side, SIZE[1]).expect("a picture");
        let same = overlap(&model, &painted, plant.width_share());
        let quads = drawn(&mut rig, 0.01, BILLBOARD_BUCKETS[0]);
        let (near, far) = (mean_color(&model), mean_color(&quads));
        let off = (near - far).abs().max_element() / far.max_element();
        let ratio = covered(&quads) as f32 / covered(&model) as f32;
        if same < 0.65 || off > 0.25 || !(0.8..2.0).contains(&ratio) {
            wrong.push(format!(
                "{plant:?}: {same} of the pixels; {near} near, {far} as quads; {ratio} times as many"
            ));
        }
        assert_eq!(drawn(&mut rig, 50.0, MODEL_BUCKET), model, "bit for bit");
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
