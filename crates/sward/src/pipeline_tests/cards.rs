//! Corners and pictures of clusters' cards in the shipped shader, against their reference.

use super::ask::{Asked, on_gpu};
use crate::bake::cards::{Cards, Size};
use crate::gpu::layout::{GpuCanopy, GpuPage};
use crate::gpu::shaders::Shader;
use crate::shared::noise_twin::{hash_u32, hash01};
use bytemuck::bytes_of;
use glam::{DVec3, Vec3};
use std::f64::consts::FRAC_PI_2;

const ENTRIES: &str = "
@compute @workgroup_size(64)
fn tell_card(@builtin(global_invocation_id) thread: vec3<u32>) {
    if thread.x < arrayLength(&asked) {
        let at = asked[thread.x];
        let facing = facing_of(at[0].xyz, at[1].xyz);
        let corner = card_corner(
            thread.x % 4u, facing, at[0].xyz, at[0].w, at[1].w, at[2].w, at[2].xyz);
        let elevation = asin(clamp(facing.sine, 0.0, 1.0)) * (3.0 / 1.5707963);
        told[thread.x] = vec4<f32>(corner, f32(picture_of(thread.x, elevation).layer));
    }
}

@compute @workgroup_size(64)
fn tell_wider(@builtin(global_invocation_id) thread: vec3<u32>) {
    if thread.x < arrayLength(&asked) {
        let at = asked[thread.x][0];
        let facing = facing_of(vec3<f32>(0.0, 1.0, 0.0), vec3<f32>(cos(at.x), sin(at.x), 0.0));
        let elevation = at.x * (3.0 / 1.5707963);
        let wide = wider(elevation, facing, vec3<f32>(0.0), at.y, at.z);
        told[thread.x] = vec4<f32>(wide, picture_of(thread.x, elevation).alpha, 0.0, 0.0);
    }
}
";

/// A card through a cylinder about `up`, seen from `to_eye`; the directions are unit vectors.
struct Card {
    up: DVec3,
    to_eye: DVec3,
    radius: f64,
    height: f64,
    widened: f64,
    /// In heights.
    sway: DVec3,
}

impl Card {
    /// Towards the eye along the ground.
    fn toward(&self) -> DVec3 {
        self.to_eye.reject_from_normalized(self.up).normalize()
    }

    /// From the cylinder's near foot to its far top.
    fn corner(&self, corner: u32) -> DVec3 {
        let side = if corner % 2 == 1 { 1.0 } else { -1.0 } * self.radius * self.widened;
        let across = self.up.cross(self.toward()) * side;
        match corner / 2 {
            0 => across + self.toward() * self.radius,
            _ => across - self.toward() * self.radius + (self.up + self.sway) * self.height,
        }
    }

    /// One of 4 places by 4 elevations by 4 sides.
    fn picture(&self, id: u32) -> u32 {
        let elevation = self.up.dot(self.to_eye).clamp(0.0, 1.0).asin() / FRAC_PI_2 * 3.0;
        let (below, above) =
            cards(&GpuCanopy::empty()).drawn_from((elevation / 3.0 * FRAC_PI_2) as f32);
        let row = below as u32 + u32::from(hash01(id, 51) < above);
        (hash_u32(id) % 4 * 4 + row) * 4 + hash_u32(id ^ 0x5bd1) % 4
    }
}

const SIZE: Size = Size { radius: 0.6, height: 1.1 };
const COVER: [f32; 7] = [0.4, 0.37, 0.33, 0.3, 0.24, 0.2, 0.11];
const DENSE: f32 = 0.7;

fn cards(canopy: &GpuCanopy) -> Cards<'_> {
    Cards { size: SIZE, cover: &COVER, dense: DENSE, canopy }
}

/// The uniforms of a field whose clusters are these.
fn uniforms() -> (GpuPage, GpuCanopy) {
    let mut page: GpuPage = bytemuck::Zeroable::zeroed();
    page.field.cluster = [1.0, SIZE.radius, SIZE.height, 0.02];
    let mut canopy = GpuCanopy::empty();
    for (look, cover) in canopy.cards.iter_mut().zip(COVER) {
        look[3] = cover;
    }
    canopy.cards[7][0] = DENSE;
    (page, canopy)
}

fn draw(i: u32, salt: u32) -> f32 {
    hash01(i, 200 + salt)
}

fn direction(i: u32, salt: u32) -> Vec3 {
    let part = |k| draw(i, salt + k) - 0.5;
    Vec3::new(part(0), part(1), part(2)).normalize()
}

