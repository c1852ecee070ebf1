//! Generated meshes: plane, sphere, torus, Mobius strip, height map. All y up, in metres, about the
//! origin, with normals and texture coordinates, counter-clockwise from outside.

use super::surface::Mesh;
use crate::Error;
use crate::error::above_zero;
use glam::{UVec2, Vec2, Vec3};
use std::f32::consts::{PI, TAU};

/// Most cells of a generated mesh: two triangles each, and vertices that fit `u32` with ease.
const MOST_CELLS: u64 = 1 << 26;
/// Longest side, metres.
const LARGEST_M: f32 = 1e6;

impl Mesh {
    /// A level rectangle of `size` (x, z) metres, cut into `divisions` cells.
    ///
    /// # Errors
    /// [`Error::Setting`] for a size that is not above 0 or cells beyond 1 to 67 million.
    pub fn plane(size: Vec2, divisions: UVec2) -> Result<Self, Error> {
        above_zero("plane.size.x", size.x, LARGEST_M)?;
        above_zero("plane.size.y", size.y, LARGEST_M)?;
        let grid = Grid { cells: divisions, wrap: [false; 2] };
        grid.mesh("plane.divisions", |at| {
            let p = (at - 0.5) * size;
            (Vec3::new(p.x, 0.0, p.y), Vec3::Y)
        })
    }

    /// A ball of `radius_m`, with `rings` bands from pole to pole and twice as many round.
    ///
    /// # Errors
    /// [`Error::Setting`] for a radius that is not above 0 or less than 2 rings.
    pub fn sphere(radius_m: f32, rings: u32) -> Result<Self, Error> {
        above_zero("sphere.radius_m", radius_m, LARGEST_M)?;
        at_least("sphere.rings", rings, 2)?;
        let grid = Grid { cells: UVec2::new(rings.saturating_mul(2), rings), wrap: [true, false] };
        grid.mesh("sphere.rings", |at| {
            let normal = if at.y == 0.0 || at.y == 1.0 {
                // The poles, exactly: all corners of a pole's row must be one place.
                Vec3::new(0.0, 1.0 - 2.0 * at.y, 0.0)
            } else {
                let (around, down) = ((-at.x * TAU).sin_cos(), (at.y * PI).sin_cos());
                Vec3::new(down.0 * around.1, down.1, down.0 * around.0)
            };
            (normal * radius_m, normal)
        })
    }

    /// A ring about the y axis: a tube of `tube_m` radius round a circle of `ring_m` radius, cut
    /// into `divisions` cells (along the ring, round the tube).
    ///
    /// # Errors
    /// [`Error::Setting`] for a radius out of range (the tube must be thinner than the ring) or
    /// less than 3 divisions.
    pub fn torus(ring_m: f32, tube_m: f32, divisions: UVec2) -> Result<Self, Error> {
        above_zero("torus.ring_m", ring_m, LARGEST_M)?;
        above_zero("torus.tube_m", tube_m, LARGEST_M)?;
        if tube_m >= ring_m {
            let cause = format!("{tube_m} is not below ring_m, {ring_m}");
            return Err(Error::setting("torus.tube_m", cause));
        }
        at_least("torus.divisions", divisions.min_element(), 3)?;
        let grid = Grid { cells: divisions, wrap: [true; 2] };
        grid.mesh("torus.divisions", |at| {
            let ((sin_u, cos_u), (sin_v, cos_v)) = ((at.x * TAU).sin_cos(), (at.y * TAU).sin_cos());
            let normal = Vec3::new(cos_v * cos_u, sin_v, cos_v * sin_u);
            (Vec3::new(cos_u, 0.0, sin_u) * ring_m + normal * tube_m, normal)
        })
    }

    /// A Mobius strip of `width_m` round a circle of `ring_m` radius about the y axis, cut into
    /// `divisions` cells (along one turn, across). Its one side is meshed whole: two turns, so
    /// that grass covers the strip everywhere, with no seam.
    ///
    /// # Errors
    /// [`Error::Setting`] for sizes out of range (half the width must be below the radius) or less
    /// than 3 divisions along.
    pub fn mobius(ring_m: f32, width_m: f32, divisions: UVec2) -> Result<Self, Error> {
        above_zero("mobius.ring_m", ring_m, LARGEST_M)?;
        above_zero("mobius.width_m", width_m, LARGEST_M)?;
        if 0.5 * width_m >= ring_m {
            let cause = format!("half of {width_m} is not below ring_m, {ring_m}");
            return Err(Error::setting("mobius.width_m", cause));
        }
        at_least("mobius.divisions", divisions.x, 3)?;
        let cells = UVec2::new(divisions.x.saturating_mul(2), divisions.y);
        let grid = Grid { cells, wrap: [true, false] };
        grid.mesh("mobius.divisions", |at| {
            let s = (at.y - 0.5) * width_m;
            let ((sin, cos), (sin_half, cos_half)) =
                ((2.0 * at.x * TAU).sin_cos(), (at.x * TAU).sin_cos());
            let away = ring_m + s * cos_half;
            let across = Vec3::new(cos_half * cos, sin_half, cos_half * sin);
            let along = Vec3::new(
                -0.5 * s * sin_half * cos - away * sin,
                0.5 * s * cos_half,
                -0.5 * s * sin_half * sin + away * cos,
            );
            let position = Vec3::new(away * cos, s * sin_half, away * sin);
            (position, across.cross(along).normalize_or(Vec3::Y))
        })
    }

