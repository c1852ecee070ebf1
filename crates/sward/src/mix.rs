//! Mixes of plants by probability, and the one setting that goes from grassland to garden.

use crate::error::within;
use crate::{Error, Species};

/// One kind of a mix.
#[derive(Debug, Clone, PartialEq)]
pub struct Kind {
    /// The plant; its `share` is not read.
    pub species: Species,
    /// How likely a plant is of this kind, 0 or more.
    pub probability: f32,
    /// Whether it counts as a flower for [`Mix::garden`].
    pub flower: bool,
}

/// Kinds of plants by probability (Wang and Yao 2023).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mix {
    /// The kinds. Their probabilities are divided by their sum.
    pub kinds: Vec<Kind>,
    /// From grassland, 0, to garden, 1: the share of flowers among all plants. Grasses among each other,
    /// and flowers among each other, keep their probabilities. `None` takes them as they are.
    pub garden: Option<f32>,
}

/// What a mix comes to.
#[derive(Debug, Clone, PartialEq)]
pub struct Mixed {
    /// The kinds that occur, their shares set.
    pub species: Vec<Species>,
    /// Told where the probabilities did not add up to 1.
    pub note: Option<String>,
}

impl Mix {
    /// The species for [`FieldDesc::species`](crate::FieldDesc::species).
    ///
    /// # Errors
    /// [`Error::Setting`] for probabilities that are negative, not finite, or all 0; for a `garden`
    /// outside 0..=1, or one that asks for flowers or for grasses where there are none.
    pub fn species(&self) -> Result<Mixed, Error> {
        let shares = self.shares()?;
        let named = self.kinds.iter().zip(shares).filter(|(_, share)| *share > 0.0);
        let species = named.map(|(kind, share)| Species { share, ..kind.species.clone() });
        let sum: f64 = self.kinds.iter().map(|kind| f64::from(kind.probability)).sum();
        let odd = (sum - 1.0).abs() > 1e-3;
        let note = odd.then(|| {
            format!("the plants' probabilities add up to {sum:.3}, not 1; each is divided by that")
        });
        Ok(Mixed { species: species.collect(), note })
    }

    /// Probabilities that add up to 1, by kind.
    fn shares(&self) -> Result<Vec<f32>, Error> {
        for (i, kind) in self.kinds.iter().enumerate() {
            within(&format!("plants[{i}].probability"), kind.probability, 0.0, 1e6)?;
        }
        let of = |flower: bool| {
            let own = self.kinds.iter().filter(|kind| kind.flower == flower);
            own.map(|kind| f64::from(kind.probability)).sum::<f64>()
        };
        let (grass, flowers) = (of(false), of(true));
        if grass + flowers == 0.0 {
            let cause = "all probabilities are 0, so nothing grows; give one kind more";
            return Err(Error::setting("plants", cause));
        }
        let Some(garden) = self.garden else {
            let share = |kind: &Kind| (f64::from(kind.probability) / (grass + flowers)) as f32;
            return Ok(self.kinds.iter().map(share).collect());
        };
        within("garden", garden, 0.0, 1.0)?;
        for (wanted, sum, what) in [(1.0 - garden, grass, "grasses"), (garden, flowers, "flowers")]
        {
            if wanted > 0.0 && sum == 0.0 {
                let cause = format!("{garden} asks for {what}, but none has a probability");
                return Err(Error::setting("garden", cause));
            }
        }
        let share = |kind: &Kind| {
            let (part, sum) = if kind.flower { (garden, flowers) } else { (1.0 - garden, grass) };
            if sum == 0.0 { 0.0 } else { (f64::from(part * kind.probability) / sum) as f32 }
        };
        Ok(self.kinds.iter().map(share).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mix(kinds: &[(f32, bool)], garden: Option<f32>) -> Mix {
        let kind = |&(probability, flower)| {
            let species = Species { name: format!("{probability}"), ..Species::default() };
            Kind { species, probability, flower }
        };
        Mix { kinds: kinds.iter().map(kind).collect(), garden }
    }

    fn shares(mix: &Mix) -> Vec<f32> {
        mix.species().expect("a mix").species.iter().map(|s| s.share).collect()
    }

    fn refused(mix: &Mix) -> String {
        mix.species().expect_err("bad").to_string()
    }

    #[test]
    fn probabilities_are_normalised_and_it_is_told() {
        let whole = mix(&[(0.7, false), (0.3, true)], None);
        assert_eq!(shares(&whole), [0.7, 0.3]);
        assert_eq!(whole.species().expect("a mix").note, None);
        let more = mix(&[(3.0, false), (1.0, true), (0.0, true)], None);
        assert_eq!(shares(&more), [0.75, 0.25], "what never occurs is left out");
        let note = more.species().expect("a mix").note.expect("told");
        assert!(note.contains("add up to 4.000"), "{note}");
    }

    #[test]
    fn garden_goes_from_grasses_to_flowers() {
        let kinds = [(0.6, false), (0.2, false), (0.15, true), (0.05, true)];
        assert_eq!(shares(&mix(&kinds, Some(0.0))), [0.75, 0.25]);
        let all = shares(&mix(&kinds, Some(1.0)));
        assert!((all[0] - 0.75).abs() < 1e-6 && (all[1] - 0.25).abs() < 1e-6, "{all:?}");
        let half = shares(&mix(&kinds, Some(0.5)));
        assert!((half[0] + half[1] - 0.5).abs() < 1e-6 && (half[2] - 0.375).abs() < 1e-6);
    }

    #[test]
    fn what_cannot_be_mixed_is_refused() {
        let two = |a, b| mix(&[(a, false), (b, true)], None);
        assert!(refused(&two(0.5, -0.1)).starts_with("plants[1].probability: -0.1"));
        assert!(refused(&two(f32::NAN, 1.0)).starts_with("plants[0].probability: NaN"));
        assert!(refused(&two(f32::INFINITY, 1.0)).starts_with("plants[0].probability: inf"));
        assert!(refused(&two(0.0, 0.0)).starts_with("plants: all probabilities are 0"));
        assert!(refused(&mix(&[], None)).starts_with("plants: all"));
        assert!(refused(&mix(&[(1.0, false)], Some(0.1))).contains("asks for flowers"));
        assert!(refused(&mix(&[(1.0, true)], Some(0.9))).contains("asks for grasses"));
        let garden = |g| mix(&[(0.5, false), (0.5, true)], Some(g));
        assert!(refused(&garden(1.5)).starts_with("garden: 1.5"));
        assert!(refused(&garden(f32::NAN)).starts_with("garden: NaN"));
    }
}
