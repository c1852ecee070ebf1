//! The light stage.
