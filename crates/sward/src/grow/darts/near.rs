//! The samples near a group of pieces, by cell.

use glam::{IVec3, Vec3};

/// Most cells a side; places beyond share the outermost.
const MOST_CELLS: i32 = 16;
const END: u32 = u32::MAX;

/// Cells are as wide as a disk, so that eight hold all that lies within a radius of a place.
pub(super) struct Near {
    radius_m: f32,
    low: Vec3,
    cells: IVec3,
    heads: Vec<u32>,
    /// Each sample, and the one before it in its cell.
    samples: Vec<(Vec3, u32)>,
}

impl Near {
    /// Room for samples about a box.
    pub(super) fn new(low: Vec3, high: Vec3, radius_m: f32) -> Self {
        let low = low - radius_m;
        let wide = (high + radius_m - low) / (2.0 * radius_m);
        let cells = (wide.as_ivec3() + 1).clamp(IVec3::ONE, IVec3::splat(MOST_CELLS));
        let count = (cells.x * cells.y * cells.z) as usize;
        Self { radius_m, low, cells, heads: vec![END; count], samples: Vec::new() }
    }

    /// Clamping moves no two places apart, so a search that clamps alike misses nothing.
    fn cell(&self, position: Vec3) -> IVec3 {
        let at = ((position - self.low) / (2.0 * self.radius_m)).floor();
        at.as_ivec3().clamp(IVec3::ZERO, self.cells - 1)
    }

    fn index(&self, cell: IVec3) -> usize {
        ((cell.z * self.cells.y + cell.y) * self.cells.x + cell.x) as usize
    }

    pub(super) fn insert(&mut self, position: Vec3) {
        let cell = self.index(self.cell(position));
        self.samples.push((position, self.heads[cell]));
        self.heads[cell] = self.samples.len() as u32 - 1;
    }

    /// Whether a sample that passes the test lies within the radius.
    pub(super) fn any_within(&self, position: Vec3, test: impl Fn(Vec3) -> bool) -> bool {
        let reach = self.radius_m * self.radius_m;
        let (low, high) =
            (self.cell(position - self.radius_m), self.cell(position + self.radius_m));
        for z in low.z..=high.z {
            for y in low.y..=high.y {
                for x in low.x..=high.x {
                    let mut next = self.heads[self.index(IVec3::new(x, y, z))];
                    while let Some(&(sample, before)) = self.samples.get(next as usize) {
                        if sample.distance_squared(position) < reach && test(sample) {
                            return true;
                        }
                        next = before;
                    }
                }
            }
        }
        false
    }

    /// Whether one sample's disk covers a triangle.
    pub(super) fn covers(&self, [a, b, c]: [Vec3; 3]) -> bool {
        let reach = self.radius_m * self.radius_m;
        self.any_within(a, |sample| {
            sample.distance_squared(b) < reach && sample.distance_squared(c) < reach
        })
    }
}
