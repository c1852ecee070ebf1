//! blades
