//! Range checks: each names the key by its path and says what is allowed.

use crate::schema::{Color, Span};
use glam::Vec3;
use std::fmt;

/// A value that is not allowed.
#[derive(Debug, PartialEq)]
pub(crate) struct Problem {
    pub(crate) key: String,
    pub(crate) cause: String,
}

/// A key path under construction.
#[derive(Debug, Clone, Default)]
pub(crate) struct Key(String);

impl Key {
    pub(crate) fn list(name: &str, index: usize) -> Self {
        Self(format!("{name}[{index}]"))
    }
    pub(crate) fn name(name: &str) -> Self {
        Self(name.into())
    }
    pub(crate) fn at(&self, name: &str) -> Self {
        Self(format!("{self}.{name}"))
    }
    pub(crate) fn index(&self, index: usize) -> Self {
        Self(format!("{self}[{index}]"))
    }
    pub(crate) fn problem(&self, cause: impl Into<String>) -> Problem {
        Problem { key: self.0.clone(), cause: cause.into() }
    }

    /// `min <= value <= max`.
    pub(crate) fn within(&self, value: f32, min: f32, max: f32) -> Result<f32, Problem> {
        if value >= min && value <= max {
            return Ok(value);
        }
        Err(self.problem(format!("{value} is out of range: {}", allowed(min, max))))
    }

    /// Above 0 and at most `max`.
    pub(crate) fn above_zero(&self, value: f32, max: f32) -> Result<f32, Problem> {
        if value > 0.0 && value <= max {
            return Ok(value);
        }
        let most = if max.is_finite() { format!(" and at most {max}") } else { String::new() };
        Err(self.problem(format!("{value} is out of range: it must be above 0{most}")))
    }

    pub(crate) fn integer(&self, value: u64, min: u64, max: u64) -> Result<u64, Problem> {
        if (min..=max).contains(&value) {
            return Ok(value);
        }
        Err(self.problem(format!("{value} is out of range: it must be {min} to {max}")))
    }

    pub(crate) fn vector(&self, value: [f32; 3]) -> Result<Vec3, Problem> {
        for component in value {
            self.within(component, -MAX_M, MAX_M)?;
        }
        Ok(Vec3::from(value))
    }

    pub(crate) fn direction<const N: usize>(&self, value: [f32; N]) -> Result<[f32; N], Problem> {
        let longest = value.iter().fold(0.0_f32, |most, c| most.max(c.abs()));
        if value.iter().any(|c| !c.is_finite()) || !(1e-6..=MAX_M).contains(&longest) {
            return Err(self.problem(format!("{value:?} is no direction: it must not be zero")));
        }
        Ok(value)
    }

    /// A range whose ends pass `check`.
    pub(crate) fn span(
        &self,
        span: Span,
        check: impl Fn(&Self, f32) -> Result<f32, Problem>,
    ) -> Result<sward::Range, Problem> {
        let (min, max) = (check(self, span.0)?, check(self, span.1)?);
        if min > max {
            return Err(self.problem(format!("({min}, {max}): the first must not be the larger")));
        }
        Ok(sward::Range::new(min, max))
    }

    /// A reflectance.
    pub(crate) fn color(&self, color: Color) -> Result<[f32; 3], Problem> {
        for channel in color.0 {
            self.within(channel, 0.0, 1.0)?;
        }
        Ok(color.0)
    }

    /// A radiance: may be above 1.
    pub(crate) fn radiance(&self, color: Color, strength: f32) -> Result<Vec3, Problem> {
        for channel in color.0 {
            self.within(channel, 0.0, 100.0)?;
        }
        Ok(Vec3::from(color.0) * strength)
    }
}

/// Farthest from the origin that anything may lie, metres: beyond, f32 has no millimetres left.
pub(crate) const MAX_M: f32 = 100_000.0;

fn allowed(min: f32, max: f32) -> String {
    match (min.is_finite(), max.is_finite()) {
        (true, false) => format!("it must be at least {min}"),
        (false, true) => format!("it must be at most {max}"),
        _ => format!("it must be {min} to {max}"),
    }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}
