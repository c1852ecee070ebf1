//! Surfaces: indexed triangle meshes that grass grows on.

use super::{FARTHEST_M, weld};
use crate::Error;
use glam::{DVec3, Vec2, Vec3};

/// A triangle whose area is less than this share of its longest edge squared is degenerate.
const THINNEST: f64 = 1e-9;

/// An indexed triangle mesh, as loaded or generated; see [`Surface::new`] for what it must hold.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Vertex positions, metres, world space, y up.
    pub positions: Vec<Vec3>,
    /// Vertex normals; empty: computed, area-weighted.
    pub normals: Vec<Vec3>,
    /// Texture coordinates; empty: none.
    pub uvs: Vec<Vec2>,
    /// Vertex colours, linear RGBA; empty: none.
    pub colors: Vec<[f32; 4]>,
    /// Triangles, counter-clockwise from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// A checked mesh with the area of its triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    mesh: Mesh,
    /// Area of all triangles up to and with this one, square metres.
    cumulative_m2: Vec<f64>,
    dropped_triangles: usize,
    bounds: (Vec3, Vec3),
}

/// A place on a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Spot {
    pub(crate) triangle: u32,
    /// Barycentric weights of the triangle's second and third corner.
    pub(crate) weights: Vec2,
    pub(crate) position: Vec3,
    /// Unit, interpolated.
    pub(crate) normal: Vec3,
}

impl Surface {
    /// Checks a mesh, drops its degenerate triangles, and fills in normals where there are none:
    /// area-weighted, smooth across vertices that were split but share a position.
    ///
    /// # Errors
    /// [`Error::Mesh`] where it is empty, has no area, an index is out of range, an attribute has
    /// the wrong length or a value is not finite; the message names the vertex or triangle.
    pub fn new(mut mesh: Mesh) -> Result<Self, Error> {
        check(&mesh)?;
        let before = mesh.triangles.len();
        let positions = &mesh.positions;
        mesh.triangles.retain(|t| area_m2(positions, t).is_some());
        let dropped_triangles = before - mesh.triangles.len();
        if mesh.triangles.is_empty() {
            return Err(Error::mesh(format!(
                "its area is 0: all {before} triangles are degenerate; check its scale and indices"
            )));
        }
        let mut total = 0.0;
        let mut cumulative_m2 = Vec::with_capacity(mesh.triangles.len());
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for triangle in &mesh.triangles {
            total += area_m2(&mesh.positions, triangle).unwrap_or(0.0);
            cumulative_m2.push(total);
            for &v in triangle {
                low = low.min(mesh.positions[v as usize]);
                high = high.max(mesh.positions[v as usize]);
            }
        }
        complete_normals(&mut mesh);
        Ok(Self { mesh, cumulative_m2, dropped_triangles, bounds: (low, high) })
    }

    /// The mesh, with normals, without its degenerate triangles.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Area, square metres.
    pub fn area_m2(&self) -> f64 {
        self.cumulative_m2.last().copied().unwrap_or(0.0)
    }

    /// Smallest and largest corner of its bounding box, metres.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        self.bounds
    }

    /// Number of triangles, without degenerate ones.
    pub fn triangle_count(&self) -> usize {
        self.mesh.triangles.len()
    }

    /// Number of degenerate triangles that were dropped: two corners in one place, or three in
    /// a line.
    pub fn dropped_triangles(&self) -> usize {
        self.dropped_triangles
    }

    /// Area of all triangles up to and with each, square metres.
    pub(crate) fn cumulative_m2(&self) -> &[f64] {
        &self.cumulative_m2
    }

    /// Area before a triangle, and its own, square metres.
    pub(crate) fn area_span_m2(&self, triangle: usize) -> (f64, f64) {
        let start = if triangle == 0 { 0.0 } else { self.cumulative_m2[triangle - 1] };
        (start, self.cumulative_m2[triangle] - start)
    }

    /// The corners of a triangle, metres.
    pub(crate) fn corners(&self, triangle: u32) -> [Vec3; 3] {
        self.mesh.triangles[triangle as usize].map(|v| self.mesh.positions[v as usize])
    }

    /// A value given at the vertices, interpolated.
    pub(crate) fn interpolate<T, V>(&self, triangle: u32, weights: Vec2, of: &[T]) -> V
    where
        T: Copy,
        V: From<T> + std::ops::Mul<f32, Output = V> + std::ops::Add<Output = V>,
    {
        let [a, b, c] = self.mesh.triangles[triangle as usize].map(|v| V::from(of[v as usize]));
        a * (1.0 - weights.x - weights.y) + b * weights.x + c * weights.y
    }

    /// The place at barycentric weights of a triangle.
    pub(crate) fn spot(&self, triangle: u32, weights: Vec2) -> Spot {
        let [a, b, c] = self.corners(triangle);
        let (ab, ac) = (b - a, c - a);
        let smooth: Vec3 = self.interpolate(triangle, weights, &self.mesh.normals);
        // Normals may cancel inside a triangle whose corners' normals oppose each other.
        let normal = if smooth.length_squared() > 1e-6 {
            smooth.normalize()
        } else {
            face_normal(a, b, c).as_vec3()
        };
        let position = a + ab * weights.x + ac * weights.y;
        Spot { triangle, weights, position, normal }
    }
}

