//! The CPU reference of sweep.wgsl, in f64; and brute force: which cells the frustum truly meets.

use super::grid::Grid;
use super::plan::{GpuSweep, SweepMethod, ground_corner};
use crate::View;
use glam::{DMat4, DVec2, DVec3, DVec4};

/// A view and what it sweeps.
pub(crate) struct Swept {
    pub settings: GpuSweep,
    pub clip_from_world: DMat4,
}

impl Swept {
    pub(crate) fn new(settings: GpuSweep, view: &View) -> Self {
        // As it is uploaded: what is swept is what is drawn with
        let clip_from_world = (view.clip_from_view * view.view_from_world).as_dmat4();
        Self { settings, clip_from_world }
    }

    /// Inward planes, unit: left, right, bottom, top, near, far.
    pub(crate) fn planes(&self) -> [DVec4; 6] {
        let m = self.clip_from_world.transpose();
        let (x, y, z, w) = (m.x_axis, m.y_axis, m.z_axis, m.w_axis);
        [w + x, w - x, w + y, w - y, z, w - z].map(|plane| {
            let length = plane.truncate().length();
            if length > 1e-9 { plane / length } else { DVec4::W }
        })
    }

    fn column_x(&self, column: u32) -> DVec2 {
        let s = &self.settings;
        let x = f64::from(s.origin[0]) + f64::from(column) * f64::from(s.cell[0]);
        let margin = f64::from(s.margin[0]);
        DVec2::new(x - margin, x + f64::from(s.cell[0]) + margin)
    }

    /// The box of a cell with its margin, between the lowest and the highest plane.
    pub(crate) fn cell_box(&self, column: u32, row: u32) -> (DVec3, DVec3) {
        let s = &self.settings;
        let x = self.column_x(column);
        let z = f64::from(s.origin[1]) + f64::from(row) * f64::from(s.cell[1]);
        let margin = f64::from(s.margin[1]);
        let low = DVec3::new(x.x, s.low.into(), z - margin);
        (low, DVec3::new(x.y, s.high.into(), z + f64::from(s.cell[1]) + margin))
    }

    fn ring(&self, y: f64) -> [DVec2; 4] {
        let corner = |side, value| {
            let found = ground_corner(&self.clip_from_world, side, value, y);
            found.map_or(DVec2::NAN, |corner| corner.place)
        };
        let far = f64::from(self.settings.far_value);
        let [a, b, c, d] = [corner(-1., 0.), corner(1., 0.), corner(1., far), corner(-1., far)];
        let push = f64::from(self.settings.push);
        [a, b, c + (c - b) * push, d + (d - a) * push]
    }

    /// First row and rows of a column.
    pub(crate) fn rows(&self, column: u32) -> (u32, u32) {
        match self.settings.method() {
            SweepMethod::Corners => self.swept_rows(column),
            SweepMethod::EveryCell => self.tested_rows(column),
        }
    }

    fn swept_rows(&self, column: u32) -> (u32, u32) {
        let s = &self.settings;
        let x = self.column_x(column);
        let (below, above) = (self.ring(s.low.into()), self.ring(s.high.into()));
        let mut span = (f64::INFINITY, f64::NEG_INFINITY);
        for i in 0..4 {
            let next = (i + 1) % 4;
            for (a, b) in [(below[i], below[next]), (above[i], above[next]), (below[i], above[i])] {
                let part = edge_between(a, b, x);
                span = (span.0.min(part.0), span.1.max(part.1));
            }
        }
        for plane in &self.planes()[2..4] {
            let best = (plane.x * x.x).max(plane.x * x.y)
                + (plane.y * f64::from(s.low)).max(plane.y * f64::from(s.high))
                + plane.w;
            if plane.z.abs() < 1e-6 {
                span.1 = if best < -1e-3 { f64::NEG_INFINITY } else { span.1 };
            } else if plane.z > 0.0 {
                span.0 = span.0.max(-best / plane.z);
            } else {
                span.1 = span.1.min(-best / plane.z);
            }
        }
        let row = |z: f64| (z - f64::from(s.origin[1])) / f64::from(s.cell[1]);
        let margin = f64::from(s.margin[1]);
        let (from, to) = (row(span.0 - margin), row(span.1 + margin));
        let last = f64::from(s.rows) - 1.0;
        if span.0 > span.1 || to < 0.0 || from > last + 1.0 {
            return (0, 0);
        }
        let (begin, end) = (from.floor().clamp(0.0, last), to.floor().clamp(0.0, last));
        (begin as u32, (end - begin) as u32 + 1)
    }

