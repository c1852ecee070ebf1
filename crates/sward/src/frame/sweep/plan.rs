//! How a view is swept: by O's corners, or, where they do not serve, by a test of every cell.

use super::grid::Grid;
use crate::View;
use bytemuck::{Pod, Zeroable};
use glam::{DMat4, DVec2, DVec4, Vec3};

/// Least share of the vertical that the camera's up direction has for corners: below it looks almost
/// straight down or up, and corners lie far out or nowhere.
const LEAST_UPRIGHT: f64 = 0.17;
/// Most tilt of the camera's right direction, as a sine: 5 degrees of roll.
const MOST_ROLL: f64 = 0.0872;

/// `GpuSweep` of sweep.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub(crate) struct GpuSweep {
    pub origin: [f32; 2],
    pub cell: [f32; 2],
    pub columns: u32,
    pub rows: u32,
    pub low: f32,
    pub high: f32,
    pub margin: [f32; 2],
    pub far_value: f32,
    pub push: f32,
    pub method: u32,
    pub reserved_a: u32,
    pub reserved_b: u32,
    pub reserved_c: u32,
}

impl GpuSweep {
    pub(crate) fn method(&self) -> SweepMethod {
        match self.method {
            0 => SweepMethod::Corners,
            _ => SweepMethod::EveryCell,
        }
    }
}

/// How the cells that a view may see are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SweepMethod {
    /// Between the four corners in which the ground meets the frustum (O section 3, system 1).
    Corners,
    /// By a frustum test of every cell: the fallback, for any camera.
    EveryCell,
}

/// A place where the ground plane meets an edge between a side of the frustum and its near or far
/// plane: what O's mixed system (1) leaves unknown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroundCorner {
    /// World (x, z), metres.
    pub place: DVec2,
    /// Clip y over clip w: outside -1..=1 where the corner is not in the picture.
    pub clip_y: f64,
    /// The scale: clip w, for a perspective camera the depth in metres.
    pub scale: f64,
}

/// Solves O's mixed system (1): known are the corner's clip x (`side` times w), its clip z (`value`
/// times w), its clip w up to the scale, and its world y; unknown its clip y, its world x and z, and
/// the scale. None where the edge runs along the ground.
pub fn ground_corner(
    clip_from_world: &DMat4,
    side: f64,
    value: f64,
    y_m: f64,
) -> Option<GroundCorner> {
    let m = clip_from_world.transpose();
    let unit = |plane: DVec4| plane / plane.truncate().length().max(1e-30);
    let (p, q) = (unit(m.x_axis - side * m.w_axis), unit(m.z_axis - value * m.w_axis));
    let right = -DVec2::new(p.y * y_m + p.w, q.y * y_m + q.w);
    let det = p.x * q.z - p.z * q.x;
    let place = DVec2::new(right.x * q.z - p.z * right.y, p.x * right.y - right.x * q.x) / det;
    if det.abs() < 1e-9 || !place.is_finite() {
        return None;
    }
    let point = DVec4::new(place.x, y_m, place.y, 1.0);
    let scale = m.w_axis.dot(point);
    Some(GroundCorner { place, clip_y: m.y_axis.dot(point) / scale, scale })
}

/// The four corners of a view on the plane `y_m`: left near, right near, right far, left far. The
/// far ones lie where the far plane is, or at `farthest_m` from the eye along the view where that is
/// nearer. None where an edge runs along the ground.
pub fn ground_corners(view: &View, y_m: f64, farthest_m: f64) -> Option<[GroundCorner; 4]> {
    let m = (view.clip_from_view * view.view_from_world).as_dmat4();
    let far = Depths::of(view, farthest_m).far_value;
    let corner = |side, value| ground_corner(&m, side, value, y_m);
    Some([corner(-1.0, 0.0)?, corner(1.0, 0.0)?, corner(1.0, far)?, corner(-1.0, far)?])
}

/// Depths along a view.
struct Depths {
    near: f64,
    /// The far plane's, or the farthest that matters.
    far: f64,
    /// Clip z over w there.
    far_value: f64,
    /// Whether z over w is a depth itself, as an orthographic view's is.
    even: bool,
}

impl Depths {
    fn of(view: &View, farthest: f64) -> Self {
        let clip = view.clip_from_view.as_dmat4();
        let (z, w) = ((clip.z_axis.z, clip.w_axis.z), (clip.z_axis.w, clip.w_axis.w));
        let near = z.1 / z.0;
        let plane = (z.1 - w.1) / (z.0 - w.0);
        let plane = if plane.is_finite() && plane > near { plane } else { f64::INFINITY };
        // What lies wholly before the near plane still gets a sweep, of nothing
        let least = near + 0.01 * near.abs().max(0.01);
        let far = farthest.max(least).min(plane);
        let far_value = (z.1 - z.0 * far) / (w.1 - w.0 * far);
        Self { near, far, far_value, even: w.0 == 0.0 }
    }
}

