//! Solids: what lies inside a triangle mesh, how far its surface is, and spheres that fill it.
//!
//! `mesh -> Solid -> Packing`. A solid serves twice: [`Solid::pack`] makes the spheres with which a
//! mesh pushes blades aside, and [`crate::Obstacle`] keeps roots out of it.
//!
//! Inside is where the generalised winding number is above one half, so holes, cracks, overlaps and
//! loose triangles do no harm: a mesh with a hole is closed as if by a soap film across it.

mod bvh;
mod distances;
mod nearest;
mod pack;
mod samples;
mod winding;

pub use pack::{PackDesc, Packing};

pub(crate) use bvh::Bvh;

use crate::grow::{surface, weld};
use crate::{Error, Mesh};
use glam::{DVec3, Vec3};
use std::collections::BTreeMap;
use std::fmt;
use winding::Winding;

/// A triangle mesh as a body with an inside.
///
/// All queries are exact but the winding number, whose far triangles are summed in clusters; they
/// depend on nothing but the mesh and the point.
#[derive(Clone, PartialEq)]
pub struct Solid {
    /// Triangles in the order of the tree, moved and scaled so that the mesh's bounding box has its
    /// centre at 0 and half a diagonal of 1: no size of a mesh meets the ends of `f32`.
    corners: Vec<[Vec3; 3]>,
    bvh: Bvh,
    winding: Winding,
    center: DVec3,
    /// Metres of a unit.
    unit_m: f64,
    open_edges: usize,
}

/// Least winding number of a point that counts as inside.
const INSIDE: f64 = 0.5;

impl Solid {
    /// Makes a solid of any triangle mesh. Triangles of no area are left out; a mesh whose triangles
    /// all face inwards is turned. A hole is closed as if by a film across it: an open bowl is full
    /// to its rim. Give it thickness where its hollow is to be outside.
    ///
    /// # Errors
    /// [`Error::Mesh`] where it is empty, an index is out of range, a coordinate is not finite or
    /// farther than 1e9 m from the origin, or where nothing lies inside: a flat sheet has none.
    pub fn new(mesh: &Mesh) -> Result<Self, Error> {
        surface::check_shape(mesh)?;
        let used = || mesh.triangles.iter().flatten().map(|&v| mesh.positions[v as usize]);
        let low = used().fold(Vec3::INFINITY, Vec3::min).as_dvec3();
        let high = used().fold(Vec3::NEG_INFINITY, Vec3::max).as_dvec3();
        let (center, unit_m) = ((low + high) * 0.5, (high - low).length() * 0.5);
        // Below, even f64 has no room for volumes.
        if unit_m < 1e-30 {
            return Err(Error::mesh(format!(
                "its {} triangles all lie in one point; check its scale",
                mesh.triangles.len()
            )));
        }
        let unit = |v: u32| ((mesh.positions[v as usize].as_dvec3() - center) / unit_m).as_vec3();
        let mut corners: Vec<[Vec3; 3]> = (mesh.triangles.iter())
            .map(|t| t.map(unit))
            .filter(|[a, b, c]| (*b - *a).cross(*c - *a).length_squared() > 1e-24)
            .collect();
        let boxes = corners.iter().map(|[a, b, c]| (a.min(*b).min(*c), a.max(*b).max(*c)));
        let bvh = Bvh::new(&boxes.collect::<Vec<_>>());
        corners = bvh.order().iter().map(|&i| corners[i as usize]).collect();
        let winding = Winding::new(&bvh, &corners);
        let open_edges = open_edges(mesh);
        let mut solid = Self { corners, bvh, winding, center, unit_m, open_edges };
        // A closed mesh with a volume has an inside, and the volume's sign is the winding number's.
        let volume = solid.signed_volume();
        let told = open_edges == 0 && volume.abs() > 1e-3;
        if if told { volume < 0.0 } else { solid.faces_inwards()? } {
            solid.corners.iter_mut().for_each(|corners| corners.swap(1, 2));
            solid.winding = Winding::new(&solid.bvh, &solid.corners);
        }
        Ok(solid)
    }

    /// Whether a point lies inside: its winding number is above one half (A. Jacobson, L. Kavan,
    /// O. Sorkine-Hornung, "Robust Inside-Outside Segmentation using Generalized Winding Numbers",
    /// SIGGRAPH 2013).
    pub fn contains(&self, point: Vec3) -> bool {
        let unit = self.unit_from_world(point);
        // The winding number of an open mesh may spread beyond it, but not past its bounds.
        let (low, high) = self.bvh.bounds();
        unit.cmpge(low).all() && unit.cmple(high).all() && self.unit_contains(unit)
    }

