//! Techniques: which forms a view draws plants in.

/// Which levels a view may use. Every technique draws the same plants, in the same places, moved by
/// the same wind and colliders; each plant is drawn in one form at a time.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Technique {
    /// Every plant a curved blade, of fewer segments and thinned farther away (Jahrmann and Wimmer
    /// 2017). The most vertices; nothing needs a picture.
    Blades,
    /// Every plant two textured strips at an angle (Olofsson and Silven).
    Strips,
    /// Modelled plants or blades near, upright textured quads farther away, in three bands (Wang and
    /// Yao 2023).
    Billboards,
    /// Each species in its near form, then clusters that stand for 32 blades each, then the ground:
    /// the cost follows what shows.
    #[default]
    Continuum,
}

impl Technique {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Blades, Self::Strips, Self::Billboards, Self::Continuum];
}
