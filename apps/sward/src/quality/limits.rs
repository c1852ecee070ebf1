//! What may not be exceeded.

use super::Quality;

/// Limits of the numbers that say whether a change of form can be seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Coverage, luminance and colour across each change, as shares.
    pub drift: f32,
    /// Jump of a path's mean.
    pub jump: f32,
    /// Jump of a path's tiles.
    pub tile_jump: f32,
}

impl Default for Limits {
    fn default() -> Self {
        Self { drift: 0.02, jump: 0.005, tile_jump: 0.10 }
    }
}

impl Limits {
    /// A line for each limit that is exceeded.
    pub fn exceeded(&self, quality: &Quality) -> Vec<String> {
        let mut values = Vec::new();
        if let Some(drift) = &quality.drift {
            values.push(("drift.coverage".to_string(), drift.coverage, self.drift));
            values.push(("drift.luminance".to_string(), drift.luminance, self.drift));
            values.push(("drift.colour".to_string(), drift.colour, self.drift));
        }
        for (name, path) in quality.paths() {
            values.push((format!("{name}.jump"), path.jump, self.jump));
            values.push((format!("{name}.tile_jump"), path.tile_jump, self.tile_jump));
        }
        let mut lines: Vec<_> = values
            .into_iter()
            // What is no number is above any limit
            .filter(|(_, value, limit)| value.is_nan() || value > limit)
            .map(|(name, value, limit)| format!("{name} is {value:.4}, above its limit {limit}"))
            .collect();
        if quality.still.is_some_and(|still| !still.equal) {
            lines.push("still.equal is false: frames of a still camera differ".into());
        }
        lines
    }
}
