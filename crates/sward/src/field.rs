//! A field: a surface, its species, density and seed, grown into blades and patches.

use crate::error::{above_zero, within};
use crate::gpu::quantize::unpack_color;
use crate::grow::obstacles::Obstacle;
use crate::grow::surface::Surface;
use crate::grow::{self, Blade, Patch};
use crate::{ColorMap, Error, Species};
use glam::Vec3;

/// Tufts: blades seeded round Poisson-disk samples (Cline et al. 2009). The blades of a tuft are of
/// one species, share a size, and lean and face outward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tufts {
    /// Share of all blades that grow in tufts, 0..=1; the rest are scattered singly.
    pub share: f32,
    /// Least straight-line distance between tufts, metres: larger gives fewer, fuller tufts; smaller
    /// costs growing time. Widened where there would be more tufts than blades for them.
    pub radius_m: f32,
    /// How far from its centre a tuft's blades stand at most, metres, measured along the surface.
    pub spread_m: f32,
}

/// A map that thins the density: 0 is bare, 1 keeps all.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum DensityMap {
    /// Sampled through the mesh's UVs, wrapping, bilinear; row 0 is v = 0.
    Texture {
        /// Width, texels.
        width: u32,
        /// Height, texels.
        height: u32,
        /// Row-major values, 0..=1.
        values: Vec<f32>,
    },
    /// The red channel of the mesh's vertex colours.
    VertexColor,
}

/// Distance used when blades are grouped into patches. Both split groups in two along an axis until
/// they fit; they differ in the axis that they choose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Metric {
    /// Straight-line distance: splits the axis of greatest variance, so that blades far off count
    /// more: rounder patches.
    #[default]
    Euclidean,
    /// Sum of the axes' distances: splits the axis of greatest mean deviation, so that stray
    /// blades count less: boxier patches.
    Manhattan,
}

/// Order of the blades inside a patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BladeOrder {
    /// Every prefix, of any length, is spread over the patch as evenly as the whole, so that
    /// thinning is a prefix.
    #[default]
    Progressive,
    /// Morton order, as equation 20 of J needs it: neighbours are near each other.
    Morton,
    /// Sorted by x, then y, then z.
    Lexicographic,
}

/// What to grow.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldDesc {
    /// Blades a square metre, before thinning by map, slope and height. More costs memory (32
    /// bytes a blade) and frame time.
    pub density: f32,
    /// Blades in all, exactly, in place of `density`, which then is not used; before thinning by
    /// map, slope and height, as `density` is.
    pub count: Option<u64>,
    /// Same seed, same field, bit for bit.
    pub seed: u64,
    /// The mix; 1 to 256 kinds.
    pub species: Vec<Species>,
    /// Tufts, where some blades grow in them.
    pub tufts: Option<Tufts>,
    /// Map that thins the density.
    pub density_map: Option<DensityMap>,
    /// Map that colours the blades, such as the surface's own texture; 4 bytes a blade. `None`: the
    /// species' colours alone.
    pub color_map: Option<ColorMap>,
    /// How far the map replaces the species' colours, 0..=1; without a map it is not used.
    pub color_mix: f32,
    /// Steepest slope that bears grass, degrees from level (0..=180); 180 sets no limit.
    pub max_slope_deg: f32,
    /// World heights (y) that bear grass, metres.
    pub height_limits_m: (f32, f32),
    /// Things in world space that no root grows inside of; blades elsewhere stay as they are
    /// without them.
    pub obstacles: Vec<Obstacle>,
    /// 0 grows along the surface's normal, 1 straight up (+y).
    pub upright: f32,
    /// Blades a patch: a multiple of 64, at most 1024. Smaller patches cull more exactly and cost
    /// more to test.
    pub patch_size: u32,
    /// Distance used to group blades.
    pub metric: Metric,
    /// Order inside a patch.
    pub order: BladeOrder,
    /// Most blades to grow; more is an error that says how many fit.
    pub max_blades: u64,
}

impl Default for FieldDesc {
    fn default() -> Self {
        Self {
            density: 400.0,
            count: None,
            seed: 1,
            species: vec![Species::default()],
            tufts: None,
            density_map: None,
            color_map: None,
            color_mix: 0.9,
            max_slope_deg: 180.0,
            height_limits_m: (f32::NEG_INFINITY, f32::INFINITY),
            obstacles: Vec::new(),
            upright: 0.0,
            patch_size: 256,
            metric: Metric::Euclidean,
            order: BladeOrder::Progressive,
            max_blades: u64::MAX,
        }
    }
}

/// A grown field.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    species: Vec<Species>,
    blades: Vec<Blade>,
    tints: Vec<u32>,
    tint_mix: f32,
    patches: Vec<Patch>,
    patch_size: u32,
    order: BladeOrder,
}

impl Field {
    /// Grows a field on a surface. Deterministic: the same input gives the same field, bit for
    /// bit, for any number of threads.
    ///
    /// `density` times the surface's area, before thinning, must be at most `max_blades`, and in
    /// any case at most `u32::MAX`.
    ///
    /// # Errors
    /// [`Error::Setting`] for a value out of range, [`Error::Mesh`] where nothing can grow.
    pub fn grow(surface: &Surface, desc: &FieldDesc) -> Result<Self, Error> {
        desc.check()?;
        let roots = grow::scatter::roots(surface, desc)?;
        let blades = grow::blades::blades(&roots, desc);
        let tinted = roots.iter().filter(|_| desc.color_map.is_some());
        let tints: Vec<u32> = tinted.map(|root| root.tint).collect();
        drop(roots);
        let species = desc.species.clone();
        let mut field =
            Self::arrange(species, &blades, &tints, desc.patch_size, desc.metric, desc.order);
        field.tint_mix = desc.color_mix;
        Ok(field)
    }

