//! Keys for objects.

use super::{CollideFile, Color, PathFile, Source, Span};
use serde::Deserialize;

/// An opaque thing.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ObjectFile {
    /// Name, by which others refer to it; default `object N`, N from 0.
    #[serde(default)]
    pub name: Option<String>,
    /// What it is made from. Needed.
    pub source: Source,
    /// Scale, not 0: one number, or `(x, y, z)`; default 1. An odd number of negative factors
    /// mirrors the mesh; its triangles stay facing outwards.
    #[serde(default = "one")]
    pub scale: Scale,
    /// Turn about x, then y, then z, after the scale; default none.
    #[serde(default)]
    pub rotate_deg: [f32; 3],
    /// Shift, after the turn; default none.
    #[serde(default)]
    pub translate: [f32; 3],
    /// Colour; default: the file's, the soil where it carries grass, else a grey.
    #[serde(default)]
    pub base_color: Option<Color>,
    /// Roughness, 0..=1; default: the file's, else 0.9.
    #[serde(default)]
    pub roughness: Option<f32>,
    /// Image that colours it through its UVs, PNG or JPEG; default: the file's own.
    #[serde(default)]
    pub texture: Option<String>,
    /// Whether it is drawn and hides what is behind; default true.
    #[serde(default = "yes")]
    pub visible: bool,
    /// How it pushes grass aside and keeps roots out; default `Auto`.
    #[serde(default)]
    pub collide: CollideFile,
    /// Where it moves, after scale, turn and shift; default: it rests. Not with `at` or `scatter`,
    /// and no grass grows on it.
    #[serde(default)]
    pub path: Option<PathFile>,
    /// An object by name, listed before this one: copies stand on it; heights of a path are above
    /// it.
    #[serde(default)]
    pub above: Option<String>,
    /// `(x, z)` of each copy, on `above` or at height 0; default: one, where `translate` says.
    #[serde(default)]
    pub at: Vec<[f32; 2]>,
    /// Copies strewn over `above`; default none.
    #[serde(default)]
    pub scatter: Option<ScatterFile>,
    /// How much bigger or smaller each copy may be, above 0; default 1.
    #[serde(default = "same")]
    pub copy_scale: Span,
}

/// One factor, or one an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale(pub [f32; 3]);

impl<'de> Deserialize<'de> for Scale {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ScaleVisitor)
    }
}

struct ScaleVisitor;

impl<'de> serde::de::Visitor<'de> for ScaleVisitor {
    type Value = Scale;

    fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str("a scale: one number or (x, y, z)")
    }
    fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<Scale, E> {
        Ok(Scale([value as f32; 3]))
    }
    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<Scale, E> {
        self.visit_f64(value as f64)
    }
    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<Scale, E> {
        self.visit_f64(value as f64)
    }
    fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut seq: A) -> Result<Scale, A::Error> {
        let mut factors = [1.0; 3];
        for (i, factor) in factors.iter_mut().enumerate() {
            *factor = seq
                .next_element()?
                .ok_or_else(|| <A::Error as serde::de::Error>::invalid_length(i, &self))?;
        }
        Ok(Scale(factors))
    }
}

fn one() -> Scale {
    Scale([1.0; 3])
}
fn yes() -> bool {
    true
}
fn same() -> Span {
    Span(1.0, 1.0)
}

/// Copies strewn at random over another object.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ScatterFile {
    /// How many, 1..=10000. Needed.
    pub count: u32,
    /// Same seed, same places; default 1.
    #[serde(default = "first_seed")]
    pub seed: u64,
    /// Centre `(x, z)` of the disk that they fall in; default: all over the object.
    #[serde(default)]
    pub center: Option<[f32; 2]>,
    /// Radius of that disk, above 0; default 10.
    #[serde(default = "ten")]
    pub radius_m: f32,
    /// Distance kept from the object's rim, 0 or more; default 1.
    #[serde(default = "margin")]
    pub margin_m: f32,
}

fn first_seed() -> u64 {
    1
}
fn ten() -> f32 {
    10.0
}
fn margin() -> f32 {
    1.0
}
