//! The GPU pipeline as a host drives it, against the stages' CPU references.

mod canopy;
mod clusters;
mod colliders;
mod compaction;
mod debugging;
mod decisions;
mod decoded;
mod depth;
mod drawing;
mod handmade;
mod lobes;
mod packing;
mod pages;
mod plants;
mod quads;
mod quantized;
mod rig;
mod saved;
mod scenes;
mod solids;
mod strip_drawing;
mod strips;
mod sweep;
mod tints;
mod views;
mod wind;
