//! What is baked of whole fields.

use super::canopy::canopy;
use super::cluster::{AZIMUTHS, CLUSTER_BLADES, ELEVATIONS, VARIANTS, clusters};
use super::cover::{ROWS, sine};
use super::layers::Layers;
use super::stand::Stands;
use crate::{ColorRange, Field, FieldDesc, Mesh, Range, Shape, Species, Surface};
use glam::{UVec2, Vec2, Vec3};

pub(super) fn grown(desc: &FieldDesc, side: f32) -> Field {
    let mesh = Mesh::plane(Vec2::splat(side), UVec2::ONE).expect("a plane");
    let surface = Surface::new(mesh).expect("a surface");
    Field::grow(&surface, desc).expect("a field")
}

/// Writes layers as a sheet: a row an elevation, a column a side, over grey.
fn sheet(layers: &Layers, path: &str) {
    use std::io::Write;
    let [w, h] = layers.size;
    let (columns, rows) = (VARIANTS * AZIMUTHS, ELEVATIONS);
    let mut file = std::fs::File::create(path).expect("a file");
    let (width, height) = (w as usize * columns, h as usize * rows);
    writeln!(file, "P6 {width} {height} 255").expect("written");
    for y in 0..height {
        for x in 0..width {
            let (column, row) = (x / w as usize, y / h as usize);
            let layer = (column / AZIMUTHS * ELEVATIONS + row) * AZIMUTHS + column % AZIMUTHS;
            let at = (y % h as usize) * w as usize + x % w as usize;
            let [r, g, b, a] = layers.layer(0, layer as u32)[at];
            let over = |c: u8| if a >= 128 { c } else { 110 };
            file.write_all(&[over(r), over(g), over(b)]).expect("written");
        }
    }
}

#[test]
#[ignore = "writes pictures to look at"]
fn pictures() {
    let field = grown(&FieldDesc { density: 400.0, ..Default::default() }, 50.0);
    let start = std::time::Instant::now();
    let stands = Stands::of(&field);
    println!("stands {:?}", start.elapsed());
    let baked = clusters(&stands);
    println!("clusters {:?}", start.elapsed());
    let canopy = canopy(&stands, Some(&baked));
    println!("canopy {:?}", start.elapsed());
    println!("{} m wide, {} m high", baked.size.radius, baked.size.height);
    println!("{:#?} {:#?}", canopy.size, canopy.pose);
    println!("periods {:?}", stands.stands.iter().map(|s| s.period).collect::<Vec<_>>());
    sheet(&baked.color, "/tmp/bake_color.ppm");
    sheet(&baked.shape, "/tmp/bake_shape.ppm");
}

fn one_color(color: [f32; 3]) -> Species {
    let plain = ColorRange { from: color, to: color };
    Species { root_color: plain, tip_color: plain, ..Species::default() }
}

fn patch_of(species: Vec<Species>, density: f32) -> Field {
    grown(&FieldDesc { density, species, ..Default::default() }, 12.0)
}

/// Blades of one colour: the light that comes from all around has that colour, and the mean of the
/// brightness that ids give is 1.
#[test]
fn mean_albedo_is_the_blades() {
    let field = patch_of(vec![one_color([0.2, 0.4, 0.1])], 60.0);
    let stands = Stands::of(&field);
    let color = stands.means.colors[0];
    assert!((color / Vec3::new(0.2, 0.4, 0.1) - 1.0).abs().max_element() < 0.01, "{color}");
    let canopy = canopy(&stands, None);
    for row in canopy.rows {
        let [r, g, b, _] = row.rest.around;
        let off = (Vec3::new(r, g, b) / g / Vec3::new(0.5, 1.0, 0.25) - 1.0).abs().max_element();
        assert!(off < 0.01 && g < 0.4, "{:?}", row.rest.around);
    }
}

/// Upright rectangles that hide each other at random: by Beer and Lambert's law the ground shows
/// through with a share of `exp(-area seen / area of ground)`.
#[test]
fn coverage_is_beer_and_lamberts() {
    let species = Species {
        shape: Shape::Quad,
        ridge: 0.0,
        droop: Range::new(0.0, 0.0),
        width_m: Range::new(0.01, 0.01),
        height_m: Range::new(0.3, 0.3),
        ..Species::default()
    };
    for density in [60.0, 200.0] {
        let field = patch_of(vec![species.clone()], density);
        let canopy = field.canopy();
        for row in 1..ROWS - 1 {
            let sine = sine(row);
            // A plane that stands any way shows 2 / pi of its width
            let across = 0.3 * 0.01 * 2.0 / std::f32::consts::PI * (1.0 - sine * sine).sqrt();
            let expected = 1.0 - (-density * across / sine).exp();
            let found = canopy.coverage(sine);
            assert!((found - expected).abs() < 0.03, "{density}, {sine}: {found} of {expected}");
        }
    }
}

