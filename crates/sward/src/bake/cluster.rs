//! The pictures of clusters: 32 blades each, of four places of the field, from four elevations and
//! four sides.

use super::Triangle;
pub(crate) use super::cards::{AZIMUTHS, ELEVATIONS};
use super::cards::{Lines, STEPS, Size, card, cover, lines};
use super::harmonics::depth_shade;
use super::layers::{Layers, color_of, shape_of};
use super::means::evenly;
use super::mips::{Chain, plain};
use super::raster::Window;
use super::stand::Stands;
use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// Blades that a cluster stands for.
pub(crate) const CLUSTER_BLADES: usize = 32;
/// Places of the field that clusters are taken from.
pub(crate) const VARIANTS: usize = 4;
/// Samples a side of a texel.
const SAMPLES: u32 = 3;

/// Clusters as they are drawn. Layer `(variant * 4 + elevation) * 4 + azimuth`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Clusters {
    /// Square root of the albedo in the canopy's own shade, and alpha.
    pub color: Layers,
    /// Normal (x to the right, y up, z level towards the eye), and height share.
    pub shape: Layers,
    /// Of the cylinder that holds one.
    pub size: Size,
    /// Share of its card that it covers in the mean, seen from 0, 15, .. 90 degrees.
    pub cover: [f32; STEPS],
    /// What rows of the pictures hold.
    pub lines: Lines,
}

/// Bakes all layers; the same for any number of threads.
pub(crate) fn clusters(stands: &Stands) -> Clusters {
    let picked = evenly(stands.stands.len(), VARIANTS).map(|i| &stands.stands[i]);
    let variants: Vec<Vec<Triangle>> =
        picked.map(|stand| stand.nearest(CLUSTER_BLADES, &stands.means)).collect();
    let points = || variants.iter().flatten().flatten().map(|corner| corner.position);
    let radius = points().map(|p| Vec2::new(p.x, p.z).length()).fold(1e-3, f32::max);
    let height = points().map(|p| p.y).fold(1e-3, f32::max);
    let size = Size { radius, height };
    let count = VARIANTS * ELEVATIONS * AZIMUTHS;
    let open = stands.root_open;
    let layer = |index: usize| {
        let (elevation, side) = (index / AZIMUTHS % ELEVATIONS, index % AZIMUTHS);
        // A small field has fewer places
        let variant = index / (AZIMUTHS * ELEVATIONS) % variants.len().max(1);
        let own = variants.get(variant).map_or(&[][..], |list| list);
        let window = Window { samples: SAMPLES, ..card(size, 2 * elevation, side) };
        let mut chain = plain(window.see(own).tile());
        let toward = window.right.cross(Vec3::Y);
        for texel in chain.iter_mut().flat_map(|tile| &mut tile.texels) {
            let n = texel.normal;
            texel.normal = Vec3::new(n.dot(window.right), n.y, n.dot(toward));
            texel.albedo *= depth_shade(texel.height_share, open);
        }
        chain
    };
    let measured = |step: usize| cover(&variants, size, step);
    let covers: Vec<f32> = (0..STEPS).into_par_iter().map(measured).collect();
    let chains: Vec<Chain> = (0..count).into_par_iter().map(layer).collect();
    Clusters {
        color: Layers::new(&chains, color_of),
        shape: Layers::new(&chains, shape_of),
        size,
        cover: std::array::from_fn(|step| covers.get(step).copied().unwrap_or(0.0)),
        lines: lines(&chains),
    }
}
