//! WGSL functions of the light stage, which `draw` calls.
