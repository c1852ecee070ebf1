//! Growing.
fn main() {}
