//! The physics stage.
