//! `--light`, of several commands.

use sward_scene::LightPreset;

/// Lights by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum LightChoice {
    /// The sun has just risen, in clear air
    Dawn,
    /// A high sun
    Noon,
    /// A low warm sun in light haze
    GoldenHour,
    /// An even cover of clouds
    Overcast,
    /// A full moon
    Moonlit,
}

impl From<LightChoice> for LightPreset {
    fn from(choice: LightChoice) -> Self {
        match choice {
            LightChoice::Dawn => Self::Dawn,
            LightChoice::Noon => Self::Noon,
            LightChoice::GoldenHour => Self::GoldenHour,
            LightChoice::Overcast => Self::Overcast,
            LightChoice::Moonlit => Self::Moonlit,
        }
    }
}
