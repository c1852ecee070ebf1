//! The GPU pipeline as a host drives it, against the stages' CPU references.

mod compaction;
mod decisions;
mod decoded;
mod depth;
mod handmade;
mod pages;
mod quantized;
mod rig;
mod scenes;
