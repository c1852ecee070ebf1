//! A software rasteriser: triangles, seen in parallel, to texels. One thread a picture, so that the
//! result does not depend on how many there are.

use super::{Corner, Triangle};
use glam::{Vec2, Vec3};

/// What a picture shows: a rectangle across the direction of view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Window {
    /// Its middle, metres.
    pub center: Vec3,
    /// Unit direction to the right in the picture.
    pub right: Vec3,
    /// Unit direction up in the picture.
    pub up: Vec3,
    /// Half its width and height, metres.
    pub half: Vec2,
    /// Texels; row 0 is the top.
    pub size: [u32; 2],
    /// Samples a side of a texel, so that a texel has the square of it.
    pub samples: u32,
}

/// What a texel holds: means over what covers it, and how much of it is covered.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Texel {
    /// Linear reflectance.
    pub albedo: Vec3,
    /// Share that is covered, 0..=1.
    pub alpha: f32,
    /// On the eye's side; of unit length, or 0 where nothing is known.
    pub normal: Vec3,
    /// 0 at the root, 1 at the tip.
    pub height_share: f32,
    /// What light passes on its way through all that lies here, relative to a blade of grass.
    pub thickness: f32,
}

impl Texel {
    /// Nothing.
    pub(crate) const EMPTY: Self = Self {
        albedo: Vec3::ZERO,
        alpha: 0.0,
        normal: Vec3::ZERO,
        height_share: 0.0,
        thickness: 0.0,
    };
}

/// A picture.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tile {
    /// Texels.
    pub size: [u32; 2],
    /// Row by row from the top.
    pub texels: Vec<Texel>,
}

/// What shows at one sample.
#[derive(Debug, Clone, Copy)]
struct Hit {
    /// Along the direction to the eye; larger is nearer.
    depth: f32,
    /// `u32::MAX` is none.
    triangle: u32,
    weights: Vec3,
}

/// Triangles that are looked for together: about those of a blade.
const GROUP: usize = 16;

const NONE: Hit = Hit { depth: f32::NEG_INFINITY, triangle: u32::MAX, weights: Vec3::ZERO };

/// A triangle in the picture, in samples, with depths, and its box.
#[derive(Debug, Clone, Copy)]
struct Flat {
    corners: [Vec3; 3],
    low: Vec2,
    high: Vec2,
}

/// Triangles seen through a window, sample by sample.
#[derive(Debug)]
pub(crate) struct Seen<'a> {
    window: Window,
    triangles: &'a [Triangle],
    hits: Vec<Hit>,
    /// Thickness of all that covers a sample.
    thickness: Vec<f32>,
}

impl Window {
    /// Unit direction to the eye.
    pub(crate) fn to_eye(self) -> Vec3 {
        self.right.cross(self.up)
    }

    /// Samples a row and a column.
    fn grid(&self) -> [u32; 2] {
        self.size.map(|n| n * self.samples)
    }

    /// Place in samples, and depth: nearer is larger.
    fn project(&self, point: Vec3) -> Vec3 {
        let [width, height] = self.grid().map(|n| n as f32 * 0.5);
        let from = point - self.center;
        let place = Vec2::new(from.dot(self.right), -from.dot(self.up)) / self.half;
        Vec3::new((place.x + 1.0) * width, (place.y + 1.0) * height, from.dot(self.to_eye()))
    }

    fn flatten(&self, triangle: &Triangle) -> Flat {
        let corners = triangle.map(|corner| self.project(corner.position));
        let [a, b, c] = corners.map(Vec3::truncate);
        Flat { corners, low: a.min(b).min(c), high: a.max(b).max(c) }
    }

    /// Whether a part of it may lie in the picture.
    fn shows(&self, flat: &Flat, by: Vec2) -> bool {
        let [width, height] = self.grid().map(|n| n as f32);
        (flat.high + by).cmpge(Vec2::ZERO).all()
            && (flat.low + by).cmple(Vec2::new(width, height)).all()
    }

