//! What the air holds at a height, and how rays lie in it. Kilometres; f64, as a metre is little
//! beside the Earth.

use glam::DVec3;

/// Radius of the ground.
pub(super) const GROUND_KM: f64 = 6360.0;
/// Radius at which the air ends.
pub(super) const TOP_KM: f64 = 6460.0;
/// Half the angle that the sun, or the moon, is wide, radians.
pub(super) const DISC_RAD: f64 = 0.004_65;

/// Scattering by molecules at the ground for 610, 545 and 460 nm, a kilometre: Hillaire's (table 1) by the
/// fourth power of the wavelength. His 680 and 440 nm are far out in what sRGB's red and blue cover; with
/// them the low sun is redder than pictures show it, and the sky a deeper blue.
const RAYLEIGH: DVec3 = DVec3::new(8.96e-3, 14.06e-3, 27.7e-3);
/// Height over which molecules thin to 1/e.
const RAYLEIGH_KM: f64 = 8.0;
/// Height over which aerosols thin to 1/e.
const MIE_KM: f64 = 1.2;
/// Share of the light that aerosols scatter of what they take (Hillaire: 3.996 of 4.44).
const MIE_ALBEDO: f64 = 0.9;
/// Aerosols' extinction by colour against green: the inverse of the wavelength (Angstrom exponent 1).
const MIE_COLOR: DVec3 = DVec3::new(0.90, 1.01, 1.20);
/// Asymmetry of the light that aerosols scatter: mostly ahead; that of dust over land.
const MIE_AHEAD: f64 = 0.7;
/// Absorption by ozone where it is densest, a kilometre.
const OZONE: DVec3 = DVec3::new(2.5e-3, 1.85e-3, 0.2e-3);

/// Air of one turbidity.
#[derive(Debug, Clone, Copy)]
pub(super) struct Air {
    /// Extinction by aerosols at the ground, a kilometre.
    mie: DVec3,
}

/// Coefficients at a height, a kilometre.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mixture {
    pub(super) rayleigh: DVec3,
    pub(super) mie: DVec3,
    pub(super) extinction: DVec3,
}

impl Air {
    /// Turbidity is the optical depth of air with aerosols over that of air without, straight up, in
    /// green: 1 is pure air.
    pub(super) fn new(turbidity: f64) -> Self {
        let pure = RAYLEIGH.y * RAYLEIGH_KM;
        Self { mie: MIE_COLOR * ((turbidity - 1.0).max(0.0) * pure / MIE_KM) }
    }

    pub(super) fn at(&self, height_km: f64) -> Mixture {
        let height = height_km.max(0.0);
        let rayleigh = RAYLEIGH * (-height / RAYLEIGH_KM).exp();
        let aerosols = self.mie * (-height / MIE_KM).exp();
        let ozone = OZONE * (1.0 - (height - 25.0).abs() / 15.0).max(0.0);
        let mie = aerosols * MIE_ALBEDO;
        Mixture { rayleigh, mie, extinction: rayleigh + aerosols + ozone }
    }
}

/// Share of the light that molecules scatter into a direction, a steradian; by the angle's cosine.
pub(super) fn rayleigh_phase(cos: f64) -> f64 {
    3.0 / (16.0 * std::f64::consts::PI) * (1.0 + cos * cos)
}

/// The same of aerosols: Cornette and Shanks 1992.
pub(super) fn mie_phase(cos: f64) -> f64 {
    let g2 = MIE_AHEAD * MIE_AHEAD;
    let spread = (1.0 + g2 - 2.0 * MIE_AHEAD * cos).max(1e-6);
    3.0 / (8.0 * std::f64::consts::PI) * (1.0 - g2) * (1.0 + cos * cos)
        / ((2.0 + g2) * spread * spread.sqrt())
}

/// A ray in the air: its start's distance from the Earth's centre, and the cosine of its angle to
/// straight up there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ray {
    pub(super) radius: f64,
    pub(super) up: f64,
}

impl Ray {
    /// Kilometres to where the air ends, were there no ground.
    pub(super) fn to_top(self) -> f64 {
        let inside = self.radius * self.radius * (self.up * self.up - 1.0) + TOP_KM * TOP_KM;
        (inside.max(0.0).sqrt() - self.radius * self.up).max(0.0)
    }

    /// Kilometres to the ground, where it meets that.
    pub(super) fn to_ground(self) -> Option<f64> {
        let inside = self.radius * self.radius * (self.up * self.up - 1.0) + GROUND_KM * GROUND_KM;
        (self.up < 0.0 && inside >= 0.0).then(|| (-self.radius * self.up - inside.sqrt()).max(0.0))
    }

    /// Cosine of the ray that just passes the ground.
    pub(super) fn horizon(radius: f64) -> f64 {
        let ratio = (GROUND_KM / radius).min(1.0);
        -(1.0 - ratio * ratio).max(0.0).sqrt()
    }
}
