//! The level stage.
