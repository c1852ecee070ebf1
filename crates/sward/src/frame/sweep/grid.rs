//! A grid of cells over the ground, and what belongs to each.

use glam::{UVec2, Vec2, Vec3, Vec3Swizzles};

/// Most columns, and rows, of a grid.
pub(crate) const MOST_CELLS_A_SIDE: u32 = 1024;

/// Something on the ground: it belongs to the cell that its place lies in.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Thing {
    /// (x, z), metres.
    pub place: Vec2,
    /// Its box, metres.
    pub low: Vec3,
    /// Its box's other corner.
    pub high: Vec3,
}

/// Equal cells over a rectangle of the xz plane. The cell of column c and row r has the number
/// c times rows plus r: columns lie along x, rows along z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Grid {
    /// Lowest (x, z), metres.
    pub origin: Vec2,
    /// Size of a cell, metres.
    pub cell: Vec2,
    /// Columns and rows.
    pub cells: UVec2,
    /// Lowest height of anything on it, metres.
    pub low: f32,
    /// Highest.
    pub high: f32,
    /// How far things reach beyond their cells, metres.
    pub margin: Vec2,
}

impl Grid {
    /// Cells of about `cell_m`, larger where there would be too many, over a rectangle; and the cell
    /// of each thing on it.
    pub(crate) fn over(
        (min, max): (Vec2, Vec2),
        things: &[Thing],
        cell_m: f32,
    ) -> (Self, Vec<u32>) {
        // A rectangle without a width still has a cell
        let size = (max - min).max(Vec2::splat(1e-3));
        let most = MOST_CELLS_A_SIDE as f32;
        let cells = (size / cell_m).ceil().clamp(Vec2::ONE, Vec2::splat(most)).as_uvec2();
        let mut grid = Self {
            origin: min,
            cell: size / cells.as_vec2(),
            cells,
            low: f32::INFINITY,
            high: f32::NEG_INFINITY,
            margin: Vec2::ZERO,
        };
        let own: Vec<u32> = things.iter().map(|thing| grid.cell_of(thing.place)).collect();
        for (thing, cell) in things.iter().zip(&own) {
            let (low, high) = grid.rectangle(*cell);
            grid.low = grid.low.min(thing.low.y);
            grid.high = grid.high.max(thing.high.y);
            let beyond = (low - thing.low.xz()).max(thing.high.xz() - high);
            grid.margin = grid.margin.max(beyond);
        }
        grid.add_slack();
        (grid, own)
    }

    /// Room for rounding: things at an edge belong to both sides of it.
    fn add_slack(&mut self) {
        let far = self.origin.abs().max((self.origin + self.cell * self.cells.as_vec2()).abs());
        self.margin += self.cell * 1e-3 + far.max_element() * 1e-5;
        let span = 1e-3 * (self.high - self.low) + 1e-5 * self.high.abs().max(self.low.abs());
        self.low -= span;
        self.high += span;
    }

    fn cell_of(&self, place: Vec2) -> u32 {
        let at = ((place - self.origin) / self.cell).max(Vec2::ZERO).as_uvec2();
        let at = at.min(self.cells - 1);
        at.x * self.cells.y + at.y
    }

    /// Number of its cells.
    pub(crate) fn count(&self) -> u32 {
        self.cells.x * self.cells.y
    }

    /// Lowest and highest (x, z) of a cell, without its margin.
    pub(crate) fn rectangle(&self, cell: u32) -> (Vec2, Vec2) {
        let at = UVec2::new(cell / self.cells.y, cell % self.cells.y).as_vec2();
        let low = self.origin + at * self.cell;
        (low, low + self.cell)
    }

    /// The box that holds everything on it.
    pub(crate) fn bounds(&self) -> (Vec3, Vec3) {
        let low = self.origin - self.margin;
        let high = self.origin + self.cell * self.cells.as_vec2() + self.margin;
        (Vec3::new(low.x, self.low, low.y), Vec3::new(high.x, self.high, high.y))
    }

    /// Whether it lies rather flat: a sweep sees only where things lie, not how high.
    pub(crate) fn is_flat(&self) -> bool {
        let (low, high) = self.bounds();
        let size = high - low;
        size.y <= 0.5 * size.x.max(size.z)
    }
}