    /// Looks at triangles.
    pub(crate) fn see<'a>(&self, triangles: &'a [Triangle]) -> Seen<'a> {
        self.see_copies(triangles, &[Vec3::ZERO])
    }

    /// Looks at copies of triangles, each moved by an offset; the nearest copies should come first.
    pub(crate) fn see_copies<'a>(&self, triangles: &'a [Triangle], offsets: &[Vec3]) -> Seen<'a> {
        let count = self.grid().map(|n| n as usize).iter().product();
        let (hits, thickness) = (vec![NONE; count], vec![0.0; count]);
        let mut seen = Seen { window: *self, triangles, hits, thickness };
        let here = self.project(Vec3::ZERO);
        let flat: Vec<Flat> = triangles.iter().map(|t| self.flatten(t)).collect();
        let boxes: Vec<Flat> = flat.chunks(GROUP).map(around).collect();
        let nearest =
            flat.iter().flat_map(|f| f.corners).fold(f32::NEG_INFINITY, |n, c| n.max(c.z));
        for (copy, offset) in offsets.iter().enumerate() {
            let by = self.project(*offset) - here;
            // What is left lies behind all that is seen
            if copy % 4 == 3 && seen.hits.iter().all(|hit| hit.depth > nearest + by.z) {
                break;
            }
            let near = |i: &usize| self.shows(&boxes[*i], by.truncate());
            let groups = (0..boxes.len()).filter(near);
            for index in groups.flat_map(|i| i * GROUP..flat.len().min((i + 1) * GROUP)) {
                let flat = &flat[index];
                if self.shows(flat, by.truncate()) {
                    seen.add(index as u32, flat.corners.map(|corner| corner + by));
                }
            }
        }
        seen
    }
}

/// The box about several.
fn around(several: &[Flat]) -> Flat {
    let low = several.iter().map(|flat| flat.low).fold(Vec2::INFINITY, Vec2::min);
    let high = several.iter().map(|flat| flat.high).fold(Vec2::NEG_INFINITY, Vec2::max);
    Flat { corners: [Vec3::ZERO; 3], low, high }
}

/// Where in the picture a sample lies: shifted from row to row and from column to column, or edges
/// along the grid would all be off the same way.
fn sample_place(x: u32, y: u32) -> Vec2 {
    const GOLDEN: f32 = 0.618_034;
    let shift = |i: u32| (i as f32 * GOLDEN).fract();
    Vec2::new(x as f32 + shift(y), y as f32 + shift(x))
}

/// Whether what lies on an edge belongs to its triangle, and not to the one across.
fn owns(from: Vec2, to: Vec2, area: f32) -> bool {
    let along = (to - from) * area.signum();
    along.y > 0.0 || along.y == 0.0 && along.x < 0.0
}

impl Seen<'_> {
    fn add(&mut self, index: u32, [a, b, c]: [Vec3; 3]) {
        let triangle = &self.triangles[index as usize];
        let cross = |p: Vec2, q: Vec2| p.perp_dot(q);
        let (p, q, r) = (a.truncate(), b.truncate(), c.truncate());
        let area = cross(q - p, r - p);
        if !area.is_finite() || area == 0.0 {
            return;
        }
        let [width, height] = self.window.grid();
        let (low, high) = (p.min(q).min(r), p.max(q).max(r));
        // A sample lies anywhere in its cell; the conversions saturate
        let range = |low: f32, high: f32, end: u32| {
            low.floor().max(0.0) as u32..(high.floor() + 1.0).clamp(0.0, end as f32) as u32
        };
        let owned = [owns(q, r, area), owns(r, p, area), owns(p, q, area)];
        let depth = Vec3::new(a.z, b.z, c.z);
        for y in range(low.y, high.y, height) {
            for x in range(low.x, high.x, width) {
                let s = sample_place(x, y);
                let weights =
                    Vec3::new(cross(r - q, s - q), cross(p - r, s - r), cross(q - p, s - p)) / area;
                let inside = |i: usize| weights[i] > 0.0 || weights[i] == 0.0 && owned[i];
                if !(inside(0) && inside(1) && inside(2)) {
                    continue;
                }
                let at = (y * width + x) as usize;
                self.thickness[at] += weights.dot(Vec3::from(triangle.map(|k| k.thickness)));
                let hit = Hit { depth: weights.dot(depth), triangle: index, weights };
                if hit.depth > self.hits[at].depth {
                    self.hits[at] = hit;
                }
            }
        }
    }

    /// What shows at a hit, its normal turned to the eye.
    fn surface(&self, hit: &Hit) -> Option<Corner> {
        let corners = self.triangles.get(hit.triangle as usize)?;
        let mix = |part: &dyn Fn(&Corner) -> Vec3| {
            part(&corners[0]) * hit.weights.x
                + part(&corners[1]) * hit.weights.y
                + part(&corners[2]) * hit.weights.z
        };
        let to_eye = self.window.to_eye();
        // Each corner's for itself, as the vertices of a drawn blade are turned
        let turned =
            |c: &Corner| c.round + if c.normal.dot(to_eye) < 0.0 { -c.normal } else { c.normal };
        let rest = mix(&|c| Vec3::new(c.height_share, c.thickness, 0.0));
        Some(Corner {
            position: mix(&|c| c.position),
            normal: mix(&turned).normalize_or(to_eye),
            round: Vec3::ZERO,
            albedo: mix(&|c| c.albedo),
            height_share: rest.x,
            thickness: rest.y,
        })
    }

    /// Every sample that something covers, and the number of the triangle.
    pub(crate) fn surfaces(&self) -> impl Iterator<Item = (usize, Corner)> + '_ {
        self.hits.iter().filter_map(|hit| Some((hit.triangle as usize, self.surface(hit)?)))
    }

    /// Share of the window that is covered.
    pub(crate) fn coverage(&self) -> f32 {
        let covered = self.hits.iter().filter(|hit| hit.triangle != u32::MAX).count();
        covered as f32 / self.hits.len().max(1) as f32
    }

    /// The picture, its colours spread into the texels that are empty.
    pub(crate) fn tile(&self) -> Tile {
        let [width, height] = self.window.size;
        let texels = (0..height)
            .flat_map(|y| (0..width).map(move |x| (x, y)))
            .map(|(x, y)| self.texel(x, y))
            .collect();
        let mut tile = Tile { size: self.window.size, texels };
        tile.dilate();
        tile
    }

    fn texel(&self, x: u32, y: u32) -> Texel {
        let (side, row) = (self.window.samples, self.window.grid()[0]);
        let mut sum = Texel::EMPTY;
        for at in (0..side).flat_map(|j| (0..side).map(move |i| (i, j))) {
            let at = ((y * side + at.1) * row + x * side + at.0) as usize;
            let Some(surface) = self.surface(&self.hits[at]) else { continue };
            sum.albedo += surface.albedo;
            sum.normal += surface.normal;
            sum.height_share += surface.height_share;
            sum.thickness += self.thickness[at];
            sum.alpha += 1.0;
        }
        sum.mean((side * side) as f32)
    }
}

