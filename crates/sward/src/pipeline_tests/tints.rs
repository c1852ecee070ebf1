//! Colours of the surface on the GPU: the right blade's, on every page, and in the picture.

use super::drawing::draw;
use super::pages::small;
use super::rig::{Rig, shared};
use super::scenes::{SIZE, breeze, look, no_culling};
use crate::{ColorMap, Field, FieldDesc, Frame, Mesh, Species, Surface, View};
use glam::{UVec2, Vec2, Vec3};

/// Red on the left, green on the right.
fn halves(count: u64, color_mix: f32) -> Field {
    let mut mesh = Mesh::plane(Vec2::splat(4.0), UVec2::new(40, 1)).expect("a plane");
    let color = |p: &Vec3| if p.x < -0.1 { [1.0, 0.0, 0.0, 1.0] } else { [0.0, 1.0, 0.0, 1.0] };
    mesh.colors = mesh.positions.iter().map(color).collect();
    let surface = Surface::new(mesh).expect("a plane");
    let color_map = Some(ColorMap::VertexColor);
    let species = vec![Species { width_m: crate::Range::new(0.05, 0.06), ..Species::default() }];
    let desc =
        FieldDesc { count: Some(count), color_map, color_mix, species, ..Default::default() };
    Field::grow(&surface, &desc).expect("it grows")
}

#[test]
fn every_page_holds_its_own_blades_colours() {
    let field = halves(7000, 1.0);
    let rig = Rig::on(small(1 << 15), field.clone());
    let pages = rig.renderer.pages();
    assert_eq!(pages.len(), 4);
    let mut held = Vec::new();
    for page in pages {
        held.extend(rig.read::<u32>(&page.tints));
    }
    assert_eq!(held, field.tints());
    let mut plain = Rig::on(shared(), super::scenes::random_field(1, 700, 2.0, 64));
    let bytes = plain.renderer.gpu_bytes();
    assert_eq!(plain.page(0).tints.size(), 4, "a field without a map holds one word");
    plain.replace(halves(700, 1.0));
    assert!(plain.renderer.gpu_bytes() + 1000 > bytes);
}

/// Means of the picture's left and right third, away from where the colours blend.
fn thirds(rig: &mut Rig) -> [Vec3; 2] {
    let above = View { culling: no_culling(), ..look(Vec3::new(0.0, 4.0, 0.01), Vec3::ZERO) };
    rig.step(&Frame::new(0.0, &breeze()), &[above]);
    let picture = draw(rig, 0);
    let mean = |from: u32, to: u32| {
        let own = (0..picture.len()).filter(|i| (from..to).contains(&(*i as u32 % SIZE[0])));
        own.map(|i| {
            Vec3::from(
                picture[i][..3]
                    .iter()
                    .map(|c| f32::from(*c))
                    .collect::<Vec<_>>()
                    .try_into()
                    .unwrap_or([0.0; 3]),
            )
        })
        .sum::<Vec3>()
    };
    [mean(0, SIZE[0] / 3), mean(2 * SIZE[0] / 3, SIZE[0])]
}

#[test]
fn blades_show_the_colour_of_their_ground() {
    let mut rig = Rig::new(halves(4000, 1.0));
    let [left, right] = thirds(&mut rig);
    assert!(left.x > 3.0 * left.y, "red on the left: {left}");
    assert!(right.y > 3.0 * right.x, "green on the right: {right}");
    rig.replace(halves(4000, 0.0));
    let [left, right] = thirds(&mut rig);
    let share = left.x / left.y;
    assert!(share < 1.5 && (share - right.x / right.y).abs() < 0.2, "{left} {right}");
}
