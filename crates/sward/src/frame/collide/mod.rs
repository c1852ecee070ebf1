//! The collide stage.

pub mod twin;
