//! The CPU reference of state.wgsl, in `f64`: a dynamic state to its 8 bytes and back.

use crate::PhysicsModel;
use crate::frame::physics::twin::{Blade, State};
use crate::shared::curve_twin::reach;
use glam::{DVec2, DVec3, dvec2, dvec3};

/// Resolution of the crush.
pub(crate) const CRUSH_STEP: f64 = 1.0 / 32768.0;
const LONGEST_PAPER: f64 = 1.25;

fn axes(blade: &Blade) -> [DVec3; 3] {
    [blade.up.cross(blade.facing), blade.up, blade.facing]
}

fn half_oct_encode(v: DVec3) -> DVec2 {
    let sum = (v.x.abs() + v.y.max(0.0) + v.z.abs()).max(1e-12);
    dvec2(v.x + v.z, v.x - v.z) / sum
}

fn half_oct_decode(e: DVec2) -> DVec3 {
    let p = dvec2(e.x + e.y, e.x - e.y) * 0.5;
    dvec3(p.x, (1.0 - p.x.abs() - p.y.abs()).max(0.0), p.y).normalize()
}

/// The 8 bytes of a state. The shader rounds the crush up or down by turns, this to the nearest.
pub(crate) fn pack_state(blade: &Blade, state: State, model: PhysicsModel) -> [u32; 2] {
    let crush = (state.crush / CRUSH_STEP).round().clamp(0.0, 65535.0) as u32;
    let length = state.tip.length();
    let local = if length > 1e-6 {
        DVec3::from_array(axes(blade).map(|axis| state.tip.dot(axis)))
    } else {
        DVec3::Z
    };
    let e = half_oct_encode(local);
    let bits = |x: f64, half: f64| ((x.clamp(-1.0, 1.0) * half).round() + half) as u32;
    match model {
        PhysicsModel::Sward => {
            let (x, y) = (bits(e.x, 8_388_607.0), bits(e.y, 8_388_607.0));
            [x | (crush & 0xff) << 24, y | (crush >> 8) << 24]
        }
        PhysicsModel::Paper => {
            let (x, y) = (bits(e.x, 65535.0), bits(e.y, 65535.0));
            let l = ((length / LONGEST_PAPER).clamp(0.0, 1.0) * 16383.0).round() as u32;
            [x | y << 17, y >> 15 | l << 2 | crush << 16]
        }
    }
}

/// A state from its 8 bytes.
pub(crate) fn unpack_state(blade: &Blade, bits: [u32; 2], model: PhysicsModel) -> State {
    let to_world = |v: DVec3| -> DVec3 {
        axes(blade).iter().zip(v.to_array()).map(|(axis, x)| *axis * x).sum()
    };
    let signed = |x: u32, half: f64| f64::from(x) / half - 1.0;
    match model {
        PhysicsModel::Sward => {
            let e = bits.map(|b| signed(b & 0xff_ffff, 8_388_607.0));
            let v = half_oct_decode(DVec2::from_array(e));
            let length = reach(v.y, dvec2(v.x, v.z).length(), blade.arch);
            let crush = bits[0] >> 24 | (bits[1] >> 24) << 8;
            State { tip: to_world(v) * length, crush: f64::from(crush) * CRUSH_STEP }
        }
        PhysicsModel::Paper => {
            let y = bits[0] >> 17 | (bits[1] & 3) << 15;
            let e = dvec2(signed(bits[0] & 0x1_ffff, 65535.0), signed(y, 65535.0));
            let length = f64::from(bits[1] >> 2 & 0x3fff) * (LONGEST_PAPER / 16383.0);
            let crush = f64::from(bits[1] >> 16) * CRUSH_STEP;
            State { tip: to_world(half_oct_decode(e)) * length, crush }
        }
    }
}
