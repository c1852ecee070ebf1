//! The parts of the `sward` command that other programs share: a headless device, the stage that
//! draws a scene round its grass, and the comparison of pictures.

pub mod compare;
pub mod gpu;
pub mod grow;
pub mod stage;
