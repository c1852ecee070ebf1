//! Modelled plants as they are drawn, against their pictures and against plants of quads.

use super::debugging::has_color;
use super::decoded::decode;
use super::drawing::{Picture, covered, difference, draw};
use super::rig::Rig;
use super::scenes::{Draws, SIZE, field_of, look, no_culling};
use crate::frame::physics::twin::State;
use crate::gpu::layout::{BILLBOARD_BUCKETS, CLUSTER_BUCKET, MODEL_BUCKET};
use crate::gpu::state_twin::pack_state;
use crate::gpu::view::focal_px;
use crate::grow::Blade;
use crate::plants::Angle;
use crate::shared::curve_twin::project_tip;
use crate::shared::noise_twin::hash01;
use crate::{
    Bands, Billboard, Culling, DebugView, Field, Form, Frame, PhysicsModel, Plant, Range, Species,
    Technique, View, Wind,
};
use glam::camera::rh::proj::directx::orthographic;
use glam::{Mat4, Vec3};
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

/// Bent over, a few degrees off the side that its only quad shows: the model that has turned into the
/// quad covers what that does, where the model itself does not.
#[test]
fn models_lie_down_on_their_quads() {
    let still = Wind::new(Vec::new()).expect("no wind");
    let mut rig = Rig::new(alone(Plant::Daisy));
    let (mut before, mut after) = (0, 0);
    for plant in [Plant::Poppy, Plant::Cornflower, Plant::TallGrass, Plant::Clover] {
        let field = alone(plant);
        let form = Form::Billboard(Billboard { quads: 1, ..Billboard::new(plant) });
        let kind = Species { form, ..field.species()[0].clone() };
        rig.replace(field_of(vec![kind], field.blades(), 64));
        rig.step(&Frame::new(0.0, &still), &[front(50.0)]);
        let own = decode(&rig.field)[0].physics;
        let lean = own.up + own.facing.cross(own.up) * 0.9;
        let tip = project_tip(lean, own.up, own.facing, own.arch);
        let model = PhysicsModel::Sward;
        rig.write_states(&[pack_state(&own, State { tip, crush: 0.0 }, model)]);
        let mut from_side = |near_m: f32| {
            let turned = Mat4::from_rotation_y(0.12);
            let view = front(near_m);
            rig.cull(&[View { view_from_world: view.view_from_world * turned, ..view }]);
            draw(&mut rig, 0)
        };
        let [model, flat, quads] = [50.0, 1.01, 0.99].map(&mut from_side);
        let (unlike, like) = (difference(&model, &quads), difference(&flat, &quads));
        println!("{plant:?}: {unlike:?} {like:?} of {}", covered(&quads));
        (before, after) = (before + unlike.1, after + like.1);
    }
    assert!(after * 2 < before, "{after} pixels of outline differ, {before} before");
}

/// 2048 plants of a kind anywhere on 16 m by 16 m.
fn meadow(plant: Plant) -> Field {
    some(plant, 2048, 8.0)
}

/// So many anywhere within so many metres along both axes.
fn some(plant: Plant, count: u32, reach_m: f32) -> Field {
    let species = Species::plant(plant);
    let mut draws = Draws::new(5);
    let blades: Vec<Blade> = (0..count)
        .map(|_| {
            let place = draws.vector(-reach_m, reach_m);
            let height = draws.between(species.height_m.min, species.height_m.max);
            Blade {
                root: place.with_y(0.0),
                up: Vec3::Y,
                facing: draws.between(0.0, 6.0),
                height,
                width: height * plant.width_share(),
                response: 5.0,
                species: 0,
            }
        })
        .collect();
    field_of(vec![species], &blades, 256)
}

/// In the continuum plants of quads go on from quads to clusters and to ground, and on the way they
/// cover as much, in the same colours.
#[test]
fn plants_of_quads_end_in_clusters_and_ground() {
    let still = Wind::new(Vec::new()).expect("no wind");
    let mut rig = Rig::new(meadow(Plant::Poppy));
    let mut seen = [false; 4];
    let (mut last, mut fewest) = (0, u64::MAX);
    for step in 0..26 {
        let away = 3.0 * 1.25_f32.powi(step);
        let view = look(Vec3::new(0.0, 0.3 * away, away), Vec3::ZERO);
        let culling = Culling { distance: true, ..no_culling() };
        let bands = Bands { near_m: 1.0, ..Bands::default() };
        let view = View { technique: Technique::Continuum, culling, bands, ..view };
        rig.step(&Frame::new(0.01, &still), &[view]);
        let count = |bucket: usize| rig.list(0).1[bucket].count;
        let [middle, far] = BILLBOARD_BUCKETS.map(count);
        let forms = [count(MODEL_BUCKET), middle + far, count(CLUSTER_BUCKET)];
        let statistics = rig.statistics();
        assert_eq!(statistics.clusters_drawn, u64::from(forms[2]));
        (0..3).for_each(|form| seen[form] |= forms[form] > 0);
        seen[3] |= forms[2] > 0 && forms[0] + forms[1] == 0;
        last = forms.iter().sum();
        if seen[3] && last > 0 {
            fewest = fewest.min(statistics.blades_moved);
        }
    }
    // One band of each patch is enough
    assert!(fewest <= 2048 / 256 * 64, "{fewest} plants are run");
    assert!(seen.iter().all(|s| *s) && last == 0, "{seen:?}, {last} are left");
}

