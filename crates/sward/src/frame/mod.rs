//! Each frame, on the GPU: one folder a stage, in the order in which they run.
//!
//! `wind` is a function that `update` calls; `collide` lists the spheres near each patch; `sweep`
//! finds the cells of the ground that a view sees, `cull` the patches; `update` moves, tests and
//! grades the blades of those patches (with the functions of `physics`, `cull` and `level`);
//! `compact` makes the draw list; `draw` draws it, lit by `light`.

pub mod collide;
pub mod physics;
pub mod sweep;
pub mod wind;

pub(crate) mod compact;
pub(crate) mod cull;
pub(crate) mod debug;
pub(crate) mod draw;
pub(crate) mod level;
pub mod light;
pub(crate) mod update;
