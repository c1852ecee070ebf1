//! The bands of distance that plants of quads are drawn in (Wang and Yao 2023).

use crate::Error;
use crate::error::{above_zero, within};

/// Three bands: modelled plants, then quads, then fewer and coarser quads. Each plant changes at its own
/// distance, so that no ring shows where a band ends, and turns into the next form by degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bands {
    /// Where the near band ends, metres at a detail of 1. Models are the dearest form.
    pub near_m: f32,
    /// Where the middle band ends, metres.
    pub middle_m: f32,
    /// Where the far band ends, and plants with it, metres; infinity has no end.
    pub far_m: f32,
    /// How much a plant's own distances differ from these, 0..=0.9, as a share of them: so the
    /// differences grow with the distance. More hides the changes better; 0 shows rings.
    pub jitter: f32,
    /// Share of the plants that are kept far off, above 0..=1; the others are as much wider.
    pub far_share: f32,
    /// Height of plants far off, above 0..=1, times their own.
    pub far_size: f32,
}

impl Default for Bands {
    fn default() -> Self {
        Self {
            near_m: 6.0,
            middle_m: 30.0,
            far_m: f32::INFINITY,
            jitter: 0.25,
            far_share: 0.7,
            far_size: 0.92,
        }
    }
}

impl Bands {
    pub(crate) fn check(&self) -> Result<(), Error> {
        above_zero("bands.near_m", self.near_m, 1e6)?;
        above_zero("bands.middle_m", self.middle_m, 1e6)?;
        if !(self.near_m < self.middle_m && self.middle_m < self.far_m) {
            let Self { near_m, middle_m, far_m, .. } = self;
            let cause = format!(
                "{near_m}, {middle_m} and {far_m} m are out of order; each band must end beyond the \
                 one before it"
            );
            return Err(Error::setting("bands", cause));
        }
        within("bands.jitter", self.jitter, 0.0, 0.9)?;
        above_zero("bands.far_share", self.far_share, 1.0)?;
        above_zero("bands.far_size", self.far_size, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Bands;

    #[test]
    fn bands_that_do_not_follow_each_other_are_refused() {
        let refused = |bands: Bands| bands.check().expect_err("bad").to_string();
        let good = Bands::default();
        assert!(good.check().is_ok());
        assert!(refused(Bands { middle_m: 5.0, ..good }).starts_with("bands: 6, 5 and inf m"));
        assert!(refused(Bands { far_m: 30.0, ..good }).contains("out of order"));
        assert!(refused(Bands { far_m: f32::NAN, ..good }).contains("out of order"));
        assert!(refused(Bands { near_m: 0.0, ..good }).starts_with("bands.near_m: 0"));
        assert!(refused(Bands { near_m: f32::NAN, ..good }).starts_with("bands.near_m"));
        assert!(refused(Bands { jitter: 1.0, ..good }).starts_with("bands.jitter"));
        assert!(refused(Bands { far_share: 0.0, ..good }).starts_with("bands.far_share"));
    }
}
