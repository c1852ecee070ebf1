//! Scattering: a surface and a density become roots.
//!
//! Single blades are area-weighted and stratified: the surface's area, triangle after triangle, is
//! cut into as many equal steps as there are blades, and each blade takes a random place of its
//! own step. Inside a triangle a step is again a compact part ([`Fragment`]), so that blades clump
//! less than fully random ones, at the same expected density everywhere.

use super::fragment::Fragment;
use super::mask::Mask;
use super::random::{Purpose, Stream};
use super::surface::{Spot, Surface};
use super::tint::Tint;
use super::tufts;
use crate::{Error, FieldDesc};
use glam::Vec3;
use rayon::prelude::*;

/// Blades of one piece of parallel work.
const CHUNK: u64 = 8192;

/// Where a blade stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Root {
    pub(crate) position: Vec3,
    /// Unit normal of the surface.
    pub(crate) normal: Vec3,
    /// Added to the up direction: blades of a tuft spread outward.
    pub(crate) lean: Vec3,
    /// Number among its kind (single or tuft blade), the key of its hashes. Thinning leaves it,
    /// so a mask removes blades and changes none.
    pub(crate) key: u32,
    /// The tuft, if any.
    pub(crate) tuft: Option<u32>,
    /// Colour of the surface, packed; 0 where the field takes none.
    pub(crate) tint: u32,
}

/// Scatters all roots of a field. The description has been checked.
///
/// # Errors
/// Where the density asks for too many blades or none, or the mask removes all.
pub(crate) fn roots(surface: &Surface, desc: &FieldDesc) -> Result<Vec<Root>, Error> {
    let mask = Mask::new(surface, desc)?;
    let tint = Tint::new(surface, desc)?;
    let count = blade_count(surface, desc)?;
    let share = desc.tufts.map_or(0.0, |t| f64::from(t.share));
    let in_tufts = (count as f64 * share).round() as u64;
    let (mut roots, tuft_roots) = rayon::join(
        || singles(surface, count - in_tufts, desc.seed, &mask, &tint),
        || tufts::roots(surface, in_tufts, desc, &mask, &tint),
    );
    roots.extend(tuft_roots);
    if roots.is_empty() {
        return Err(Error::mesh(format!(
            "nothing grows: the density map, max_slope_deg, height_limits_m and obstacles remove all \
             {count} blades; widen or move them"
        )));
    }
    Ok(roots)
}

/// Number of blades before thinning.
fn blade_count(surface: &Surface, desc: &FieldDesc) -> Result<u64, Error> {
    let (area_m2, wanted) = (surface.area_m2(), desc.planned_blades(surface));
    let fit = desc.max_blades.min(u64::from(u32::MAX));
    if let Some(count) = desc.count {
        if (1..=fit).contains(&count) {
            return Ok(count);
        }
        return Err(Error::setting("count", format!("{count} is out of range; 1 to {fit} fit")));
    }
    if wanted > fit {
        return Err(Error::setting(
            "density",
            format!(
                "{} blades on each of {area_m2:.6} m2 make {wanted} blades, but {fit} fit; use at \
                 most {:.6} blades a square metre, or a smaller mesh",
                desc.density,
                fit as f64 / area_m2
            ),
        ));
    }
    if wanted == 0 {
        return Err(Error::setting(
            "density",
            format!(
                "{} blades on each of {area_m2:e} m2 make no blade; use at least {:e}, or check that \
                 the mesh is in metres",
                desc.density,
                1.0 / area_m2
            ),
        ));
    }
    Ok(wanted)
}

fn singles(surface: &Surface, count: u64, seed: u64, mask: &Mask, tint: &Tint) -> Vec<Root> {
    let stream = Stream::new(seed, Purpose::Single);
    let step_m2 = surface.area_m2() / count.max(1) as f64;
    (0..count.div_ceil(CHUNK))
        .into_par_iter()
        .flat_map_iter(|chunk| {
            let first = chunk * CHUNK;
            let cumulative = surface.cumulative_m2();
            let mut triangle = cumulative.partition_point(|&a| a <= first as f64 * step_m2);
            (first..count.min(first + CHUNK)).filter_map(move |i| {
                let mut draws = stream.at(i);
                let at_m2 = (i as f64 + draws.unit_f64()) * step_m2;
                while triangle + 1 < cumulative.len() && cumulative[triangle] <= at_m2 {
                    triangle += 1;
                }
                let triangle = triangle.min(cumulative.len() - 1);
                let (start_m2, own_m2) = surface.area_span_m2(triangle);
                // Rounding of the sums can leave the triangle by a hair.
                let t = ((at_m2 - start_m2) / own_m2).clamp(0.0, 1.0 - f64::EPSILON);
                let fragment = Fragment::at(t, levels(own_m2 / step_m2));
                let spot = surface.spot(triangle as u32, fragment.point(&mut draws));
                mask.keeps(&spot, draws.unit()).then(|| Root::new(spot, i as u32, tint))
            })
        })
        .collect()
}

impl Root {
    fn new(spot: Spot, key: u32, tint: &Tint) -> Self {
        let tint = tint.at(&spot);
        let (position, normal) = (spot.position, spot.normal);
        Self { position, normal, lean: Vec3::ZERO, key, tuft: None, tint }
    }
}

/// Cuts until a part is a quarter of a blade's step or less.
fn levels(blades: f64) -> u32 {
    if blades < 1.0 { 0 } else { ((blades * 4.0) as u64).ilog2() / 2 + 1 }
}
