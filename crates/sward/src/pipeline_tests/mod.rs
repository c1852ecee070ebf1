//! The GPU pipeline as a host drives it, against the stages' CPU references.

mod decisions;
mod decoded;
mod depth;
mod handmade;
mod quantized;
mod rig;
mod scenes;
