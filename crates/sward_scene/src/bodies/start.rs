//! Where and how bodies start.

use super::BodyShape;
use crate::check::{Key, Problem};
use crate::objects::ground::Ground;
use crate::objects::random::Random;
use crate::objects::{Placed, find};
use crate::schema::BodiesFile;
use glam::{Quat, Vec3, Vec3Swizzles};
use std::f32::consts::TAU;

/// How a body starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Start {
    pub(crate) time_s: f32,
    pub(crate) scale: f32,
    pub(crate) position: Vec3,
    pub(crate) rotation: Quat,
    pub(crate) velocity: Vec3,
    /// Radians a second.
    pub(crate) spin: Vec3,
}

/// Times that a place is sought anew where it is over nothing or inside another body.
const TRIES: u32 = 64;
/// Bodies just before that one must not start inside.
const NEIGHBORS: usize = 512;

/// Every start of a group, in order.
pub(super) fn starts(
    file: &BodiesFile,
    key: &Key,
    shape: BodyShape,
    placed: &[Placed],
) -> Result<Vec<Start>, Problem> {
    let ground = file.above.as_deref().map(|name| find(placed, name, &key.at("above")));
    let ground = ground.transpose()?.map(Placed::ground);
    let region = Region::check(file, key, ground)?;
    let sizes = key.at("copy_scale").span(file.copy_scale, |key, v| key.above_zero(v, 1000.0))?;
    let velocity = key.at("velocity_mps").vector(file.velocity_mps)?;
    let faster = key.at("velocity_spread_mps").within(file.velocity_spread_mps, 0.0, 1000.0)?;
    let spin = key.at("spin_rps").vector(file.spin_rps)?;
    let spinning = key.at("spin_spread_rps").within(file.spin_spread_rps, 0.0, 1000.0)?;
    let first_s = key.at("start_s").within(file.start_s, 0.0, 100_000.0)?;
    let every_s = key.at("every_s").within(file.every_s, 0.0, 1000.0)?;
    let mut random = Random::new(file.seed, 31);
    let mut starts: Vec<Start> = Vec::with_capacity(file.count as usize);
    for number in 0..file.count {
        let scale = sizes.at(random.between(0.0, 1.0));
        let time_s = first_s + every_s * number as f32;
        let reach = shape.reach() * scale;
        let near = starts.iter().rev().take(NEIGHBORS);
        let near = near.filter(|other| other.time_s == time_s);
        let others: Vec<_> = near.map(|s| (s.position, shape.reach() * s.scale)).collect();
        let position = region.place(&mut random, reach, &others)?;
        let turn = random.direction() * random.between(0.0, TAU / 2.0);
        starts.push(Start {
            time_s,
            scale,
            position,
            rotation: Quat::from_scaled_axis(turn),
            velocity: velocity + random.direction() * faster * random.between(0.0, 1.0).cbrt(),
            spin: (spin + random.direction() * spinning * random.between(0.0, 1.0).cbrt()) * TAU,
        });
    }
    Ok(starts)
}

/// The box that bodies start in.
struct Region<'a> {
    middle: Vec3,
    half: Vec3,
    ground: Option<&'a Ground>,
    key: &'a Key,
}

impl<'a> Region<'a> {
    fn check(file: &BodiesFile, key: &'a Key, ground: Option<&'a Ground>) -> Result<Self, Problem> {
        let middle = key.at("at").vector(file.at)?;
        let half = key.at("spread_m").vector(file.spread_m)?;
        if half.min_element() < 0.0 {
            return Err(key.at("spread_m").problem(format!("{half} must not be below 0")));
        }
        Ok(Self { middle, half, ground, key })
    }

    /// A place over the ground and, where one is found, outside other bodies.
    fn place(
        &self,
        random: &mut Random,
        reach: f32,
        others: &[(Vec3, f32)],
    ) -> Result<Vec3, Problem> {
        let mut found = None;
        for _ in 0..TRIES {
            let mut axis = || random.between(-1.0, 1.0);
            let mut at = self.middle + self.half * Vec3::new(axis(), axis(), axis());
            if let Some(ground) = self.ground {
                let Some(height) = ground.height(at.xz()) else { continue };
                at.y += height + reach;
            }
            found = Some(at);
            let clear = |&(other, far): &(Vec3, f32)| other.distance(at) > far + reach;
            if others.iter().all(clear) {
                break;
            }
        }
        let cause = "is beside the object that they start above";
        found.ok_or_else(|| self.key.at("at").problem(cause))
    }
}
