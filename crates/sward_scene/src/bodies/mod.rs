//! Rigid bodies: they fall, bounce and roll on the scene's objects, and push blades.
//!
//! [`Bodies`] holds their world. It takes fixed steps of its own from time 0 on, so where a body is
//! at a time depends on that time alone, whatever steps led there, and is the same in every run of
//! one program on one machine. Another machine's sine and cube root may start them a little
//! otherwise.

mod grass;
mod start;
mod world;

pub(crate) use start::Start;
pub use world::{Bodies, Body};

use crate::check::{Key, MAX_M, Problem};
use crate::objects::Placed;
use crate::schema::{BodiesFile, BodyShapeFile, SceneFile};
use glam::Vec3;
use sward::ColliderShape;

/// Bodies of one kind.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyGroup {
    /// Its name, for messages.
    pub name: String,
    /// Their shape, before each one's own scale.
    pub shape: BodyShape,
    /// Whether they are drawn.
    pub visible: bool,
    /// Colours that they take in turn, linear RGB reflectance; at least one.
    pub colors: Vec<[f32; 3]>,
    /// Colour of every other stripe of a sphere; none: they are plain.
    pub stripe_color: Option<[f32; 3]>,
    /// Roughness, 0 (mirror) to 1 (chalk).
    pub roughness: f32,
    restitution: f32,
    friction: f32,
    density: f32,
    grass_drag: f32,
    starts: Vec<Start>,
}

/// What a body is; its middle is the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BodyShape {
    /// A ball of that radius, metres.
    Sphere(f32),
    /// A box of these half edges, metres.
    Box(Vec3),
    /// All within a radius of a segment along y of that half length, metres.
    Capsule {
        /// Radius, metres.
        radius: f32,
        /// Half the length of the segment, metres.
        half: f32,
    },
}

impl BodyShape {
    /// The shape that pushes blades, of a body that is `scale` times as big.
    pub fn collider(self, scale: f32) -> ColliderShape<'static> {
        match self {
            Self::Sphere(radius) => ColliderShape::Sphere { radius: radius * scale },
            Self::Box(half) => ColliderShape::Cuboid { half_extents: half * scale },
            Self::Capsule { radius, half } => ColliderShape::Capsule {
                from: Vec3::NEG_Y * half * scale,
                to: Vec3::Y * half * scale,
                radius: radius * scale,
            },
        }
    }

    /// Radius of the ball round it, metres.
    pub fn reach(self) -> f32 {
        match self {
            Self::Sphere(radius) => radius,
            Self::Box(half) => half.length(),
            Self::Capsule { radius, half } => radius + half,
        }
    }

    fn check(file: BodyShapeFile, key: &Key) -> Result<Self, Problem> {
        const MOST_M: f32 = 1000.0;
        Ok(match file {
            BodyShapeFile::Sphere { radius_m } => {
                Self::Sphere(key.at("radius_m").above_zero(radius_m, MOST_M)?)
            }
            BodyShapeFile::Box { size_m } => {
                for edge in size_m {
                    key.at("size_m").above_zero(edge, MOST_M)?;
                }
                Self::Box(Vec3::from(size_m) / 2.0)
            }
            BodyShapeFile::Capsule { radius_m, length_m } => {
                let radius = key.at("radius_m").above_zero(radius_m, MOST_M)?;
                let length = key.at("length_m").above_zero(length_m, MOST_M)?;
                if length <= 2.0 * radius {
                    let cause = format!("{length} must be above twice the radius, {radius}");
                    return Err(key.at("length_m").problem(cause));
                }
                Self::Capsule { radius, half: length / 2.0 - radius }
            }
        })
    }
}

impl BodyGroup {
    /// How many there are.
    pub fn count(&self) -> usize {
        self.starts.len()
    }

    /// Colour of its body of that number.
    pub fn color(&self, number: usize) -> [f32; 3] {
        self.colors.get(number % self.colors.len().max(1)).copied().unwrap_or_default()
    }

    fn check(file: &BodiesFile, index: usize, placed: &[Placed]) -> Result<Self, Problem> {
        let key = Key::list("bodies", index);
        let shape = BodyShape::check(file.shape, &key.at("shape"))?;
        if file.colors.is_empty() {
            return Err(key.at("colors").problem("is empty: give at least one colour"));
        }
        let colors = file.colors.iter().enumerate();
        let stripes = file.stripe_color.map(|color| key.at("stripe_color").color(color));
        Ok(Self {
            name: file.name.clone().unwrap_or_else(|| format!("bodies {index}")),
            shape,
            visible: file.visible,
            colors: colors
                .map(|(i, color)| key.at("colors").index(i).color(*color))
                .collect::<Result<_, _>>()?,
            stripe_color: stripes.transpose()?,
            roughness: key.at("roughness").within(file.roughness, 0.0, 1.0)?,
            restitution: key.at("restitution").within(file.restitution, 0.0, 1.0)?,
            friction: key.at("friction").within(file.friction, 0.0, 10.0)?,
            density: key.at("density_kgpm3").within(file.density_kgpm3, 1e-3, MAX_M)?,
            grass_drag: key.at("grass_drag").within(file.grass_drag, 0.0, 100.0)?,
            starts: start::starts(file, &key, shape, placed)?,
        })
    }
}

/// Most bodies of a scene.
const MOST_BODIES: usize = 10_000;

/// All groups of a scene.
pub(crate) fn groups(file: &SceneFile, placed: &[Placed]) -> Result<Vec<BodyGroup>, Problem> {
    let mut groups = Vec::with_capacity(file.bodies.len());
    let mut count = 0;
    for (index, bodies) in file.bodies.iter().enumerate() {
        let key = Key::list("bodies", index).at("count");
        count += key.integer(bodies.count.into(), 1, MOST_BODIES as u64)? as usize;
        if count > MOST_BODIES {
            let cause = format!("makes {count} bodies in all: at most {MOST_BODIES} are taken");
            return Err(key.problem(cause));
        }
        groups.push(BodyGroup::check(bodies, index, placed)?);
    }
    Ok(groups)
}

#[cfg(test)]
mod tests;