/// A cluster shows as much as its blades: from the side, the pictures' coverage is that of 32
/// rectangles which hide each other at random.
#[test]
fn clusters_cover_what_their_blades_do() {
    let field = patch_of(vec![Species::default()], 300.0);
    let stands = Stands::of(&field);
    let baked = clusters(&stands);
    assert_eq!(baked.color.count as usize, VARIANTS * ELEVATIONS * AZIMUTHS);
    for level in 0..baked.color.levels.len() {
        let mean = |elevation: u32| {
            let layers = (0..baked.color.count).filter(|l| l / 4 % 4 == elevation);
            let texels: Vec<_> = layers.flat_map(|l| baked.color.layer(level, l)).collect();
            texels.iter().map(|t| f32::from(t[3])).sum::<f32>() / (255 * texels.len()) as f32
        };
        let (side, top) = (mean(0), mean(3));
        let window = 2.0 * baked.size.radius * baked.size.height;
        let leaves = CLUSTER_BLADES as f32 * stands.means.area;
        let most = leaves * 0.64 / window;
        assert!(side < most && side > 0.5 * most, "level {level}: {side} of {most}");
        assert!(top < side, "less shows from above: {top}");
    }
}

#[test]
fn a_bake_is_the_same_for_any_number_of_threads() {
    let field = patch_of(vec![Species::default(), one_color([0.3, 0.1, 0.1])], 150.0);
    let bake = || {
        let stands = Stands::of(&field);
        let baked = clusters(&stands);
        (canopy(&stands, Some(&baked)), baked)
    };
    let pool = |n| rayon::ThreadPoolBuilder::new().num_threads(n).build().expect("threads");
    assert!(pool(1).install(bake) == pool(3).install(bake));
}

/// One blade, and blades all at one place, have a look too.
#[test]
fn small_fields_are_baked() {
    let blade = crate::grow::Blade {
        root: Vec3::new(5.0, 1.0, -3.0),
        up: Vec3::new(0.0, -1.0, 0.0),
        facing: 1.0,
        height: 0.4,
        width: 0.01,
        response: 5.0,
        species: 0,
    };
    for count in [1, 2, 5, 70] {
        let (metric, order) = Default::default();
        let species = vec![Species::default()];
        let field =
            Field::from_blades(species, &vec![blade; count], 64, metric, order).expect("a field");
        let stands = Stands::of(&field);
        let baked = clusters(&stands);
        assert_eq!(baked.color.count as usize, VARIANTS * ELEVATIONS * AZIMUTHS);
        assert!(baked.size.radius.is_finite() && baked.size.height > 0.3, "{}", baked.size.height);
        let canopy = canopy(&stands, Some(&baked));
        assert!(bytemuck::cast_slice::<_, f32>(&[canopy]).iter().all(|x| x.is_finite()));
    }
}

#[test]
fn fields_together_cover_more_than_each() {
    let tall = patch_of(vec![one_color([0.1, 0.5, 0.1])], 100.0).canopy();
    let low = Species { height_m: Range::new(0.05, 0.06), ..one_color([0.5, 0.1, 0.1]) };
    let low = patch_of(vec![low], 100.0).canopy();
    let both = crate::Canopy::together(&[tall, low]);
    for sine in [0.05, 0.3, 1.0] {
        let expected = 1.0 - (1.0 - tall.coverage(sine)) * (1.0 - low.coverage(sine));
        assert!((both.coverage(sine) - expected).abs() < 0.01);
    }
    let [r, g, _] = both.color();
    assert!(g > r, "the taller shows more");
    assert_eq!(crate::Canopy::together(&[tall]), tall);
    assert_eq!(crate::Canopy::together(&[]).coverage(0.1), 0.0);
}

/// Plants of quads stand in a bake as what they are: their colours, and no more of them than shows.
#[test]
fn plants_of_quads_are_baked_as_they_look() {
    use crate::Plant;
    let looks = |plant, density| {
        let species = vec![Species::plant(plant)];
        grown(&FieldDesc { density, species, ..Default::default() }, 12.0).canopy()
    };
    let [grass, poppies] = [Plant::MeadowGrass, Plant::Poppy].map(|plant| looks(plant, 20.0));
    let redness = |canopy: &crate::Canopy| canopy.color()[0] / canopy.color()[1];
    assert!(redness(&grass) < 0.95, "{:?}", grass.color());
    assert!(redness(&poppies) > 1.3 * redness(&grass), "{:?}", poppies.color());
    // A box of 0.3 by 0.27 m each, of which leaves fill a third, would hide all from low down
    let field = patch_of(vec![Species::plant(Plant::MeadowGrass)], 20.0);
    let stands = Stands::of(&field);
    let baked = clusters(&stands);
    let alpha = |layer: u32| {
        let texels = baked.color.layer(0, layer);
        texels.iter().map(|t| f32::from(t[3])).sum::<f32>() / (255 * texels.len()) as f32
    };
    let side = (0..AZIMUTHS as u32).map(alpha).sum::<f32>() / AZIMUTHS as f32;
    assert!((0.2..0.9).contains(&side), "{side}");
    for sine in [0.1, 0.3, 1.0] {
        assert!(grass.coverage(sine) > looks(Plant::MeadowGrass, 4.0).coverage(sine) + 0.02);
    }
}
