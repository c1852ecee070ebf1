//! The default model of one blade, the reference of `physics.wgsl`: an exact step of the linear
//! recovery, and length by projection. Velocities and displacements are in units of the blade's
//! height, so that 5 cm turf and 2 m reed behave alike; equation numbers are J's (Jahrmann &
//! Wimmer 2017).

use crate::frame::collide::primitive::Primitive;
use crate::frame::collide::twin::contact;
use crate::shared::curve_twin::{project_tip, safe_normalize};
use crate::shared::noise_twin::smoothstep;
use crate::{Gravity, Wind};
use glam::DVec3;

/// A sleeping blade catches up in at most this many substeps.
const MAX_SUBSTEPS: u32 = 32;
/// Largest `k dt` of the last substep.
const SUBSTEP: f64 = 0.25;
/// Each substep is this much longer than the next: what is long past is soon forgotten.
const SUBSTEP_GROWTH: f64 = 1.1;

/// One blade: what does not change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blade {
    /// v0, metres.
    pub root: DVec3,
    /// Unit up.
    pub up: DVec3,
    /// Unit facing f, perpendicular to `up`.
    pub facing: DVec3,
    /// h, metres, above 0.
    pub height: f64,
    /// Response s, 1/s, above 0.
    pub response: f64,
    /// Droop gamma: gravity is `gamma s h`.
    pub droop: f64,
    /// Multiplies the wind: it is `beta gust s h`.
    pub gust: f64,
    /// Arch kappa, 0..=1.
    pub arch: f64,
}

/// What physics changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// `(v2 - v0) / h`. Its length follows from its direction.
    pub tip: DVec3,
    /// Crush eta, 0..=2.
    pub crush: f64,
}

/// What acts on blades in one step.
#[derive(Debug, Clone, Copy)]
pub struct Surroundings<'a> {
    /// Wind, advanced to the end of the step.
    pub wind: &'a Wind,
    /// Gravity.
    pub gravity: Gravity,
    /// What pushes, on its way to the end of the step; in the paper's model at its end.
    pub primitives: &'a [Primitive],
    /// Crush lost a second without contact: 0.25 lets a flattened blade stand 7 s later.
    pub crush_decay: f64,
    /// Seconds of the frame; a longer gap than this is a sleep.
    pub dt_s: f64,
}

impl State {
    /// `self`, or an upright blade where it is not a number.
    pub(super) fn sound(self, blade: &Blade) -> Self {
        if self.is_finite() { self } else { Self { tip: blade.up, crush: 0.0 } }
    }

    pub(super) fn is_finite(self) -> bool {
        self.tip.is_finite() && self.crush.is_finite()
    }
}

/// Recovery rate k, 1/s (equation 3): crush suppresses it to a tenth.
pub fn recovery_rate(blade: &Blade, crush: f64) -> f64 {
    blade.response * (1.0 - crush).max(0.1)
}

/// The pull of gravity at the root, without the species' droop (equation 4). The printed second
/// term lacks its norm; where the centre is at the root it has no direction and is 0.
pub fn gravity_pull(gravity: &Gravity, root: DVec3) -> DVec3 {
    let unit = |v| safe_normalize(v, DVec3::ZERO);
    let direction = unit(gravity.direction.as_dvec3()) * f64::from(gravity.strength);
    let center = unit(gravity.center.as_dvec3() - root) * f64::from(gravity.center_strength);
    direction.lerp(center, f64::from(gravity.blend))
}

/// Velocity by gravity (equations 4 to 6). The front part turns from the facing to the present
/// lean as the blade lies down; otherwise a flattened blade swims towards its facing. It turns
/// beyond the lean of a blade at rest: else nothing would bring that blade back to its facing.
fn gravity_velocity(blade: &Blade, tip: DVec3, gravity: &Gravity) -> DVec3 {
    let pull = gravity_pull(gravity, blade.root);
    let flat = tip - blade.up * tip.dot(blade.up);
    let l = flat.length();
    let turned = smoothstep(0.4, 0.9, l);
    let front = blade.facing * (1.0 - turned) + flat * (turned / l.max(0.1));
    (pull + front * (pull.length() * 0.25)) * (blade.droop * blade.response)
}

/// Velocity by wind of strength `wind` (equations 7 and 8). Beyond the printed form, wind along
/// the blade's width acts half, as the paper's text wants it to act less.
pub fn wind_velocity(blade: &Blade, tip: DVec3, wind: DVec3) -> DVec3 {
    let direction = safe_normalize(wind, DVec3::ZERO);
    let along = direction.dot(safe_normalize(tip, blade.up)).abs();
    let broadside = 1.0 + (direction.dot(blade.facing).abs() - 1.0) * 0.5;
    let height_ratio = tip.dot(blade.up);
    wind * ((1.0 - along).max(0.0) * height_ratio * broadside * blade.gust * blade.response)
}

