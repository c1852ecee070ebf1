//! The physics stage.

pub mod paper_twin;
pub mod twin;
