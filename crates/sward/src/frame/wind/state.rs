//! From settings and phases to the numbers that wind is worked out from, on the CPU and on the GPU.

use super::source::{Fan, Rotor, Vortex, WindSource};
use super::twin::{Kind, Source, WAVE_CELLS};
use crate::shared::noise_twin::NOISE_PERIOD;
use glam::{DVec2, DVec3, dvec2, dvec3};
use std::f64::consts::TAU;

/// Cells of turbulence that a whirl carries gusts over before they are drawn anew.
const CARRIED_CELLS: f64 = 1.5;

/// What the GPU reads of one source: the mirror of the WGSL struct.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct GpuWindSource {
    pub kind: u32,
    pub seed: u32,
    pub direction: [f32; 2],
    pub strength: [f32; 2],
    pub frequency: f32,
    pub rate: f32,
    pub phase: [f32; 2],
    pub radius: f32,
    pub range: f32,
    pub position: [f32; 3],
    pub turbulence: f32,
    pub velocity: [f32; 3],
    pub spread: f32,
    pub flow: [f32; 3],
    pub carried: f32,
    pub spokes: u32,
    pub spoke_rate: f32,
    pub spoke_wind: f32,
    pub pulse: f32,
    pub map_row: u32,
    pub map_size: u32,
    pub reserved: [u32; 2],
}

impl WindSource {
    /// The source with its phase; none where its settings make no sense.
    pub(super) fn state(&self, phase: DVec2) -> Option<Source<'_>> {
        self.check("").ok()?;
        let [position, velocity] = self.motion().map(|v| v.as_dvec3());
        let placed = Source { position, velocity, phase, ..Source::default() };
        Some(match self {
            Self::Waves(w) => {
                let frequency = TAU / f64::from(w.wavelength_m);
                Source {
                    kind: Kind::Waves,
                    seed: 0x5eed,
                    direction: w.direction.as_dvec2().normalize(),
                    strength: dvec2(f64::from(w.mean), f64::from(w.amplitude)),
                    frequency,
                    rate: frequency * f64::from(w.speed_mps),
                    ..placed
                }
            }
            Self::Gusts(g) => Source {
                kind: Kind::Gusts,
                seed: g.seed,
                direction: g.direction.as_dvec2().normalize(),
                strength: dvec2(f64::from(g.strength), f64::from(g.turbulence)),
                frequency: 1.0 / f64::from(g.size_m),
                rate: f64::from(g.speed_mps),
                ..placed
            },
            Self::Cosine(c) => Source {
                kind: Kind::Cosine,
                direction: c.direction.as_dvec2().normalize(),
                strength: dvec2(f64::from(c.strength), 0.0),
                frequency: TAU / f64::from(c.wavelength_m),
                rate: TAU / f64::from(c.period_s),
                ..placed
            },
            Self::Texture(t) => Source {
                kind: Kind::Texture,
                direction: t.direction.as_dvec2().normalize(),
                strength: dvec2(f64::from(t.strength), 0.0),
                frequency: f64::from(t.map.width()) / f64::from(t.size_m),
                rate: f64::from(t.speed_mps),
                map: Some(&t.map),
                ..placed
            },
            Self::Rotor(r) => rotor(r, placed),
            Self::Vortex(v) => vortex(v, placed),
            Self::Fan(f) => fan(f, placed),
        })
    }
}

fn rotor<'a>(r: &Rotor, placed: Source<'a>) -> Source<'a> {
    let spoke_rate = f64::from(r.rpm) / 60.0 * TAU * f64::from(r.blades);
    let turn = if r.rpm < 0.0 { -1.0 } else { 1.0 };
    let flow = dvec3(1.0, turn * f64::from(r.swirl), -f64::from(r.downwash));
    Source {
        kind: Kind::Rotor,
        spokes: r.blades,
        spoke_rate,
        spoke_wind: spoke_rate / f64::from(r.speed_mps),
        pulse: f64::from(r.pulse),
        ..whirl(
            placed,
            flow,
            [r.radius_m, r.range_m, r.strength, r.turbulence, r.speed_mps],
            r.seed,
        )
    }
}

