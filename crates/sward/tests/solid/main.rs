//! Solids: inside, distance, and the spheres that fill them.

mod inside;
mod packing;
mod shapes;
