//! What must hold for every kind: shape, colours, mips, and that the points of the near form show
//! what the pictures show.

use super::kinds::model;
use super::layers::{LAYER_SIZE, PlantLayers, VARIANTS, VIEWS, view_angle};
use super::mesh::{POINT_RANGE, RIBBON_POINTS, points};
use super::model::{MAX_RIBBONS, Model};
use super::paint::{paint, paint_model};
use super::{Angle, Look, Picture, Plant};
use crate::bake::mips::{chain, passing};
use crate::bake::raster::{Texel, Tile, Window};
use crate::bake::{Corner, Triangle};
use glam::{Vec2, Vec3};

const SIDE: Angle = Angle::Side { turned: 0.0 };

/// A model, from the texels that the shader reads.
fn unpacked(model: &Model, width: f32, towards: Vec3) -> Vec<Triangle> {
    let snorm = |bits: u32| f32::from((bits & 0xffff) as u16 as i16) / 32767.0;
    let corner = |texel: [u32; 4]| {
        let [xy, z_half, color, oct] = texel;
        let scale = Vec3::new(width, 1.0, width) * POINT_RANGE;
        let place = Vec3::new(snorm(xy), snorm(xy >> 16), snorm(z_half)) * scale;
        let half = snorm(z_half >> 16) * scale.x;
        let e = Vec2::new(snorm(oct), snorm(oct >> 16));
        let y = 1.0 - e.x.abs() - e.y.abs();
        let fold = (-y).max(0.0);
        let direction =
            Vec3::new(e.x - fold.copysign(e.x), y, e.y - fold.copysign(e.y)).normalize();
        let channel = |shift: u32| (((color >> shift) & 0x3ff) as f32 / 1023.0).powi(2);
        let albedo = Vec3::new(channel(0), channel(10), channel(20));
        let round = color >> 30 == 1;
        let across = direction.cross(towards).normalize_or(Vec3::X);
        let position = if round { place + across * half } else { place };
        let normal = if round { towards } else { direction };
        let height_share = position.y.clamp(0.0, 1.0);
        Corner { position, normal, round: Vec3::ZERO, albedo, height_share, thickness: 1.0 }
    };
    let mut list = Vec::new();
    for ribbon in &model.ribbons {
        let ring: Vec<Corner> = points(ribbon, width).map(corner).to_vec();
        for low in (0..RIBBON_POINTS as usize - 2).step_by(2) {
            list.push([ring[low], ring[low + 1], ring[low + 2]]);
            list.push([ring[low + 1], ring[low + 3], ring[low + 2]]);
        }
    }
    list
}

/// Mean colour of what is covered.
fn mean_color(tile: &Tile) -> Vec3 {
    let sum: Vec3 = tile.texels.iter().map(|t| t.albedo * t.alpha).sum();
    sum / tile.texels.iter().map(|t| t.alpha).sum::<f32>()
}

/// Share of the covered texels between two heights for which something holds.
fn share(tile: &Tile, heights: [f32; 2], holds: impl Fn(&Texel) -> bool) -> f32 {
    let rows = tile.texels.chunks_exact(tile.size[0] as usize);
    let height = |row: usize| 1.0 - (row as f32 + 0.5) / tile.size[1] as f32;
    let inside =
        rows.enumerate().filter(|(row, _)| (heights[0]..heights[1]).contains(&height(*row)));
    let covered: Vec<&Texel> =
        inside.flat_map(|(_, row)| row).filter(|texel| texel.alpha > 0.5).collect();
    covered.iter().filter(|texel| holds(texel)).count() as f32 / covered.len().max(1) as f32
}