/// Unit normal of a triangle that is not degenerate; 0 of one that is.
pub(crate) fn face_normal(a: Vec3, b: Vec3, c: Vec3) -> DVec3 {
    let a = a.as_dvec3();
    (b.as_dvec3() - a).cross(c.as_dvec3() - a).normalize_or_zero()
}

/// Area of a triangle, or none where it is degenerate.
fn area_m2(positions: &[Vec3], triangle: &[u32; 3]) -> Option<f64> {
    let [a, b, c] = triangle.map(|v| positions[v as usize].as_dvec3());
    let area = (b - a).cross(c - a).length() * 0.5;
    let longest = a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a));
    (area > longest * THINNEST && area > f64::MIN_POSITIVE).then_some(area)
}

fn check(mesh: &Mesh) -> Result<(), Error> {
    let count = mesh.positions.len();
    let lengths = [
        ("normals", mesh.normals.len()),
        ("texture coordinates", mesh.uvs.len()),
        ("colours", mesh.colors.len()),
    ];
    for (what, length) in lengths {
        if length != 0 && length != count {
            return Err(Error::mesh(format!(
                "it has {count} vertices but {length} {what}; give one each, or none"
            )));
        }
    }
    check_shape(mesh)?;
    if let Some(i) = mesh.normals.iter().position(|n| !n.is_finite()) {
        return Err(not_finite("normal", i, format!("{}", mesh.normals[i])));
    }
    if let Some(i) = mesh.uvs.iter().position(|uv| !uv.is_finite()) {
        return Err(not_finite("texture coordinate", i, format!("{}", mesh.uvs[i])));
    }
    if let Some(i) = mesh.colors.iter().position(|c| !c.iter().all(|x| x.is_finite())) {
        return Err(not_finite("colour", i, format!("{:?}", mesh.colors[i])));
    }
    Ok(())
}

fn not_finite(what: &str, at: usize, value: String) -> Error {
    Error::mesh(format!("the {what} of vertex {at} is {value}; it must be finite"))
}

/// Checks positions and triangles alone.
pub(crate) fn check_shape(mesh: &Mesh) -> Result<(), Error> {
    let count = mesh.positions.len();
    if count == 0 || mesh.triangles.is_empty() {
        return Err(Error::mesh(format!(
            "it is empty: {count} vertices, {} triangles; it needs at least one triangle",
            mesh.triangles.len()
        )));
    }
    for (i, p) in mesh.positions.iter().enumerate() {
        if !p.is_finite() {
            return Err(not_finite("position", i, format!("{p}")));
        }
        if p.abs().max_element() > FARTHEST_M {
            return Err(Error::mesh(format!(
                "the position of vertex {i} is {p}; keep within {FARTHEST_M:e} m of the origin"
            )));
        }
    }
    for (i, triangle) in mesh.triangles.iter().enumerate() {
        if let Some(v) = triangle.iter().find(|&&v| v as usize >= count) {
            return Err(Error::mesh(format!(
                "triangle {i} uses vertex {v}, but there are {count} vertices"
            )));
        }
    }
    Ok(())
}

/// Makes given normals unit; computes those that are missing or 0.
fn complete_normals(mesh: &mut Mesh) {
    if mesh.normals.iter().any(|n| n.length_squared() < 1e-12) || mesh.normals.is_empty() {
        let computed = smooth_normals(mesh);
        if mesh.normals.is_empty() {
            mesh.normals = computed;
            return;
        }
        for (normal, other) in mesh.normals.iter_mut().zip(computed) {
            if normal.length_squared() < 1e-12 {
                *normal = other;
            }
        }
    }
    for normal in &mut mesh.normals {
        *normal = normal.as_dvec3().normalize_or(DVec3::Y).as_vec3();
    }
}

/// Area-weighted normals; vertices in one place share theirs.
fn smooth_normals(mesh: &Mesh) -> Vec<Vec3> {
    let place = weld::places(&mesh.positions);
    let mut sums = vec![DVec3::ZERO; mesh.positions.len()];
    for t in &mesh.triangles {
        let [a, b, c] = t.map(|v| mesh.positions[v as usize].as_dvec3());
        let weighted = (b - a).cross(c - a);
        for &v in t {
            sums[place[v as usize] as usize] += weighted;
        }
    }
    place.iter().map(|&p| sums[p as usize].normalize_or(DVec3::Y).as_vec3()).collect()
}
