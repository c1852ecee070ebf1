//! Real-time grass that responds.

pub mod error;
pub mod field;
pub mod frame;
mod gpu;
pub mod grow;
pub mod renderer;
pub mod shared;
pub mod simulation;
pub mod species;
pub mod statistics;
pub mod view;

#[cfg(test)]
mod pipeline_tests;

pub use error::Error;
pub use field::{BladeOrder, DensityMap, Field, FieldDesc, Metric, Tufts};
pub use frame::wind::{Gusts, Waves, Wind, WindSource};
pub use grow::surface::{Mesh, Surface};
pub use renderer::{Renderer, Stage, Targets};
pub use simulation::{Frame, Gravity, Light, PhysicsModel, Sphere};
pub use species::{ColorRange, Range, Shape, Species};
pub use statistics::Statistics;
pub use view::{Culling, View};