#[test]
fn every_variant_fills_its_box_and_no_more() {
    for plant in Plant::ALL {
        for seed in 0..8 {
            let model = model(plant, seed);
            let count = model.ribbons.len();
            assert!((20..=MAX_RIBBONS).contains(&count), "{plant:?}: {count} ribbons");
            let (mut top, mut out, mut low) = (0.0_f32, 0.0_f32, 1.0_f32);
            for towards in [Vec3::X, Vec3::Z] {
                for corner in unpacked(&model, plant.width_share(), towards).into_iter().flatten() {
                    let at = corner.position;
                    (top, low) = (top.max(at.y), low.min(at.y));
                    out = out.max(at.x.hypot(at.z));
                }
            }
            let half = 0.5 * plant.width_share();
            assert!((0.95..1.005).contains(&top), "{plant:?} {seed}: up to {top}");
            assert!((0.9 * half..1.02 * half).contains(&out), "{plant:?} {seed}: out to {out}");
            assert!((-0.06..0.05).contains(&low), "{plant:?} {seed}: down to {low}");
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_and_others_do_not() {
    for plant in Plant::ALL {
        assert_eq!(model(plant, 3), model(plant, 3));
        assert_ne!(model(plant, 3), model(plant, 4));
        assert_eq!(paint(plant, 1, SIDE, 32), paint(plant, 1, SIDE, 32));
    }
    assert_eq!(Plant::from_name("poppy"), Some(Plant::Poppy));
    assert_eq!(Plant::from_name("rose"), None);
    for plant in Plant::ALL {
        assert_eq!(Plant::from_name(plant.name()), Some(plant));
    }
}

/// Heads have their colours, above; leaves are green, below; grasses are all green or straw.
#[test]
fn every_kind_has_what_it_is_known_by() {
    let green = |t: &Texel| t.albedo.y > t.albedo.x && t.albedo.y > 1.5 * t.albedo.z;
    let white = |t: &Texel| t.albedo.min_element() > 0.45;
    let straw = |t: &Texel| t.albedo.x > 1.1 * t.albedo.y && t.albedo.y > 1.3 * t.albedo.z;
    let yellow = |t: &Texel| t.albedo.x > 0.5 && t.albedo.y > 0.25 && t.albedo.z < 0.1;
    let red = |t: &Texel| t.albedo.x > 0.25 && t.albedo.x > 6.0 * t.albedo.y;
    let blue = |t: &Texel| t.albedo.z > 0.3 && t.albedo.z > 2.0 * t.albedo.x;
    let pink = |t: &Texel| t.albedo.x > 0.35 && t.albedo.x > 1.5 * t.albedo.y && t.albedo.z > 0.2;
    type Holds<'a> = &'a dyn Fn(&Texel) -> bool;
    let heads: [(Plant, Holds, f32); 8] = [
        (Plant::MeadowGrass, &green, 0.9),
        (Plant::TallGrass, &straw, 0.6),
        (Plant::FineGrass, &green, 0.9),
        (Plant::Clover, &pink, 0.15),
        (Plant::Daisy, &white, 0.4),
        (Plant::Daisy, &yellow, 0.01),
        (Plant::Poppy, &red, 0.5),
        (Plant::Cornflower, &blue, 0.35),
    ];
    for seed in 0..VARIANTS.into() {
        for (plant, holds, least) in heads {
            let found = share(&paint(plant, seed, SIDE, 96), [0.55, 1.0], holds);
            assert!(found >= least, "{plant:?} {seed}: {found} of the upper half");
        }
        let clock = share(&paint(Plant::DandelionClock, seed, SIDE, 96), [0.6, 1.0], white);
        assert!(clock > 0.5, "{seed}: {clock}");
        for plant in Plant::ALL {
            let found = share(&paint(plant, seed, SIDE, 96), [0.02, 0.3], green);
            assert!(found > 0.75, "{plant:?} {seed}: {found} of the lower part");
        }
        // From above, a daisy shows its rays and its discs
        let above = paint(Plant::Daisy, seed, Angle::Above, 96);
        assert!(share(&above, [0.0, 1.0], white) > 0.2 && share(&above, [0.0, 1.0], yellow) > 0.01);
    }
}

/// Whichever level is drawn, as much of the plant shows.
#[test]
fn mips_keep_what_shows() {
    for plant in Plant::ALL {
        let tile = paint(plant, 0, SIDE, LAYER_SIZE);
        let cover = tile.coverage();
        for level in chain(tile, cover) {
            // A texel of the smaller levels is a large part of them
            let near = 0.02 + 0.5 / level.size[0] as f32;
            let off = (passing(&level) - cover).abs();
            assert!(off < near, "{plant:?} at {}: off by {off} of {cover}", level.size[0]);
        }
    }
}

/// The near form is coarser, and quantised; what it shows is the picture.
#[test]
fn the_near_form_shows_what_the_pictures_show() {
    for plant in Plant::ALL {
        let model = model(plant, 1);
        let picture = paint_model(&model, plant.width_share(), SIDE, 96);
        let half = Vec2::new(0.5 * plant.width_share(), 0.5);
        let (center, right, up) = (Vec3::Y * 0.5, Vec3::X, Vec3::Y);
        let window = Window { center, right, up, half, size: [96; 2], samples: 4 };
        let near = window.see(&unpacked(&model, plant.width_share(), Vec3::Z)).tile();
        let (a, b) = (mean_color(&picture), mean_color(&near));
        let off = (a - b).abs().max_element() / a.max_element();
        assert!(off < 0.06, "{plant:?}: {a} painted, {b} near");
        let (painted, drawn) = (picture.coverage(), near.coverage());
        assert!((drawn / painted - 1.0).abs() < 0.08, "{plant:?}: {painted}, {drawn} near");
    }
}

#[test]
fn layers_are_in_order() {
    let picture = Picture::new([2, 2], vec![255; 16]).expect("a picture");
    let wanted = [
        Look::from(picture.clone()),
        Look::from(Plant::Poppy),
        Look::from(Plant::Clover),
        Look::from(Plant::Poppy),
        Look::from(picture.clone()),
    ];
    let layers = PlantLayers::new(wanted.iter());
    let each = VARIANTS * VIEWS;
    assert_eq!(layers.color.count, 2 * each + 2);
    assert_eq!(layers.normal.count, layers.color.count);
    assert_eq!(layers.range(&wanted[1]).first, 0);
    assert_eq!((layers.range(&wanted[2]).first, layers.range(&wanted[2]).count), (each, each));
    assert_eq!((layers.range(&wanted[0]).first, layers.range(&wanted[0]).count), (2 * each, 1));
    assert_eq!(layers.strip().first, 2 * each + 1);
    assert_eq!(layers.models.len() % 2, 0);
    let poppy = paint(Plant::Poppy, 2, view_angle(1), LAYER_SIZE);
    let cover = poppy.coverage();
    let level = &chain(poppy, cover)[0];
    let sent = layers.color.layer(0, 2 * VIEWS + 1);
    let differ = level
        .texels
        .iter()
        .zip(sent)
        .filter(|(texel, sent)| (texel.alpha * 255.0 - f32::from(sent[3])).abs() > 1.0);
    assert_eq!(differ.count(), 0);
    assert!(layers.check(&wgpu::Limits::default()).is_ok());
    let few = wgpu::Limits { max_texture_array_layers: 10, ..Default::default() };
    let error = layers.check(&few).expect_err("26 layers").to_string();
    assert!(
        error.contains("26 pictures of plants needs max_texture_array_layers of 26"),
        "{error}"
    );
}

/// A picture that the library painted comes back as it was, and at another size keeps its colour
/// and its share.
#[test]
fn pictures_are_resampled() {
    let picture = Picture::paint(Plant::Daisy, 1, SIDE, 64).expect("a picture");
    let same = picture.resampled(64);
    assert_eq!(same.coverage(), {
        let sum: u32 = picture.rgba().iter().skip(3).step_by(4).map(|a| u32::from(*a)).sum();
        (f64::from(sum) / 255.0 / 4096.0) as f32
    });
    for size in [16, 48, 128, 200] {
        let other = picture.resampled(size);
        let off = (mean_color(&other) - mean_color(&same)).abs().max_element();
        assert!(off < 0.01, "{size}: {off}");
        assert!((other.coverage() / same.coverage() - 1.0).abs() < 0.03, "{size}");
    }
}

#[test]
fn the_blade_of_strips_is_round_at_its_tip_and_nearly_full() {
    let strip = Picture::strip(64).expect("a picture");
    let alpha = |x: usize, y: usize| strip.rgba()[4 * (y * 64 + x) + 3];
    assert_eq!((alpha(0, 0), alpha(63, 0)), (0, 0), "cut at its corners");
    assert!(alpha(32, 1) > 128 && alpha(32, 62) > 128, "there at both ends");
    let levels = strip.mips(true);
    for level in &levels {
        assert!((level.shown - levels[0].shown).abs() < 0.06, "{}", level.size);
    }
}