    fn tested_rows(&self, column: u32) -> (u32, u32) {
        let planes = self.planes();
        let meets = |row: u32| {
            let (low, high) = self.cell_box(column, row);
            planes.iter().all(|plane| {
                let corner = DVec3::select(plane.truncate().cmpgt(DVec3::ZERO), high, low);
                plane.truncate().dot(corner) + plane.w >= 0.0
            })
        };
        let rows: Vec<u32> = (0..self.settings.rows).filter(|row| meets(*row)).collect();
        match (rows.first(), rows.last()) {
            // Those between are too, or a plane would not be one
            (Some(first), Some(last)) => (*first, last - first + 1),
            _ => (0, 0),
        }
    }

    /// Brute force: whether a cell's box and the frustum have a point in common, by separating axes.
    /// `inset` shrinks the frustum by so much of its size, so that what only touches does not count.
    pub(crate) fn truly_meets(&self, column: u32, row: u32, inset: f64) -> bool {
        let Some(corners) = self.frustum_corners(inset) else { return false };
        let (low, high) = self.cell_box(column, row);
        let center = 0.5 * (low + high);
        let half = 0.5 * (high - low);
        let edges = [
            corners[1] - corners[0],
            corners[2] - corners[0],
            corners[4] - corners[0],
            corners[5] - corners[1],
            corners[6] - corners[2],
            corners[7] - corners[3],
        ];
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let faces = self.planes().map(|plane| plane.truncate());
        let crossed = edges.iter().flat_map(|edge| axes.map(|axis| edge.cross(axis)));
        axes.into_iter().chain(faces).chain(crossed).all(|axis| {
            let own = half.dot(axis.abs());
            let at = corners.map(|corner| (corner - center).dot(axis));
            let (least, most) = at
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
            axis.length_squared() < 1e-18 || (least <= own && most >= -own)
        })
    }

    /// By bits: x, y, z. An infinite far plane ends where the grid does.
    fn frustum_corners(&self, inset: f64) -> Option<[DVec3; 8]> {
        let world = self.clip_from_world.inverse();
        let far = f64::from(self.settings.far_value).min(1.0);
        let corners: [DVec3; 8] = std::array::from_fn(|i| {
            let side = |bit: usize| if i >> bit & 1 == 1 { 1.0 - inset } else { inset - 1.0 };
            let z = if i >> 2 & 1 == 1 { far } else { 0.0 };
            world.project_point3(DVec3::new(side(0), side(1), z))
        });
        corners.iter().all(|c| c.is_finite()).then_some(corners)
    }
}

/// Lowest and highest z of the part of an edge between two x.
fn edge_between(a: DVec2, b: DVec2, x: DVec2) -> (f64, f64) {
    if a.x.max(b.x) < x.x || a.x.min(b.x) > x.y {
        return (f64::INFINITY, f64::NEG_INFINITY);
    }
    let along = b.x - a.x;
    let at = |x: f64| {
        let t = if along.abs() > 1e-6 { ((x - a.x) / along).clamp(0.0, 1.0) } else { f64::NAN };
        a.y + (b.y - a.y) * t
    };
    let (first, second) = if along.abs() > 1e-6 { (at(x.x), at(x.y)) } else { (a.y, b.y) };
    (first.min(second), first.max(second))
}

/// Cells of a grid that a view lists, column by column.
pub(crate) fn listed(grid: &Grid, swept: &Swept) -> Vec<u32> {
    let column = |c: u32| {
        let (first, count) = swept.rows(c);
        (first..first + count).map(move |row| c * grid.cells.y + row)
    };
    (0..grid.cells.x).flat_map(column).collect()
}
