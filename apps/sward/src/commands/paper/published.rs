//! The paper's own numbers: one data file, each number with its source.

use super::quantity::{Condition, Quantity, SceneName};
use crate::input;
use anyhow::{Context, Result, bail};
use serde::Deserialize;
use std::io::Read;
use std::path::Path;

/// A file of published numbers.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Published {
    /// Which paper.
    pub paper: String,
    /// What it was measured on.
    pub machine: Option<String>,
    /// Why numbers are missing; shown while any is.
    pub missing: String,
    numbers: Vec<Number>,
}

/// One number.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct Number {
    scene: SceneName,
    conditions: Vec<Condition>,
    quantity: Quantity,
    value: f64,
    source: String,
}

impl Published {
    /// The file that comes with the program.
    pub fn built_in() -> Result<Self> {
        Self::parse(include_str!("published.ron")).context("published.ron")
    }

    /// A file of the user's.
    pub fn read(path: &Path) -> Result<Self> {
        let about = || format!("--published {}", path.display());
        let mut text = String::new();
        let mut file = input::open(path).with_context(about)?;
        file.read_to_string(&mut text).with_context(about)?;
        Self::parse(&text).with_context(about)
    }

    fn parse(text: &str) -> Result<Self> {
        let published: Self =
            ron::from_str(text).map_err(|error| anyhow::anyhow!("line {}", spanned(&error)))?;
        let numbers = &published.numbers;
        for (i, number) in numbers.iter().enumerate() {
            let about = || number.about();
            if !(number.value.is_finite() && number.value >= 0.0) {
                bail!("{}: {} is no count and no time; use 0 or more", about(), number.value);
            }
            if number.source.trim().is_empty() {
                bail!("{}: source is empty; say where the number stands", about());
            }
            if number.conditions.is_empty() {
                bail!("{}: conditions is empty; name at least one", about());
            }
            let again = |later: &Number| {
                (later.scene, later.quantity) == (number.scene, number.quantity)
                    && later.conditions.iter().any(|c| number.conditions.contains(c))
            };
            if numbers[i + 1..].iter().any(again) {
                bail!("{}: stands there twice; keep one", about());
            }
        }
        Ok(published)
    }

    /// The number and its source, where it is known.
    pub fn get(
        &self,
        scene: SceneName,
        condition: Condition,
        quantity: Quantity,
    ) -> Option<(f64, &str)> {
        let found = self.numbers.iter().find(|number| {
            (number.scene, number.quantity) == (scene, quantity)
                && number.conditions.contains(&condition)
        })?;
        Some((found.value, &found.source))
    }
}

impl Number {
    fn about(&self) -> String {
        format!("{} of {}", self.quantity.key(), self.scene.key())
    }
}

/// The place and the cause in one line.
fn spanned(error: &ron::error::SpannedError) -> String {
    format!("{}: {}", error.span.start.line, error.code)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(numbers: &str) -> Result<Published> {
        Published::parse(&format!(
            "(paper: \"p\", machine: None, missing: \"m\", numbers: [{numbers}])"
        ))
    }

    const GOOD: &str = "(scene: nature, conditions: [everything_on, culling_off], \
                        quantity: frame_ms, value: 1.5, source: \"table 1\"),";

    #[test]
    fn what_comes_with_the_program_is_well_formed_and_each_number_has_a_source() {
        let published = Published::built_in().unwrap();
        for condition in Condition::ALL {
            let total = |scene| published.get(scene, condition, Quantity::BladesTotal).unwrap().0;
            assert_eq!(total(SceneName::Nature), 397_881.0);
            assert_eq!(total(SceneName::Helicopter), 900_000.0);
        }
        assert!(published.get(SceneName::Nature, Condition::All, Quantity::FrameMs).is_none());
    }

    #[test]
    fn a_number_that_is_filled_in_is_found_under_its_conditions_only() {
        let published = with(GOOD).unwrap();
        let frame = |condition| published.get(SceneName::Nature, condition, Quantity::FrameMs);
        assert_eq!(frame(Condition::All), Some((1.5, "table 1")));
        assert_eq!(frame(Condition::NoCulling), Some((1.5, "table 1")));
        assert_eq!(frame(Condition::NoCollisions), None);
    }

    #[test]
    fn mistakes_are_named() {
        let error = |numbers: &str| format!("{:#}", with(numbers).unwrap_err());
        assert!(error(&GOOD.repeat(2)).contains("frame_ms of nature: stands there twice"));
        assert!(error(&GOOD.replace("1.5", "-1.0")).contains("is no count and no time"));
        assert!(error(&GOOD.replace("table 1", " ")).contains("source is empty"));
        assert!(error(&GOOD.replace("frame_ms", "frame")).contains("frame_ms"), "lists the names");
        let none = GOOD.replace("[everything_on, culling_off]", "[]");
        assert!(error(&none).contains("name at least one"));
        assert!(error(&GOOD.replace("value", "valeu")).starts_with("line 1: "));
    }
}
