//! Each frame, on the GPU: one folder a stage, in the order in which they run.

pub mod collide;
pub mod cull;
pub mod draw;
pub mod level;
pub mod light;
pub mod physics;
pub mod wind;
