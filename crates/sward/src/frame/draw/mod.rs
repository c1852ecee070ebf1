//! The draw stage.
