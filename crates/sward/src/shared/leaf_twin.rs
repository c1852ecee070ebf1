//! leaf.wgsl on the CPU, in `f64`: what is baked, and the reference of tests.

use glam::{DVec2, DVec3, dvec2, dvec3};
#[cfg(test)]
use std::f64::consts::PI;

#[cfg(test)]
const FACING: f64 = 0.04;
const DRY: DVec2 = dvec2(0.45, 0.28);
const WET: DVec2 = dvec2(0.2, 0.12);
/// How much more of what passes goes straight on than to the sides.
pub(crate) const STRAIGHT: f64 = 1.8;
/// Mean of [`straight_mean`] over all directions.
#[cfg(test)]
pub(crate) const STRAIGHT_MEAN: f64 = 17.0 / 72.0;
const BACK: f64 = 0.55;
const THIN: f64 = 0.8;
const WAY: DVec3 = dvec3(1.15, 1.25, 1.4);

/// A leaf's surface.
#[cfg(test)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Leaf {
    /// Share of the light that it scatters back, of what is not mirrored.
    pub reflects: DVec3,
    /// Share that passes.
    pub passes: DVec3,
    /// Its face.
    pub face: Face,
}

/// What mirrors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Face {
    /// Squares of the GGX roughness across and along.
    pub rough: DVec2,
    /// 1 over 1 less the share that is mirrored in the mean over all directions.
    pub inner: f64,
}

/// What passes a leaf of that reflectance and thickness; 1 is a blade of grass.
pub(crate) fn passes(reflects: DVec3, thickness: f64) -> DVec3 {
    let a = reflects.clamp(DVec3::splat(1e-4), DVec3::ONE);
    let rest = BACK * (DVec3::ONE - a);
    let back = DVec3::from_array((a * a + rest * rest).to_array().map(f64::sqrt));
    (DVec3::ONE - back) * power(a / back, WAY * thickness.max(THIN))
}

fn power(base: DVec3, exponent: DVec3) -> DVec3 {
    DVec3::from_array([0, 1, 2].map(|i| base[i].powf(exponent[i])))
}

impl Face {
    /// 0 dry, 1 wet.
    pub(crate) fn new(wetness: f64) -> Self {
        let rough = DRY.lerp(WET, wetness);
        let mean = 0.0457 + wetness * (0.0137 + wetness * 0.0046);
        Self { rough: rough * rough, inner: 1.0 / (1.0 - mean) }
    }

    /// Share of light that the face mirrors, all in all, from a direction.
    pub(crate) fn mirrored(&self, d: DVec3) -> f64 {
        let level = d.truncate() * d.truncate();
        let q = level.dot(self.rough) / level.element_sum().max(1e-6);
        let i = 1.0 / (q + 0.02);
        let x4 = (1.0 - d.z.abs().min(1.0)).powi(4);
        let low = 0.0151 * i + 0.0445 + 0.0174 * q + x4 * (0.022 - 0.0059 * i - 0.006 * q);
        0.0478 - 0.0002 * i - 0.0736 * q + x4 * low
    }

    /// How much facets hide each other, over 4 times both cosines.
    pub(crate) fn hiding(&self, v: DVec3, l: DVec3) -> f64 {
        let hide = |d: DVec3| {
            let level = d.truncate() * d.truncate();
            (d.z * d.z + level.dot(self.rough)).sqrt()
        };
        0.5 / (v.z * hide(l) + l.z * hide(v)).max(1e-6)
    }

    /// What it mirrors but for Fresnel's share.
    #[cfg(test)]
    fn gloss(&self, v: DVec3, l: DVec3, h: DVec3) -> f64 {
        let level = h.truncate() * h.truncate();
        let spread = (level / self.rough).element_sum() + h.z * h.z;
        let facets = 1.0 / ((self.rough.x * self.rough.y).sqrt() * PI * spread * spread);
        facets * self.hiding(v, l)
    }
}

/// Fresnel's law after Schlick.
#[cfg(test)]
fn fresnel(cosine: f64) -> f64 {
    FACING + (1.0 - FACING) * (1.0 - cosine.clamp(0.0, 1.0)).powi(5)
}

/// Mean of the fourth power of the cosine between a direction and those on the other side.
pub(crate) fn straight_mean(cosine: f64) -> f64 {
    let c2 = cosine * cosine;
    0.125 + c2 * (0.25 - c2 / 24.0)
}

/// How much more than in the mean passes from a direction to another.
#[cfg(test)]
fn straight(v: DVec3, l: DVec3) -> f64 {
    let means = straight_mean(v.z) + straight_mean(l.z) - STRAIGHT_MEAN;
    1.0 + STRAIGHT * (v.dot(l).powi(4) - means)
}

