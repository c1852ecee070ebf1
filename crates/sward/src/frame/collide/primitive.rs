//! What colliders are made of when blades meet them, and its 32 bytes on the GPU.

use crate::Sphere;
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Quat, Vec3};

/// A convex thing that blades are tested against, in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Primitive {
    /// All within `radius` of a segment.
    Capsule {
        /// One end, metres.
        from: Vec3,
        /// The other end.
        to: Vec3,
        /// Radius, metres.
        radius: f32,
    },
    /// A ball that moved: the same room, but passed in order, so that blades fall before it.
    Swept {
        /// Centre at the last step, metres.
        from: Vec3,
        /// Centre now.
        to: Vec3,
        /// Radius, metres.
        radius: f32,
    },
    /// A box.
    Cuboid {
        /// Its middle, metres.
        center: Vec3,
        /// Half its edges, metres.
        half_extents: Vec3,
        /// World from its own axes, of unit length.
        rotation: Quat,
    },
}

impl From<Sphere> for Primitive {
    /// A ball that rests.
    fn from(Sphere { center, radius }: Sphere) -> Self {
        Self::Capsule { from: center, to: center, radius }
    }
}

/// Axis-aligned box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Least corner, metres.
    pub min: Vec3,
    /// Greatest corner.
    pub max: Vec3,
}

impl Bounds {
    /// The box of nothing.
    pub const NONE: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// The box of both.
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Whether they share a point.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }
}

impl Primitive {
    /// The box round it.
    pub fn bounds(&self) -> Bounds {
        match *self {
            Self::Capsule { from, to, radius } | Self::Swept { from, to, radius } => {
                Bounds { min: from.min(to) - radius, max: from.max(to) + radius }
            }
            Self::Cuboid { center, half_extents: h, rotation } => {
                let axes = [Vec3::X * h.x, Vec3::Y * h.y, Vec3::Z * h.z];
                let reach: Vec3 = axes.iter().map(|axis| (rotation * *axis).abs()).sum();
                Bounds { min: center - reach, max: center + reach }
            }
        }
    }

    /// The ball round it: centre and radius.
    pub fn ball(&self) -> (Vec3, f32) {
        match *self {
            Self::Capsule { from, to, radius } | Self::Swept { from, to, radius } => {
                (from.midpoint(to), from.distance(to) * 0.5 + radius)
            }
            Self::Cuboid { center, half_extents, .. } => (center, half_extents.length()),
        }
    }

    /// Whether all its numbers are finite and its size is above 0.
    pub(crate) fn is_sound(&self) -> bool {
        match *self {
            Self::Capsule { from, to, radius } | Self::Swept { from, to, radius } => {
                from.is_finite() && to.is_finite() && radius.is_finite() && radius > 0.0
            }
            Self::Cuboid { center, half_extents, rotation } => {
                center.is_finite()
                    && half_extents.is_finite()
                    && half_extents.min_element() > 0.0
                    && rotation.is_finite()
            }
        }
    }

    /// A point of the world in the box's own axes.
    pub(crate) fn into_box(rotation: Quat, v: DVec3) -> DVec3 {
        rotation.as_dquat().inverse() * v
    }
}

/// Kinds of [`GpuPrimitive`], the lowest two bits of its last word.
pub(crate) const CAPSULE: u32 = 0;
/// A ball that moved.
pub(crate) const SWEPT: u32 = 1;
/// A box.
pub(crate) const CUBOID: u32 = 2;

/// `GpuPrimitive` of primitive.wgsl. Of a capsule: one end, radius; other end, kind. Of a box:
/// middle and first half extent; the others, and its turn in 20 bits a component.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Pod, Zeroable)]
pub struct GpuPrimitive {
    /// First half.
    pub a: [u32; 4],
    /// Second half.
    pub b: [u32; 4],
}

impl From<&Primitive> for GpuPrimitive {
    fn from(primitive: &Primitive) -> Self {
        let bits = |v: Vec3, w: u32| [v.x.to_bits(), v.y.to_bits(), v.z.to_bits(), w];
        match *primitive {
            Primitive::Capsule { from, to, radius } => {
                Self { a: bits(from, radius.to_bits()), b: bits(to, CAPSULE) }
            }
            Primitive::Swept { from, to, radius } => {
                Self { a: bits(from, radius.to_bits()), b: bits(to, SWEPT) }
            }
            Primitive::Cuboid { center, half_extents: h, rotation } => {
                let [first, second] = turn_bits(rotation);
                Self {
                    a: bits(center, h.x.to_bits()),
                    b: [h.y.to_bits(), h.z.to_bits(), first, second | CUBOID],
                }
            }
        }
    }
}

/// A turn without its largest component: which one it is in 2 bits, the others in 20 bits each.
/// The lowest two bits of the second word are free.
fn turn_bits(rotation: Quat) -> [u32; 2] {
    let q = rotation.normalize().to_array();
    let mut largest = 0;
    for i in 1..4 {
        if q[i].abs() > q[largest].abs() {
            largest = i;
        }
    }
    let sign = if q[largest] < 0.0 { -1.0 } else { 1.0 };
    let steps = |x: f32| {
        let unit = (f64::from(x * sign) * std::f64::consts::SQRT_2).clamp(-1.0, 1.0);
        ((unit * 524_287.0).round() + 524_287.0) as u64
    };
    let mut bits = largest as u64;
    for i in 1..4 {
        bits = bits << 20 | steps(q[(largest + i) % 4]);
    }
    bits <<= 2;
    [(bits >> 32) as u32, bits as u32]
}