/// How a view sweeps a grid.
pub(crate) fn plan(grid: &Grid, view: &View) -> GpuSweep {
    let (low, high) = grid.bounds();
    let row = view.view_from_world.transpose().z_axis;
    let depth = |p: Vec3| f64::from(-row.dot(p.extend(1.0)));
    let corner = |i: usize| {
        let pick = |axis: usize| if i >> axis & 1 == 1 { high[axis] } else { low[axis] };
        Vec3::new(pick(0), pick(1), pick(2))
    };
    let farthest = (0..8).map(|i| depth(corner(i))).fold(f64::NEG_INFINITY, f64::max);
    let depths = Depths::of(view, 1.001 * farthest + 0.01);
    let method = match serves(grid, view, &depths) {
        true => SweepMethod::Corners,
        false => SweepMethod::EveryCell,
    };
    GpuSweep {
        origin: grid.origin.to_array(),
        cell: grid.cell.to_array(),
        columns: grid.cells.x,
        rows: grid.cells.y,
        low: grid.low,
        high: grid.high,
        margin: grid.margin.to_array(),
        far_value: depths.far_value as f32,
        push: push(&depths),
        method: method as u32,
        reserved_a: 0,
        reserved_b: 0,
        reserved_c: 0,
    }
}

/// z over w tells far depths apart by steps of about far^2 / near times its precision; the rest is
/// for the solution itself.
fn push(depths: &Depths) -> f32 {
    let steps = if depths.even { 1.0 } else { depths.far / depths.near.abs().max(1e-6) };
    (1e-3 + 4.0 * f64::from(f32::EPSILON) * steps).min(1.0) as f32
}

/// Whether the corners are what O takes them for: a camera above the lowest ground, its horizon
/// about level, that does not look straight down or up.
fn serves(grid: &Grid, view: &View, depths: &Depths) -> bool {
    let camera = view.view_from_world.transpose();
    let eye = view.view_from_world.inverse().w_axis;
    let clip = view.clip_from_view;
    let plain = clip.x_axis.z == 0.0 && clip.y_axis.z == 0.0 && clip.y_axis.x == 0.0;
    let upright = f64::from(camera.y_axis.y) >= LEAST_UPRIGHT;
    let level = f64::from(camera.x_axis.y).abs() <= MOST_ROLL;
    let near_to_far = depths.near.is_finite() && depths.far > depths.near;
    plain && upright && level && near_to_far && eye.y > grid.low
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::View;
    use glam::Mat4;
    use glam::camera::rh::proj::directx::{perspective, perspective_infinite};

    fn level(far_m: f32) -> View<'static> {
        let clip = match far_m.is_finite() {
            true => perspective(0.9, 1.5, 0.1, far_m),
            false => perspective_infinite(0.9, 1.5, 0.1),
        };
        let eye = Vec3::new(3.0, 2.0, 5.0);
        let view = Mat4::from_rotation_y(0.3) * Mat4::from_translation(-eye);
        View::new(view, clip, [300, 200])
    }

    /// The corners have what the system knows of them, with a level camera too.
    #[test]
    fn corners_have_their_known_components() {
        let view = level(80.0);
        let m = (view.clip_from_view * view.view_from_world).as_dmat4();
        let corners = ground_corners(&view, -0.5, 1e9).expect("not looking down");
        let known = [(-1.0, 0.0, 0.1), (1.0, 0.0, 0.1), (1.0, 1.0, 80.0), (-1.0, 1.0, 80.0)];
        for (corner, (side, value, depth)) in corners.iter().zip(known) {
            let clip = m * DVec4::new(corner.place.x, -0.5, corner.place.y, 1.0);
            assert!((clip.x / clip.w - side).abs() < 1e-4, "{clip}");
            assert!((clip.z / clip.w - value).abs() < 1e-4, "{clip}");
            assert!((corner.scale / depth - 1.0).abs() < 1e-3, "{corner:?}");
            assert!((clip.y / clip.w - corner.clip_y).abs() < 1e-9);
        }
        // Straight below a level camera's near plane, far outside the picture; far off inside
        assert!(corners[0].clip_y < -10.0 && corners[2].clip_y.abs() < 0.2, "{corners:?}");
    }

    #[test]
    fn an_infinite_far_plane_ends_where_it_is_told_to() {
        let view = level(f32::INFINITY);
        let corners = ground_corners(&view, 0.0, 50.0).expect("not looking down");
        assert!((corners[2].scale - 50.0).abs() < 0.1, "{corners:?}");
    }

    #[test]
    fn a_camera_that_looks_straight_down_has_no_corners() {
        let mut view = level(80.0);
        view.view_from_world = Mat4::from_rotation_x(std::f32::consts::FRAC_PI_2)
            * Mat4::from_translation(Vec3::new(0.0, -20.0, 0.0));
        assert_eq!(ground_corners(&view, 0.0, 50.0).filter(|c| c[2].place.length() < 1e6), None);
    }
}