impl Texel {
    /// Of a sum over the covered of so many samples, whose alpha counts them.
    fn mean(self, samples: f32) -> Self {
        if self.alpha <= 0.0 {
            return Self::EMPTY;
        }
        Self {
            albedo: self.albedo / self.alpha,
            normal: self.normal.normalize_or_zero(),
            height_share: self.height_share / self.alpha,
            thickness: self.thickness / self.alpha,
            alpha: self.alpha / samples,
        }
    }

    /// What takes a place in a sum, weighted by how much it covers.
    fn weighted(&self) -> Self {
        Self {
            albedo: self.albedo * self.alpha,
            normal: self.normal * self.alpha,
            height_share: self.height_share * self.alpha,
            thickness: self.thickness * self.alpha,
            alpha: self.alpha,
        }
    }
}

impl Tile {
    /// Share that is covered: the mean alpha.
    pub(crate) fn coverage(&self) -> f32 {
        let sum: f64 = self.texels.iter().map(|t| f64::from(t.alpha)).sum();
        (sum / self.texels.len().max(1) as f64) as f32
    }

    /// At half the size, each texel the mean of four, weighted by what they cover. An odd last row
    /// or column counts twice.
    pub(crate) fn halved(&self) -> Self {
        let [width, height] = self.size;
        let size = [(width / 2).max(1), (height / 2).max(1)];
        let pick = |x: u32, y: u32| {
            self.texels[(y.min(height - 1) * width + x.min(width - 1)) as usize].weighted()
        };
        let texel = |x: u32, y: u32| {
            let mut sum = Texel::EMPTY;
            for part in [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| pick(2 * x + i, 2 * y + j)) {
                sum.albedo += part.albedo;
                sum.normal += part.normal;
                sum.height_share += part.height_share;
                sum.thickness += part.thickness;
                sum.alpha += part.alpha;
            }
            sum.mean(4.0)
        };
        let texels =
            (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))).map(|(x, y)| texel(x, y));
        Self { size, texels: texels.collect() }
    }

    /// Empty texels take the colour of what is nearest to them, level by level: else filtering
    /// would mix the empty ones' black into the rims. Alpha stays.
    pub(crate) fn dilate(&mut self) {
        if self.size == [1, 1] || self.texels.iter().all(|t| t.alpha > 0.0) {
            return;
        }
        let mut coarse = self.halved();
        coarse.dilate();
        let [width, _] = self.size;
        for (index, texel) in self.texels.iter_mut().enumerate() {
            if texel.alpha > 0.0 {
                continue;
            }
            let (x, y) = (index as u32 % width / 2, index as u32 / width / 2);
            let from = y.min(coarse.size[1] - 1) * coarse.size[0] + x.min(coarse.size[0] - 1);
            *texel = Texel { alpha: 0.0, ..coarse.texels[from as usize] };
        }
    }
}
