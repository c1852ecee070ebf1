//! The kinds of wind source: what a host sets.

use super::WindMap;
use glam::{Vec2, Vec3};
use std::sync::Arc;

/// One term of the wind field.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum WindSource {
    /// A steady breeze with travelling waves on it.
    Waves(Waves),
    /// Gusts: noise that drifts with the wind.
    Gusts(Gusts),
    /// A wind that swings to and fro.
    Cosine(Cosine),
    /// The wash of a rotor: a helicopter over the grass.
    Rotor(Rotor),
    /// A whirlwind or a tornado.
    Vortex(Vortex),
    /// A jet of air that widens as a cone.
    Fan(Fan),
    /// A map of winds that repeats and drifts.
    Texture(WindTexture),
}

/// Travelling waves: `direction * (mean + amplitude * wave(phase))`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waves {
    /// Where the wind blows to, in the xz plane; need not be unit length, must not be zero.
    pub direction: Vec2,
    /// Steady strength (beta), -100..=100. Higher bends the meadow more at all times.
    pub mean: f32,
    /// Strength of the waves (beta), 0..=100. Above the mean, blades swing against the wind
    /// between crests.
    pub amplitude: f32,
    /// Distance between crests, metres, 0.01..=10000. Longer waves read as gusts, shorter as ripples.
    pub wavelength_m: f32,
    /// How fast crests travel, metres a second, -1000..=1000; negative travels against the wind.
    pub speed_mps: f32,
}

/// Gust noise, longer across the wind than along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gusts {
    /// Where the gusts blow and drift to, in the xz plane; must not be zero.
    pub direction: Vec2,
    /// Peak strength (beta), 0..=100.
    pub strength: f32,
    /// Size of a gust along the wind, metres, 0.01..=10000; it is twice as long across. Larger
    /// gusts last longer over one place.
    pub size_m: f32,
    /// Drift speed, metres a second, -1000..=1000. Faster gusts pass a place in less time.
    pub speed_mps: f32,
    /// Turbulence, 0..=1: how much the direction veers inside a gust.
    pub turbulence: f32,
    /// Seed of the noise.
    pub seed: u32,
}

/// A wind that swings to and fro: `direction * strength * cos(omega T - k x)`, equation 4 of Wang and
/// Yao (2023), whose print lacks the time T. The phase by position is ours, as without it a whole
/// meadow nods in unison.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cosine {
    /// Where the wind blows to first, in the xz plane; must not be zero.
    pub direction: Vec2,
    /// Strength at its strongest (beta), 0..=100.
    pub strength: f32,
    /// Seconds from one swing to the next, 0.01..=10000.
    pub period_s: f32,
    /// Distance along the direction after which the swing is the same again, metres, 0.01 or more;
    /// infinite moves all blades in unison, as the paper prints it. It shows as straight stripes: for a
    /// natural wind take [`Waves`].
    pub wavelength_m: f32,
}

/// The wash of a rotor with an upright axis. Air is blown down, flows outward over the ground,
/// strongest at about one radius, and fades as one over the distance. The nearer the rotor is to the
/// grass, the stronger the wash; above the rotor there is none.
///
/// Each of its blades leaves a gust behind, so that `blades` arms of a spiral turn with the rotor and
/// run outward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotor {
    /// The hub, metres. How high it is over the grass decides how strong the wash is: four
    /// fifths are left at 2 radii, half at 4.
    pub position: Vec3,
    /// How fast the hub moves, metres a second, up to 1000 along each axis: only for the wind of the
    /// past, which blades ask for that wake up. The host moves `position`.
    pub velocity: Vec3,
    /// Radius of the rotor, metres, 0.01..=1000.
    pub radius_m: f32,
    /// Strength of the outflow at its strongest (beta), 0..=100, with the rotor close to the grass.
    pub strength: f32,
    /// Distance from the axis at which the wash ends, metres, 0.01..=10000. Blades beyond cost
    /// next to nothing.
    pub range_m: f32,
    /// Downward part under the rotor, as a share of the strength, 0..=4. It presses down blades that
    /// lean; one that stands straight up has nothing that it could push.
    pub downwash: f32,
    /// Part that turns with the rotor, as a share of the strength, -4..=4; negative turns against it.
    pub swirl: f32,
    /// Blades of the rotor, 1..=16.
    pub blades: u32,
    /// Turns a minute, -10000..=10000; positive is counter-clockwise seen from above. Above about
    /// 60 over the number of blades grass is too slow to follow; the arms then show less.
    pub rpm: f32,
    /// How much stronger and weaker the wash is on and between the arms, 0..=1; 0 is a steady wash.
    pub pulse: f32,
    /// How fast gusts run outward, metres a second, 0.01..=1000. Faster stretches the arms.
    pub speed_mps: f32,
    /// Share of the strength that is irregular, 0..=1. It breaks the arms and shakes the blades;
    /// 0 looks like a machine.
    pub turbulence: f32,
    /// Seed of the turbulence.
    pub seed: u32,
}

