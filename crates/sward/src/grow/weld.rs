//! Which vertices lie in one place, and which triangles meet at an edge.

use super::surface::{Surface, face_normal};
use glam::Vec3;
use rayon::prelude::*;
use std::collections::HashMap;

/// For each vertex the first vertex at exactly its position: loaders split vertices where normals
/// or texture coordinates differ, yet the surface goes on there.
pub(crate) fn places(positions: &[Vec3]) -> Vec<u32> {
    let mut first = HashMap::with_capacity(positions.len());
    // Adding 0 turns -0 into 0, which is the same place.
    let key = |p: &Vec3| (*p + Vec3::ZERO).to_array().map(f32::to_bits);
    positions.iter().zip(0..).map(|(p, i)| *first.entry(key(p)).or_insert(i)).collect()
}

/// No triangle lies beyond an edge.
pub(crate) const NONE: u32 = u32::MAX;

/// For each triangle its neighbours across the edges (0, 1), (1, 2) and (2, 0).
///
/// Where more than two triangles meet at an edge, the neighbour is the one that goes on most
/// nearly straight, so that a walk never changes to the back of a two-sided sheet.
#[derive(Debug)]
pub(crate) struct Adjacency {
    neighbors: Vec<[u32; 3]>,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct HalfEdge {
    /// The edge's ends by place, smaller first.
    ends: (u32, u32),
    /// Whether it runs from the larger to the smaller.
    backward: bool,
    triangle: u32,
    side: u32,
}

impl Adjacency {
    pub(crate) fn new(surface: &Surface) -> Self {
        let mesh = surface.mesh();
        let place = places(&mesh.positions);
        let mut edges: Vec<HalfEdge> = (mesh.triangles.par_iter().enumerate())
            .flat_map_iter(|(i, t)| {
                let at = t.map(|v| place[v as usize]);
                (0..3u32).map(move |side| {
                    let (from, to) = (at[side as usize], at[(side as usize + 1) % 3]);
                    HalfEdge {
                        ends: (from.min(to), from.max(to)),
                        backward: from > to,
                        triangle: i as u32,
                        side,
                    }
                })
            })
            .collect();
        edges.par_sort_unstable();
        let mut neighbors = vec![[NONE; 3]; mesh.triangles.len()];
        for group in edges.chunk_by(|a, b| a.ends == b.ends) {
            for edge in group {
                let best = best_partner(surface, edge, group);
                neighbors[edge.triangle as usize][edge.side as usize] = best;
            }
        }
        Self { neighbors }
    }

    /// The neighbour across an edge, or [`NONE`].
    pub(crate) fn across(&self, triangle: u32, side: usize) -> u32 {
        self.neighbors[triangle as usize][side]
    }
}

fn best_partner(surface: &Surface, edge: &HalfEdge, group: &[HalfEdge]) -> u32 {
    let mut others = group.iter().filter(|o| o.backward != edge.backward).map(|o| o.triangle);
    if group.len() <= 2 {
        return others.next().unwrap_or(NONE);
    }
    let normal = |triangle| {
        let [a, b, c] = surface.corners(triangle);
        face_normal(a, b, c)
    };
    let own = normal(edge.triangle);
    let straight = |triangle: u32| own.dot(normal(triangle));
    others.max_by(|&a, &b| straight(a).total_cmp(&straight(b)).then(b.cmp(&a))).unwrap_or(NONE)
}