fn vortex<'a>(v: &Vortex, placed: Source<'a>) -> Source<'a> {
    let turn = if v.clockwise { -1.0 } else { 1.0 };
    let flow = dvec3(-f64::from(v.inflow), turn, f64::from(v.updraft));
    Source {
        kind: Kind::Vortex,
        ..whirl(
            placed,
            flow,
            [v.radius_m, v.range_m, v.strength, v.turbulence, v.speed_mps],
            v.seed,
        )
    }
}

/// What rotors and vortices have in common: `flow` is outward, around and upward.
fn whirl(placed: Source<'_>, flow: DVec3, settings: [f32; 5], seed: u32) -> Source<'_> {
    let [radius, range, strength, turbulence, speed] = settings.map(f64::from);
    let cell_m = 0.45 * radius;
    let carried = CARRIED_CELLS * cell_m;
    Source {
        seed,
        strength: dvec2(strength, 0.0),
        frequency: 1.0 / cell_m,
        rate: speed / carried,
        radius,
        range,
        turbulence,
        flow,
        // Where the flow is strongest it carries gusts so far.
        carried: carried / dvec2(flow.x, flow.y).length().max(1.0),
        ..placed
    }
}

fn fan<'a>(f: &Fan, placed: Source<'a>) -> Source<'a> {
    let axis = f.direction.as_dvec3().normalize();
    let side = dvec2(axis.z, -axis.x).try_normalize().unwrap_or(DVec2::X);
    Source {
        kind: Kind::Fan,
        seed: f.seed,
        direction: side,
        strength: dvec2(f64::from(f.strength), 0.0),
        frequency: 0.7 / f64::from(f.radius_m),
        rate: f64::from(f.speed_mps),
        radius: f64::from(f.radius_m),
        range: f64::from(f.range_m),
        turbulence: f64::from(f.turbulence),
        spread: f64::from(f.half_angle_deg).to_radians().tan(),
        flow: axis,
        ..placed
    }
}

impl Source<'_> {
    /// The phase `dt_s` later, wrapped where the wind is the same again.
    pub(super) fn phase_after(&self, dt_s: f64) -> DVec2 {
        let period = f64::from(NOISE_PERIOD);
        let turned = |rate: f64| (self.phase.x + rate * dt_s).rem_euclid(TAU);
        let drifted = |cells: f64| (self.phase.y + cells).rem_euclid(period);
        match self.kind {
            Kind::Waves => dvec2(turned(self.rate), drifted(self.rate * dt_s / TAU * WAVE_CELLS)),
            Kind::Gusts | Kind::Fan => {
                let drift = self.rate * self.frequency * dt_s;
                dvec2((self.phase.x + drift).rem_euclid(period), 0.0)
            }
            Kind::Texture => {
                let width = f64::from(self.map.map_or(1, |map| map.width()));
                let drift = self.phase.x + self.rate * self.frequency * dt_s;
                dvec2(drift.rem_euclid(width), 0.0)
            }
            Kind::Cosine => dvec2(turned(self.rate), 0.0),
            Kind::Rotor | Kind::Vortex => dvec2(turned(self.spoke_rate), drifted(self.rate * dt_s)),
        }
    }
}

impl From<Source<'_>> for GpuWindSource {
    /// All but the map's row.
    fn from(source: Source) -> Self {
        let f = |x: f64| x as f32;
        Self {
            kind: source.kind as u32,
            seed: source.seed,
            direction: source.direction.as_vec2().to_array(),
            strength: source.strength.as_vec2().to_array(),
            frequency: f(source.frequency),
            rate: f(source.rate),
            phase: source.phase.as_vec2().to_array(),
            radius: f(source.radius),
            range: f(source.range),
            position: source.position.as_vec3().to_array(),
            turbulence: f(source.turbulence),
            velocity: source.velocity.as_vec3().to_array(),
            spread: f(source.spread),
            flow: source.flow.as_vec3().to_array(),
            carried: f(source.carried),
            spokes: source.spokes,
            spoke_rate: f(source.spoke_rate),
            spoke_wind: f(source.spoke_wind),
            pulse: f(source.pulse),
            map_row: 0,
            map_size: source.map.map_or(0, |map| map.width() | (map.height() << 16)),
            reserved: [0; 2],
        }
    }
}
