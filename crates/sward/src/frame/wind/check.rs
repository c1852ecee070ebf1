//! What settings of a source are allowed.

use super::source::WindSource;
use crate::Error;
use glam::Vec3;

/// A setting: name, value, least, most.
type Setting = (&'static str, f32, f32, f32);

/// Farthest place of a source, metres: beyond, `f32` has no millimetres left.
const FARTHEST_M: f32 = 1e6;

impl WindSource {
    /// Where all settings make sense; else an error that names the first that does not.
    pub(super) fn check(&self, path: &str) -> Result<(), Error> {
        if let Some(direction) = self.direction()
            && direction.try_normalize().is_none()
        {
            let cause = format!("{direction} is no direction; give finite numbers, not all 0");
            return Err(Error::setting(format!("{path}.direction"), cause));
        }
        let [position, velocity] = self.motion();
        for (name, vector, most) in
            [("position", position, FARTHEST_M), ("velocity", velocity, 1e3)]
        {
            if !vector.to_array().iter().all(|c| c.abs() <= most) {
                let cause = format!("{vector} is not within {most} along each axis");
                return Err(Error::setting(format!("{path}.{name}"), cause));
            }
        }
        for (name, value, min, max) in self.settings() {
            if !(min..=max).contains(&value) {
                let cause = format!("{value} is not in {min} to {max}");
                return Err(Error::setting(format!("{path}.{name}"), cause));
            }
        }
        Ok(())
    }

    /// `None` for kinds that have no direction.
    fn direction(&self) -> Option<Vec3> {
        match self {
            Self::Waves(w) => Some(w.direction.extend(0.0)),
            Self::Gusts(g) => Some(g.direction.extend(0.0)),
            Self::Cosine(c) => Some(c.direction.extend(0.0)),
            Self::Fan(fan) => Some(fan.direction),
            Self::Texture(t) => Some(t.direction.extend(0.0)),
            Self::Rotor(_) | Self::Vortex(_) => None,
        }
    }

    /// Position and velocity, zero for kinds without a place.
    pub(super) fn motion(&self) -> [Vec3; 2] {
        match self {
            Self::Waves(_) | Self::Gusts(_) | Self::Cosine(_) | Self::Texture(_) => [Vec3::ZERO; 2],
            Self::Rotor(rotor) => [rotor.position, rotor.velocity],
            Self::Vortex(vortex) => [vortex.position, vortex.velocity],
            Self::Fan(fan) => [fan.position, fan.velocity],
        }
    }

    fn settings(&self) -> Vec<Setting> {
        match self {
            Self::Waves(w) => vec![
                ("mean", w.mean, -100.0, 100.0),
                ("amplitude", w.amplitude, 0.0, 100.0),
                ("wavelength_m", w.wavelength_m, 0.01, 1e4),
                ("speed_mps", w.speed_mps, -1e3, 1e3),
            ],
            Self::Gusts(g) => vec![
                ("strength", g.strength, 0.0, 100.0),
                ("size_m", g.size_m, 0.01, 1e4),
                ("speed_mps", g.speed_mps, -1e3, 1e3),
                ("turbulence", g.turbulence, 0.0, 1.0),
            ],
            Self::Cosine(c) => vec![
                ("strength", c.strength, 0.0, 100.0),
                ("period_s", c.period_s, 0.01, 1e4),
                ("wavelength_m", c.wavelength_m, 0.01, f32::INFINITY),
            ],
            Self::Texture(t) => vec![
                ("strength", t.strength, 0.0, 100.0),
                ("size_m", t.size_m, 0.01, 1e5),
                ("speed_mps", t.speed_mps, -1e3, 1e3),
            ],
            Self::Rotor(r) => vec![
                ("radius_m", r.radius_m, 0.01, 1e3),
                ("strength", r.strength, 0.0, 100.0),
                ("range_m", r.range_m, 0.01, 1e4),
                ("downwash", r.downwash, 0.0, 4.0),
                ("swirl", r.swirl, -4.0, 4.0),
                ("blades", r.blades as f32, 1.0, 16.0),
                ("rpm", r.rpm, -1e4, 1e4),
                ("pulse", r.pulse, 0.0, 1.0),
                ("speed_mps", r.speed_mps, 0.01, 1e3),
                ("turbulence", r.turbulence, 0.0, 1.0),
            ],
            Self::Vortex(v) => vec![
                ("radius_m", v.radius_m, 0.01, 1e3),
                ("strength", v.strength, 0.0, 100.0),
                ("range_m", v.range_m, 0.01, 1e4),
                ("inflow", v.inflow, -4.0, 4.0),
                ("updraft", v.updraft, -4.0, 4.0),
                ("speed_mps", v.speed_mps, 0.01, 1e3),
                ("turbulence", v.turbulence, 0.0, 1.0),
            ],
            Self::Fan(f) => vec![
                ("radius_m", f.radius_m, 0.01, 1e3),
                ("half_angle_deg", f.half_angle_deg, 0.1, 80.0),
                ("strength", f.strength, 0.0, 100.0),
                ("range_m", f.range_m, 0.01, 1e4),
                ("speed_mps", f.speed_mps, 0.0, 1e3),
                ("turbulence", f.turbulence, 0.0, 1.0),
            ],
        }
    }
}