    /// A height map: `width` x `height` samples in metres, row by row (row 0 at the least z), on a
    /// rectangle of `size_m` (x, z).
    ///
    /// # Errors
    /// [`Error::Setting`] where the samples do not match, are not finite, or are less than 2 x 2.
    pub fn heightmap(
        width: u32,
        height: u32,
        heights_m: &[f32],
        size_m: Vec2,
    ) -> Result<Self, Error> {
        above_zero("heightmap.size_m.x", size_m.x, LARGEST_M)?;
        above_zero("heightmap.size_m.y", size_m.y, LARGEST_M)?;
        at_least("heightmap.width", width, 2)?;
        at_least("heightmap.height", height, 2)?;
        if u64::from(width) * u64::from(height) != heights_m.len() as u64 {
            let cause = format!("{width} x {height} samples, but {} heights", heights_m.len());
            return Err(Error::setting("heightmap", cause));
        }
        if let Some(i) = heights_m.iter().position(|h| !h.is_finite() || h.abs() > LARGEST_M) {
            let cause = format!("height {i} is {}; use -1e6 to 1e6 m", heights_m[i]);
            return Err(Error::setting("heightmap", cause));
        }
        let cells = UVec2::new(width - 1, height - 1);
        let step_m = size_m / cells.as_vec2();
        let sample = |x: u32, y: u32| heights_m[y as usize * width as usize + x as usize];
        Grid { cells, wrap: [false; 2] }.mesh_by_cell("heightmap", |i, j, at| {
            // Central differences, one-sided at the rim.
            let (west, east) = (i.saturating_sub(1), (i + 1).min(cells.x));
            let (north, south) = (j.saturating_sub(1), (j + 1).min(cells.y));
            let dx = (sample(east, j) - sample(west, j)) / ((east - west) as f32 * step_m.x);
            let dz = (sample(i, south) - sample(i, north)) / ((south - north) as f32 * step_m.y);
            let p = (at - 0.5) * size_m;
            (Vec3::new(p.x, sample(i, j), p.y), Vec3::new(-dx, 1.0, -dz).normalize())
        })
    }
}

fn at_least(setting: &str, value: u32, least: u32) -> Result<(), Error> {
    if value >= least {
        return Ok(());
    }
    Err(Error::setting(setting, format!("{value} is too small; use at least {least}")))
}

/// A rectangle of cells, bent into shape.
struct Grid {
    cells: UVec2,
    /// Whether the last column, and row, lie where the first do.
    wrap: [bool; 2],
}

impl Grid {
    /// Builds a mesh from (position, normal) at each share (0..=1) of the two sides. Triangles
    /// face `d/dv x d/du`; those with two corners in one place are left out.
    fn mesh(&self, setting: &str, place: impl Fn(Vec2) -> (Vec3, Vec3)) -> Result<Mesh, Error> {
        self.mesh_by_cell(setting, |_, _, at| place(at))
    }

    fn mesh_by_cell(
        &self,
        setting: &str,
        place: impl Fn(u32, u32, Vec2) -> (Vec3, Vec3),
    ) -> Result<Mesh, Error> {
        let cells = u64::from(self.cells.x) * u64::from(self.cells.y);
        if cells == 0 || cells > MOST_CELLS {
            let cause = format!("{cells} cells; use 1 to {MOST_CELLS}");
            return Err(Error::setting(setting, cause));
        }
        let mut mesh = Mesh::default();
        let share = |i: u32, n: u32, wrap: bool| {
            // A seam's two sides must be one place to the last bit.
            if wrap && i == n { 0.0 } else { i as f32 / n as f32 }
        };
        for j in 0..=self.cells.y {
            for i in 0..=self.cells.x {
                let uv = Vec2::new(i as f32, j as f32) / self.cells.as_vec2();
                let at = Vec2::new(
                    share(i, self.cells.x, self.wrap[0]),
                    share(j, self.cells.y, self.wrap[1]),
                );
                let (position, normal) = place(i, j, at);
                mesh.positions.push(position);
                mesh.normals.push(normal);
                mesh.uvs.push(uv);
            }
        }
        let row = self.cells.x + 1;
        for j in 0..self.cells.y {
            for i in 0..self.cells.x {
                let a = j * row + i;
                let (b, c, d) = (a + row, a + 1, a + row + 1);
                for triangle in [[a, b, c], [c, b, d]] {
                    let [p, q, r] = triangle.map(|v| mesh.positions[v as usize]);
                    if p != q && q != r && r != p {
                        mesh.triangles.push(triangle);
                    }
                }
            }
        }
        Ok(mesh)
    }
}
