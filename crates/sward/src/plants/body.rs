//! Plants of quads as they stand in a field that is baked: triangles that do not turn to a viewer.

use super::kinds::model;
use super::model::{Model, Outline, Ribbon};
use super::{Look, Picture, Plant};
use crate::Form;
use crate::bake::mips::{chain, passing};
use crate::bake::{ALPHA_TEST, Corner, Triangle};
use glam::{Vec2, Vec3};
use std::f32::consts::{PI, TAU};

/// Pieces along a ribbon, fine and coarse.
const PIECES: [u32; 2] = [4, 2];
/// Pieces that an outline's area is measured with.
const EXACT: u32 = 24;
/// Texels a side of a picture, fine and coarse.
const TEXELS: [u32; 2] = [16, 8];
/// Sides of a round ribbon. A convex outline shows its perimeter over pi in the mean (Cauchy).
const SIDES: u32 = 3;

/// A plant's triangles. x, to the right, and z, forwards, are in widths of the plant, y in heights.
#[derive(Debug, Clone)]
pub(crate) struct Body {
    fine: Vec<Triangle>,
    coarse: Vec<Triangle>,
    /// Mean colour, by area.
    pub(crate) mean: Vec3,
}

/// Where a plant stands and how it is bent.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stance {
    /// Root, knee and tip of its middle line, metres.
    pub(crate) curve: [Vec3; 3],
    /// Unit up direction at its root.
    pub(crate) up: Vec3,
    /// Unit direction to its right.
    pub(crate) right: Vec3,
    /// Full width, metres.
    pub(crate) width: f32,
}

impl Body {
    /// The variants of a form; none where it has no quads.
    pub(crate) fn variants(form: &Form) -> Vec<Self> {
        let Form::Billboard(billboard) = form else { return Vec::new() };
        match &billboard.look {
            Look::Plant(plant) => {
                let own = |variant| Self::modelled(*plant, &model(*plant, u64::from(variant)));
                (0..super::layers::VARIANTS).map(own).collect()
            }
            Look::Picture(picture) => vec![Self::painted(picture, billboard.quads)],
        }
    }

    fn new(make: impl Fn(usize) -> Vec<Triangle>) -> Self {
        let (fine, coarse) = (make(0), make(1));
        let (mut area, mut sum) = (1e-12, Vec3::ZERO);
        for triangle in &fine {
            let [a, b, c] = triangle.map(|corner| corner.position);
            let own = (b - a).cross(c - a).length();
            area += own;
            sum += triangle.iter().map(|corner| corner.albedo).sum::<Vec3>() * (own / 3.0);
        }
        Self { fine, coarse, mean: sum / area }
    }

    fn modelled(plant: Plant, model: &Model) -> Self {
        let widths = Vec3::new(plant.width_share(), 1.0, plant.width_share()).recip();
        Self::new(|detail| {
            let mut list = Vec::new();
            for ribbon in &model.ribbons {
                add_ribbon(ribbon, PIECES[detail], &mut list);
            }
            list.iter_mut().flatten().for_each(|corner| corner.position *= widths);
            list
        })
    }