/// A whirlwind with an upright axis: round, inward and upward. The round part grows in proportion to
/// the distance up to the core's radius and falls as one over it beyond, without the kink of
/// Rankine's vortex (the profile of W. Kaufmann, 1962). It is the same at every height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vortex {
    /// A point of the axis, metres; its height does not matter.
    pub position: Vec3,
    /// How fast the axis moves, metres a second: see [`Rotor::velocity`].
    pub velocity: Vec3,
    /// Radius of the core, where the wind is strongest, metres, 0.01..=1000.
    pub radius_m: f32,
    /// Strength of the round part at the core's radius (beta), 0..=100.
    pub strength: f32,
    /// Distance from the axis at which the wind ends, metres, 0.01..=10000.
    pub range_m: f32,
    /// Inward part, as a share of the strength, -4..=4; negative flows outward.
    pub inflow: f32,
    /// Upward part on the axis, as a share of the strength, -4..=4; it lifts blades that lean.
    pub updraft: f32,
    /// Turns clockwise seen from above.
    pub clockwise: bool,
    /// How fast gusts are carried round at the core's radius, metres a second, 0.01..=1000.
    pub speed_mps: f32,
    /// Share of the strength that is irregular, 0..=1.
    pub turbulence: f32,
    /// Seed of the turbulence.
    pub seed: u32,
}

/// A fan: a jet of air that widens as a cone, weaker as it widens, towards its edge and towards its
/// range. Nothing blows behind the fan or outside the cone; the ground does not stop it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fan {
    /// Middle of the fan, metres.
    pub position: Vec3,
    /// How fast it moves, metres a second: see [`Rotor::velocity`].
    pub velocity: Vec3,
    /// Where it blows to; need not be unit length, must not be zero.
    pub direction: Vec3,
    /// Radius of the fan, metres, 0.01..=1000.
    pub radius_m: f32,
    /// Angle between the axis and the cone's edge, degrees, 0.1..=80.
    pub half_angle_deg: f32,
    /// Strength at the fan (beta), 0..=100; half a radius before it, it is at its strongest.
    pub strength: f32,
    /// Distance along the axis at which the wind ends, metres, 0.01..=10000.
    pub range_m: f32,
    /// How fast gusts run along the jet, metres a second, 0..=1000.
    pub speed_mps: f32,
    /// Share of the strength that is irregular, 0..=1.
    pub turbulence: f32,
    /// Seed of the turbulence.
    pub seed: u32,
}

/// A map of winds that repeats over the ground and drifts with the wind: the wind texture of Wang and
/// Yao (2023). What a map holds across its direction turns plants aside.
#[derive(Debug, Clone, PartialEq)]
pub struct WindTexture {
    /// Where the map drifts to, in the xz plane, and what its columns run along; must not be zero.
    pub direction: Vec2,
    /// The map. Sources that share one share its memory, 8 bytes a texel; the renderer takes all maps
    /// anew when another comes.
    pub map: Arc<WindMap>,
    /// Strength of the map's 1 (beta), 0..=100.
    pub strength: f32,
    /// Length of a tile along the direction, metres, 0.01..=100000. Texels are as wide as long. Larger
    /// tiles repeat less often and have coarser gusts.
    pub size_m: f32,
    /// Drift, metres a second, -1000..=1000; negative drifts against the wind.
    pub speed_mps: f32,
}