#[cfg(test)]
impl Leaf {
    /// The whole function: see leaf.wgsl.
    pub(crate) fn bsdf(&self, v: DVec3, l: DVec3) -> DVec3 {
        let face = &self.face;
        let kept = (1.0 - face.mirrored(v)) * (1.0 - face.mirrored(l));
        let scattered = kept * face.inner / PI;
        if v.z * l.z <= 0.0 {
            return self.passes * (scattered * straight(v, l));
        }
        let side = v.z.signum();
        let h = (v + l).normalize_or(DVec3::Z) * side;
        let gloss = face.gloss(v * side, l * side, h) * fresnel((v * side).dot(h));
        self.reflects * scattered + DVec3::splat(gloss)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WETNESS: [f64; 4] = [0.0, 0.3, 0.7, 1.0];

    fn leaf(wetness: f64, reflects: f64, passes: f64) -> Leaf {
        let [reflects, passes] = [reflects, passes].map(DVec3::splat);
        Leaf { reflects, passes, face: Face::new(wetness) }
    }

    fn direction(cosine: f64, angle: f64) -> DVec3 {
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        DVec3::new(sine * angle.cos(), sine * angle.sin(), cosine)
    }

    /// From low over the leaf to straight above it, across and along it.
    fn views() -> impl Iterator<Item = DVec3> {
        let cosines = [0.01, 0.03, 0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 1.0];
        let angles = [0.0, 0.4, 0.8, 1.2, PI / 2.0, 2.5];
        cosines.into_iter().flat_map(move |c| angles.map(|a| direction(c, a)))
    }

    /// All that leaves towards v of light that is 1 from everywhere: what is mirrored by half-way
    /// directions drawn as facets lie, the rest over both half spheres.
    fn furnace(leaf: &Leaf, v: DVec3) -> f64 {
        const N: u32 = 96;
        let spread = |i: u32, n: u32| (f64::from(i) + 0.5) / f64::from(n);
        let (mut mirrored, mut scattered) = (0.0, 0.0);
        for (i, j) in (0..N).flat_map(|i| (0..N).map(move |j| (i, j))) {
            let (t, angle) = (spread(i, N), 2.0 * PI * spread(j, N));
            // Denser towards the facets that are steep
            let u = 1.0 - (1.0 - t).powi(2);
            let slope = (u / (1.0 - u)).sqrt();
            let [across, along] = [leaf.face.rough.x, leaf.face.rough.y].map(f64::sqrt);
            let h = DVec3::new(slope * across * angle.cos(), slope * along * angle.sin(), 1.0);
            let h = h.normalize();
            let l = 2.0 * v.dot(h) * h - v;
            if v.dot(h) > 0.0 && l.z > 0.0 {
                // The density over l is facets * h.z / (4 v.h)
                let weight =
                    leaf.face.hiding(v, l) * fresnel(v.dot(h)) * l.z * 4.0 * v.dot(h) / h.z;
                mirrored += weight * 2.0 * (1.0 - t);
            }
            for side in [1.0, -1.0] {
                let l = direction(side * t.sqrt(), angle);
                let gloss = if side > 0.0 {
                    let h = (v + l).normalize();
                    leaf.face.gloss(v, l, h) * fresnel(v.dot(h))
                } else {
                    0.0
                };
                scattered += PI * (leaf.bsdf(v, l).x - gloss);
            }
        }
        (mirrored + scattered) / f64::from(N * N)
    }

    /// A leaf that absorbs nothing is not seen where light is the same from everywhere.
    #[test]
    fn white_furnace() {
        let mut worst = 0.0_f64;
        for wetness in WETNESS {
            for (reflects, passes) in [(1.0, 0.0), (0.5, 0.5), (0.2, 0.8), (0.0, 1.0)] {
                let leaf = leaf(wetness, reflects, passes);
                for v in views() {
                    let all = furnace(&leaf, v);
                    worst = worst.max((all - 1.0).abs());
                }
            }
        }
        println!("off by up to {worst}");
        assert!(worst < 0.02, "{worst}");
    }

    /// What a black leaf mirrors is what the fit says.
    #[test]
    fn mirrored_is_the_integral() {
        for wetness in WETNESS {
            let leaf = leaf(wetness, 0.0, 0.0);
            for v in views() {
                let (found, fit) = (furnace(&leaf, v), leaf.face.mirrored(v));
                assert!((found - fit).abs() < 0.02, "{wetness} {v}: {found} of {fit}");
                assert!((0.02..0.5).contains(&fit));
            }
        }
    }

    #[test]
    fn no_leaf_sends_out_more_than_comes() {
        for thickness in [0.0, 0.8, 1.0, 4.0] {
            for reflects in (0..=20).map(|i| DVec3::splat(f64::from(i) / 20.0)) {
                let all = reflects + passes(reflects, thickness);
                assert!(all.x <= 1.0 + 1e-3 && all.x >= 0.0, "{reflects} {thickness}: {all}");
            }
        }
    }

    /// The thicker, the darker and the more of its own hue; light that passes is yellower than light off it.
    #[test]
    fn light_through_a_leaf_has_more_of_its_colour() {
        let green = DVec3::new(0.22, 0.34, 0.07);
        let [thin, plain, thick] = [0.8, 1.0, 2.0].map(|d| passes(green, d));
        assert!(thick.cmplt(plain).all() && plain.cmplt(thin).all());
        let blue = |c: DVec3| c.z / c.y;
        assert!(blue(thick) < blue(plain) && blue(plain) < blue(thin) && blue(plain) < blue(green));
        assert!(plain.x / plain.y > green.x / green.y, "{plain}");
    }

    /// Straight on more passes than to the sides, and in all as much.
    #[test]
    fn light_through_a_leaf_goes_straight_on() {
        let leaf = leaf(0.0, 0.0, 1.0);
        let on = leaf.bsdf(DVec3::Z, DVec3::NEG_Z).x;
        let aside = leaf.bsdf(DVec3::Z, direction(-0.5, 0.3)).x;
        assert!(on > 1.5 * aside && aside > 0.0, "{on} {aside}");
        for v in views() {
            let least = views().map(|l| straight(v, -l).min(straight(v, direction(-l.z, 0.1))));
            assert!(least.fold(1.0, f64::min) > 0.2);
        }
    }

    /// Gloss is narrow along the blade and wide across it.
    #[test]
    fn gloss_runs_across_what_is_smooth() {
        let face = Face::new(0.0);
        let v = direction(0.8, 1.0);
        let at = |x: f64, y: f64| {
            let h = DVec3::new(x, y, 1.0).normalize();
            face.gloss(v, 2.0 * v.dot(h) * h - v, h)
        };
        assert!(at(0.25, 0.0) > 1.5 * at(0.0, 0.25));
    }
}