    /// As many quads as stand far off, each cut into the texels that show.
    fn painted(picture: &Picture, quads: u32) -> Self {
        let tile = picture.resampled(TEXELS[0]);
        let shown = passing(&tile);
        let levels = chain(tile, shown);
        let quads = quads.div_ceil(2).max(1);
        Self::new(|detail| {
            let mut list = Vec::new();
            let Some(tile) = levels.iter().find(|tile| tile.size == [TEXELS[detail]; 2]) else {
                return list;
            };
            for quad in 0..quads {
                let (sin, cos) = (PI * quad as f32 / quads as f32).sin_cos();
                let side = Vec3::new(cos, 0.0, -sin);
                let face = side.cross(Vec3::Y);
                let size = tile.size[0];
                for (index, texel) in (0..).zip(&tile.texels) {
                    if texel.alpha < ALPHA_TEST {
                        continue;
                    }
                    let place = Vec2::new((index % size) as f32, (index / size) as f32);
                    let corner = |x: f32, y: f32| {
                        let at = (place + Vec2::new(x, y)) / size as f32;
                        let high = 1.0 - at.y;
                        let n = texel.normal;
                        Corner {
                            position: side * (at.x - 0.5) + Vec3::Y * high,
                            normal: face * n.z.max(0.1),
                            round: side * n.x + Vec3::Y * n.y,
                            albedo: texel.albedo,
                            height_share: high,
                            thickness: texel.thickness,
                        }
                    };
                    let [a, b, c, d] =
                        [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].map(|(x, y)| corner(x, y));
                    list.extend([[a, b, c], [b, d, c]]);
                }
            }
            list
        })
    }

    /// Adds its triangles where it stands, its colours times `tone`; few ones for counting what shows.
    pub(crate) fn add(
        &self,
        stance: &Stance,
        tone: Vec3,
        is_coarse: bool,
        out: &mut Vec<Triangle>,
    ) {
        let own = if is_coarse { &self.coarse } else { &self.fine };
        out.extend(own.iter().map(|triangle| triangle.map(|corner| stance.place(corner, tone))));
    }
}

impl Stance {
    /// The twin of model.wgsl: along the curve, and turned by the shortest turn from up to it.
    fn place(&self, corner: Corner, tone: Vec3) -> Corner {
        let [root, knee, tip] = self.curve;
        let v = 1.0 - (1.0 - corner.position.y).clamp(0.0, 1.0).sqrt();
        let (a, b) = (root.lerp(knee, v), knee.lerp(tip, v));
        let along = (b - a).normalize_or(self.up);
        let forwards = self.right.cross(self.up);
        let over = (1.0 + self.up.dot(along)).max(1e-3);
        let turned = |own: Vec3| {
            let level = self.right * own.x + forwards * own.z;
            level - (self.up + along) * (level.dot(along) / over) + along * own.y
        };
        let level = corner.position.with_y(0.0);
        Corner {
            position: a.lerp(b, v) + turned(level) * self.width,
            normal: turned(corner.normal),
            round: turned(corner.round),
            albedo: corner.albedo * tone,
            ..corner
        }
    }
}

/// Mean share of the width along an outline, drawn in so many pieces.
fn mean_width(outline: Outline, pieces: u32) -> f32 {
    let at = |k: u32| outline.at(k as f32 / pieces as f32);
    (0..pieces).map(|k| 0.5 * (at(k) + at(k + 1))).sum::<f32>() / pieces as f32
}