impl Default for Waves {
    /// A breeze with waves 14 m apart.
    fn default() -> Self {
        Self { direction: Vec2::X, mean: 0.25, amplitude: 0.35, wavelength_m: 14.0, speed_mps: 5.0 }
    }
}

impl Default for Gusts {
    /// Gusts of 12 m on a fresh day.
    fn default() -> Self {
        Self {
            direction: Vec2::X,
            strength: 0.8,
            size_m: 12.0,
            speed_mps: 5.0,
            turbulence: 0.3,
            seed: 1,
        }
    }
}

impl Default for Cosine {
    /// A slow swing, the same again every 20 m.
    fn default() -> Self {
        Self { direction: Vec2::X, strength: 0.5, period_s: 4.0, wavelength_m: 20.0 }
    }
}

impl Default for Rotor {
    /// A light helicopter 4 m over the origin.
    fn default() -> Self {
        Self {
            position: Vec3::new(0.0, 4.0, 0.0),
            velocity: Vec3::ZERO,
            radius_m: 5.0,
            strength: 3.0,
            range_m: 40.0,
            downwash: 0.8,
            swirl: 0.3,
            blades: 2,
            rpm: 40.0,
            pulse: 0.5,
            speed_mps: 9.0,
            turbulence: 0.4,
            seed: 1,
        }
    }
}

impl Default for Vortex {
    /// A small tornado at the origin.
    fn default() -> Self {
        Self {
            position: Vec3::ZERO,
            velocity: Vec3::ZERO,
            radius_m: 4.0,
            strength: 4.0,
            range_m: 40.0,
            inflow: 0.5,
            updraft: 0.5,
            clockwise: false,
            speed_mps: 12.0,
            turbulence: 0.4,
            seed: 1,
        }
    }
}

impl Default for Fan {
    /// A fan of 1 m at the origin's knee, blowing along x.
    fn default() -> Self {
        Self {
            position: Vec3::new(0.0, 0.6, 0.0),
            velocity: Vec3::ZERO,
            direction: Vec3::X,
            radius_m: 0.5,
            half_angle_deg: 15.0,
            strength: 3.0,
            range_m: 12.0,
            speed_mps: 6.0,
            turbulence: 0.3,
            seed: 1,
        }
    }
}

impl Default for WindTexture {
    /// Tiles of 40 m of noise.
    fn default() -> Self {
        Self {
            direction: Vec2::X,
            map: Arc::new(WindMap::noise(4, 1)),
            strength: 0.9,
            size_m: 40.0,
            speed_mps: 5.0,
        }
    }
}

impl WindSource {
    /// Where the source is, metres; `None` for a kind that blows everywhere.
    pub fn position(&self) -> Option<Vec3> {
        match self {
            Self::Waves(_) | Self::Gusts(_) | Self::Cosine(_) | Self::Texture(_) => None,
            Self::Rotor(rotor) => Some(rotor.position),
            Self::Vortex(vortex) => Some(vortex.position),
            Self::Fan(fan) => Some(fan.position),
        }
    }

    /// Moves a source that has a place; others stay as they are. `velocity` (metres a second) is
    /// how it moves now: see [`Rotor::velocity`].
    pub fn place(&mut self, position: Vec3, velocity: Vec3) {
        let (old_position, old_velocity) = match self {
            Self::Waves(_) | Self::Gusts(_) | Self::Cosine(_) | Self::Texture(_) => return,
            Self::Rotor(rotor) => (&mut rotor.position, &mut rotor.velocity),
            Self::Vortex(vortex) => (&mut vortex.position, &mut vortex.velocity),
            Self::Fan(fan) => (&mut fan.position, &mut fan.velocity),
        };
        (*old_position, *old_velocity) = (position, velocity);
    }
}
