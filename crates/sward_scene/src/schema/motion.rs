//! Keys for things that move.

use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Visitor};
use std::fmt;

/// A path: `[(time_s, x, y, z), ...]`, or `(keys: [...], smooth: true, repeat: false)`.
#[derive(Debug, Clone, PartialEq)]
pub struct PathFile {
    /// Keys by rising time; at least one.
    pub keys: Vec<PathKeyFile>,
    /// Whether a thing takes the turns of its path smoothly, never beyond its keys (the default),
    /// or goes straight from key to key.
    pub smooth: bool,
    /// Whether the path starts again at its end, for ever; then its last key must be where its
    /// first is. Default false: a thing rests before the first key and after the last.
    pub repeat: bool,
    /// Whether it was written as a list, for messages.
    pub(crate) listed: bool,
}

/// A key: `(time_s, x, y, z)`, or `(time_s: 1, at: (x, y, z), rotate_deg: (x, y, z))`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathKeyFile {
    /// Time, 0..=100000 seconds.
    pub time_s: f32,
    /// Place, metres.
    pub at: [f32; 3],
    /// Turn about x, then y, then z; default none. Between keys the shorter way round.
    pub rotate_deg: [f32; 3],
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename = "path")]
struct NamedPath {
    keys: Vec<PathKeyFile>,
    #[serde(default = "yes")]
    smooth: bool,
    #[serde(default)]
    repeat: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename = "key")]
struct NamedKey {
    time_s: f32,
    at: [f32; 3],
    #[serde(default)]
    rotate_deg: [f32; 3],
}

fn yes() -> bool {
    true
}

struct PathVisitor;

impl<'de> Visitor<'de> for PathVisitor {
    type Value = PathFile;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(
            "a path: [(time_s, x, y, z), ...] or (keys: [...], smooth: true, repeat: false)",
        )
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<PathFile, A::Error> {
        let mut keys = Vec::new();
        while let Some(key) = seq.next_element()? {
            keys.push(key);
        }
        Ok(PathFile { keys, smooth: true, repeat: false, listed: true })
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<PathFile, A::Error> {
        let NamedPath { keys, smooth, repeat } =
            NamedPath::deserialize(MapAccessDeserializer::new(map))?;
        Ok(PathFile { keys, smooth, repeat, listed: false })
    }
}

impl<'de> Deserialize<'de> for PathFile {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PathVisitor)
    }
}

struct KeyVisitor;

impl<'de> Visitor<'de> for KeyVisitor {
    type Value = PathKeyFile;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a key: (time_s, x, y, z) or (time_s: 0, at: (x, y, z), rotate_deg: (x, y, z))")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<PathKeyFile, A::Error> {
        let mut numbers = [0.0; 4];
        for (i, number) in numbers.iter_mut().enumerate() {
            *number = seq.next_element()?.ok_or_else(|| A::Error::invalid_length(i, &self))?;
        }
        if seq.next_element::<f32>()?.is_some() {
            return Err(A::Error::invalid_length(5, &self));
        }
        let [time_s, x, y, z] = numbers;
        Ok(PathKeyFile { time_s, at: [x, y, z], rotate_deg: [0.0; 3] })
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<PathKeyFile, A::Error> {
        let NamedKey { time_s, at, rotate_deg } =
            NamedKey::deserialize(MapAccessDeserializer::new(map))?;
        Ok(PathKeyFile { time_s, at, rotate_deg })
    }
}

impl<'de> Deserialize<'de> for PathKeyFile {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(KeyVisitor)
    }
}