    /// Distance to the nearest triangle, metres; negative inside. A point inside an open mesh near
    /// its hole may be nearer to the outside than to any triangle.
    pub fn distance(&self, point: Vec3) -> f32 {
        let unit = self.unit_from_world(point);
        if !unit.is_finite() {
            return f32::INFINITY;
        }
        let distance = f64::from(self.unit_distance(unit)) * self.unit_m;
        if self.contains(point) { -distance as f32 } else { distance as f32 }
    }

    /// Smallest and largest corner of its bounding box, metres.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        let (low, high) = self.bvh.bounds();
        (self.world_from_unit(low), self.world_from_unit(high))
    }

    /// Edges with a triangle on one side only, vertices in one place taken as one: 0 where the mesh
    /// is closed. Where it is not, its inside ends in the hole as the winding number has it.
    pub fn open_edges(&self) -> usize {
        self.open_edges
    }

    fn unit_from_world(&self, point: Vec3) -> Vec3 {
        ((point.as_dvec3() - self.center) / self.unit_m).as_vec3()
    }

    fn world_from_unit(&self, point: Vec3) -> Vec3 {
        (point.as_dvec3() * self.unit_m + self.center).as_vec3()
    }

    fn unit_contains(&self, point: Vec3) -> bool {
        self.winding.at(&self.bvh, &self.corners, point) > INSIDE
    }

    /// Distance to the nearest triangle, in units, 0 or more.
    fn unit_distance(&self, point: Vec3) -> f32 {
        self.unit_distance_within(point, f32::INFINITY)
    }

    /// The same, where it is known to be at most `most`.
    fn unit_distance_within(&self, point: Vec3, most: f32) -> f32 {
        let triangle = |i: u32| nearest::distance_squared(&self.corners[i as usize], point);
        self.bvh.nearest(point, most * most, triangle).sqrt()
    }

    /// Volume of a closed mesh, cubic units: negative where its triangles face inwards.
    fn signed_volume(&self) -> f64 {
        let corner = |[a, b, c]: &[Vec3; 3]| a.as_dvec3().dot(b.as_dvec3().cross(c.as_dvec3()));
        self.corners.iter().map(corner).sum::<f64>() / 6.0
    }

    /// Whether what it encloses has a winding number of -1: its triangles face inwards.
    ///
    /// # Errors
    /// Where it encloses nothing. Judged by points just behind and before the triangles, where a
    /// sheet has one half, and by a coarse grid of the box, for what is rather open.
    fn faces_inwards(&self) -> Result<bool, Error> {
        let mut votes = [0_u32; 2];
        let mut vote = |winding: f64, least: f64| {
            votes[0] += u32::from(winding > least);
            votes[1] += u32::from(winding < -least);
        };
        let at = |point| self.winding.at(&self.bvh, &self.corners, point);
        let stride = self.corners.len().div_ceil(1024).max(1);
        for [a, b, c] in self.corners.iter().step_by(stride) {
            let normal = (*b - *a).cross(*c - *a).normalize_or_zero();
            for depth in [-1e-3, -1e-4, 1e-4, 1e-3] {
                vote(at((*a + *b + *c) / 3.0 + normal * depth), 0.65);
            }
        }
        let (low, high) = self.bvh.bounds();
        for i in 0..GRID.pow(3) {
            let cell =
                Vec3::new((i % GRID) as f32, (i / GRID % GRID) as f32, (i / GRID / GRID) as f32);
            let point = low + (high - low) * (cell + 0.5) / GRID as f32;
            // On a triangle itself the winding number is neither side's.
            if self.unit_distance(point) > 1e-4 {
                vote(at(point), 0.51);
            }
        }
        if votes == [0, 0] {
            return Err(Error::mesh(
                "nothing lies inside: it is a sheet, or too open to tell inside from outside; \
                 close it, or give it thickness",
            ));
        }
        Ok(votes[1] > votes[0])
    }
}

/// In short: a mesh has many triangles.
impl fmt::Debug for Solid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (f.debug_struct("Solid"))
            .field("triangles", &self.corners.len())
            .field("bounds", &self.bounds())
            .field("open_edges", &self.open_edges)
            .finish()
    }
}

/// Points along a side of the coarse grid that looks for an inside.
const GRID: u32 = 16;

/// Edges that are not walked as often one way as the other.
fn open_edges(mesh: &Mesh) -> usize {
    let place = weld::places(&mesh.positions);
    let mut walks: BTreeMap<(u32, u32), i32> = BTreeMap::new();
    for &[a, b, c] in &mesh.triangles {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let (from, to) = (place[from as usize], place[to as usize]);
            if from != to {
                let way = if from < to { 1 } else { -1 };
                *walks.entry((from.min(to), from.max(to))).or_default() += way;
            }
        }
    }
    walks.values().filter(|&&walks| walks != 0).count()
}