fn card(i: u32) -> (Asked, Card) {
    let up = if i.is_multiple_of(3) { Vec3::Y } else { direction(i, 1) };
    let eye = direction(i, 4);
    // From above the ground, and not straight above, where any direction will do
    let eye = if eye.dot(up) < 0.0 { -eye } else { eye };
    let to_eye = if eye.dot(up) > 0.99 { up.any_orthonormal_vector() } else { eye };
    let [radius, height, wide] = [5, 6, 7].map(|salt| 0.2 + draw(i, salt));
    let sway = direction(i, 8) * draw(i, 11);
    let asked = [
        up.extend(radius).to_array(),
        to_eye.extend(height).to_array(),
        sway.extend(wide).to_array(),
        [0.0; 4],
        [0.0; 4],
    ];
    let [radius, height, widened] = [radius, height, wide].map(f64::from);
    let [up, to_eye, sway] = [up, to_eye, sway].map(|v| v.as_dvec3());
    (asked, Card { up, to_eye, radius, height, widened, sway })
}

#[test]
fn cards_equal_their_reference() {
    let (asked, cards): (Vec<_>, Vec<_>) = (0..4000).map(card).unzip();
    let (page, canopy) = uniforms();
    let given = [(1, 0, bytes_of(&page)), (2, 4, bytes_of(&canopy))];
    let told = on_gpu((Shader::DrawCluster, ENTRIES, "tell_card"), &asked, &given);
    let mut pictures = [0; 64];
    for ((i, told), card) in (0..).zip(told).zip(&cards) {
        let error = Vec3::from_slice(&told).as_dvec3().distance(card.corner(i % 4));
        assert!(error < 1e-5, "{i}: {error:e} of {:?}", asked[i as usize]);
        pictures[told[3] as usize] += i32::from(told[3] as u32 == card.picture(i));
    }
    // The sine's rounding may tip a picture into the next row
    assert!(pictures.iter().sum::<i32>() > 3990, "{pictures:?}");
    assert!(pictures.iter().all(|count| *count > 0), "{pictures:?}");
}

/// How much wider they are drawn; and alpha keeps what pictures of other elevations cover in the mean.
#[test]
fn widths_equal_their_reference() {
    let (page, canopy) = uniforms();
    let given = [(1, 0, bytes_of(&page)), (2, 4, bytes_of(&canopy))];
    let at = |i: u32| (0.02 + 1.54 * draw(i, 1), 12.0 * draw(i, 2).powi(3), draw(i, 3));
    let ask = |i: u32| [[at(i).0, at(i).1, at(i).2, 0.0], [0.0; 4], [0.0; 4], [0.0; 4], [0.0; 4]];
    let asked: Vec<Asked> = (0..2000).map(ask).collect();
    let told = on_gpu((Shader::DrawCluster, ENTRIES, "tell_wider"), &asked, &given);
    let mut between = 0;
    for (i, told) in (0..).zip(told) {
        let (angle, blades, grown) = at(i);
        let expected = cards(&canopy).wider(angle, blades, grown);
        assert!((told[0] - expected).abs() < 1e-3, "{angle}, {blades}: {told:?}, {expected}");
        between += i32::from(expected > 1.0 && expected < 1.5);
        assert!((told[1] - 1.0).abs() < 0.25, "{angle}: {told:?}");
    }
    assert!(between > 50, "{between}");
}

/// On the screen it reaches from the cylinder's lowest point to its highest, and stays above the ground.
#[test]
fn a_card_covers_what_its_cylinder_does() {
    for (_, card) in (0..300).map(card) {
        let card = Card { sway: DVec3::ZERO, widened: 1.0, ..card };
        let up_screen = card.up.reject_from_normalized(card.to_eye);
        let right = card.up.cross(card.toward());
        let corners = [0, 1, 2, 3].map(|corner| card.corner(corner));
        assert!(corners.iter().all(|c| c.dot(card.up) > -1e-6));
        let rim = |turn: f64, top: f64| {
            let level = card.toward() * turn.cos() + right * turn.sin();
            level * card.radius + card.up * (top * card.height)
        };
        let points: Vec<_> =
            (0..64).flat_map(|i| [0.0, 1.0].map(|top| rim(f64::from(i) * 0.1, top))).collect();
        for axis in [up_screen, right] {
            let reach = |list: &[DVec3]| {
                let along = list.iter().map(|p| p.dot(axis));
                along.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)))
            };
            let (own, cylinder) = (reach(&corners), reach(&points));
            assert!((own.0 - cylinder.0).abs() < 0.01 && (own.1 - cylinder.1).abs() < 0.01);
        }
    }
}
