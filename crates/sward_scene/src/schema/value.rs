//! Values that a scene may write in more than one way.

use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use std::fmt;

/// A colour, linear sRGB: `"#rrggbb"` (sRGB, converted) or `(r, g, b)` (linear).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Color(pub [f32; 3]);

/// A range: `(min, max)`, or one number for both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span(pub f32, pub f32);

impl Color {
    /// From `#rrggbb`; `None` where it is not six hexadecimal digits after a `#`.
    pub fn from_hex(text: &str) -> Option<Self> {
        let digits = text.strip_prefix('#').filter(|d| d.len() == 6 && d.is_ascii())?;
        let value = u32::from_str_radix(digits, 16).ok().filter(|_| !digits.starts_with('+'))?;
        let linear = |shift: u32| linear_from_srgb(((value >> shift) & 255) as f32 / 255.0);
        Some(Self([linear(16), linear(8), linear(0)]))
    }
}

/// The sRGB transfer function, decoded (IEC 61966-2-1).
pub(crate) fn linear_from_srgb(encoded: f32) -> f32 {
    if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

struct ColorVisitor;

impl<'de> Visitor<'de> for ColorVisitor {
    type Value = Color;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a colour: \"#rrggbb\" or (r, g, b)")
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Color, E> {
        Color::from_hex(text).ok_or_else(|| {
            E::custom(format!("'{text}' is not a colour: write \"#rrggbb\" or (r, g, b)"))
        })
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Color, A::Error> {
        let mut color = [0.0; 3];
        for (i, channel) in color.iter_mut().enumerate() {
            *channel = seq.next_element()?.ok_or_else(|| A::Error::invalid_length(i, &self))?;
        }
        match seq.next_element::<f32>()? {
            None => Ok(Color(color)),
            Some(_) => Err(A::Error::invalid_length(4, &self)),
        }
    }
}

impl<'de> Deserialize<'de> for Color {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ColorVisitor)
    }
}

struct SpanVisitor;

impl<'de> Visitor<'de> for SpanVisitor {
    type Value = Span;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a range: (min, max) or one number")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Span, E> {
        Ok(Span(value as f32, value as f32))
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Span, E> {
        self.visit_f64(value as f64)
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Span, E> {
        self.visit_f64(value as f64)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Span, A::Error> {
        let min: f32 = seq.next_element()?.ok_or_else(|| A::Error::invalid_length(0, &self))?;
        let max = seq.next_element()?.unwrap_or(min);
        match seq.next_element::<f32>()? {
            None => Ok(Span(min, max)),
            Some(_) => Err(A::Error::invalid_length(3, &self)),
        }
    }
}

impl<'de> Deserialize<'de> for Span {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(SpanVisitor)
    }
}
