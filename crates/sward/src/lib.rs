//! Real-time grass that responds.

pub mod error;
pub mod field;
pub mod frame;
mod gpu;
pub mod grow;
pub mod renderer;
pub mod shared;
pub mod species;

pub use error::Error;
pub use field::{BladeOrder, DensityMap, Field, FieldDesc, Metric, Tufts};
pub use frame::wind::{Gusts, Waves, Wind, WindSource};
pub use grow::surface::{Mesh, Surface};
pub use renderer::{
    Culling, Frame, Gravity, Light, PhysicsModel, Renderer, Sphere, Statistics, Targets, View,
};
pub use species::{ColorRange, Range, Shape, Species};
