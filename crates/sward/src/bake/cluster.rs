//! The pictures of clusters: 32 blades each, of four places of the field, from four elevations and
//! four sides.

use super::Triangle;
use super::cover::axes;
use super::harmonics::depth_shade;
use super::layers::{Layers, color_of, shape_of};
use super::means::evenly;
use super::mips::{Chain, plain};
use super::raster::Window;
use super::stand::Stands;
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use std::f32::consts::{FRAC_PI_2, TAU};

/// Blades that a cluster stands for.
pub(crate) const CLUSTER_BLADES: usize = 32;
/// Places of the field that clusters are taken from.
pub(crate) const VARIANTS: usize = 4;
/// Elevations that they are seen from: 0, 30, 60 and 90 degrees.
pub(crate) const ELEVATIONS: usize = 4;
/// Sides that they are seen from.
pub(crate) const AZIMUTHS: usize = 4;
/// Texels of an edge.
const TEXELS: u32 = 64;
/// Samples a side of a texel.
const SAMPLES: u32 = 3;

/// Clusters as they are drawn. Layer `(variant * 4 + elevation) * 4 + azimuth`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Clusters {
    /// Square root of the albedo in the canopy's own shade, and alpha.
    pub color: Layers,
    /// Normal (x to the right, y up, z level towards the eye), and height share.
    pub shape: Layers,
    /// Half width, metres.
    pub radius_m: f32,
    /// Height, metres.
    pub height_m: f32,
}

/// A picture of a cluster: from the near foot of the cylinder that holds it to its far top.
fn picture(
    triangles: &[Triangle],
    radius: f32,
    height: f32,
    elevation: usize,
    side: usize,
) -> (Window, Chain) {
    let angle = elevation as f32 * FRAC_PI_2 / (ELEVATIONS - 1) as f32;
    let [_, right, up] = axes(side as f32 * TAU / AZIMUTHS as f32, angle.sin());
    let tall = height * angle.cos();
    let window = Window {
        center: up * (0.5 * tall),
        right,
        up,
        half: Vec2::new(radius, 0.5 * tall + radius * angle.sin()),
        size: [TEXELS; 2],
        samples: SAMPLES,
    };
    (window, plain(window.see(triangles).tile()))
}

/// Bakes all layers; the same for any number of threads.
pub(crate) fn clusters(stands: &Stands) -> Clusters {
    let picked = evenly(stands.stands.len(), VARIANTS).map(|i| &stands.stands[i]);
    let variants: Vec<Vec<Triangle>> =
        picked.map(|stand| stand.nearest(CLUSTER_BLADES, &stands.means)).collect();
    let points = || variants.iter().flatten().flatten().map(|corner| corner.position);
    let radius = points().map(|p| Vec2::new(p.x, p.z).length()).fold(1e-3, f32::max);
    let height = points().map(|p| p.y).fold(1e-3, f32::max);
    let count = VARIANTS * ELEVATIONS * AZIMUTHS;
    let open = stands.root_open;
    let layer = |index: usize| {
        let (elevation, side) = (index / AZIMUTHS % ELEVATIONS, index % AZIMUTHS);
        // A small field has fewer places
        let variant = index / (AZIMUTHS * ELEVATIONS) % variants.len().max(1);
        let own = variants.get(variant).map_or(&[][..], |list| list);
        let (window, mut chain) = picture(own, radius, height, elevation, side);
        let toward = window.right.cross(Vec3::Y);
        for texel in chain.iter_mut().flat_map(|tile| &mut tile.texels) {
            let n = texel.normal;
            texel.normal = Vec3::new(n.dot(window.right), n.y, n.dot(toward));
            texel.albedo *= depth_shade(texel.height_share, open);
        }
        chain
    };
    let chains: Vec<Chain> = (0..count).into_par_iter().map(layer).collect();
    Clusters {
        color: Layers::new(&chains, color_of),
        shape: Layers::new(&chains, shape_of),
        radius_m: radius,
        height_m: height,
    }
}
