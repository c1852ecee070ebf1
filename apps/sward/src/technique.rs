//! `--technique`, of several commands.

use sward::Technique;

/// Which forms plants are drawn in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum TechniqueChoice {
    /// Curved blades, thinned with distance (Jahrmann and Wimmer)
    Blades,
    /// Textured strips (Olofsson and Silven)
    Strips,
    /// Modelled plants, then textured quads (Wang and Yao)
    Billboards,
    /// Near forms, then clusters, then ground
    Continuum,
}

impl From<TechniqueChoice> for Technique {
    fn from(choice: TechniqueChoice) -> Self {
        match choice {
            TechniqueChoice::Blades => Self::Blades,
            TechniqueChoice::Strips => Self::Strips,
            TechniqueChoice::Billboards => Self::Billboards,
            TechniqueChoice::Continuum => Self::Continuum,
        }
    }
}