/// Adds a ribbon in so many pieces, as wide in the mean as it is in many.
fn add_ribbon(ribbon: &Ribbon, pieces: u32, out: &mut Vec<Triangle>) {
    let exact = mean_width(ribbon.outline, EXACT);
    let wider = (exact / mean_width(ribbon.outline, pieces).max(1e-6)).clamp(0.5, 2.0);
    let ring = |k: u32| {
        let v = k as f32 / pieces as f32;
        let (center, along) = (ribbon.point(v), ribbon.along(v));
        let width = ribbon.width_at(v) * wider;
        let corner = |out: Vec3, normal: Vec3, round: Vec3| Corner {
            position: center + out,
            normal,
            round,
            albedo: ribbon.color(v),
            height_share: (center + out).y.clamp(0.0, 1.0),
            thickness: ribbon.thickness,
        };
        if ribbon.round {
            // From the middle to a corner of a regular outline of that perimeter
            let edge = PI * width / SIDES as f32;
            let reach = 0.5 * edge / (PI / SIDES as f32).sin();
            let first = ribbon.across(v, Vec3::Z);
            let other = first.cross(along);
            let at = |i: u32| {
                let (sin, cos) = (TAU * i as f32 / SIDES as f32).sin_cos();
                let out = first * cos + other * sin;
                corner(out * reach, out, Vec3::ZERO)
            };
            return (0..=SIDES).map(at).collect::<Vec<_>>();
        }
        let across = ribbon.across(v, Vec3::Z);
        let normal = across.cross(along);
        [-1.0, 1.0].map(|side| corner(across * (0.5 * side * width), normal, Vec3::ZERO)).to_vec()
    };
    let mut low = ring(0);
    for k in 1..=pieces {
        let high = ring(k);
        for side in 1..low.len() {
            let (a, b, c, d) = (low[side - 1], low[side], high[side - 1], high[side]);
            out.extend([[a, b, c], [b, d, c]]);
        }
        low = high;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Billboard;
    use crate::bake::raster::Window;

    fn upright() -> Stance {
        let curve = [Vec3::ZERO, Vec3::Y, Vec3::Y];
        Stance { curve, up: Vec3::Y, right: Vec3::X, width: 1.0 }
    }

    /// Share of the plant's box that shows from a side.
    fn cover(triangles: &[Triangle], turned: f32) -> f32 {
        let (sin, cos) = turned.sin_cos();
        let window = Window {
            center: Vec3::Y * 0.5,
            right: Vec3::new(cos, 0.0, -sin),
            up: Vec3::Y,
            half: Vec2::new(0.5, 0.5),
            size: [128; 2],
            samples: 2,
        };
        window.see(triangles).coverage()
    }

    /// From all around it covers what its pictures do, fine and coarse.
    #[test]
    fn bodies_cover_what_their_pictures_do() {
        for plant in Plant::ALL {
            let bodies = Body::variants(&Form::Billboard(Billboard::new(plant)));
            assert_eq!(bodies.len(), super::super::layers::VARIANTS as usize);
            let (mut own, mut few, mut painted) = (0.0, 0.0, 0.0);
            for (body, seed) in bodies.iter().zip(0..) {
                let list = |is_coarse| {
                    let mut list = Vec::new();
                    body.add(&upright(), Vec3::ONE, is_coarse, &mut list);
                    list
                };
                let (fine, coarse) = (list(false), list(true));
                assert!(coarse.len() < fine.len());
                for view in 0..3 {
                    let turned = view as f32 * TAU / 6.0;
                    own += cover(&fine, turned);
                    few += cover(&coarse, turned);
                    let angle = super::super::layers::view_angle(view);
                    painted += super::super::paint::paint(plant, seed, angle, 128).coverage();
                }
            }
            println!("{}: {:.3}, {:.3}", plant.name(), own / painted, few / painted);
            assert!((own / painted - 1.0).abs() < 0.06, "{}: {}", plant.name(), own / painted);
            assert!((few / painted - 1.0).abs() < 0.15, "{}: {}", plant.name(), few / painted);
        }
    }

    /// A picture whose left half is there covers half of a quad that faces the viewer.
    #[test]
    fn pictures_are_cut_to_what_shows() {
        let texels: Vec<u8> =
            (0..64 * 64).flat_map(|i| [40, 160, 20, if i % 64 < 32 { 255 } else { 0 }]).collect();
        let picture = Picture::new([64; 2], texels).expect("a picture");
        let form = Form::Billboard(Billboard { quads: 1, ..Billboard::new(picture) });
        let [body] = &Body::variants(&form)[..] else { panic!("one variant") };
        for is_coarse in [false, true] {
            let mut list = Vec::new();
            body.add(&upright(), Vec3::ONE, is_coarse, &mut list);
            assert!((cover(&list, 0.0) - 0.5).abs() < 0.05, "{}", cover(&list, 0.0));
            assert!(list.iter().flatten().all(|c| c.position.x < 0.05));
        }
        assert!(body.mean.y > body.mean.x && body.mean.x > body.mean.z);
        assert!(Body::variants(&Form::default()).is_empty());
    }
}
