//! Parts of a large mesh: those out of view are not drawn, and ground that is too near to stand for
//! grass is drawn without the grass's look.

use super::frame::CameraMatrices;
use glam::{Mat4, Vec3};
use std::ops::Range;

/// Most triangles of a part.
const PART_TRIANGLES: usize = 1024;

/// A run of a mesh's triangles that lie together.
#[derive(Debug, Clone)]
pub(super) struct Part {
    indices: Range<u32>,
    low: Vec3,
    high: Vec3,
}

/// Which parts of a mesh a pass draws.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Which {
    All,
    /// Those of which nothing stands for grass.
    Near,
    /// The others.
    Far,
}

/// Sorts triangles into parts, by halves along the longest side.
pub(super) fn parts(positions: &[Vec3], triangles: &mut [[u32; 3]]) -> Vec<Part> {
    let mut list = Vec::new();
    split(positions, triangles, 0, &mut list);
    list
}

fn split(positions: &[Vec3], triangles: &mut [[u32; 3]], first: usize, list: &mut Vec<Part>) {
    let corners = || triangles.iter().flatten().map(|i| positions[*i as usize]);
    let Some(low) = corners().reduce(Vec3::min) else { return };
    let high = corners().fold(low, Vec3::max);
    if triangles.len() <= PART_TRIANGLES {
        let indices = 3 * first as u32..3 * (first + triangles.len()) as u32;
        list.push(Part { indices, low, high });
        return;
    }
    let size = high - low;
    let axis = (0..3).max_by(|a, b| size[*a].total_cmp(&size[*b])).unwrap_or(0);
    let place = |t: &[u32; 3]| t.iter().map(|i| positions[*i as usize][axis]).sum::<f32>();
    let half = triangles.len() / 2;
    triangles.select_nth_unstable_by(half, |a, b| place(a).total_cmp(&place(b)));
    let (near, far) = triangles.split_at_mut(half);
    split(positions, near, first, list);
    split(positions, far, first + half, list);
}

impl Part {
    /// Whether some of it may be in view.
    fn is_seen(&self, clip_from_world: Mat4) -> bool {
        let corner = |i: u32| {
            let pick = |bit: u32| (i >> bit & 1) == 1;
            let high = glam::BVec3::new(pick(0), pick(1), pick(2));
            clip_from_world * Vec3::select(high, self.high, self.low).extend(1.0)
        };
        let corners: [glam::Vec4; 8] = std::array::from_fn(|i| corner(i as u32));
        let all = |beyond: fn(&glam::Vec4) -> bool| corners.iter().all(beyond);
        !(all(|c| c.x < -c.w)
            || all(|c| c.x > c.w)
            || all(|c| c.y < -c.w)
            || all(|c| c.y > c.w)
            || all(|c| c.z < 0.0)
            || all(|c| c.z > c.w))
    }

    fn farthest_m(&self, eye: Vec3) -> f32 {
        (self.low - eye).abs().max((self.high - eye).abs()).length()
    }
}

/// The runs of indices that a camera sees, neighbours joined. Ground stands for grass from
/// `stands_in_m` on.
pub(super) fn seen(
    parts: &[Part],
    camera: CameraMatrices,
    which: Which,
    stands_in_m: f32,
) -> Vec<Range<u32>> {
    let clip_from_world = camera.clip_from_view * camera.view_from_world;
    let eye = camera.view_from_world.inverse().w_axis.truncate();
    let wanted = |part: &&Part| match which {
        Which::All => true,
        Which::Near => part.farthest_m(eye) < stands_in_m,
        Which::Far => part.farthest_m(eye) >= stands_in_m,
    };
    let mut runs: Vec<Range<u32>> = Vec::new();
    for part in parts.iter().filter(wanted).filter(|part| part.is_seen(clip_from_world)) {
        match runs.last_mut().filter(|run| run.end == part.indices.start) {
            Some(run) => run.end = part.indices.end,
            None => runs.push(part.indices.clone()),
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::camera::rh::{proj::directx::perspective, view::look_at_mat4};

    /// A level field of 200 by 200 cells of a metre.
    fn field() -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let point = |i: u32| Vec3::new((i % 201) as f32 - 100.0, 0.0, (i / 201) as f32 - 100.0);
        let cell = |i: u32| {
            let a = i / 200 * 201 + i % 200;
            [[a, a + 201, a + 1], [a + 1, a + 201, a + 202]]
        };
        ((0..201 * 201).map(point).collect(), (0..40_000).flat_map(cell).collect())
    }

    fn camera(eye: Vec3, target: Vec3) -> CameraMatrices {
        CameraMatrices {
            view_from_world: look_at_mat4(eye, target, Vec3::Y),
            clip_from_view: perspective(1.0, 1.5, 0.1, 1000.0),
        }
    }

    #[test]
    fn parts_hold_every_triangle_once() {
        let (positions, mut triangles) = field();
        let before = triangles.clone();
        let parts = parts(&positions, &mut triangles);
        let ends: Vec<u32> = parts.iter().flat_map(|p| [p.indices.start, p.indices.end]).collect();
        assert!(ends.is_sorted() && ends[0] == 0 && ends[ends.len() - 1] == 240_000);
        assert!(ends[1..ends.len() - 1].chunks(2).all(|pair| pair[0] == pair[1]));
        let sorted = |mut list: Vec<[u32; 3]>| {
            list.sort_unstable();
            list
        };
        assert_eq!(sorted(triangles), sorted(before));
    }

    #[test]
    fn no_triangle_in_view_is_missed() {
        let (positions, mut triangles) = field();
        let parts = parts(&positions, &mut triangles);
        for turn in 0..12 {
            let angle = turn as f32 * 0.55;
            let eye = Vec3::new(30.0 * angle.sin(), 1.0 + turn as f32, -20.0);
            let camera = camera(eye, eye + Vec3::new(angle.cos(), -0.15, angle.sin()));
            let clip = camera.clip_from_view * camera.view_from_world;
            let runs = |which| seen(&parts, camera, which, 25.0);
            let all = runs(Which::All);
            let count =
                |runs: &[Range<u32>]| runs.iter().map(ExactSizeIterator::len).sum::<usize>();
            assert_eq!(count(&all), count(&runs(Which::Near)) + count(&runs(Which::Far)));
            assert!(count(&all) < 150_000, "{}", count(&all));
            for (i, triangle) in triangles.iter().enumerate() {
                let inside = triangle.iter().any(|v| {
                    let c = clip * positions[*v as usize].extend(1.0);
                    c.w > 0.0 && c.x.abs() < c.w && c.y.abs() < c.w && c.z > 0.0 && c.z < c.w
                });
                assert!(!inside || all.iter().any(|run| run.contains(&(3 * i as u32))));
            }
            for index in runs(Which::Near).into_iter().flatten() {
                let place = positions[triangles[index as usize / 3][index as usize % 3] as usize];
                assert!(place.distance(eye) < 25.0);
            }
        }
    }
}