/// Where the tip would go in `dt_s` were the forces those at `at`, and were it free of the length:
/// `(1 - e^-kdt)` of the way to `rest + force / k`.
fn free_move(blade: &Blade, tip: DVec3, at: DVec3, drive: &Drive, k: f64, dt_s: f64) -> DVec3 {
    let force = gravity_velocity(blade, at, &drive.gravity) + wind_velocity(blade, at, drive.wind);
    (blade.up + force / k - tip) * (1.0 - (-k * dt_s).exp())
}

/// What drives one substep.
struct Drive {
    gravity: Gravity,
    wind: DVec3,
}

/// One substep by the midpoint rule. Only the move across the middle direction turns the blade:
/// the part along it would shorten the lever and make the turn depend on dt.
fn substep(blade: &Blade, tip: DVec3, drive: &Drive, k: f64, dt_s: f64) -> DVec3 {
    let half_move = free_move(blade, tip, tip, drive, k, 0.5 * dt_s);
    let middle = project_tip(tip + half_move, blade.up, blade.facing, blade.arch);
    let whole = free_move(blade, tip, middle, drive, k, dt_s);
    let turn = whole.reject_from(middle);
    let start = safe_normalize(tip, blade.facing) * middle.length();
    project_tip(start + turn, blade.up, blade.facing, blade.arch)
}

/// Advances a blade by `gap_s`, the time since it was last advanced: a frame, or a whole sleep.
///
/// The result is finite whatever the surroundings hold; a gap of 0 changes nothing.
pub fn advance(blade: &Blade, state: State, gap_s: f64, around: &Surroundings) -> State {
    if gap_s.is_nan() || gap_s <= 0.0 {
        return state;
    }
    let crush_end = (state.crush - around.crush_decay * gap_s).max(0.0);
    let tip = move_freely(blade, state, gap_s, crush_end, around);
    let mut next = State { tip, crush: crush_end };
    if let Some(hit) = contact(blade, tip, around.primitives) {
        next.tip = hit.tip;
        // Contact holds the crush: it fades only over the part of the gap that was a sleep.
        let asleep = (gap_s - around.dt_s).max(0.0);
        let held = (state.crush - around.crush_decay * asleep).max(0.0);
        next.crush = held.max(hit.bend.min(2.0));
    }
    if next.is_finite() { next } else { state.sound(blade) }
}

/// The tip after `gap_s` of wind, gravity and recovery, in substeps that are longer the longer ago
/// they are. A sleep that they cannot cover starts from recovery alone; they then forget it.
fn move_freely(
    blade: &Blade,
    state: State,
    gap_s: f64,
    crush_end: f64,
    around: &Surroundings,
) -> DVec3 {
    let crush_after = |seconds: f64| (state.crush - around.crush_decay * seconds).max(0.0);
    let k_end = recovery_rate(blade, crush_end);
    // Lengths of the substeps in units of the last one's, and their number.
    let (mut count, mut total, mut first) = (1, 1.0, 1.0);
    while count < MAX_SUBSTEPS && total * SUBSTEP < k_end * gap_s - 1e-3 {
        first *= SUBSTEP_GROWTH;
        total += first;
        count += 1;
    }
    let window = gap_s.min(total * SUBSTEP / k_end);
    let skipped = gap_s - window;
    let k_skipped = recovery_rate(blade, crush_after(skipped * 0.5));
    let left = (-k_skipped * skipped).exp();
    let woken = blade.up + (state.tip - blade.up) * left;
    let mut tip = project_tip(woken, blade.up, blade.facing, blade.arch);
    let mut dt_s = window * first / total;
    let mut ago = window;
    for _ in 0..count {
        let middle = ago - 0.5 * dt_s;
        let wind = around.wind.strength_at_f64(blade.root, middle);
        let drive = Drive { gravity: around.gravity, wind };
        let k = recovery_rate(blade, crush_after(gap_s - middle));
        tip = substep(blade, tip, &drive, k, dt_s);
        ago -= dt_s;
        dt_s /= SUBSTEP_GROWTH;
    }
    tip
}

/// The tip of an undisturbed blade: the equilibrium of recovery and gravity.
pub fn rest_tip(blade: &Blade, gravity: &Gravity) -> DVec3 {
    settled_tip(blade, gravity, DVec3::ZERO)
}

/// The tip of a blade in a steady wind of that strength.
pub fn settled_tip(blade: &Blade, gravity: &Gravity, wind: DVec3) -> DVec3 {
    let drive = Drive { gravity: *gravity, wind };
    let dt_s = 0.5 / blade.response;
    (0..32).fold(blade.up, |tip, _| substep(blade, tip, &drive, blade.response, dt_s))
}