#[test]
fn clusters_of_plants_look_as_their_models_do() {
    let still = Wind::new(Vec::new()).expect("no wind");
    for plant in [Plant::MeadowGrass, Plant::Poppy] {
        let mut rig = Rig::new(meadow(plant));
        // Plants are 5 pixels high: all are clusters, and none has passed to the ground
        let height = plant.height_m();
        let focal = focal_px(&look(Vec3::Z, Vec3::ZERO));
        let away = 0.5 * (height.min + height.max) * focal / 5.0;
        let view = look(Vec3::new(0.0, 0.3, 1.0).normalize() * away, Vec3::ZERO);
        let clusters = View {
            technique: Technique::Continuum,
            culling: Culling { distance: true, ..no_culling() },
            ..view
        };
        rig.step(&Frame::new(0.01, &still), &[clusters]);
        let clustered = rig.list(0).1[CLUSTER_BUCKET].count;
        let quads: u32 = BILLBOARD_BUCKETS.iter().map(|b| rig.list(0).1[*b].count).sum();
        assert!(clustered > 8 && quads < 20, "{clustered}, {quads}");
        let far = draw(&mut rig, 0);
        // Triangles are not filtered: what they cover, and in what colour, is right in the mean
        let bands = Bands { near_m: 1e4, middle_m: 2e4, ..Bands::default() };
        let (technique, culling) = (Technique::Billboards, no_culling());
        let models = View { technique, culling, bands, ..view };
        rig.step(&Frame::new(0.0, &still), &[models]);
        assert_eq!(rig.list(0).1[MODEL_BUCKET].count, 2048);
        let near = draw(&mut rig, 0);
        let ratio = covered(&far) as f32 / covered(&near) as f32;
        let (far, near) = (mean_color(&far), mean_color(&near));
        println!("{plant:?}: {ratio} of the pixels; {far} as clusters, {near} as models");
        assert!((0.7..1.3).contains(&ratio), "{plant:?}: {ratio} of the pixels");
        // Petals let more light through than the light of a whole field knows of
        let hue = |c: Vec3| c / c.element_sum();
        assert!((hue(far) - hue(near)).abs().max_element() < 0.1, "{plant:?}: {far}, {near}");
    }
}

/// A cluster of flowers comes texel by texel at its whole width: narrow, it would be a streak of colour.
#[test]
fn a_cluster_of_flowers_is_no_streak() {
    let still = Wind::new(Vec::new()).expect("no wind");
    let mut rig = Rig::new(some(Plant::Poppy, 32, 1.0));
    let color = DebugView::Level.colors()[4].1;
    let seen: Vec<(usize, f32)> = (0..40)
        .map(|step| {
            let away = 2.3 * 1.03_f32.powi(step);
            let culling = Culling { distance: true, ..no_culling() };
            let bands = Bands { near_m: 0.01, ..Bands::default() };
            let (technique, debug) = (Technique::Continuum, Some(DebugView::Level));
            let view = look(Vec3::new(0.0, 0.2 * away, away), Vec3::ZERO);
            rig.step(
                &Frame::new(0.01, &still),
                &[View { technique, culling, bands, debug, detail: 1.6, ..view }],
            );
            let picture = draw(&mut rig, 0);
            let columns = (0..SIZE[0] as usize)
                .filter(|x| picture.chunks(SIZE[0] as usize).any(|row| has_color(&row[*x], color)));
            let columns: Vec<usize> = columns.collect();
            let wide = columns.last().map_or(0, |last| last + 1 - columns[0]);
            (picture.iter().filter(|p| has_color(p, color)).count(), wide as f32 * away)
        })
        .collect();
    println!("{seen:?}");
    let most = seen.iter().map(|(count, _)| *count).max().unwrap_or(0);
    let widest = seen.iter().map(|(_, wide)| *wide).fold(0.0, f32::max);
    // So few that a card which grows with them would be less than half as wide
    let is_coming = |(count, _): &&(usize, f32)| (most / 8..most * 2 / 5).contains(count);
    let coming: Vec<_> = seen.iter().filter(is_coming).collect();
    assert!(most > 40 && !coming.is_empty(), "{seen:?}");
    assert!(coming.iter().all(|(_, wide)| *wide > 0.55 * widest), "{coming:?} of {widest}");
}