    /// A field of blades placed by hand. They are sorted into patches, so their order changes.
    ///
    /// # Errors
    /// [`Error::Setting`] for a value out of range; the message names the blade.
    pub fn from_blades(
        species: Vec<Species>,
        blades: &[Blade],
        patch_size: u32,
        metric: Metric,
        order: BladeOrder,
    ) -> Result<Self, Error> {
        check_species(&species)?;
        check_patch_size(patch_size)?;
        if blades.is_empty() || blades.len() > u32::MAX as usize {
            let cause = format!("there are {}; use 1 to {}", blades.len(), u32::MAX);
            return Err(Error::setting("blades", cause));
        }
        for (i, blade) in blades.iter().enumerate() {
            blade.check(i, &species)?;
        }
        Ok(Self::arrange(species, blades, &[], patch_size, metric, order))
    }

    fn arrange(
        species: Vec<Species>,
        blades: &[Blade],
        tints: &[u32],
        patch_size: u32,
        metric: Metric,
        order: BladeOrder,
    ) -> Self {
        let (blades, tints, patches) =
            grow::patches::arrange(blades, tints, patch_size, metric, order);
        Self { species, blades, tints, tint_mix: 0.0, patches, patch_size, order }
    }

    /// The species of the mix.
    pub fn species(&self) -> &[Species] {
        &self.species
    }
    /// All blades, patch by patch.
    pub fn blades(&self) -> &[Blade] {
        &self.blades
    }
    /// The colour that a blade takes from the colour map, linear RGB; `None` without a map.
    pub fn color(&self, blade: usize) -> Option<[f32; 3]> {
        self.tints.get(blade).map(|bits| unpack_color(*bits))
    }
    /// Packed colours by blade; empty without a map.
    pub(crate) fn tints(&self) -> &[u32] {
        &self.tints
    }
    /// How far they replace the species' colours.
    pub(crate) fn tint_mix(&self) -> f32 {
        self.tint_mix
    }
    /// All patches.
    pub fn patches(&self) -> &[Patch] {
        &self.patches
    }
    /// Blades a patch (the last may have fewer).
    pub fn patch_size(&self) -> u32 {
        self.patch_size
    }
    /// Order of the blades inside a patch.
    pub fn order(&self) -> BladeOrder {
        self.order
    }
    /// Smallest and largest corner of a box that holds every pose of every blade, metres.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        (self.patches.iter()).fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), patch| {
            (low.min(patch.reach_min), high.max(patch.reach_max))
        })
    }
}

impl FieldDesc {
    /// Blades that growing starts with: `count`, or `density` times the area; the density map, the
    /// slope, the heights and the obstacles remove some of them. Known at once, so that a host can refuse a field
    /// that does not fit (see [`crate::Renderer::check_blades`]) before it grows.
    pub fn planned_blades(&self, surface: &Surface) -> u64 {
        // The conversion saturates; no blade comes of NaN.
        self.count.unwrap_or((f64::from(self.density) * surface.area_m2()).round() as u64)
    }

    /// Checks every value.
    fn check(&self) -> Result<(), Error> {
        if self.count.is_none() {
            above_zero("density", self.density, 1e9)?;
        }
        check_species(&self.species)?;
        if let Some(tufts) = &self.tufts {
            within("tufts.share", tufts.share, 0.0, 1.0)?;
            above_zero("tufts.radius_m", tufts.radius_m, 1e6)?;
            within("tufts.spread_m", tufts.spread_m, 0.0, 1e6)?;
        }
        if let Some(map) = &self.density_map {
            map.check()?;
        }
        if let Some(map) = &self.color_map {
            map.check()?;
        }
        within("color_mix", self.color_mix, 0.0, 1.0)?;
        within("max_slope_deg", self.max_slope_deg, 0.0, 180.0)?;
        let (low, high) = self.height_limits_m;
        if low.is_nan() || high.is_nan() || low > high {
            let cause = format!("{low} to {high} holds no height; give the lower limit first");
            return Err(Error::setting("height_limits_m", cause));
        }
        self.obstacles.iter().enumerate().try_for_each(|(i, obstacle)| obstacle.check(i))?;
        within("upright", self.upright, 0.0, 1.0)?;
        check_patch_size(self.patch_size)?;
        if self.max_blades == 0 {
            return Err(Error::setting("max_blades", "0 lets nothing grow; use at least 1"));
        }
        Ok(())
    }
}

impl DensityMap {
    fn check(&self) -> Result<(), Error> {
        let Self::Texture { width, height, values } = self else {
            return Ok(());
        };
        let texels = u64::from(*width) * u64::from(*height);
        if texels == 0 || texels != values.len() as u64 {
            let cause = format!("{width} x {height} texels, but {} values", values.len());
            return Err(Error::setting("density_map", cause));
        }
        match values.iter().position(|v| !(0.0..=1.0).contains(v)) {
            None => Ok(()),
            Some(i) => {
                let cause = format!("value {i} is {}; use 0 to 1", values[i]);
                Err(Error::setting("density_map", cause))
            }
        }
    }
}

fn check_species(species: &[Species]) -> Result<(), Error> {
    if species.is_empty() || species.len() > 256 {
        let cause = format!("there are {}; use 1 to 256", species.len());
        return Err(Error::setting("species", cause));
    }
    species.iter().enumerate().try_for_each(|(i, s)| s.check(&format!("species[{i}]")))
}

fn check_patch_size(size: u32) -> Result<(), Error> {
    if size == 0 || size > 1024 || !size.is_multiple_of(64) {
        let cause = format!("{size} is out of range; use a multiple of 64, at most 1024");
        return Err(Error::setting("patch_size", cause));
    }
    Ok(())
}
