//! The parts of the `sward` command that other programs share: a headless device, the stage that
//! draws a scene round its grass, the map of its wind, and the comparison of pictures.

pub mod compare;
pub mod gpu;
pub mod grow;
pub mod picture;
pub mod quality;
pub mod stage;
pub mod wind_map;

/// The program in the project's README compiles.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
